// The views of the page: a tab, an answer, a matrix and rows of the time line each. Another one is added by another file
// that pushes it here; a row of the time line or a table belongs to the views that it names.

const views = [
  { id: "repeats", tab: $("tab-repeats"), title: payload.title, lead: payload.lead, ready: true },
  {
    id: "symmetry", tab: $("tab-symmetry"), title: payload.symmetry?.title, lead: payload.symmetry?.lead,
    ready: symmetry !== null, none: payload.symmetry?.none,
  },
];
const viewNow = () => views.find((view) => view.id === state.view);

function showView(id) {
  const view = views.find((each) => each.id === id);
  if (!view.ready) {
    sayAtOnce(view.none);
    showTip(view.tab, view.none);
    setTimeout(() => showTip(null), 4000);
    return;
  }
  if (state.view === id) {
    showLesson(false);
    return;
  }
  pause();
  showTip(null);
  if (state.take !== null) state.pattern = null;
  Object.assign(state, { view: id, span: null, item: null, visit: 0, pointed: null, lesson: false, take: null, stripe: null, hover: null, curve: null });
  // A pair of moments belongs to a matrix.
  if (id === "graph") Object.assign(state, { held: false, second: null });
  keepHash();
  redraw("layout");
}

function buildViews() {
  for (const view of views) {
    if (!view.tab) {
      view.tab = make("button", "", view.name, { type: "button", id: `tab-${view.id}` });
      document.querySelector(".tabs").append(view.tab);
    }
    view.tab.hidden = several && view.id !== "repeats";
    if (!view.ready) {
      view.tab.setAttribute("aria-disabled", "true");
      view.tab.title = view.none;
    }
    view.tab.addEventListener("click", () => showView(view.id));
  }
}

on("layout", () => {
  root.dataset.view = state.view;
  const { title, lead } = viewNow();
  if ($("title").textContent === title && $("lead").dataset.view === state.view) return;
  $("title").textContent = title;
  document.title = `${title} · ${payload.source.name}`;
  $("lead").dataset.view = state.view;
  $("lead").replaceChildren(...lead.map((piece) => (piece.chip ? chip(patterns.findIndex((p) => p.id === piece.chip)) : piece)));
});
on("change", () => {
  for (const { id, tab } of views) tab.setAttribute("aria-pressed", state.view === id && !(id === "repeats" && state.lesson));
});
