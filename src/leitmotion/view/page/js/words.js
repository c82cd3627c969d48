// Moments and distances in the units of a person.

function clockWord(seconds, digits = 1) {
  const scale = 10 ** digits;
  const units = Math.round(seconds * scale);
  const minutes = Math.floor(units / (60 * scale));
  const rest = ((units % (60 * scale)) / scale).toFixed(digits);
  return `${minutes}:${rest.padStart(digits ? 3 + digits : 2, "0")}`;
}

// A moment as a person reads it: the clock of its own recording, and where there are several, which one.
const momentClock = (time) => clockWord(ownTime(time));
const momentWord = (time) => (several ? `${partOf(time).name} ${momentClock(time)}` : momentClock(time));

const UNIT = payload.distance.unit;
const spaced = UNIT === "°" ? UNIT : " " + UNIT;
const shown = (distance) => distance * payload.distance.factor;
const apartNumber = (distance) => shown(distance).toFixed(1);
const apartWord = (distance) => `${apartNumber(distance)}${spaced}`;
const apartWhole = (distance) => `${Math.round(shown(distance))}${UNIT[0] === "%" ? " %" : spaced}`;
const capWord = `${Math.round(shown(payload.distance.cap))}${spaced}`;

const WORDS = {
  point: "Point at the matrix to compare any two moments.",
  none: `No other moment comes within ${capWord} of this posture.`,
  unknown: "Too little of the body was seen to compare the two.",
  apart: "apart, on average",
  drag: "Drag along the stripe to play the two together.",
  apartPatterns: "Not part of one pattern.",
};

const patternName = (p) => state.names[patterns[p].id] || `pattern ${patterns[p].id}`;

// One sentence for those who hear the page.
function pairSentence(pair) {
  if (state.view === "symmetry") return mirrorSentence(pair);
  const { distance, farther } = compare(pair.one, pair.two);
  const where = sharedPattern(pair.one, pair.two);
  const moments = `Moments ${momentWord(pair.one)} and ${momentWord(pair.two)}`;
  if (Number.isNaN(distance)) return `${moments}. ${WORDS.unknown}`;
  const how = `${moments} are ${farther ? "more than " : ""}${apartWord(distance)} apart, on average.`;
  return where === null ? `${how} ${WORDS.apartPatterns}` : `${how} Both in ${patternName(where)}.`;
}

function chip(p, tag = "span") {
  const made = document.createElement(tag);
  made.className = "chip";
  made.textContent = patterns[p].id;
  made.style.setProperty("--c", patternToken(p));
  return made;
}

const lowerFirst = (text) => text[0].toLowerCase() + text.slice(1);

// An element with class, children (text or elements) and attributes.
function make(tag, className, children = [], attributes = {}) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...[children].flat());
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}
