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

function buildTable() {
  const box = $("table");
  const notes = payload.notes.length
    ? [make("div", "notes", [make("h2", "", "Notes"), ...payload.notes.map((note) => make("p", "", note))])]
    : [];
  if (!patterns.length) {
    box.classList.add("nothing");
    box.append(make("h2", "", "What was looked for"), make("p", "", payload.looked_for), ...notes);
    return;
  }
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
  box.append(make("table", "", [head, body]), ...notes);
}

on("change", () => {
  for (const button of $("table").querySelectorAll("button")) {
    const [p, k] = button.dataset.stretch.split(" ").map(Number);
    button.style.setProperty("--c", patternToken(p));
    button.setAttribute("aria-label", stretchLabel(p, k));
    button.setAttribute("aria-pressed", state.pattern === p);
    button.nextSibling.textContent = state.names[patterns[p].id] ? " " + state.names[patterns[p].id] : "";
  }
});
