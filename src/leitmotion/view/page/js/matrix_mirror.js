// The matrix of symmetry: red where a moment is like another, cyan where it is like its mirror image, added on black; in
// a square, or the half above the diagonal turned so that time runs right along it and moments meet above their middle.

const [RED, CYAN, BLACK] = [[255, 76, 66], [16, 200, 214], [16, 18, 22]];
const UNKNOWN = [44, 49, 57];
const MIRROR_LEGEND = [["like itself", "#FF4C42"], ["like its mirror image", "#10C8D6"], ["both", "#FFFFFF"]];

function paintLikenesses(pixels) {
  const { own, mirror, cells } = twoLikenesses;
  const table = new Uint32Array(255 * 255);
  for (let o = 0; o < 255; o++) {
    for (let m = 0; m < 255; m++) {
      const [r, g, b] = RED.map((v, k) => Math.min(Math.max(Math.round((v * o + CYAN[k] * m) / 254), BLACK[k]), 255));
      table[o * 255 + m] = (255 << 24) | (b << 16) | (g << 8) | r;
    }
  }
  const unknown = (255 << 24) | (UNKNOWN[2] << 16) | (UNKNOWN[1] << 8) | UNKNOWN[0];
  for (let i = 0; i < cells; i++) {
    for (let j = 0; j < cells; j++) {
      const [o, m] = [own(i, j), mirror(i, j)];
      pixels[i * cells + j] = o === 255 || m === 255 ? unknown : table[o * 255 + m];
    }
  }
}

function mirrorLegend(legend) {
  const discs = MIRROR_LEGEND.map(([word, colour]) => {
    const mark = make("i", "disc");
    mark.style.setProperty("--disc", colour);
    return make("span", "", [mark, word]);
  });
  legend.replaceChildren(...discs, make("span", "half", symmetry.half));
}

// The chosen stretch and the one pointed at are outlined where they meet themselves or their partner.
function outlineSpans(pen) {
  const { shape } = field.shown;
  for (const [k, width] of [[state.span, 1.6], [state.pointed, 1.2]]) {
    if (k === null) continue;
    const { start, stop, partner } = motifSpans[k];
    const [from, to] = partner ?? [start, stop];
    const corners = partner || shape === SQUARE ? [[start, from], [start, to], [stop, to], [stop, from]] : [[start, start], [start, stop], [stop, stop]];
    pen.beginPath();
    corners.forEach(([one, two], n) => (n ? pen.lineTo(...shape.place(one, two)) : pen.moveTo(...shape.place(one, two))));
    pen.closePath();
    pen.lineWidth = width + 2;
    pen.strokeStyle = "#101216";
    pen.stroke();
    pen.lineWidth = width;
    pen.strokeStyle = "#ECEAE4";
    pen.stroke();
  }
}

const triangleBase = () => field.upper + field.side / 2 - 24;
const SPEED_HEIGHT = 84;

const TRIANGLE = {
  id: "triangle",
  place(one, two) {
    const scale = field.side / clip.seconds / 2;
    return [field.left + (one + two) * scale, triangleBase() - (two - one) * scale];
  },
  cell(x, y) {
    const scale = clip.seconds / field.side;
    const [middle, apart] = [(x - field.left) * scale, (triangleBase() - y) * 2 * scale];
    if (apart < 0 && !pointing.down) return [-1, -1];
    return [middle - Math.max(apart, 0) / 2, middle + Math.max(apart, 0) / 2];
  },
  cross: (time) => [[time, clip.seconds], [0, time]].map(([one, two]) => [...TRIANGLE.place(time, time), ...TRIANGLE.place(one, two)]),
  pair: (one, two) => [one, two].map((time) => [...TRIANGLE.place(time, time), ...TRIANGLE.place(one, two)]),
  draw(pen) {
    pen.save();
    pen.beginPath();
    for (const [one, two] of [[0, 0], [0, clip.seconds], [clip.seconds, clip.seconds]]) pen.lineTo(...TRIANGLE.place(one, two));
    pen.closePath();
    pen.clip();
    // The column goes right and up, the row right and down: the diagonal lies level.
    pen.transform(0.5, -0.5, 0.5, 0.5, field.left, triangleBase());
    pen.drawImage(bitmap, 0, 0, field.side, field.side);
    pen.restore();
    drawAxisSpeed(pen);
  },
  axes(pen) {
    const step = tickStep(field.side > 500 ? 8.2 : 6.2);
    pen.font = `11.5px ${theme.font}`;
    pen.fillStyle = theme.tokens.ink2;
    pen.textBaseline = "alphabetic";
    for (let time = 0; time < clip.seconds * 0.985; time += step) {
      pen.textAlign = time ? "center" : "left";
      pen.fillText(time || step >= 60 ? tickWord(time, step) : "0 s", xOf(time), triangleBase() + 17);
    }
    drawEdgeSpans(pen);
  },
};

// Patterns as bars of 4 px under the identity axis, as they stand along the edges of the square.
function drawEdgeSpans(pen) {
  patterns.forEach((pattern, p) => {
    pen.fillStyle = patternColour(p);
    pen.globalAlpha = state.pattern === null || state.pattern === p ? 1 : 0.25;
    for (const { start, stop } of pattern.stretches) pen.fillRect(xOf(start) + 0.5, triangleBase() + 23, Math.max(xOf(stop) - xOf(start) - 1, 1), 4);
  });
  pen.globalAlpha = 1;
}

// The wider the identity axis, the slower the body: its speed as a curve beneath, and where it keeps still as bars.
function drawAxisSpeed(pen) {
  const top = triangleBase() + 50;
  const { values, most } = axisSpeed;
  pen.font = `11.5px ${theme.font}`;
  pen.textAlign = "left";
  pen.textBaseline = "alphabetic";
  pen.fillStyle = theme.tokens.ink2;
  pen.fillText(`speed, from the width of the axis; to ${most} °/s a link`, field.left, top - 5);
  pen.beginPath();
  pen.moveTo(field.left, top + SPEED_HEIGHT);
  values.forEach((value, k) => pen.lineTo(xOf((k + 0.5) / twoLikenesses.rate), top + SPEED_HEIGHT * (1 - value / 254)));
  pen.lineTo(field.left + field.side, top + SPEED_HEIGHT);
  pen.fillStyle = theme.tokens.sunken;
  pen.fill();
  pen.lineWidth = 1.1;
  pen.strokeStyle = theme.tokens.ink2;
  pen.stroke();
  pen.fillStyle = theme.tokens.ink;
  for (const [start, stop] of symmetry.still) pen.fillRect(xOf(start), top + SPEED_HEIGHT + 3, Math.max(xOf(stop) - xOf(start), 1), 4);
  if (symmetry.still.length) {
    pen.fillStyle = theme.tokens.ink2;
    pen.fillText("still", field.left - 30, top + SPEED_HEIGHT + 9);
  }
}

// Where two moments meet, their times stand under the axis.
function tagsBelow(pen, one, two) {
  const middle = Math.max((TAG_WIDTH - Math.abs(xOf(two) - xOf(one))) / 2, 0);
  momentTag(pen, "1", one, xOf(one) - middle, triangleBase() + 12, true);
  momentTag(pen, "2", two, xOf(two) + middle, triangleBase() + 12, false);
}

if (symmetry) {
  const shared = {
    view: "symmetry", title: "Like itself, like its mirror image", foot: 54, black: true,
    cells: () => twoLikenesses.cells, paint: paintLikenesses, legend: mirrorLegend, over: outlineSpans,
  };
  matrices.push({ ...shared, id: "mirror", shape: SQUARE }, { ...shared, id: "mirror-triangle", shape: TRIANGLE });
}

function buildForms() {
  if (!symmetry) return;
  const shapes = [["square", "M2 2h10v10H2z"], ["triangle", "M1 10 7 3.5 13 10z"]];
  for (const [form, d] of shapes) {
    const button = make("button", "", [], { type: "button", "data-form": form, "aria-label": form === "square" ? "Square" : "Triangle", title: form === "square" ? "Square" : "Triangle: time runs along the diagonal" });
    button.innerHTML = `<svg viewBox="0 0 14 14" width="13" height="13" aria-hidden="true"><path d="${d}" fill="none" stroke="currentColor" stroke-width="1.5" stroke-linejoin="round"/></svg>`;
    button.addEventListener("click", () => {
      state.form = form;
      keepHash();
      redraw("layout");
    });
    $("forms").append(button);
  }
}

on("layout", () => ($("forms").hidden = state.view !== "symmetry"));
on("change", () => {
  for (const button of $("forms").children) button.setAttribute("aria-pressed", button.dataset.form === state.form);
});
// What the ghost is stands beside the sides.
on("frame", () => {
  const note = $("mirror-note");
  note.hidden = state.view !== "symmetry" || !state.ghost || Boolean(pairOnShow());
  if (note.hidden) return;
  const { words, mirrored, time } = mirrorMoment(shownTime());
  const word = words.replace("then", `at ${momentClock(time)}`);
  if ($("mirror-words").textContent !== word) $("mirror-words").textContent = word;
  note.firstChild.style.setProperty("--c", mirrored ? "var(--mirror)" : "var(--ink2)");
});
