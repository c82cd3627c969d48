// Lanes: one a pattern, with a bar a stretch and a field a cycle; bars and heads are real buttons.

const LANES_SHOWN = 6;
const lanes = [];

(() => {
  if (!patterns.length) {
    timeRows.push({ order: 35, views: ["repeats"], element: make("div", "row empty", make("p", "", payload.empty)) });
    return;
  }
  if (several) return;
  const element = make("div", "row lanes", [], { role: "group", "aria-label": "Patterns" });
  patterns.forEach((pattern, p) => {
    const lane = buildLane(pattern, p);
    lanes.push(lane);
    element.append(lane.element);
  });
  timeRows.push({
    order: 30,
    views: ["repeats", "graph"],
    element,
    layout() {
      element.style.maxHeight = lanes.length > LANES_SHOWN ? lanes[0].element.offsetHeight * LANES_SHOWN + "px" : "";
      // A lane is as wide as the time line even where a scroll bar stands, so that the x scale stays one.
      for (const lane of lanes) lane.element.style.width = timeline.element.clientWidth + "px";
      lanes.forEach((lane) => lane.layout());
    },
    change() {
      element.classList.toggle("dimmed", state.pattern !== null);
      lanes.forEach((lane) => lane.change());
    },
    frame() {
      lanes.forEach((lane) => lane.frame());
    },
  });
})();

function buildLane(pattern, p) {
  const figure = document.createElement("canvas");
  const [first, second] = [make("strong", ""), make("small", "")];
  const head = make("button", "lane-head", [chip(p), figure, make("span", "", [first, " ", second])], { type: "button" });
  const track = make("div", "track");
  const element = make("div", "lane", [head, track]);
  element.classList.toggle("unsure", pattern.confidence < 0.5);
  head.addEventListener("click", (event) => event.detail < 2 && choosePattern(p));
  head.addEventListener("dblclick", () => {
    // The first of the two clicks chose it.
    if (state.pattern === p) clearPattern();
    renameLane(p, element);
  });
  head.addEventListener("keydown", (event) => {
    if (event.key !== "F2" && !(event.key === "Enter" && event.shiftKey)) return;
    event.preventDefault();
    renameLane(p, element);
  });
  const bars = pattern.stretches.map((stretch, k) => {
    const bar = make("button", "stretch", [], { type: "button" });
    bar.addEventListener("click", () => choosePattern(p, k));
    for (const [enter, leave] of [["pointerenter", "pointerleave"], ["focus", "blur"]]) {
      bar.addEventListener(enter, () => pointAtBar(p, k, bar));
      bar.addEventListener(leave, () => pointAtBar(null));
    }
    track.append(bar);
    return bar;
  });
  return {
    element,
    head,
    bars,
    layout() {
      bars.forEach((bar, k) => layBar(bar, pattern, pattern.stretches[k]));
      drawSmall(sized(figure, 34, 32), pattern.key, { x: 17, base: 31, height: 29, width: 32 });
    },
    change() {
      const name = state.names[pattern.id];
      element.style.setProperty("--c", patternToken(p));
      head.firstChild.style.setProperty("--c", patternToken(p));
      element.classList.toggle("chosen", state.pattern === p);
      head.setAttribute("aria-pressed", state.pattern === p);
      first.textContent = name || pattern.head;
      first.classList.toggle("named", Boolean(name));
      second.textContent = name ? `${pattern.head}, ${pattern.sub}` : pattern.sub;
      head.setAttribute("aria-label", `${name ? name + ", pattern" : "Pattern"} ${pattern.id}, ${pattern.head}, ${pattern.sub}. Choose; Shift and Enter names it.`);
      head.title = "Click to choose, double-click to name";
      bars.forEach((bar, k) => bar.setAttribute("aria-label", stretchLabel(p, k)));
    },
    frame() {
      const playing = state.pattern === p ? stretchAt(shownTime(), p)?.stretch ?? state.loop : -1;
      bars.forEach((bar, k) => bar.classList.toggle("playing", k === playing));
    },
  };
}

const stretchLabel = (p, k) => {
  const name = state.names[patterns[p].id];
  return (name ? name + ": " : "") + patterns[p].stretches[k].name;
};

// Cycles as fields, numbered where 18 px wide; below 4 px a cycle one plain fill and the count.
function layBar(bar, pattern, stretch) {
  const width = across(stretch.stop - stretch.start);
  bar.style.left = placeOf(stretch.start) + "px";
  bar.style.width = Math.max(width - 1, 3) + "px";
  bar.replaceChildren();
  bar.classList.toggle("plain-bar", pattern.kind !== "cyclic");
  const { cycles } = stretch;
  if (!cycles.length) return;
  const [from, to] = [cycles[0][0], cycles.at(-1)[1]];
  if (across(to - from) / cycles.length < 4) {
    const all = make("span", "many", across(to - from) > 26 ? String(cycles.length) : "");
    place(all, from, to);
    bar.append(all);
    return;
  }
  cycles.forEach(([start, stop], k) => {
    const box = make("span", k % 2 ? "even" : "", across(stop - start) >= 18 ? String(k + 1) : "");
    box.classList.toggle("last", k === cycles.length - 1 || cycles[k + 1][0] > stop + 0.02);
    place(box, start, stop);
    bar.append(box);
  });
  function place(box, start, stop) {
    box.style.left = across(start - stretch.start) + "px";
    box.style.width = across(stop - start) + "px";
  }
}

// Hover a bar: its stripes widen, and its line of words stands beside it.
function pointAtBar(p, k = 0, bar = null) {
  const changed = state.bar !== p;
  state.bar = p;
  showTip(bar, p === null ? "" : named(p, patterns[p].stretches[k].tip));
  if (changed) redraw("change");
}

const named = (p, tip) => (state.names[patterns[p].id] ? `${state.names[patterns[p].id]} · ${tip}` : tip);

function showTip(beside, text) {
  const tip = $("tip");
  tip.hidden = !beside;
  if (!beside) return;
  tip.textContent = text;
  const box = beside.getBoundingClientRect();
  const x = clamp(box.left + box.width / 2 - tip.offsetWidth / 2, 8, Math.max(innerWidth - tip.offsetWidth - 8, 8));
  const above = box.bottom + tip.offsetHeight + 8 > innerHeight;
  tip.style.left = x + scrollX + "px";
  tip.style.top = (above ? box.top - tip.offsetHeight - 5 : box.bottom + 5) + scrollY + "px";
}

// The person names a pattern; the name stands first and stays in the address.
function renameLane(p, element) {
  if (element.querySelector("input")) return;
  const { id } = patterns[p];
  const input = make("input", "lane-name", [], { "aria-label": `Name of pattern ${id}`, maxlength: "60", placeholder: "Name it" });
  input.value = state.names[id] || "";
  let done = false;
  const finish = (keep) => {
    if (done) return;
    done = true;
    if (keep) {
      const name = input.value.trim();
      if (name) state.names[id] = name;
      else delete state.names[id];
    }
    input.remove();
    keepHash();
    redraw("change");
  };
  input.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Enter" || event.key === "Escape") {
      event.preventDefault(); // else the key would press the lane head that takes the focus
      finish(event.key === "Enter");
      lanes[p].head.focus();
    }
  });
  input.addEventListener("blur", () => finish(true));
  element.append(input);
  input.focus();
  input.select();
}
