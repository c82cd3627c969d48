// The way through the graph along the time line: states as blocks with their letters, paths between them.

if (graph) addGraphRow();

function addGraphRow() {
  const track = make("div", "track");
  const element = make("div", "row walk", [make("p", "row-head", ["The way through the graph"]), track], { role: "group", "aria-label": "The way through the graph" });
  const bars = graphItems.flatMap((item) => item.visits.map((visit, k) => {
    const bar = make("button", `visit ${item.kind}`, make("span", "", nameMarks(item)), { type: "button", "aria-label": visit.name, title: visit.name });
    bar.addEventListener("click", () => chooseItem(item.name, k));
    return { item, visit, k, bar };
  })).sort((a, b) => a.visit.start - b.visit.start);
  track.append(...bars.map(({ bar }) => bar));
  timeRows.push({
    order: 28,
    views: ["graph"],
    element,
    layout() {
      for (const { item, visit, bar } of bars) {
        const width = Math.max(across(visit.stop) - across(visit.start), item.kind === "state" ? 3 : 1);
        bar.style.left = across(visit.start) + "px";
        bar.style.width = width + "px";
        bar.firstChild.hidden = width < 8 + item.name.length * 6.5;
      }
    },
    change() {
      for (const { item, bar, k } of bars) {
        bar.classList.toggle("chosen", item.name === state.item);
        bar.classList.toggle("playing", item.name === state.item && k === state.visit);
      }
    },
  });
}
