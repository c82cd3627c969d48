// Lanes of the view of symmetry: one a motif that was found, with a bar a stretch and a field a half-cycle, cycle or way.
// What merely comes again, a posture or a way, stands behind a button, as there may be much of it.

const motifLanes = [];
const isLaneShown = (l) => state.more || symmetry.lanes[l].chief || !symmetry.lanes.some((lane) => lane.chief);

if (symmetry && !symmetry.lanes.length) {
  timeRows.push({ order: 35, views: ["symmetry"], element: make("div", "row empty", make("p", "", symmetry.empty)) });
}
if (symmetry?.lanes.length) addMotifs();

function addMotifs() {
  const element = make("div", "row lanes motifs", [], { role: "group", "aria-label": "Motifs of symmetry" });
  symmetry.lanes.forEach((lane, l) => {
    motifLanes.push(buildMotifLane(lane, l));
    element.append(motifLanes[l].element);
  });
  const rest = symmetry.lanes.filter((lane) => !lane.chief);
  const more = make("button", "more-lanes", "", { type: "button" });
  more.addEventListener("click", () => {
    state.more = !state.more;
    if (!state.more && state.span !== null && !isLaneShown(motifSpans[state.span].lane)) clearSpan();
    keepHash();
    redraw("layout");
  });
  const foldable = rest.length && rest.length < symmetry.lanes.length;
  timeRows.push({
    order: 30,
    views: ["symmetry"],
    element,
    layout() {
      const shown = motifLanes.filter(({ element }, l) => {
        element.hidden = !isLaneShown(l);
        return !element.hidden;
      });
      element.style.maxHeight = shown.length > LANES_SHOWN ? shown[0].element.offsetHeight * LANES_SHOWN + "px" : "";
      for (const lane of shown) {
        lane.element.style.width = timeline.element.clientWidth + "px";
        lane.layout();
      }
    },
    change() {
      element.classList.toggle("dimmed", state.pattern !== null || state.span !== null);
      motifLanes.forEach((lane) => lane.change());
    },
  });
  if (foldable) {
    timeRows.push({
      order: 31,
      views: ["symmetry"],
      element: make("div", "row more-row no-print", more),
      change() {
        const names = rest.map((lane) => lowerFirst(lane.name)).join(" · ");
        more.textContent = state.more ? "Show fewer lanes" : `${rest.length} more: ${names}`;
        more.setAttribute("aria-expanded", state.more);
      },
    });
  }
}

function buildMotifLane(lane, l) {
  const figure = document.createElement("canvas");
  const head = make("button", "lane-head motif-head", [figure, make("span", "", [make("strong", "", lane.name), " ", make("small", "", lane.term)])], { type: "button", title: `${lane.name}: ${lane.term}` });
  const track = make("div", "track");
  const element = make("div", "lane", [head, track]);
  const first = motifSpans.findIndex((span) => span.lane === l);
  head.setAttribute("aria-label", `${lane.name}, ${lane.term}, ${lane.spans.length} ${lane.spans.length === 1 ? "stretch" : "stretches"}. Play the first.`);
  head.addEventListener("click", () => chooseSpan(first));
  const bars = lane.spans.flatMap((span, n) => buildMotifBars(span, first + n));
  track.append(...bars.map(({ bar }) => bar));
  return {
    element,
    layout() {
      drawSmall(sized(figure, 34, 32), lane.key, { x: 17, base: 31, height: 29, width: 32 });
      for (const { bar, span, from, to } of bars) layMotifBar(bar, span, from, to, lane.rows, l);
    },
    change() {
      for (const { bar, k, span } of bars) {
        bar.style.setProperty("--c", span.pattern === null ? "var(--ink2)" : patternToken(span.pattern));
        bar.classList.toggle("chosen", state.span === k || (state.span === null && span.pattern !== null && span.pattern === state.pattern));
        bar.classList.toggle("playing", state.span === k);
        bar.setAttribute("aria-pressed", state.span === k);
      }
      element.classList.toggle("chosen", bars.some(({ bar }) => bar.classList.contains("chosen")));
    },
  };
}

// A stretch has one bar, one with a partner two: the second moment is dashed, as everywhere.
function buildMotifBars(span, k) {
  const ends = [[span.start, span.stop], ...(span.partner ? [span.partner] : [])];
  return ends.map(([from, to], n) => {
    const bar = make("button", span.confidence < 0.5 ? "stretch unsure" : "stretch", [], { type: "button", "aria-label": n ? `${span.name}: the second time` : span.name });
    bar.classList.toggle("second", n > 0);
    bar.addEventListener("click", () => chooseSpan(k));
    for (const [enter, leave] of [["pointerenter", "pointerleave"], ["focus", "blur"]]) {
      bar.addEventListener(enter, () => pointAtSpan(k, bar));
      bar.addEventListener(leave, () => pointAtSpan(null));
    }
    return { bar, k, span, from, to };
  });
}

const LEAST_FIELD = 4;
const LETTER_ROOM = 22;

function layMotifBar(bar, span, from, to, rows, l) {
  const width = Math.max(across(to - from) - 1, 3);
  bar.style.left = placeOf(from) + "px";
  bar.style.width = width + "px";
  if (rows > 1) {
    const box = motifLanes[l].element.offsetHeight;
    const [upper, lower] = innerWidth <= 760 && !state.printing ? [25, 6] : [6, 6];
    const height = (box - upper - lower) / rows;
    bar.style.top = upper + span.row * height + "px";
    bar.style.bottom = box - upper - (span.row + 1) * height + 1 + "px";
  }
  bar.replaceChildren();
  const second = bar.classList.contains("second");
  const { marks } = span;
  const fields = second ? 0 : marks.length - 1;
  bar.classList.toggle("plain-bar", fields < 1 && !second);
  if (fields > 0 && across(marks.at(-1) - marks[0]) / fields >= LEAST_FIELD) {
    for (let n = 0; n < fields; n++) {
      const field = make("span", n % 2 ? "even" : "");
      field.classList.toggle("last", n === fields - 1);
      field.style.left = across(marks[n] - from) + "px";
      field.style.width = across(marks[n + 1] - marks[n]) + "px";
      bar.append(field);
    }
  } else if (fields > 0) {
    const all = make("span", "many", width > 40 ? String(fields) : "");
    all.style.left = across(marks[0] - from) + "px";
    all.style.width = across(marks.at(-1) - marks[0]) + "px";
    bar.append(all);
  }
  if (!second && rows === 1 && span.pattern !== null && width > LETTER_ROOM) bar.append(make("b", "letter", patterns[span.pattern].id));
}

// Point at a bar: where it lies in the matrix is outlined, and its line of words stands beside it.
function pointAtSpan(k, bar = null) {
  const changed = state.pointed !== k;
  state.pointed = k;
  showTip(bar, k === null ? "" : motifSpans[k].tip);
  if (changed) redraw("change");
}
