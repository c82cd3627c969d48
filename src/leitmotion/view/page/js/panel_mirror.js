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
  const span = spanAt(now);
  box.append(make("p", "verdict", span ? spanWords(span) : "No motif of symmetry was found at this moment."));
  return box;
}

// A sentence about a stretch, with the letter of its pattern, and how it looks in the matrix.
function spanWords(span) {
  const [before, after] = span.sentence.split("{it}");
  if (after === undefined) return `${before} ${span.picture}`;
  const it = span.pattern === null ? ["This movement"] : ["Pattern ", chip(span.pattern)];
  const words = make("span", "", [before, ...it, `${after} ${span.picture}`]);
  return words;
}

function mirrorVerdict(pair) {
  const straight = compareSides(pair.one, pair.two, !pair.mirrored).distance;
  const other = Number.isNaN(straight) ? "" : `${sidesWord(straight)} ${pair.mirrored ? "as they are" : "in the mirror"}.`;
  return pair.mirrored ? `Nearer in the mirror: ${other}` : `Nearer as they are: ${other}`;
}

function nowInTheMirrorSentence() {
  const apart = lopsidednessAt(state.time);
  const span = spanAt(state.time);
  const far = Number.isNaN(apart) ? WORDS.unknown : `${sidesWord(apart)} from its own mirror image, on average.`;
  return `Now ${momentWord(state.time)}. ${far}${span ? ` ${symmetry.lanes[span.lane].name}.` : ""}`;
}
