// The curve under the lanes. Another curve is added by another file that pushes it here.

const curves = [
  {
    id: "likeness",
    title: "Likeness to now",
    note: "peaks: this posture again",
    // The matrix row of now as a line: 1 where alike, 0 from 1.5 caps on; NaN where unknown.
    values() {
      const { values, cells } = likeness;
      const row = cellAt(shownTime()) * cells;
      return { count: cells, at: (k) => (values[row + k] === 255 ? NaN : 1 - values[row + k] / 254), time: timeOfCell };
    },
  },
];

if (!several) (() => {
  const canvas = make("canvas", "", [], { "aria-hidden": "true" });
  const title = make("p", "row-head", []);
  const element = make("div", "row curve", [title, canvas]);
  let shownCurve = curves[0];
  title.append(shownCurve.title, make("small", "", [document.createElement("br"), shownCurve.note]));
  title.lastChild.style.fontSize = "inherit";
  seekable(element);
  timeRows.push({
    order: 50,
    element,
    frame() {
      const height = element.clientHeight;
      const pen = sized(canvas, timeline.element.clientWidth, height);
      const [upper, lower] = [element.dataset.upper || (height > 60 ? 26 : 6), height - 11];
      const { count, at, time } = shownCurve.values();
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
        } else run.push([timeline.left + across(time(k)), lower - value * (lower - upper)]);
      }
      paint();
    },
  });
})();
