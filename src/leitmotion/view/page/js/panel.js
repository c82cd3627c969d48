// The panel keeps its place: Most like now when idle, Two moments when a pair is on show. At most ten times a second.

const panel = { element: $("panel"), drawn: 0, late: 0, key: "" };
const EVERY_MS = 100;

on("layout", () => (panel.key = ""));
on("change", () => (panel.key = ""));
on("frame", () => {
  clearTimeout(panel.late);
  const wait = state.playing ? panel.drawn + EVERY_MS - performance.now() : 0;
  if (wait > 0) panel.late = setTimeout(drawPanel, wait);
  else drawPanel();
});

function drawPanel() {
  panel.drawn = performance.now();
  const pair = pairOnShow();
  if (isGraphShown()) {
    sayNow(pair);
    return;
  }
  const key = pair ? `${pair.one} ${pair.two} ${pair.mirrored}` : `${frameAt(state.time)}`;
  if (key !== panel.key) {
    panel.key = key;
    panel.element.classList.toggle("paired", Boolean(pair));
    panel.element.classList.toggle("held", state.held && !state.hover);
    // On a phone the panel lies over the page, in the half that does not hold the cell.
    const box = field.top.getBoundingClientRect();
    if (pair) panel.element.classList.toggle("upper", box.top + yOf(pair.one) > innerHeight / 2);
    const idle = state.view === "symmetry" ? nowInTheMirror : mostLikeNow;
    panel.element.replaceChildren(pair ? twoMoments(pair) : idle());
  }
  sayNow(pair);
}

function mostLikeNow() {
  const found = nearestTo(state.time);
  const box = make("div", "idle", [make("h2", "", "Most like now"), make("p", "", WORDS.point)]);
  if (!found.length) box.append(make("p", "", WORDS.none));
  for (const { time, distance } of found) {
    const figure = document.createElement("canvas");
    const held = stretchAt(time);
    const words = make("span", "", [make("b", "", momentClock(time)), held ? chip(held.pattern) : "", make("small", "", [`${apartWord(distance)} apart`, ...fromPart(time)])]);
    const button = make("button", "near", [figure, words], { type: "button" });
    button.addEventListener("click", () => hold({ one: Math.min(state.time, time), two: Math.max(state.time, time) }));
    box.append(button);
    const height = clamp((stage.height + 46 - 90) / 3 - 12, 60, 104);
    drawSmall(sized(figure, 76, height), time, { x: 38, base: height - 3, height: height - 5, width: 74 });
  }
  return box;
}

const fromPart = (time) => (several ? [document.createElement("br"), partOf(time).name] : []);

function twoMoments(pair) {
  const { distance, joints, farther } = comparePair(pair);
  const mirrorView = state.view === "symmetry";
  const where = sharedPattern(pair.one, pair.two);
  const figures = [pair.one, pair.two].map((time, k) => {
    const canvas = document.createElement("canvas");
    const mirrored = Boolean(k && pair.mirrored);
    const colour = mirrored ? theme.tokens.mirror : k ? (where === null ? theme.tokens.ink2 : patternColour(where)) : null;
    const narrow = innerWidth <= 1100 && !state.printing;
    const [height, width] = narrow ? [112, 80] : [clamp(stage.height * 0.36, 90, 150), 100];
    drawSmall(sized(canvas, width, height), time, { x: width / 2, base: height - 4, height: height - 8, width: width - 2, colour, mirrored });
    const second = mirrored ? [document.createElement("br"), "mirrored"] : fromPart(time);
    return make("figure", "", [canvas, make("span", "", [make("b", "", String(k + 1)), ` ${momentClock(time)}`, ...second])]);
  });
  const box = make("div", "two", [make("h2", "", "Two moments"), make("div", "both", figures)]);
  if (Number.isNaN(distance)) {
    box.append(make("p", "verdict", WORDS.unknown));
    return box;
  }
  const number = make("b", "", (farther ? "> " : "") + (mirrorView ? sidesNumber : apartNumber)(distance));
  const unit = mirrorView ? symmetry.told.unit : UNIT;
  box.append(make("p", "apart", [number, ` ${unit} ${WORDS.apart}`.replace(" °", "°")]));
  const verdict = make("p", "verdict");
  if (mirrorView) verdict.append(mirrorVerdict(pair));
  else if (where === null) verdict.append(WORDS.apartPatterns);
  else verdict.append("Both in pattern ", chip(where), ". ", stripeNear(pair.one, pair.two, 40) ? WORDS.drag : "");
  box.append(verdict, mirrorView ? jointBars(joints, 0.2, (apart) => `${Math.round(apart * symmetry.told.factor)} ${unit}`.replace(/ of .*/, "")) : jointBars(joints));
  return box;
}

// The five joints that are farthest apart, as bars with whole numbers.
function jointBars(joints, least = payload.distance.cap * 1.2, word = apartWhole) {
  const list = make("div", "joints", [], { role: "list" });
  const top = joints.length ? Math.max(joints[0].apart, least) : 1;
  for (const joint of joints.slice(0, 5)) {
    const bar = document.createElement("i");
    bar.style.width = Math.max((100 * joint.apart) / top, 2) + "%";
    list.append(make("span", "", joint.word), bar, make("b", "", word(joint.apart)));
  }
  return list;
}

// Canvases carry a sentence kept current; the live region speaks at most once a second, never while playing.
const spoken = { at: 0, text: "", late: 0 };
function sayNow(pair) {
  const sentence = pair ? pairSentence(pair) : nowSentence();
  field.top.setAttribute("aria-label", `${$("matrix-title").textContent}. ${sentence} Arrow keys move the cell, Enter holds it.`);
  stage.canvas.setAttribute("aria-label", `The figure at ${momentWord(shownTime())} of ${clockWord(partOf(shownTime()).seconds ?? clip.seconds)}. ${sentence}`);
  clearTimeout(spoken.late);
  if (state.playing || sentence === spoken.text) return;
  const speak = () => {
    spoken.at = performance.now();
    spoken.text = sentence;
    $("live").textContent = sentence;
  };
  const wait = spoken.at + 1000 - performance.now();
  if (wait > 0) spoken.late = setTimeout(speak, wait);
  else speak();
}

// What a person asked for is said before what is told by the way.
function sayAtOnce(text) {
  clearTimeout(spoken.late);
  spoken.at = performance.now();
  $("live").textContent = text;
}

function nowSentence() {
  if (state.view === "symmetry") return nowInTheMirrorSentence();
  if (state.view === "graph") return graphSentence();
  const held = stretchAt(state.time);
  const [near] = nearestTo(state.time);
  const inside = held ? `, in ${patternName(held.pattern)}` : "";
  const like = near ? `Most like it: ${momentWord(near.time)}, ${apartWord(near.distance)} apart.` : WORDS.none;
  return `Now ${momentWord(state.time)}${inside}. ${like}`;
}
