// What the page shows, kept in the address's hash so that a copied address opens the same view.

const CAMERAS = ["room", "front", "side", "top"];
const SPEEDS = [0.5, 1, 2];

const state = {
  view: "repeats", // which tab is shown
  time: 0, // seconds of moment 1
  second: null, // seconds of moment 2 while a pair is held
  held: false,
  hover: null, // {one, two}: the pair under the pointer
  stripe: null, // the stripe that a held pair follows
  step: 0, // how far along it, in steps of its path
  playing: false,
  speed: 1,
  pattern: null, // index of the chosen pattern
  loop: 0, // which of its stretches plays
  span: null, // index of the chosen stretch of a motif
  pointed: null, // the one that is pointed at
  item: null, // name of the chosen state or path of the graph
  visit: 0, // which of its times plays
  whole: false, // whether all of a large graph is drawn, not only what was visited most
  images: false, // whether the graph is shown with the mirror images that nobody performed
  form: "square", // how the matrix of symmetry is drawn
  curve: null, // which curve is shown; null is the view's own
  more: false, // whether the lanes of what merely comes again are shown
  lesson: false, // whether the lesson takes the panel's place
  take: null, // which time of the chosen pattern the lesson plays: 0 is the typical one
  repeat: several, // whether it plays that one again and again
  other: null, // of several recordings: which time it is compared with; null is the usual one
  beside: false, // whether they stand side by side, not over one another
  inStep: true, // whether they go moment by moment, not each at its own pace
  bar: null, // the pattern whose bar is pointed at
  camera: "room",
  turn: 0,
  tilt: 0,
  zoom: 1,
  follow: true,
  trails: true,
  ghost: true,
  theme: null, // "light" or "dark" once chosen, else the system's
  names: {},
  printing: false,
};

// The pair on show: the one pointed at, else the held one, else none.
function pairOnShow() {
  const pair = state.hover ?? (state.held ? { one: state.time, two: state.second } : null);
  return pair && state.view === "symmetry" ? { ...pair, mirrored: isNearerMirrored(pair.one, pair.two) } : pair;
}

const shownTime = () => (state.hover ? state.hover.one : state.time);

const listeners = { frame: [], change: [], layout: [] };
const on = (event, listener) => listeners[event].push(listener);

// "frame": the moment moved; "change": a choice was made; "layout": size or theme changed. Drawing waits for the
// next animation frame, so that many changes in one frame are drawn once.
const due = new Set();
let waiting = 0;
function redraw(event = "frame") {
  due.add(event);
  if (!waiting) waiting = requestAnimationFrame(drawNow);
}

function drawNow() {
  cancelAnimationFrame(waiting);
  waiting = 0;
  const order = due.has("layout") ? ["layout", "change", "frame"] : due.has("change") ? ["change", "frame"] : ["frame"];
  due.clear();
  const before = performance.now();
  for (const event of order) for (const listener of listeners[event]) listener();
  cost.last = performance.now() - before;
  cost.frames++;
}
const cost = { last: 0, frames: 0 };

// Of several recordings what they share stands beside the figure from the start, of one a lesson that was asked for.
const opensWithLesson = (several || payload.opens_with === "lesson") && Boolean(payload.lesson);
const openingView = () => (views.some(({ id, ready }) => id === payload.opens_with && ready) ? payload.opens_with : "repeats");

const short = (value, digits = 2) => String(Number(value.toFixed(digits)));

function writeHash() {
  const parts = new URLSearchParams();
  if (state.view !== openingView()) parts.set("view", state.view);
  parts.set("t", short(state.time));
  if (state.held) parts.set("u", short(state.second));
  if (state.pattern !== null) parts.set("pattern", patterns[state.pattern].id);
  if (state.span !== null) parts.set("span", String(state.span + 1));
  if (state.item !== null) parts.set("item", state.item);
  if (state.visit) parts.set("visit", String(state.visit + 1));
  if (state.images) parts.set("images", "1");
  if (state.form !== "square") parts.set("form", state.form);
  if (state.curve !== null) parts.set("curve", state.curve);
  if (state.more) parts.set("more", "1");
  if (state.lesson !== opensWithLesson) parts.set("lesson", state.lesson ? "1" : "0");
  if (state.take !== null) parts.set("take", String(state.take + 1));
  if (state.repeat !== several) parts.set("repeat", state.repeat ? "1" : "0");
  if (state.other !== null) parts.set("other", String(state.other + 1));
  if (state.beside) parts.set("beside", "1");
  if (!state.inStep) parts.set("step", "0");
  if (state.camera !== "room") parts.set("camera", state.camera);
  if (state.turn) parts.set("turn", short(state.turn));
  if (state.tilt) parts.set("tilt", short(state.tilt));
  if (state.zoom !== 1) parts.set("zoom", short(state.zoom));
  if (state.speed !== 1) parts.set("speed", String(state.speed));
  for (const what of ["follow", "trails", "ghost"]) if (!state[what]) parts.set(what, "0");
  if (state.theme) parts.set("theme", state.theme);
  for (const [id, name] of Object.entries(state.names)) parts.set("name." + id, name);
  history.replaceState(null, "", "#" + parts.toString().replaceAll("+", "%20"));
}

// Browsers allow few writes a second; the last one always lands.
let writing = 0;
function keepHash() {
  if (!writing) writing = setTimeout(() => ((writing = 0), writeHash()), 250);
}

function readHash(hash = location.hash) {
  const parts = new URLSearchParams(hash.slice(1));
  const number = (key, fallback, low, high) => {
    const value = parts.has(key) ? Number(parts.get(key)) : NaN;
    return Number.isFinite(value) ? clamp(value, low, high) : fallback;
  };
  state.view = views.some((view) => view.id === parts.get("view") && view.ready) ? parts.get("view") : openingView();
  state.time = number("t", openingTime(), 0, clip.last);
  state.second = number("u", null, 0, clip.last);
  state.held = state.second !== null;
  Object.assign(state, { hover: null, stripe: null, step: 0, bar: null, pointed: null });
  const span = number("span", null, 1, Math.max(motifSpans.length, 1));
  state.span = state.view === "symmetry" && motifSpans.length && span !== null ? Math.round(span) - 1 : null;
  state.images = parts.get("images") === "1";
  const item = state.view === "graph" ? itemNamed(parts.get("item")) : null;
  state.item = item && isItemShown(item) ? item.name : null;
  state.visit = state.item === null ? 0 : Math.round(number("visit", 1, 1, Math.max(timesOf(item).length, 1))) - 1;
  if (state.view === "graph") Object.assign(state, { held: false, second: null });
  state.form = parts.get("form") === "triangle" ? "triangle" : "square";
  state.curve = curves.some((curve) => curve.id === parts.get("curve")) ? parts.get("curve") : null;
  state.more = parts.get("more") === "1";
  const chosen = patterns.findIndex((p) => p.id === parts.get("pattern"));
  state.pattern = chosen < 0 || state.span !== null || state.item !== null ? null : chosen;
  if (state.span !== null && !parts.has("t")) state.time = motifSpans[state.span].start;
  if (state.item !== null && !parts.has("t")) state.time = itemNow().lead.start;
  state.loop = chosen < 0 ? 0 : (stretchAt(state.time, chosen)?.stretch ?? 0);
  const takes = state.pattern === null || state.view !== "repeats" ? 0 : takesOf(chosen).length;
  const take = number("take", null, 1, Math.max(takes, 1));
  state.take = takes && take !== null ? Math.round(take) - 1 : null;
  const played = state.take === null ? null : takesOf(chosen)[state.take];
  const away = played && (state.time < played.start || state.time > played.stop);
  if (played && (!parts.has("t") || (several && away))) state.time = played.start;
  const asked = parts.has("lesson") ? parts.get("lesson") === "1" : opensWithLesson;
  state.lesson = state.view === "repeats" && lessonSteps.length > 0 && (asked || state.take !== null);
  state.repeat = parts.has("repeat") ? parts.get("repeat") === "1" : several;
  const other = number("other", null, 1, Math.max(takes, 1));
  state.other = several && takes && other !== null ? Math.round(other) - 1 : null;
  state.beside = several && parts.get("beside") === "1";
  state.inStep = parts.get("step") !== "0";
  state.camera = CAMERAS.includes(parts.get("camera")) ? parts.get("camera") : "room";
  state.turn = number("turn", 0, -1e3, 1e3);
  state.tilt = number("tilt", 0, -1.6, 1.6);
  state.zoom = number("zoom", 1, 0.3, 6);
  state.speed = SPEEDS.includes(Number(parts.get("speed"))) ? Number(parts.get("speed")) : 1;
  for (const what of ["follow", "trails", "ghost"]) state[what] = parts.get(what) !== "0";
  state.theme = ["light", "dark"].includes(parts.get("theme")) ? parts.get("theme") : null;
  state.names = {};
  for (const [key, value] of parts) if (key.startsWith("name.") && value) state.names[key.slice(5)] = value.slice(0, 60);
}

// Nothing plays by itself: the page opens on the key posture of the pattern with the most time, else in the middle.
function openingTime() {
  return patterns.length ? patterns[0].key : Math.min(clip.last * 0.38, clip.last);
}
