// Of several recordings: the time that plays and the one that it is compared with, laid over one another or side by side.

const MOST_BESIDE = 4;
const LEAST_WIDE = 150;

// What the time that plays is compared with: what was asked for, else of another recording the typical one, else the
// nearest to the typical one.
function otherTake() {
  if (state.take === null) return null;
  const takes = takesOf(state.pattern);
  if (!several) return state.take ? 0 : null;
  if (state.other !== null && state.other !== state.take && state.other < takes.length) return state.other;
  const lead = takes[state.take];
  const elsewhere = (take) => partAt(take.start) !== partAt(lead.start);
  const away = (k) => takes[k].distance + (elsewhere(takes[k]) ? 0 : 1e3);
  const others = takes.map((_, k) => k).filter((k) => k !== state.take);
  return others.reduce((best, k) => (best === null || away(k) < away(best) ? k : best), null);
}

// The moment of another time that belongs to a moment of the one that plays: both along the typical one, or in seconds.
function momentIn(k, time) {
  const [lead, other] = [takeNow(), takesOf(state.pattern)[k]];
  if (!state.inStep) return Math.min(other.start + time - lead.start, Math.min(other.stop, lastOf(other.start)));
  const typical = lead.path.length ? throughPath(lead.path, 1, time) : time;
  return other.path.length ? throughPath(other.path, 0, typical) : typical;
}

function throughPath(path, from, time) {
  let k = 0;
  while (k < path.length / 2 - 1 && path[2 * k + from] < time) k++;
  const before = Math.max(k - 1, 0);
  const [one, two] = [path[2 * before + from], path[2 * k + from]];
  const part = two > one ? clamp((time - one) / (two - one), 0, 1) : 1;
  const [start, stop] = [path[2 * before + 1 - from], path[2 * k + 1 - from]];
  return start + (stop - start) * part;
}

function compareWith(k) {
  if (k === state.take) return;
  state.other = k;
  keepHash();
  redraw("change");
}

// The next time to compare with, or the one before.
function stepOther(by) {
  const count = takesOf(state.pattern).length;
  if (state.take === null || count < 3) return;
  let k = otherTake();
  do k = (k + by + count) % count;
  while (k === state.take);
  compareWith(k);
}

function setView(what, value) {
  state[what] = value;
  keepHash();
  redraw("change");
}

// The times that stand side by side: the one that plays, what it is compared with, the nearest of each other recording.
function timesBeside() {
  const takes = takesOf(state.pattern);
  const most = clamp(Math.floor(stage.width / LEAST_WIDE), 2, MOST_BESIDE);
  const shown = [state.take, otherTake()].filter((k) => k !== null);
  const taken = new Set(shown.map((k) => partAt(takes[k].start)));
  const order = takes.map((_, k) => k).sort((a, b) => takes[a].distance - takes[b].distance);
  for (const k of order) {
    const part = partAt(takes[k].start);
    if (shown.length >= most || taken.has(part)) continue;
    taken.add(part);
    shown.push(k);
  }
  return shown;
}

const isBeside = () => several && state.beside && state.take !== null && !pairOnShow();

// Figures in a row, each placed and turned as the first, so that only how they move differs.
function drawBeside(pen, camera, now) {
  const shown = timesBeside();
  const width = stage.width / shown.length;
  const shrink = Math.min(stage.height - 150, width * 0.95) / Math.min(stage.height * 0.7, stage.width * 0.95);
  shown.forEach((k, n) => {
    const time = k === state.take ? now : momentIn(k, now);
    postureAt(time, other);
    placeOnto(posture, other, facingAt(now) - facingAt(time), placed);
    const view = { ...camera, focal: camera.focal * shrink, centre: [width * (n + 0.5), stage.height / 2 + (state.camera === "top" ? 30 : 44)] };
    if (!clip.flat) drawShadow(pen, view, placed);
    drawFigure(pen, placed, view);
    const x = width * (n + 0.5);
    pen.font = `600 13px ${theme.font}`;
    label(pen, `${n + 1} ${fitting(pen, partOf(time).name, width - 30)}`, x, 58, theme.tokens.ink, { align: "center" });
    const apart = n ? `${apartWord(compare(now, time).distance)} apart` : "";
    const small = { align: "center", size: 12, weight: 400 };
    label(pen, momentClock(time), x, 76, theme.tokens.ink2, small);
    label(pen, fitting(pen, apart, width - 8), x, 92, theme.tokens.ink2, small);
  });
}

// What the lesson has more among several recordings: how two times are shown, and whether moment by moment.
const besideControls = { views: [], inStep: null };

function buildBeside() {
  const views = make("div", "segments", [], { role: "group", "aria-label": "How two times are shown" });
  for (const [word, value] of [["Overlaid", false], ["Side by side", true]]) {
    const button = make("button", "", word, { type: "button", title: `${word}: S` });
    button.addEventListener("click", () => setView("beside", value));
    besideControls.views.push({ button, value });
    views.append(button);
  }
  return make("div", "lesson-views", views);
}

function inStepToggle() {
  const button = make("button", "toggle", [], { type: "button", title: "Moment by moment, or each at its own pace: T" });
  button.innerHTML = '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1 5.5 4 8.5 9 1.5" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>';
  button.append("In step");
  button.addEventListener("click", () => setView("inStep", !state.inStep));
  besideControls.inStep = button;
  return button;
}

on("change", () => {
  for (const { button, value } of besideControls.views) button.setAttribute("aria-pressed", state.beside === value);
  besideControls.inStep?.setAttribute("aria-pressed", state.inStep);
  // Names stand over the figures, so the legend below them is all that the corners keep.
  stage.field.classList.toggle("beside", isBeside());
});
