// Save: the address of this view, the table, the pictures. Files are made in the page, from memory.

const fileStem = payload.source.name.replace(/[^\w.-]+/g, "_");

function download(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function csv(lines) {
  const quote = (value) => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
  return lines.map((line) => line.map(quote).join(",")).join("\r\n") + "\r\n";
}

function tableText() {
  const lines = [["pattern", "name", ...(several ? ["recording"] : []), "stretch", "start_s", "stop_s", "cycles", "cycle_s", "confidence", "reason"]];
  for (const { pattern, stretch, k, cycles, cycle } of tableRows()) {
    const name = state.names[pattern.id] || "";
    const part = partOf(stretch.start);
    const times = [stretch.start, stretch.stop].map((time) => (time - part.start).toFixed(3));
    lines.push([pattern.id, name, ...(several ? [part.name] : []), k + 1, ...times, cycles, cycles ? cycle.toFixed(3) : "", pattern.confidence.toFixed(3), pattern.reason]);
  }
  return csv(lines);
}

const isTable = () => ({ symmetry: motifSpans, graph: graphItems }[state.view] ?? patterns).length > 0;

// Flatten layers onto the surface, at the density at which they are drawn.
function picture(name, ...layers) {
  const flat = document.createElement("canvas");
  flat.width = layers[0].width;
  flat.height = layers[0].height;
  const pen = flat.getContext("2d");
  pen.fillStyle = theme.tokens.surface;
  pen.fillRect(0, 0, flat.width, flat.height);
  for (const layer of layers) pen.drawImage(layer, 0, 0);
  flat.toBlob((blob) => download(`${fileStem}-${name}.png`, blob));
}

async function copyAddress() {
  writeHash();
  let copied = true;
  try {
    await navigator.clipboard.writeText(location.href);
  } catch {
    const field = make("textarea", "hear", location.href);
    document.body.append(field);
    field.select();
    copied = document.execCommand("copy");
    field.remove();
  }
  $("live").textContent = copied ? "The address of this view is copied." : "The address of this view stands in the address bar.";
  showTip($("save").offsetParent ? $("save") : $("more"), $("live").textContent);
  setTimeout(() => showTip(null), 1800);
}

const SAVES = [
  ["Copy the address of this view", copyAddress],
  ["Table (CSV)", () => {
    const [name, text] = { symmetry: ["motifs", motifText], graph: ["graph", graphText] }[state.view] ?? ["stretches", tableText];
    download(`${fileStem}-${name}.csv`, new Blob([text()], { type: "text/csv" }));
  }],
  ["Figure (PNG)", () => picture("figure", stage.canvas)],
  ["Matrix (PNG)", () => picture("matrix", field.base, field.top)],
  ["Print or save as PDF", () => print()],
];

function buildSaves() {
  const offered = () => SAVES.map(([name, act]) => Object.assign(menuButton(name, act), { isTable: name.startsWith("Table"), isMatrix: name.startsWith("Matrix") }));
  $("save-sheet").append(...offered());
  $("more-sheet").append(menuButton("How to read this", toggleHelp), ...offered());
  on("layout", () => {
    for (const id of ["save-sheet", "more-sheet"]) for (const button of $(id).children) button.hidden = (Boolean(button.isTable) && !isTable()) || (Boolean(button.isMatrix) && state.view === "graph");
  });
  for (const id of ["save-sheet", "more-sheet"]) $(id).classList.add("menu");
}
