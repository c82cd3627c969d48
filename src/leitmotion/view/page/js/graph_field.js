// The graph itself, where the matrix stands in the other views: states as cards, paths as curves, as the library laid
// them out. A click on either plays its times.

const graphField = { box: null, sheet: null, most: null, nodes: [], edges: [], scale: 1 };
const NAME_ROOM = 18; // pixels of a card for its name
const COMPACT = 56;
const HEAD_LENGTH = 7;
const LEAST_SCALE = 46; // pixels that a card is wide at least: what is larger than the field is scrolled

function buildGraphField() {
  if (!graph) return;
  const lines = document.createElementNS(SVG, "svg");
  lines.setAttribute("aria-hidden", "true");
  const axis = document.createElementNS(SVG, "path");
  axis.setAttribute("class", "axis");
  lines.append(axis);
  graphField.lines = lines;
  graphField.axis = axis;
  const box = make("div", "graph-field", [], { role: "group", "aria-label": "The graph of motion" });
  for (const item of graphItems.filter(({ kind }) => kind === "path")) {
    const group = document.createElementNS(SVG, "g");
    const [reach, line, heads] = ["reach", "line", "heads"].map((name) => {
      const made = document.createElementNS(SVG, "path");
      made.setAttribute("class", name);
      group.append(made);
      return made;
    });
    group.addEventListener("click", () => chooseItem(item.name));
    lines.append(group);
    const label = make("button", "edge-name", nameMarks(item), { type: "button", "aria-label": item.said, title: item.said });
    label.addEventListener("click", () => chooseItem(item.name));
    graphField.edges.push({ item, group, reach, line, heads, label });
  }
  for (const item of graphItems.filter(({ kind }) => kind === "state")) {
    const figure = document.createElement("canvas");
    const button = make("button", "node", [figure, make("span", "node-name", nameMarks(item))], { type: "button", "aria-label": item.said, title: item.said });
    button.addEventListener("click", () => chooseItem(item.name));
    graphField.nodes.push({ item, figure, button });
  }
  graphField.sheet = make("div", "graph-sheet", [lines, ...graphField.edges.map(({ label }) => label), ...graphField.nodes.map(({ button }) => button)]);
  box.append(graphField.sheet);
  graphField.box = box;
  $("matrix-card").append(box);
  if (mostVisited) buildMost();
}

// The line above a large graph: which part is drawn, and a button for the whole.
function buildMost() {
  const words = make("span", "");
  const button = make("button", "", [], { type: "button" });
  button.addEventListener("click", () => {
    state.whole = !state.whole;
    if (state.item !== null && !isItemDrawn(itemNamed(state.item))) clearItem();
    redraw("layout");
  });
  graphField.most = { line: make("p", "graph-most", [words, " ", button]), words, button };
  graphField.box.classList.add("of-many");
  $("matrix-card").append(graphField.most.line);
}

const isGraphShown = () => graph !== null && state.view === "graph";

function layGraph() {
  const { box, sheet, lines, most } = graphField;
  if (most) {
    most.words.textContent = state.whole ? "All postures and ways." : mostVisited.said;
    most.button.textContent = state.whole ? "Show the most visited" : "Show all";
  }
  const [left, top, right, bottom] = isAllDrawn() ? graph.box : mostVisited.box;
  const least = mostVisited ? LEAST_SCALE : 0;
  const scale = Math.max(Math.min(box.clientWidth / (right - left), box.clientHeight / (bottom - top), 110), least);
  const [width, height] = [Math.max(box.clientWidth, (right - left) * scale), Math.max(box.clientHeight, (bottom - top) * scale)];
  Object.assign(sheet.style, { width: width + "px", height: height + "px" });
  box.style.overflow = width > box.clientWidth || height > box.clientHeight ? "auto" : "";
  const x = (at) => (width - (right - left) * scale) / 2 + (at - left) * scale;
  const y = (at) => (height - (bottom - top) * scale) / 2 + (at - top) * scale;
  graphField.scale = scale;
  lines.setAttribute("viewBox", `0 0 ${width} ${height}`);
  graphField.axis.setAttribute("d", left < 0 && right > 0 ? `M${x(0)} ${y(top)} ${x(0)} ${y(bottom)}` : "");
  // On a small card the name stands in the corner, so that the figure has its height.
  const compact = scale < COMPACT;
  box.classList.toggle("compact", compact);
  const name = clamp(scale * 0.2, 11.5, 15);
  box.style.setProperty("--name", name + "px");
  const [wide, high] = graph.card.map((length) => length * scale);
  for (const { item, figure, button } of graphField.nodes) {
    const at = drawnPlace(item)?.at;
    if (!at) continue;
    Object.assign(button.style, { left: x(at[0]) - wide / 2 + "px", top: y(at[1]) - high / 2 + "px", width: wide + "px", height: high + "px" });
    const room = Math.max(high - (compact ? 0 : NAME_ROOM) - 4, 10);
    const pen = sized(figure, wide - 6, room);
    if (item.key !== null) drawSmall(pen, item.key, { x: (wide - 6) / 2, base: room - 2, height: room - 4, width: wide - 10, row: true, mirrored: item.mirrored });
  }
  for (const { item, reach, line, heads, label } of graphField.edges) {
    const place = drawnPlace(item);
    if (!place) continue;
    const points = place.curve.map(([a, b]) => [x(a), y(b)]);
    const text = (list) => list.map((point) => point.map((v) => v.toFixed(1)).join(" ")).join(" ");
    const d = `M${text([points[0]])} C${text(points.slice(1))}`;
    reach.setAttribute("d", d);
    line.setAttribute("d", d);
    heads.setAttribute("d", arrowHead(points[3], points[2]) + (item.reversible ? arrowHead(points[0], points[1]) : ""));
    Object.assign(label.style, { left: x(place.at[0]) + "px", top: y(place.at[1]) + "px" });
  }
}

// A filled head at the end of a curve, pointing as the curve does there.
function arrowHead([x, y], [fromX, fromY]) {
  const long = Math.hypot(x - fromX, y - fromY) || 1;
  const [dx, dy] = [((x - fromX) / long) * HEAD_LENGTH, ((y - fromY) / long) * HEAD_LENGTH];
  return `M${x} ${y} ${x - dx - dy * 0.42} ${y - dy + dx * 0.42} ${x - dx + dy * 0.42} ${y - dy - dx * 0.42}Z`;
}

on("layout", () => {
  if (!graphField.box) return;
  graphField.box.hidden = !isGraphShown();
  if (graphField.most) graphField.most.line.hidden = !isGraphShown();
  if (!isGraphShown()) return;
  $("matrix-title").textContent = "Postures, and the ways between them";
  layGraph();
});

function markGraph() {
  const held = itemAt(shownTime());
  for (const { item, group, label } of graphField.edges) {
    group.classList.toggle("now", held === item);
    label.classList.toggle("now", held === item);
  }
  for (const { item, button } of graphField.nodes) button.classList.toggle("now", held === item);
}

on("change", () => {
  if (!isGraphShown()) return;
  const chosen = state.item !== null;
  if (chosen && !isItemDrawn(itemNamed(state.item))) {
    state.whole = true;
    layGraph();
  }
  graphField.box.classList.toggle("choosing", chosen);
  for (const { item, group, label } of graphField.edges) {
    const classes = { reflected: isReflected(item), chosen: item.name === state.item };
    for (const element of [group, label]) {
      for (const [name, on] of Object.entries(classes)) element.classList.toggle(name, on);
      element.classList.toggle("gone", !isItemDrawn(item));
    }
    label.setAttribute("aria-pressed", item.name === state.item);
    label.hidden = !isItemDrawn(item);
  }
  for (const { item, button } of graphField.nodes) {
    button.classList.toggle("reflected", isReflected(item));
    button.setAttribute("aria-pressed", item.name === state.item);
    button.hidden = !isItemDrawn(item);
  }
});

on("frame", () => {
  if (!isGraphShown()) return;
  markGraph();
  const mirrored = overlaidOn(shownTime()).some((moment) => moment.mirrored);
  $("mirror-note").hidden = !mirrored;
  if (!mirrored) return;
  $("mirror-words").textContent = "mirrored";
  $("mirror-note").firstChild.style.setProperty("--c", "var(--mirror)");
});
