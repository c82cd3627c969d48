// The panel of symmetry: the posture of now beside its mirror image, how far it is from it, and what the stretch is.

function nowInTheMirror() {
  const now = state.time;
  const [height, width] = [clamp(stage.height * 0.36, 90, 150), 100];
  const figures = [false, true].map((mirrored) => {
    const canvas = document.createElement("canvas");
    const colour = mirrored ? theme.tokens.mirror : null;
    drawSmall(sized(canvas, width, height), now, { x: width / 2, base: height - 4, height: height - 8, width: width - 2, colour, mirrored });
    return make("figure", "", [canvas, make("span", "", mirrored ? "mirrored" : "now")]);
  });
  const box = make("div", "two", [make("h2", "", "Now, and its mirror image"), make("div", "both", figures)]);
  const apart = lopsidednessAt(now);
  if (Number.isNaN(apart)) box.append(make("p", "verdict", WORDS.unknown));
  else box.append(make("p", "apart", [make("b", "", sidesNumber(apart)), ` ${symmetry.told.unit}`, document.createElement("br"), "from its own mirror image, on average"]));
  const there = mirroredMoment(now);
  if (there !== null) {
    const { mirrored, words } = mirrorMoment(now);
    box.append(make("p", "verdict", `${sidesWord(compareSides(now, there, mirrored).distance)} from ${words.replace("then", `at ${momentClock(there)}`)}.`));
  }
  const span = spanAt(now);
  box.append(make("p", "verdict", span ? spanWords(span) : "No motif of symmetry was found at this moment."));
  return box;
}

const SURE = 0.5; // below it is hatched

// A sentence about a stretch, with the letter of its pattern, and how it looks in the matrix.
function spanWords(span) {
  if (span.confidence < SURE) return `Perhaps ${lowerFirst(span.plain)}: uncertain, confidence ${span.confidence.toFixed(2)}.`;
  const [before, after] = span.sentence.split("{it}");
  if (after === undefined) return `${before} ${span.picture}`;
  const it = span.pattern === null ? ["This movement"] : ["Pattern ", chip(span.pattern)];
  return make("span", "", [before, ...it, `${after} ${span.picture}`]);
}

function mirrorVerdict(pair) {
  const other = sidesWord(compareSides(pair.one, pair.two, !pair.mirrored).distance);
  return pair.mirrored ? `Nearer in the mirror; as they are it is ${other}.` : `Nearer as they are; in the mirror it is ${other}.`;
}

function nowInTheMirrorSentence() {
  const apart = lopsidednessAt(state.time);
  const span = spanAt(state.time);
  const far = Number.isNaN(apart) ? WORDS.unknown : `${sidesWord(apart)} from its own mirror image, on average.`;
  const name = span?.plain;
  const told = !span ? "" : span.confidence < SURE ? ` Perhaps ${lowerFirst(name)}.` : ` ${name}.`;
  return `Now ${momentWord(state.time)}. ${far}${told}`;
}
