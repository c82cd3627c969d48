// The curve under the lanes, chosen by a menu. Another curve is added by another file that pushes it here: `values` tells
// numbers and their times, `range` what is drawn from the floor to the top; NaN is unknown. What carries a unit tells the
// value of now.

const curves = [
  {
    id: "likeness",
    title: "Likeness to now",
    note: "peaks: this posture again",
    range: [0, 1],
    // The matrix row of now as a line: 1 where alike, 0 from 1.5 caps on; NaN where unknown.
    values() {
      const { values, cells } = likeness;
      const row = cellAt(shownTime()) * cells;
      return { count: cells, at: (k) => (values[row + k] === 255 ? NaN : 1 - values[row + k] / 254), time: timeOfCell };
    },
  },
];
const flights = payload.curves?.flights ?? [];

// What is told at the drawn frames.
function drawnCurve({ values, missing, scale, from_zero: fromZero = true, ...rest }) {
  const at = (k) => (values[k] === missing ? NaN : values[k] * scale);
  let [low, high] = fromZero ? [0, 0] : [Infinity, -Infinity];
  for (let k = 0; k < values.length; k++) {
    const value = at(k);
    if (value > high) high = value;
    if (value < low) low = value;
  }
  return { range: high > low ? [low, high] : [0, 1], now: (time) => at(frameAt(time)), values: () => ({ count: values.length, at, time: (k) => k / clip.rate }), ...rest };
}

if (symmetry) {
  curves.push(drawnCurve({
    id: "lopsidedness", title: "Lopsidedness", note: "distance to its mirror image", unit: symmetry.told.unit, digits: 1,
    values: lopsidedness.values, missing: 65535, scale: lopsidedness.quantum * symmetry.told.factor,
  }));
}
for (const curve of payload.curves?.items ?? []) {
  curves.push(drawnCurve({ ...curve, values: decode(curve.values), missing: -32768, scale: curve.quantum, flights: true }));
}

const OWN_CURVE = { symmetry: "lopsidedness" };
const curveNow = () => curves.find((curve) => curve.id === (state.curve ?? OWN_CURVE[state.view])) ?? curves[0];

if (!several) (() => {
  const canvas = make("canvas", "", [], { "aria-hidden": "true" });
  const track = make("div", "track");
  const [name, note] = [make("span", ""), make("small", "")];
  const menu = make("button", "curve-menu", [name], { type: "button", "aria-expanded": "false", "aria-controls": "curve-sheet" });
  menu.innerHTML += '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1.5 3.5 5 7l3.5-3.5" fill="none" stroke="currentColor" stroke-width="1.4"/></svg>';
  const head = make("div", "row-head", [curves.length > 1 ? menu : name, note]);
  const element = make("div", "row curve", [canvas, head, track]);
  const title = curves.length > 1 ? menu.firstChild : name;
  seekable(element);
  menu.addEventListener("pointerdown", (event) => event.stopPropagation());
  menu.addEventListener("click", () => openSheet($("curve-sheet"), menu));
  $("curve-sheet").classList.add("menu");
  $("curve-sheet").append(...curves.map((curve) => {
    const button = menuButton(curve.title, () => {
      state.curve = curve.id === (OWN_CURVE[state.view] ?? curves[0].id) ? null : curve.id;
      keepHash();
      redraw("layout");
    });
    button.dataset.curve = curve.id;
    button.append(make("small", "", ` ${curve.unit ?? ""}`));
    return button;
  }));
  timeRows.push({
    order: 50,
    element,
    layout() {
      const curve = curveNow();
      title.textContent = curve.title;
      menu.setAttribute("aria-label", `${curve.title}: choose another curve`);
      note.textContent = curve.note;
      element.setAttribute("data-curve", curve.id);
      track.replaceChildren(...(curve.flights ? flights.map((flight) => bandOf(flight)) : []), ...(state.view === "symmetry" ? symmetry.strikes.map(strikeOf) : []));
      for (const button of $("curve-sheet").children) button.setAttribute("aria-pressed", button.dataset.curve === curve.id);
    },
    frame() {
      const height = element.clientHeight;
      const pen = sized(canvas, timeline.element.clientWidth, height);
      const [upper, lower] = [height > 60 ? 26 : 8, height - 11];
      drawCurve(pen, curveNow(), upper, lower);
    },
  });
})();

// The time in the air, with what it says of the recording.
function bandOf({ start, stop, tip }) {
  const band = make("i", "flight", "", { role: "img", "aria-label": tip, title: tip });
  band.style.left = across(start) + "px";
  band.style.width = Math.max(across(stop - start), 2) + "px";
  return band;
}

function strikeOf(time) {
  const tip = `An abrupt stop or turn (strike) at ${clockWord(time)}: a fast movement is stopped or thrown back at once`;
  const tick = make("i", "strike", "", { role: "img", "aria-label": tip, title: tip });
  tick.style.left = across(time) + "px";
  return tick;
}

function drawCurve(pen, curve, upper, lower) {
  const { count, at, time } = curve.values();
  const [low, high] = curve.range;
  const yAt = (value) => lower - ((value - low) / (high - low)) * (lower - upper);
  pen.fillStyle = theme.tokens.sunken;
  pen.strokeStyle = theme.tokens.ink2;
  pen.lineWidth = 1.3;
  pen.lineJoin = "round";
  let run = [];
  const paint = () => {
    if (run.length < 2) return;
    pen.beginPath();
    pen.moveTo(run[0][0], lower);
    for (const [x, y] of run) pen.lineTo(x, y);
    pen.lineTo(run.at(-1)[0], lower);
    pen.fill();
    pen.beginPath();
    run.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.stroke();
  };
  for (let k = 0; k < count; k++) {
    const value = at(k);
    if (Number.isNaN(value)) {
      paint();
      run = [];
    } else run.push([timeline.left + across(time(k)), yAt(value)]);
  }
  paint();
  if (!curve.unit) return;
  const word = (value) => `${value.toFixed(curve.digits)} ${curve.unit}`;
  label(pen, word(high), timeline.left + 3, upper + 1, theme.tokens.ink2, { size: 11.5, weight: 400 });
  const value = curve.now(shownTime());
  if (Number.isNaN(value)) return;
  const x = timeline.left + placeOf(shownTime());
  const onLeft = x > timeline.left + timeline.width - 90;
  label(pen, word(value), onLeft ? x - 8 : x + 8, Math.min(yAt(value), lower - 6), theme.tokens.ink, { size: 12, align: onLeft ? "right" : "left" });
}
