// Of several recordings: the movements with their colours, then a lane a recording, in each what occurs when.

const PARTS_SHOWN = 8;
const NAME_END = 11;

if (several) timeline.element.classList.add("several");
if (several && patterns.length) addMovements();
if (several) addParts();

// A button a movement: letter, key posture, in how many recordings it occurs.
function addMovements() {
  const element = make("div", "row movements", [], { role: "group", "aria-label": "Movements" });
  patterns.forEach((pattern, p) => {
    const figure = document.createElement("canvas");
    const [first, second] = [make("strong", ""), make("small", "")];
    const head = make("button", "movement", [chip(p), figure, make("span", "", [first, " ", second])], { type: "button" });
    const place = make("div", "movement-place", head);
    head.addEventListener("click", (event) => event.detail < 2 && choosePattern(p));
    head.addEventListener("dblclick", () => renameLane(p, place));
    head.addEventListener("keydown", (event) => {
      if (event.key !== "F2" && !(event.key === "Enter" && event.shiftKey)) return;
      event.preventDefault();
      renameLane(p, place);
    });
    lanes.push({ head, place, figure, first, second });
    element.append(place);
  });
  timeRows.push({
    order: 10,
    element,
    layout() {
      patterns.forEach((pattern, p) => drawSmall(sized(lanes[p].figure, 34, 32), pattern.key, { x: 17, base: 31, height: 29, width: 32 }));
      timeline.element.style.setProperty("--strip", element.offsetHeight + "px");
    },
    change() {
      patterns.forEach((pattern, p) => {
        const { head, first, second } = lanes[p];
        const name = state.names[pattern.id];
        head.firstChild.style.setProperty("--c", patternToken(p));
        head.classList.toggle("faint", state.pattern !== null && state.pattern !== p);
        head.setAttribute("aria-pressed", state.pattern === p);
        first.textContent = name || pattern.head;
        second.textContent = name ? `${pattern.head}, ${pattern.sub}` : pattern.sub;
        head.setAttribute("aria-label", `${name ? name + ", pattern" : "Pattern"} ${pattern.id}, ${pattern.head}, ${pattern.sub}. Choose; Shift and Enter names it.`);
        head.title = "Click to choose, double-click to name";
      });
    },
  });
}

function addParts() {
  const element = make("div", "row lanes parts", [], { role: "group", "aria-label": "Recordings" });
  const rows = clip.parts.map(buildPart);
  element.append(...rows.map((row) => row.element));
  const showLines = () => timeline.lines.forEach(({ line }, which) => {
    if (line.hidden) return;
    const time = which ? secondMoment() : shownTime();
    const row = rows[partAt(time ?? 0)].element;
    const top = row.offsetTop - element.scrollTop;
    const inSight = top > -row.offsetHeight / 2 && top < element.clientHeight - row.offsetHeight / 2;
    line.style.setProperty("--lane-top", element.offsetTop + top - line.offsetTop + "px");
    line.style.setProperty("--lane-height", (inSight ? row.offsetHeight : 0) + "px");
  });
  element.addEventListener("scroll", showLines);
  let before = null;
  timeRows.push({
    order: 30,
    element,
    layout() {
      element.style.maxHeight = rows.length > PARTS_SHOWN ? rows[0].element.offsetHeight * PARTS_SHOWN + "px" : "";
      for (const row of rows) row.layout();
    },
    change() {
      element.classList.toggle("dimmed", state.pattern !== null);
      for (const row of rows) row.change();
    },
    frame() {
      const now = partAt(shownTime());
      if (now !== before) keepLaneInSight(element, rows[now].element);
      before = now;
      rows.forEach((row, k) => row.element.classList.toggle("now", k === now));
      showLines();
    },
  });
}

const secondMoment = () => pairOnShow()?.two ?? otherMoment(state.time);

function keepLaneInSight(box, row) {
  if (row.offsetTop < box.scrollTop) box.scrollTop = row.offsetTop;
  else if (row.offsetTop + row.offsetHeight > box.scrollTop + box.clientHeight) box.scrollTop = row.offsetTop + row.offsetHeight - box.clientHeight;
}

// A long name is cut in its middle: files of one series differ at their end.
function cutName(name) {
  return [make("span", "", name.slice(0, -NAME_END)), make("span", "", name.slice(-NAME_END))];
}

function buildPart(part, n) {
  const words = make("span", "", [make("strong", "cut-name", cutName(part.name)), " ", make("small", "", part.sub)]);
  const head = make("button", "lane-head part-head", words, { type: "button", title: part.name, "aria-label": `Play ${part.name}, ${part.sub}` });
  const track = make("div", "track");
  const end = make("i", "part-end");
  track.append(end);
  const element = make("div", "lane", [head, track]);
  head.addEventListener("click", () => {
    if (state.pattern !== null) clearPattern();
    goTo(part.start);
    if (!reducedMotion.matches) play();
  });
  track.addEventListener("click", (event) => {
    if (event.target === track || event.target === end) goTo(timeAt(event));
  });
  const timeAt = (event) => {
    const box = track.getBoundingClientRect();
    return clamp(part.start + ((event.clientX - box.left) / box.width) * clip.span, part.start, lastOf(part.start));
  };
  const bars = patterns.flatMap((pattern, p) =>
    pattern.stretches.flatMap((stretch, k) => (partAt(stretch.start) === n ? [buildBar(pattern, p, stretch, k, timeAt)] : [])),
  );
  bars.sort((a, b) => a.stretch.start - b.stretch.start);
  track.append(...bars.map(({ bar }) => bar));
  return {
    element,
    layout() {
      element.style.width = timeline.element.clientWidth + "px";
      end.style.width = across(part.stop - part.start) + "px";
      for (const { bar, pattern, stretch } of bars) {
        layBar(bar, pattern, stretch);
        // The letter says which movement it is; cycles are fields without a number.
        for (const field of bar.children) field.textContent = "";
        if (across(stretch.stop - stretch.start) >= 15) bar.append(make("b", "letter", pattern.id));
      }
    },
    change() {
      for (const { bar, p, k, stretch } of bars) {
        bar.style.setProperty("--c", patternToken(p));
        bar.setAttribute("aria-label", stretchLabel(p, k));
        bar.classList.toggle("chosen", state.pattern === p);
        markTakes(bar, p, stretch);
      }
    },
  };
}

function buildBar(pattern, p, stretch, k, timeAt) {
  const bar = make("button", pattern.confidence < 0.5 ? "stretch unsure" : "stretch", [], { type: "button" });
  bar.addEventListener("click", (event) => {
    const take = takeAt(p, event.detail ? timeAt(event) : stretch.start, stretch);
    if (event.shiftKey && state.pattern === p && state.take !== null) compareWith(take);
    else chooseTake(p, take);
  });
  for (const [enter, leave] of [["pointerenter", "pointerleave"], ["focus", "blur"]]) {
    bar.addEventListener(enter, () => pointAtBar(p, k, bar));
    bar.addEventListener(leave, () => pointAtBar(null));
  }
  return { bar, pattern, p, stretch, k };
}

// Which time of a movement a moment belongs to: the one around it, else the nearest in its stretch.
function takeAt(p, time, stretch) {
  const away = ({ cut: [start, stop] }) => Math.max(start - time, time - stop, 0) + (start < stretch.start - 0.05 || stop > stretch.stop + 0.05 ? 1e3 : 0);
  const takes = takesOf(p);
  return takes.reduce((best, take, k) => (away(take) < away(takes[best]) ? k : best), 0);
}

// The time that plays is outlined, the one it is compared with dashed.
function markTakes(bar, p, stretch) {
  const marks = state.pattern === p && state.take !== null ? [takesOf(p)[state.take], takesOf(p)[otherTake()]] : [];
  const fields = [...bar.querySelectorAll("span")];
  marks.forEach((_, k) => fields.forEach((field) => field.classList.remove(k ? "two" : "one")));
  if (!marks.length) fields.forEach((field) => field.classList.remove("one", "two"));
  const holds = (take) => Boolean(take) && take.cut[0] >= stretch.start - 0.05 && take.cut[1] <= stretch.stop + 0.05;
  marks.forEach((take, k) => {
    if (!holds(take)) return;
    const cycle = stretch.cycles.findIndex(([start]) => Math.abs(start - take.cut[0]) < 0.02);
    if (cycle >= 0 && fields[cycle]) fields[cycle].classList.add(k ? "two" : "one");
  });
  bar.classList.toggle("one", holds(marks[0]) && !stretch.cycles.length);
  bar.classList.toggle("two", holds(marks[1]) && !stretch.cycles.length);
}
