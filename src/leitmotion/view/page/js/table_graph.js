// The table of the view of the graph: every time of every state and path, in the order of time.

const GRAPH_COLUMNS = ["Posture or way", "From", "To", "Lasts", "Direction"];

const graphVisits = graphItems
  .flatMap((item) => item.visits.map((visit, k) => ({ item, visit, k })))
  .sort((a, b) => a.visit.start - b.visit.start || a.visit.stop - b.visit.stop);

function graphTable() {
  const body = document.createElement("tbody");
  for (const { item, visit, k } of graphVisits) {
    const button = make("button", "motif-name", nameMarks(item), { type: "button", "data-item": item.name, "aria-label": visit.name });
    const direction = item.kind === "state" ? "–" : visit.back ? "back" : "there";
    const cells = [clockWord(visit.start), clockWord(visit.stop), `${(visit.stop - visit.start).toFixed(2)} s`, direction].map((text) => make("td", "", text));
    const row = make("tr", "", [make("td", "", button), ...cells]);
    row.addEventListener("click", () => chooseItem(item.name, k));
    body.append(row);
  }
  const head = make("thead", "", make("tr", "", GRAPH_COLUMNS.map((name) => make("th", "", name, { scope: "col" }))));
  return make("table", "", [head, body]);
}

if (graph) tables.graph = graphTable;

on("change", () => {
  for (const button of $("table").querySelectorAll("[data-item]")) button.setAttribute("aria-pressed", state.item === button.dataset.item);
});

function graphText() {
  const lines = [["name", "kind", "source", "target", "start_s", "stop_s", "direction"]];
  for (const { item, visit } of graphVisits) {
    lines.push([item.name, item.kind, item.source ?? "", item.target ?? "", visit.start.toFixed(3), visit.stop.toFixed(3), item.kind === "state" ? "" : visit.back ? "back" : "there"]);
  }
  return csv(lines);
}
