// Sheets that open beside their button and close with Escape or a click elsewhere; none of them blocks the page.

const SVG = "http://www.w3.org/2000/svg";
const LESSONS = [
  ["A stripe: this movement again, later", [["M43 8 70 36", "A", 3]]],
  ["Even stripes: a cycle, one per repeat", [["M16 0 82 66", "C", 3], ["M32 0 82 50", "C", 3], ["M48 0 82 34", "C", 3], ["M63 0 82 19", "C", 3]]],
  ["A block: the body keeps still", []],
];

const MIRROR_LESSONS = [
  ["Cyan between the red: the sides alternate", [["M0 0 82 82", "#FF4C42"], ["M20 0 82 62", "#10C8D6"], ["M41 0 82 41", "#FF4C42"], ["M62 0 82 20", "#10C8D6"], ["M0 20 62 82", "#10C8D6"], ["M0 41 41 82", "#FF4C42"], ["M0 62 20 82", "#10C8D6"]]],
  ["White: both sides move together", [["M0 0 82 82", "#FFFFFF"], ["M41 0 82 41", "#FFFFFF"], ["M0 41 41 82", "#FFFFFF"]]],
  ["Lines across: out, and back the same way", [["M0 0 82 82", "#FF4C42"], ["M10 40 40 10", "#FF4C42"], ["M42 72 72 42", "#FF4C42"]]],
];

function mirrorLessons() {
  return MIRROR_LESSONS.map(([text, lines]) => {
    const shapes = lines.map(([d, colour]) => `<path d="${d}" stroke="${colour}" stroke-width="4"/>`).join("");
    const box = make("div", "", [make("span", ""), make("p", "", text)]);
    box.firstChild.innerHTML = `<svg class="black" viewBox="0 0 82 82" aria-hidden="true">${shapes}</svg>`;
    return box;
  });
}

function lessons() {
  return LESSONS.map(([text, lines], k) => {
    const picture = document.createElementNS(SVG, "svg");
    picture.setAttribute("viewBox", "0 0 82 82");
    picture.setAttribute("aria-hidden", "true");
    const draw = (tag, attributes, style) => {
      const shape = document.createElementNS(SVG, tag);
      for (const [name, value] of Object.entries(attributes)) shape.setAttribute(name, value);
      Object.assign(shape.style, style);
      picture.append(shape);
    };
    draw("path", { d: "M0 0 82 82" }, { stroke: "var(--ink)", strokeWidth: "2.2" });
    if (k === 2) draw("rect", { x: 24, y: 24, width: 33, height: 33 }, { fill: "var(--ink3)", opacity: ".8" });
    for (const [d, token, width] of lines) draw("path", { d }, { stroke: `var(--${token})`, strokeWidth: String(width), fill: "none" });
    return make("div", "", [picture, make("p", "", text)]);
  });
}

const KEYS = () => [
  ["space", "play or pause"], ["← →", "one frame"], ["shift ← →", "one second"], ["A–H", "choose a pattern"],
  ...(several ? [] : [["M", "repeats or symmetry"]]),
  ["L", several ? "the movements, or most like now" : "the lesson"], ["N P", symmetry ? "in it, in symmetry and in the graph: next, previous" : "in it: next, previous"],
  ...(graph ? [["G", "repeats or graph"], ["A–Z", "in the graph: choose a posture, with shift its mirror image"], ...(hasImages ? [["I", "in it: with mirror images"]] : [])] : []),
  ...(several ? [["shift N P", "compare with the next, the previous"], ["S", "side by side or overlaid"], ["T", "in step, or each at its own pace"]] : []),
  ["R", "in it: loop this one"],
  ["Esc", "clear the choice or the pair"], ["[ ]", "slower, faster"], ["1 2 3 4", "camera"],
  ["arrows", "on the matrix: move the cell; Enter holds it"], ["F2", several ? "on a movement: name it" : "on a lane: name the pattern"], ["?", "this help"],
];

function buildHelp() {
  const list = make("dl", "", KEYS().flatMap(([keys, what]) => [make("dt", "", keys.split(" ").map((key) => make("kbd", "", key))), make("dd", "", what)]));
  $("help-sheet").append(
    make("h2", "", "How to read the matrix"), make("div", "lessons", lessons()), make("h2", "", "Keys"), list,
    make("p", "private", "A solid line is moment 1, a dashed one moment 2. Drag along a stripe to play the two together. This page is one file: nothing in it leaves your machine."),
  );
  $("lessons").append(...lessons());
}

on("layout", () => {
  const shown = { symmetry: mirrorLessons, graph: graphLessons }[state.view] ?? lessons;
  $("reading-title").textContent = $("help-sheet").firstChild.textContent = `How to read the ${state.view === "graph" ? "graph" : "matrix"}`;
  for (const box of [$("lessons"), $("help-sheet").querySelector(".lessons")]) {
    if (box.dataset.view !== state.view) box.replaceChildren(...shown());
    box.dataset.view = state.view;
  }
});

const sheets = { open: null };
function openSheet(sheet, button) {
  const again = sheets.open && sheets.open.sheet === sheet;
  closeSheet();
  if (again) return;
  sheet.hidden = false;
  button.setAttribute("aria-expanded", "true");
  sheets.open = { sheet, button };
  const box = button.getBoundingClientRect();
  const width = sheet.offsetWidth;
  sheet.style.left = clamp(box.right - width, 12, Math.max(root.clientWidth - width - 12, 12)) + scrollX + "px";
  sheet.style.top = box.bottom + 6 + scrollY + "px";
  const first = sheet.querySelector("button");
  if (first) first.focus({ preventScroll: true });
}

function closeSheet() {
  if (!sheets.open) return false;
  const { sheet, button } = sheets.open;
  const inside = sheet.contains(document.activeElement);
  sheet.hidden = true;
  button.setAttribute("aria-expanded", "false");
  sheets.open = null;
  if (inside) button.focus({ preventScroll: true });
  return true;
}

document.addEventListener("pointerdown", (event) => {
  if (!sheets.open) return;
  const { sheet, button } = sheets.open;
  if (!sheet.contains(event.target) && !button.contains(event.target)) closeSheet();
});

const menuButton = (text, act) => {
  const button = make("button", "", text, { type: "button" });
  button.addEventListener("click", () => {
    closeSheet();
    act();
  });
  return button;
};

const toggleHelp = () => openSheet($("help-sheet"), $("help").offsetParent ? $("help") : $("more"));
