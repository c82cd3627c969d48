// The time line: rows that share one x scale, so that one vertical line is one moment.

// A row is {order, element, views?, layout(width)?, change?(), frame?()}, of all views where it names none; another one
// is added by another file that pushes it.
const timeRows = [];
const timeline = { element: $("timeline"), left: 0, width: 0, marks: [], lines: [] };

const across = (seconds) => (seconds / clip.span) * timeline.width;
const placeOf = (time) => across(ownTime(time));

function buildTimeline() {
  timeRows.sort((a, b) => a.order - b.order);
  timeline.element.append(...timeRows.map((row) => row.element));
  for (const second of [false, true]) {
    const tag = make("b", "");
    const line = make("div", second ? "moment second" : "moment", tag, { "aria-hidden": "true" });
    timeline.lines.push({ line, tag });
    timeline.element.append(line);
  }
}

on("layout", () => {
  const style = getComputedStyle(timeline.element);
  const [head, pad] = ["--head", "--pad"].map((name) => parseFloat(style.getPropertyValue(name)));
  timeline.left = head + 1;
  timeline.width = timeline.element.clientWidth - head - pad - 1;
  for (const mark of timeline.marks) mark.remove();
  timeline.marks = [];
  const step = tickStep(timeline.width > 500 ? 8.2 : 4.2);
  for (let time = step; time < clip.span; time += step) {
    const mark = make("i", "grid-line");
    mark.style.left = timeline.left + across(time) + "px";
    timeline.marks.push(mark);
  }
  timeline.element.prepend(...timeline.marks);
  for (const row of timeRows) row.element.hidden = !isRowShown(row);
  for (const row of timeRows) if (isRowShown(row)) row.layout?.(timeline.width, step);
});
const isRowShown = (row) => row.views?.includes(state.view) ?? true;
on("change", () => timeRows.forEach((row) => isRowShown(row) && row.change?.()));
on("frame", () => {
  const pair = pairOnShow();
  // Tags of two near moments stand side by side.
  const two = pair ? pair.two : otherMoment(state.time) ?? mirroredMoment(state.time);
  const near = two === null ? Infinity : placeOf(two) - placeOf(shownTime());
  const push = (Math.max(0, TAG_WIDTH - Math.abs(near)) / 2) * (near < 0 ? -1 : 1);
  moveLine(0, shownTime(), two === null ? "" : "1 ", -push);
  moveLine(1, two, "2 ", push);
  for (const row of timeRows) if (isRowShown(row)) row.frame?.();
});

const TAG_WIDTH = 64;

function moveLine(which, time, prefix, push) {
  const { line, tag } = timeline.lines[which];
  line.hidden = time === null;
  if (time === null) return;
  const x = timeline.left + placeOf(time);
  line.style.transform = `translateX(${x.toFixed(2)}px)`;
  const word = prefix + momentClock(time);
  if (tag.textContent !== word) tag.textContent = word;
  const half = (word.length * 6.6 + 14) / 2;
  const middle = x + push;
  const shift = push + Math.max(half - middle + 2, 0) - Math.max(middle + half - timeline.element.clientWidth + 2, 0);
  tag.style.setProperty("--shift", `calc(-50% + ${shift.toFixed(1)}px)`);
}

// Point, click or drag in a row: the moment goes there.
function seekable(element) {
  const seek = (event) => {
    const box = timeline.element.getBoundingClientRect();
    const { start, stop } = partOf(state.time);
    goTo(start + clamp(((event.clientX - box.left - 1 - timeline.left) / timeline.width) * clip.span, 0, stop - start - 1 / clip.rate));
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    element.setPointerCapture(event.pointerId);
    element.dataset.down = "1";
    pause();
    seek(event);
  });
  element.addEventListener("pointermove", (event) => element.dataset.down && seek(event));
  for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, () => delete element.dataset.down);
}

// Ruler: a mark each minor step, a number each major one.
(() => {
  const track = make("div", "track");
  const element = make("div", "row ruler", track, { "aria-hidden": "true" });
  seekable(element);
  timeRows.push({
    order: 20,
    element,
    layout(width, step) {
      track.replaceChildren();
      const fine = step / ({ 0.2: 4, 2: 4, 30: 6, 60: 6, 120: 4, 1800: 6, 3600: 6 }[step] || 5);
      const minor = across(fine) >= 7 ? fine : step;
      for (let k = 0; k * minor < clip.span - 1e-6; k++) {
        const time = k * minor;
        const major = Math.abs(time / step - Math.round(time / step)) < 1e-6;
        const mark = make("i", major ? "mark major" : "mark");
        mark.style.left = across(time) + "px";
        track.append(mark);
        if (!major || across(time) > width - 6) continue;
        const tick = make("span", time ? "tick" : "tick first", time || step >= 60 ? tickWord(time, step) : "0 s");
        tick.style.left = across(time) + "px";
        track.append(tick);
      }
    },
  });
})();
