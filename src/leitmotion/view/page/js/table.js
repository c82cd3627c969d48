// The table holds everything the lanes show.

const COLUMNS = ["Pattern", ...(several ? ["Recording"] : []), "From", "To", "Lasts", "Cycles", "One cycle", "Confidence"];

// As the heads of the lanes: the median, so that one cycle cut short does not tell.
function median(lengths) {
  const sorted = [...lengths].sort((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

function tableRows() {
  return patterns.flatMap((pattern, p) =>
    pattern.stretches.map((stretch, k) => {
      const cycles = stretch.cycles.length;
      return { p, k, pattern, stretch, cycles, cycle: median(stretch.cycles.map(([a, b]) => b - a)) };
    }),
  );
}

// Another view has another table; the notes belong to all.
const tables = { repeats: patternTable, symmetry: motifTable };

function buildTable() {
  const box = $("table");
  const notes = payload.notes.length
    ? [make("div", "notes", [make("h2", "", "Notes"), ...payload.notes.map((note) => make("p", "", note))])]
    : [];
  for (const [view, table] of Object.entries(tables)) {
    if (view === "symmetry" && !symmetry) continue;
    const part = table();
    part.dataset.view = view;
    box.append(part);
  }
  box.append(...notes);
}

on("layout", () => {
  const parts = [...$("table").querySelectorAll("[data-view]")];
  const shown = parts.find((part) => part.dataset.view === state.view) ?? parts[0];
  for (const part of parts) part.hidden = part !== shown;
  $("table").classList.toggle("nothing", shown.tagName !== "TABLE");
});

function patternTable() {
  if (!patterns.length) return make("div", "", [make("h2", "", "What was looked for"), make("p", "", payload.looked_for)]);
  const body = document.createElement("tbody");
  for (const { p, k, pattern, stretch, cycles, cycle } of tableRows()) {
    const button = chip(p, "button");
    button.type = "button";
    button.dataset.stretch = `${p} ${k}`;
    const cells = [
      ...(several ? [partOf(stretch.start).name] : []), momentClock(stretch.start), clockWord(stretch.stop - partOf(stretch.start).start), `${(stretch.stop - stretch.start).toFixed(1)} s`,
      cycles || "–", cycles ? `${cycle.toFixed(2)} s` : "–", pattern.confidence.toFixed(2),
    ].map((text) => make("td", "", String(text)));
    cells.at(-1).title = pattern.reason;
    const row = make("tr", "", [make("td", "", [button, make("span", "given-name", "")]), ...cells]);
    row.addEventListener("click", () => choosePattern(p, k));
    body.append(row);
  }
  const head = make("thead", "", make("tr", "", COLUMNS.map((name) => make("th", "", name, { scope: "col" }))));
  return make("table", "", [head, body]);
}

on("change", () => {
  for (const button of $("table").querySelectorAll("button[data-stretch]")) {
    const [p, k] = button.dataset.stretch.split(" ").map(Number);
    button.style.setProperty("--c", patternToken(p));
    button.setAttribute("aria-label", stretchLabel(p, k));
    button.setAttribute("aria-pressed", state.pattern === p);
    button.nextSibling.textContent = state.names[patterns[p].id] ? " " + state.names[patterns[p].id] : "";
  }
});
