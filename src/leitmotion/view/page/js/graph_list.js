// The list of states and paths: in the place of the panel where there is room, else a card of its own.

const graphList = { element: $("graph"), rows: [], images: null };

function buildGraphList() {
  if (!graph) {
    graphList.element.remove();
    return;
  }
  const list = (kind) => make("ol", "items", graphItems.filter((item) => item.kind === kind).map(buildItem));
  graphList.images = make("button", "toggle", [], { type: "button", title: "With mirror images: I" });
  graphList.images.innerHTML = '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1 5.5 4 8.5 9 1.5" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>';
  graphList.images.append("With mirror images");
  graphList.images.addEventListener("click", toggleImages);
  graphList.element.append(
    make("div", "graph-head", [make("h2", "", "Play a posture or a way", { id: "graph-title" }), make("p", "", "All its times lie over one another, in step; the solid one is at its place in time.")]),
    make("div", "graph-items", [make("h3", "", "Postures"), list("state"), make("h3", "", "Ways"), list("path")]),
    ...(hasImages ? [make("div", "graph-bar", graphList.images)] : []),
  );
  graphList.element.setAttribute("aria-labelledby", "graph-title");
}

function buildItem(item) {
  const arrow = item.arrow ? ` ${item.arrow}` : "";
  const head = make("button", "item", [make("b", "", nameMarks(item)), make("span", "", arrow), make("small", "", item.times)], { type: "button", "aria-label": `${item.said}. Play.` });
  head.addEventListener("click", () => chooseItem(item.name));
  const times = make("ol", "times", []);
  const row = make("li", isReflected(item) ? "reflected" : "", [head, times]);
  graphList.rows.push({ item, head, times, row });
  return row;
}

// Each time of the chosen one as a button; mirrored ones say so.
function fillTimes(item, list) {
  const shown = timesOf(item);
  list.replaceChildren(...shown.map((visit, k) => {
    const words = [momentClock(visit.start), visit.back ? "back" : "", visit.mirrored ? "mirrored" : ""].filter(Boolean).join(" ");
    const label = `${visit.name}${visit.mirrored ? ", mirrored" : ""}`;
    const button = make("button", "time", words, { type: "button", "aria-label": label, "aria-pressed": String(k === state.visit), "data-visit": String(k) });
    button.addEventListener("click", () => chooseItem(item.name, k));
    return make("li", "", button);
  }));
}

function placeGraphList() {
  const shown = isGraphShown() && !state.printing;
  graphList.element.hidden = !shown;
  panel.element.hidden = panel.element.hidden || (shown && wide.matches);
  const home = wide.matches ? document.querySelector(".scene") : document.querySelector("main");
  if (graphList.element.parentNode === home) return;
  if (wide.matches) home.append(graphList.element);
  else home.insertBefore(graphList.element, $("timeline"));
}

if (graph) {
  on("layout", placeGraphList);
  on("frame", placeGraphList);
  on("change", () => {
    if (!isGraphShown()) return;
    graphList.images.setAttribute("aria-pressed", state.images);
    for (const { item, head, times, row } of graphList.rows) {
      const chosen = item.name === state.item;
      row.hidden = !isItemShown(item);
      head.setAttribute("aria-expanded", chosen);
      times.hidden = !chosen;
      if (chosen) refillTimes(item, times);
      else times.replaceChildren();
    }
  });
}

// The buttons stay while the times do, so that the focus stays.
function refillTimes(item, list) {
  const buttons = [...list.querySelectorAll("button")];
  if (buttons.length !== timesOf(item).length) fillTimes(item, list);
  else buttons.forEach((button, k) => button.setAttribute("aria-pressed", k === state.visit));
}

const GRAPH_LESSONS = [
  ["On the line: its own mirror image. Beside it: each other’s", '<path class="axis" d="M41 4V78"/><rect x="33" y="8" width="16" height="22" rx="3"/><rect x="8" y="50" width="16" height="22" rx="3"/><rect x="58" y="50" width="16" height="22" rx="3"/>'],
  ["Two heads: gone there and back the same way", '<path d="M14 41H68"/><path class="head" d="M8 41 18 36V46ZM74 41 64 36V46Z"/>'],
  ["Dotted: a mirror image that nobody performed", '<path class="dotted" d="M10 60Q41 8 66 52"/><path class="head" d="M70 60 61 53 70 48Z"/>'],
];

function graphLessons() {
  return GRAPH_LESSONS.map(([text, shapes]) => {
    const box = make("div", "", [make("span", ""), make("p", "", text)]);
    box.firstChild.innerHTML = `<svg class="graph-lesson" viewBox="0 0 82 82" aria-hidden="true">${shapes}</svg>`;
    return box;
  });
}
