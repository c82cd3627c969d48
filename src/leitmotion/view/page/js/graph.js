// The graph of motion: which state or path is chosen, its times, and how they play over one another, aligned in time.

const graph = payload.graph?.states ? payload.graph : null;
const graphItems = graph ? [...graph.states.map((item) => ({ ...item, kind: "state" })), ...graph.paths.map((item) => ({ ...item, kind: "path" }))] : [];
const itemNamed = (name) => graphItems.find((item) => item.name === name) ?? null;
// What only reflection made was never performed.
const isReflected = (item) => !item.visits.length;
const hasImages = graphItems.some((item) => item.mirror);
const isItemShown = (item) => state.images || !isReflected(item);
// Of a large graph the most visited part is drawn at first, laid out by itself; the list holds all.
const mostVisited = graph?.most ?? null;
const isAllDrawn = () => !mostVisited || state.whole;
const drawnPlace = (item) => (isAllDrawn() ? item : mostVisited[item.kind === "state" ? "states" : "paths"][item.name]);
const isItemDrawn = (item) => isItemShown(item) && Boolean(drawnPlace(item));
const itemsShown = () => graphItems.filter(isItemShown);
const MOST_OVERLAID = 8;

views.push({ id: "graph", name: "Graph", title: graph?.title, lead: graph?.lead, ready: graph !== null, none: payload.graph?.none ?? "" });

// The times of a state or path: its own, then with mirror images those of its image, to be drawn mirrored.
function timesOf(item) {
  const own = item.visits.map((visit) => ({ ...visit, mirrored: false }));
  const image = itemNamed(item.mirror);
  const images = state.images && image ? image.visits.map((visit) => ({ ...visit, mirrored: true })) : [];
  return [...own, ...images];
}

// The time that plays: which one, and how it is drawn; null where nothing is chosen.
function itemNow() {
  if (state.view !== "graph" || state.item === null) return null;
  const item = itemNamed(state.item);
  const times = timesOf(item);
  return times.length ? { item, times, lead: times[Math.min(state.visit, times.length - 1)] } : null;
}

const leastLong = (visit) => Math.max(visit.stop - visit.start, 1 / clip.rate);
// How far along the path a moment is, from its source, and the moment at which another time is as far.
function alongOf(visit, time) {
  const part = clamp((time - visit.start) / leastLong(visit), 0, 1);
  return visit.back ? 1 - part : part;
}
const momentAlong = (visit, part) => clamp(visit.start + (visit.back ? 1 - part : part) * leastLong(visit), 0, clip.last);

// The moments that are laid under the figure: of the other times those that belong to now, evenly chosen among many.
function overlaidOn(time) {
  const now = itemNow();
  if (!now || !state.ghost || time < now.lead.start - 1e-6 || time > now.lead.start + leastLong(now.lead) + 1e-6) return [];
  const part = alongOf(now.lead, time);
  const others = now.times.filter((visit) => visit !== now.lead);
  const count = Math.min(others.length, MOST_OVERLAID);
  return Array.from({ length: count }, (_, k) => others[Math.floor((k * others.length) / count)])
    .map((visit) => ({ time: momentAlong(visit, part), mirrored: visit.mirrored }));
}

const isLeadMirrored = () => itemNow()?.lead.mirrored ?? false;

// Choose a state or a path and play its times; choosing it again lets it go.
function chooseItem(name, visit = 0) {
  if (state.item === name && state.visit === visit) {
    clearItem();
    return;
  }
  const item = itemNamed(name);
  if (isReflected(item)) state.images = true;
  Object.assign(state, { item: name, visit, pattern: null, take: null, held: false, second: null, stripe: null, hover: null });
  state.time = timesOf(item)[visit].start;
  keepHash();
  redraw("change");
  if (!wide.matches) stage.field.scrollIntoView({ block: "nearest" });
  if (!reducedMotion.matches) play();
}

function clearItem() {
  Object.assign(state, { item: null, visit: 0 });
  pause();
  keepHash();
  redraw("change");
}

function stepItem(by) {
  const shown = itemsShown();
  const at = shown.findIndex((item) => item.name === state.item);
  chooseItem(shown[at < 0 ? (by > 0 ? 0 : shown.length - 1) : (at + by + shown.length) % shown.length].name);
}

function toggleImages() {
  state.images = !state.images;
  const item = state.item === null ? null : itemNamed(state.item);
  if (item && !isItemShown(item)) Object.assign(state, { item: null, visit: 0 });
  state.visit = item ? Math.min(state.visit, Math.max(timesOf(item).length - 1, 0)) : 0;
  keepHash();
  redraw("change");
}

function loopItem(seconds) {
  const { lead } = itemNow();
  const end = Math.min(lead.start + leastLong(lead), clip.last);
  state.time = state.time < lead.start || state.time >= end ? lead.start : state.time + seconds;
}

// The state or path that holds a moment: a path before the state that it leads to, as paths are longer.
function itemAt(time) {
  const holds = ({ start, stop }) => time >= start - 1e-6 && time < Math.max(stop, start + 1 / clip.rate);
  return graphItems.find((item) => item.kind === "state" && item.visits.some(holds)) ?? graphItems.find((item) => item.visits.some(holds)) ?? null;
}

// A letter chooses the state of that name, with shift its mirror image.
function stateOfKey(letter, starred) {
  const name = letter + (starred ? "*" : "");
  return letter && graphItems.find((item) => item.kind === "state" && item.name === name && isItemShown(item));
}

// A name with its bar, star and subscript.
const nameMarks = (item) => item.pieces.map(([text, kind]) => make({ above: "sup", below: "sub" }[kind] ?? "span", kind === "bar" ? "bar-over" : "", text));

function graphSentence() {
  const held = itemAt(state.time);
  const where = held ? `, in ${held.said.split(",")[0].toLowerCase()}` : "";
  const now = itemNow();
  const chosen = now ? ` ${now.item.said}: time ${now.times.indexOf(now.lead) + 1} of ${now.times.length} plays.` : "";
  return `Now ${momentWord(state.time)}${where}.${chosen}`;
}
