// The lesson: what recurs, most frequent first. Choosing one plays its typical time, then its variations in turn, each
// over the typical one as a ghost. Beside the stage where there is room, else a card of its own.

const lessonSteps = (() => {
  if (!payload.lesson) return [];
  const points = decode(payload.lesson.points);
  let at = 0;
  return payload.lesson.steps.map((step) => ({
    ...step,
    takes: step.takes.map((take) => {
      const path = points.subarray(2 * at, 2 * (at + take.length));
      at += take.length;
      return { ...take, path };
    }),
  }));
})();
const wide = matchMedia("(min-width: 1101px)");
const lesson = { element: $("lesson"), steps: [], rows: [] };

const stepOf = (p) => lessonSteps.find((step) => step.pattern === p);
const takesOf = (p) => stepOf(p)?.takes ?? [];
const takeNow = () => (state.take === null ? null : takesOf(state.pattern)[state.take]);

// The moment of the typical time that belongs to a moment of the variation that plays; null outside of it.
function typicalMoment(time) {
  const take = takeNow();
  if (!take || !take.path.length || time < take.start || time > take.stop) return null;
  const { path } = take;
  let k = 0;
  while (k < path.length / 2 - 1 && path[2 * k + 1] < time) k++;
  const [one, two] = [path[2 * Math.max(k - 1, 0) + 1], path[2 * k + 1]];
  const part = two > one ? clamp((time - one) / (two - one), 0, 1) : 1;
  const before = path[2 * Math.max(k - 1, 0)];
  return before + (path[2 * k] - before) * part;
}

function chooseTake(p, k) {
  const takes = takesOf(p);
  if (!takes.length) return;
  const take = takes[clamp(k, 0, takes.length - 1)];
  Object.assign(state, { lesson: true, pattern: p, take: takes.indexOf(take), held: false, second: null, stripe: null, hover: null });
  state.time = take.start;
  state.loop = stretchAt(take.start, p)?.stretch ?? 0;
  keepHash();
  redraw("change");
  if (!wide.matches) stage.field.scrollIntoView({ block: "nearest" });
  if (!reducedMotion.matches) play();
}

// The next time or the one before; past the ends of a movement, the next movement or the one before.
function stepTake(by) {
  if (!lessonSteps.length) return;
  if (state.take === null) {
    chooseTake(lessonSteps[0].pattern, 0);
    return;
  }
  const at = lessonSteps.indexOf(stepOf(state.pattern));
  const next = state.take + by;
  if (next >= 0 && next < lessonSteps[at].takes.length) chooseTake(state.pattern, next);
  else if (lessonSteps[at + by]) chooseTake(lessonSteps[at + by].pattern, by < 0 ? lessonSteps[at + by].takes.length - 1 : 0);
}

function playTakes(seconds) {
  const takes = takesOf(state.pattern);
  const take = takeNow();
  const end = Math.min(take.stop, clip.last);
  state.time = state.time < take.start || state.time >= end ? take.start : Math.min(state.time + seconds, end);
  if (state.time < end) return;
  if (state.repeat) state.time = take.start;
  else if (state.take + 1 < takes.length) {
    state.take++;
    state.time = takes[state.take].start;
    redraw("change");
  } else pause();
}

// Playing on after the last one begins with the first.
function rewindTakes() {
  const takes = takesOf(state.pattern);
  const over = state.time >= Math.min(takes.at(-1).stop, clip.last) - 1e-6;
  if (state.take !== takes.length - 1 || !over || state.repeat) return;
  state.take = 0;
  state.time = takes[0].start;
}

function toggleRepeat() {
  state.repeat = !state.repeat;
  keepHash();
  redraw("change");
}

function showLesson(shown) {
  if (!lessonSteps.length || state.lesson === shown) return;
  state.lesson = shown;
  if (!shown && state.take !== null) clearPattern();
  keepHash();
  redraw("change");
}

function buildLesson() {
  $("tab-lesson").hidden = !lessonSteps.length;
  if (!lessonSteps.length) {
    lesson.element.remove();
    return;
  }
  $("tab-lesson").addEventListener("click", () => showLesson(true));
  $("tab-repeats").addEventListener("click", () => showLesson(false));
  const list = make("ol", "steps", lessonSteps.map(buildStep));
  const arrow = (name, key, d, act) => {
    const button = make("button", "plain icon", [], { type: "button", "aria-label": name, title: `${name}: ${key}` });
    button.innerHTML = `<svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="${d}" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>`;
    button.addEventListener("click", act);
    return button;
  };
  lesson.repeat = make("button", "toggle", [], { type: "button", title: "Loop this one: R" });
  lesson.repeat.innerHTML = '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1 5.5 4 8.5 9 1.5" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>';
  lesson.repeat.append("Loop this one");
  lesson.repeat.addEventListener("click", toggleRepeat);
  const bar = make("div", "lesson-bar", [
    arrow("Previous", "P", "M10.5 3 5.5 8l5 5", () => stepTake(-1)), arrow("Next", "N", "M5.5 3l5 5-5 5", () => stepTake(1)), lesson.repeat,
  ], { role: "group", "aria-label": "Lesson" });
  const head = make("div", "lesson-head", [make("h2", "", "Lesson", { id: "lesson-title" }), make("p", "", "Most frequent first. Choose one to see its typical time, then the others over it.")]);
  lesson.element.append(head, list, bar);
  lesson.element.setAttribute("aria-labelledby", "lesson-title");
}

function buildStep(step) {
  const p = step.pattern;
  const figure = document.createElement("canvas");
  const [first, second] = [make("strong", ""), make("small", "", step.seconds)];
  const head = make("button", "step-head", [chip(p), figure, make("span", "", [first, " ", second])], { type: "button" });
  head.addEventListener("click", () => chooseTake(p, 0));
  const takes = step.takes.map((take, k) => {
    const name = k ? [make("b", "", clockWord(take.start)), ` ${take.apart} apart`] : [make("b", "", "Typical"), ` ${clockWord(take.start)}`];
    const said = take.words.join(", ").replace(/(\d) (%|cm|s)/g, "$1\u00a0$2");
    const button = make("button", "take", [make("span", "", name), ...(k ? [make("small", "", said)] : [])], { type: "button" });
    button.addEventListener("click", () => chooseTake(p, k));
    return button;
  });
  const list = make("ol", "takes", takes.map((button) => make("li", "", button)));
  const element = make("li", "step", [head, list]);
  lesson.steps.push({ step, p, figure, first, head, takes, list, element });
  return element;
}

// Where there is room it takes the panel's place, and gives it back while two moments are on show.
function placeLesson() {
  const beside = wide.matches && !state.printing;
  const home = beside ? document.querySelector(".scene") : document.querySelector("main");
  if (lesson.element.parentNode !== home) {
    if (beside) home.append(lesson.element);
    else home.insertBefore(lesson.element, $("timeline"));
  }
  const shown = !beside || (state.lesson && !pairOnShow());
  if (lesson.element.hidden === shown) lesson.element.hidden = !shown;
  if (panel.element.hidden !== (beside && shown)) panel.element.hidden = beside && shown;
}

if (lessonSteps.length) {
  on("layout", () => {
    placeLesson();
    for (const { p, figure } of lesson.steps) drawSmall(sized(figure, 34, 32), patterns[p].key, { x: 17, base: 31, height: 29, width: 32 });
  });
  on("frame", placeLesson);
  on("change", () => {
    $("tab-lesson").setAttribute("aria-pressed", state.lesson);
    $("tab-repeats").setAttribute("aria-pressed", !state.lesson);
    lesson.repeat.setAttribute("aria-pressed", state.repeat);
    for (const { step, p, first, head, takes, list, element } of lesson.steps) {
      const chosen = state.take !== null && state.pattern === p;
      const name = state.names[patterns[p].id];
      element.style.setProperty("--c", patternToken(p));
      head.firstChild.style.setProperty("--c", patternToken(p));
      first.textContent = name || step.times;
      head.setAttribute("aria-expanded", chosen);
      head.setAttribute("aria-label", `${name ? name + ", pattern" : "Pattern"} ${patterns[p].id}, ${step.times}, ${step.seconds}. Play its typical time.`);
      list.hidden = !chosen;
      takes.forEach((button, k) => {
        const now = chosen && k === state.take;
        if (button.hasAttribute("aria-current") === now) return;
        if (!now) button.removeAttribute("aria-current");
        else {
          button.setAttribute("aria-current", "true");
          keepInSight(button);
        }
      });
    }
  });
}

// The list scrolls, never the page.
function keepInSight(button) {
  const box = button.closest(".steps");
  const [top, foot] = [button.offsetTop, button.offsetTop + button.offsetHeight];
  if (top < box.scrollTop) box.scrollTop = top - 40;
  else if (foot > box.scrollTop + box.clientHeight) box.scrollTop = foot - box.clientHeight + 8;
}
