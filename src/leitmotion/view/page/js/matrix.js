// The matrix: every moment against every other. Bitmap, ticks and edge bars are drawn once per size, theme and choice.

// How cells lie: where a cell is, which one is at a place, and the lines of a moment from edge to edge.
const SQUARE = {
  id: "square",
  place: (one, two) => [xOf(two), yOf(one)],
  cell: (x, y) => [y - field.upper, x - field.left].map((v) => (v / field.side) * clip.seconds),
  cross: (time) => [[field.left - field.edge, yOf(time), field.left + field.side, yOf(time)], [xOf(time), field.upper - field.edge, xOf(time), field.upper + field.side]],
  pair: (one, two) => [[field.left - field.edge, yOf(one), xOf(two), yOf(one)], [xOf(two), field.upper - field.edge, xOf(two), yOf(two)]],
  draw: (pen) => pen.drawImage(bitmap, field.left, field.upper, field.side, field.side),
  axes: drawAxes,
};

// A matrix has a title, cells and a legend, belongs to a view and a form, and may be black in both themes; another one
// is added by another file that pushes it here. `foot` is what its legend needs beneath the cells.
const matrices = [
  {
    id: "distance", view: "repeats", shape: SQUARE, title: "Every moment against every other", foot: 38, stripes: true,
    cells: () => likeness.cells, paint: paintDistances, legend: distanceLegend,
  },
];
const field = { base: $("matrix-base"), top: $("matrix"), box: $("matrix-field"), left: 0, upper: 0, side: 0, edge: 7, shown: matrices[0] };
const bitmap = document.createElement("canvas");
const TICKS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600];

// Seconds between ticks, so that at most `most` of them stand on the axis; `least` apart at the finest.
const tickStep = (most) => TICKS.find((step) => clip.span / step < most) || TICKS.at(-1);
const tickWord = (seconds, step) => (step >= 60 ? clockWord(seconds, 0) : String(Number(seconds.toFixed(1))));

const xOf = (time) => field.left + (time / clip.seconds) * field.side;
const yOf = (time) => field.upper + (time / clip.seconds) * field.side;

function paintDistances(pixels) {
  const { values, cells } = likeness;
  const near = likeness.top / payload.distance.cap;
  const blank = rgb(theme.tokens.sunken);
  const unknown = (255 << 24) | (blank[2] << 16) | (blank[1] << 8) | blank[0];
  const table = new Uint32Array(256);
  for (let byte = 0; byte < 255; byte++) table[byte] = theme.map[Math.round(255 * (1 - Math.min((byte / 254) * near, 1)))];
  table[255] = unknown;
  for (let i = 0; i < cells * cells; i++) pixels[i] = table[values[i]];
}

function distanceLegend(legend) {
  const scale = document.createElement("canvas");
  legend.replaceChildren(make("span", "", "same posture"), scale, make("span", "", `${capWord} apart or more`));
  const width = field.side < 260 ? 36 : UNIT.length > 4 ? 52 : 96;
  const pen = sized(scale, width, 12);
  for (let x = 0; x < width; x++) {
    const colour = theme.map[Math.round(255 * (1 - x / (width - 1)))];
    pen.fillStyle = `rgb(${colour & 255} ${(colour >> 8) & 255} ${(colour >> 16) & 255})`;
    pen.fillRect(x, 0, 1.2, 12);
  }
}

on("layout", () => {
  field.shown = matrices.find(({ view, shape }) => view === state.view && shape.id === state.form)
    ?? matrices.find(({ view }) => view === state.view) ?? matrices[0];
  field.edge = field.shown.black ? 0 : 7;
  const cells = field.shown.cells();
  $("matrix-title").textContent = field.shown.title;
  bitmap.width = bitmap.height = cells;
  const pen = bitmap.getContext("2d");
  const image = pen.createImageData(cells, cells);
  field.shown.paint(new Uint32Array(image.data.buffer));
  pen.putImageData(image, 0, 0);
  const [width, height] = [field.box.clientWidth, field.box.clientHeight];
  const phone = innerWidth <= 760 && !state.printing;
  field.left = phone ? 46 : 51;
  field.upper = 55;
  field.side = Math.max(60, Math.min(width - field.left - 12, height - field.upper - field.shown.foot + (phone ? 2 : 0)));
  field.shown.legend($("matrix-legend"));
  $("matrix-legend").style.left = (field.side < 260 ? 14 : field.left) + "px";
  $("matrix-legend").style.right = "auto";
});

on("change", () => {
  const pen = sized(field.base, field.box.clientWidth, field.box.clientHeight);
  pen.imageSmoothingEnabled = true;
  pen.imageSmoothingQuality = "high";
  field.shown.shape.draw(pen);
  field.shown.shape.axes(pen);
  if (field.shown.shape === SQUARE) drawEdgeBars(pen);
  if (field.shown.stripes) drawStripes(pen);
  field.shown.over?.(pen);
});

function drawAxes(pen) {
  if (several) {
    drawParts(pen);
    return;
  }
  const step = tickStep(field.side > 500 ? 8.2 : 6.2);
  pen.font = `11.5px ${theme.font}`;
  pen.fillStyle = theme.tokens.ink2;
  for (let time = 0; time < clip.seconds * 0.985; time += step) {
    const word = tickWord(time, step);
    pen.textBaseline = "alphabetic";
    pen.textAlign = time ? "center" : "left";
    if (xOf(time) < field.left + field.side - 8) pen.fillText(time || step >= 60 ? word : "0 s", xOf(time), field.upper - 11);
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    if (time) pen.fillText(word, field.left - 13, yOf(time));
  }
}

const LEAST_PART = 8; // pixels, on average: among more recordings lines would hide what they part

// Where one recording ends and the next begins; its name stands along both axes where it has room.
function drawParts(pen) {
  pen.font = `11.5px ${theme.font}`;
  pen.textBaseline = "alphabetic";
  pen.textAlign = "left";
  const parted = field.side / clip.parts.length > LEAST_PART;
  for (const [k, { name, start, stop }] of clip.parts.entries()) {
    const [from, to] = [xOf(start), xOf(stop)];
    pen.fillStyle = theme.tokens.surface;
    if (k && parted) pen.fillRect(from - 1, field.upper - 8, 2, field.side + 8);
    if (k && parted) pen.fillRect(field.left - 8, from - field.left + field.upper - 1, field.side + 8, 2);
    const word = fitting(pen, name, to - from - 6);
    pen.fillStyle = theme.tokens.ink2;
    pen.fillText(word, from, field.upper - 11);
    pen.save();
    pen.translate(field.left - 13, to - field.left + field.upper);
    pen.rotate(-Math.PI / 2);
    pen.fillText(word, 0, 0);
    pen.restore();
  }
}

// How many marks all recordings' names begin with alike, to the end of a word: what follows tells them apart.
const alikeUpTo = (() => {
  const [first, ...others] = clip.parts.map((part) => part.name);
  let count = 0;
  while (others.length && count < first.length && others.every((name) => name[count] === first[count])) count++;
  return first.slice(0, count).search(/[^\W_]*$/);
})();

// A name, or as much as there is room for of what tells it from the others: its head and its end.
function fitting(pen, name, room) {
  const fits = (word) => pen.measureText(word).width <= room;
  if (fits(name)) return name;
  const own = alikeUpTo && clip.parts.some((part) => part.name === name) ? name.slice(alikeUpTo) : name;
  if (own !== name && fits("…" + own)) return "…" + own;
  for (let kept = own.length - 1; kept > 1; kept--) {
    const word = `${own.slice(0, Math.ceil(kept / 2))}…${own.slice(own.length - Math.floor(kept / 2))}`;
    if (fits(word)) return word;
  }
  return "";
}

// Stretches as bars of 4 px along both edges: the bridge to the lanes.
function drawEdgeBars(pen) {
  patterns.forEach((pattern, p) => {
    pen.fillStyle = patternColour(p);
    pen.globalAlpha = state.pattern === null || state.pattern === p ? 1 : 0.25;
    for (const { start, stop } of pattern.stretches) {
      const [from, length] = [xOf(start) + 0.5, Math.max(xOf(stop) - xOf(start) - 1, 1)];
      pen.fillRect(from, field.upper - 7, length, 4);
      pen.fillRect(field.left - 7, from - field.left + field.upper, 4, length);
    }
  });
  pen.globalAlpha = 1;
}

// What moves: the cross of now, or the two lines of a pair with their tags.
on("frame", () => {
  const pen = sized(field.top, field.box.clientWidth, field.box.clientHeight);
  const pair = pairOnShow();
  if (pair) drawPair(pen, pair);
  else drawCross(pen, state.time);
});

// Ink and ground of what lies over the cells.
const over = () => (field.shown.black ? { ink: "#ECEAE4", surface: "#101216" } : theme.tokens);

function strokeLine(pen, [x0, y0, x1, y1]) {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

function drawCross(pen, time) {
  const { shape } = field.shown;
  pen.strokeStyle = over().ink;
  pen.globalAlpha = 0.55;
  pen.lineWidth = 1;
  for (const line of shape.cross(time)) strokeLine(pen, line);
  pen.globalAlpha = 1;
  dotAt(pen, ...shape.place(time, time), true);
  const there = mirroredMoment(time);
  if (there === null) return;
  dotAt(pen, ...shape.place(there, there), false);
  ringAt(pen, ...shape.place(Math.min(time, there), Math.max(time, there)));
}

// Moment 1 is the row, solid; moment 2 the column, dashed; both meet at the cell and stand on the diagonal.
function drawPair(pen, { one, two }) {
  const { shape } = field.shown;
  const [first, second] = shape.pair(one, two);
  const cell = shape.place(one, two);
  pen.strokeStyle = over().ink;
  pen.lineWidth = 1.2;
  strokeLine(pen, first);
  pen.setLineDash([4, 3]);
  strokeLine(pen, second);
  pen.setLineDash([]);
  dotAt(pen, ...shape.place(one, one), true);
  dotAt(pen, ...shape.place(two, two), false);
  ringAt(pen, ...cell);
  if (shape !== SQUARE) {
    tagsBelow(pen, one, two);
    return;
  }
  momentTag(pen, "1", one, field.left - 10, cell[1], true);
  momentTag(pen, "2", two, cell[0], field.upper - 17, false);
}

function ringAt(pen, x, y) {
  const { ink, surface } = over();
  disc(pen, x, y, 6.5);
  for (const [width, colour] of [[4, surface], [1.8, ink]]) {
    pen.lineWidth = width;
    pen.strokeStyle = colour;
    pen.stroke();
  }
}

function dotAt(pen, x, y, solid) {
  disc(pen, x, y, 5.4);
  pen.fillStyle = over().surface;
  pen.fill();
  disc(pen, x, y, solid ? 4 : 3.6);
  pen.fillStyle = pen.strokeStyle = over().ink;
  pen.lineWidth = 1.6;
  if (solid) pen.fill();
  else pen.stroke();
}

// Tag 1 is filled and stands left of its row, tag 2 outlined and above its column.
function momentTag(pen, name, time, x, y, solid) {
  pen.font = `600 11.5px ${theme.font}`;
  const text = `${name} ${momentClock(time)}`;
  const width = pen.measureText(text).width + 12;
  const beside = solid && field.shown.shape === SQUARE;
  const left = beside ? Math.max(1, field.left - 7 - width) : clamp(x - width / 2, 1, field.box.clientWidth - width - 1);
  pen.beginPath();
  pen.roundRect(left, y - 9, width, 18, 5);
  pen.fillStyle = solid ? theme.tokens.ink : theme.tokens.surface;
  pen.fill();
  pen.strokeStyle = theme.tokens.ink;
  pen.lineWidth = 1.3;
  pen.stroke();
  pen.fillStyle = solid ? theme.tokens.surface : theme.tokens.ink;
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  pen.fillText(text, left + 6, y + 0.5);
}
