// The table of the view of symmetry: every stretch of every motif, those of folded lanes too.

const MOTIF_COLUMNS = ["Motif", "From", "To", "Again from", "To", "Lasts", "Parts", "Side", "Pattern", "Confidence"];

function motifTable() {
  if (!motifSpans.length) return make("div", "", [make("h2", "", "What was looked for"), make("p", "", symmetry.looked_for)]);
  const body = document.createElement("tbody");
  motifSpans.forEach((span, k) => {
    const lane = symmetry.lanes[span.lane];
    const button = make("button", "motif-name", span.plain, { type: "button", "data-span": String(k), "aria-label": span.name, title: lane.term });
    const [from, to] = span.partner ?? [null, null];
    const fields = span.partner ? 0 : span.marks.length - 1;
    const cells = [
      clockWord(span.start), clockWord(span.stop), from === null ? "–" : clockWord(from), to === null ? "–" : clockWord(to),
      `${(span.stop - span.start).toFixed(1)} s`, fields > 0 ? String(fields) : "–", span.side || "–",
    ].map((text) => make("td", "", text));
    cells.at(-1).title = span.sides;
    const letter = make("td", "", span.pattern === null ? "–" : chip(span.pattern));
    const row = make("tr", "", [make("td", "", button), ...cells, letter, make("td", "", span.confidence.toFixed(2), { title: span.reason })]);
    row.addEventListener("click", () => chooseSpan(k));
    body.append(row);
  });
  const head = make("thead", "", make("tr", "", MOTIF_COLUMNS.map((name) => make("th", "", name, { scope: "col" }))));
  return make("table", "", [head, body]);
}

on("change", () => {
  for (const button of $("table").querySelectorAll("[data-span]")) button.setAttribute("aria-pressed", state.span === Number(button.dataset.span));
});

function motifText() {
  const lines = [["motif", "term", "start_s", "stop_s", "partner_start_s", "partner_stop_s", "marks_s", "cyclic", "side", "left_share", "links", "pattern", "confidence", "reason"]];
  for (const span of motifSpans) {
    const { motif, term } = symmetry.lanes[span.lane];
    const seconds = [span.start, span.stop, ...(span.partner ?? [null, null])].map((time) => (time === null ? "" : time.toFixed(3)));
    const marks = span.marks.map((mark) => mark.toFixed(3)).join(" ");
    lines.push([motif, term, ...seconds, marks, span.cyclic ? 1 : 0, span.side, span.left_share === null ? "" : span.left_share.toFixed(3), span.links.join(" "), span.pattern === null ? "" : patterns[span.pattern].id, span.confidence.toFixed(3), span.reason]);
  }
  return csv(lines);
}
