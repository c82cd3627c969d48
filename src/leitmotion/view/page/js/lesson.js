// The lesson: what recurs, most frequent first. Choosing one plays its typical time, then its variations in turn, each
// over the typical one as a ghost. Beside the stage where there is room, else a card of its own.

const lessonSteps = (() => {
  if (!payload.lesson) return [];
  const points = decode(payload.lesson.points);
  let at = 0;
  const steps = payload.lesson.steps.map((step) => ({
    ...step,
    takes: step.takes.map((take) => {
      const path = points.subarray(2 * at, 2 * (at + take.length));
      at += take.length;
      return { ...take, path };
    }),
  }));
  // Among several recordings what is shared comes first, as in the patterns.
  return several ? steps.sort((a, b) => a.pattern - b.pattern) : steps;
})();
const wide = matchMedia("(min-width: 1101px)");
const lesson = { element: $("lesson"), steps: [], rows: [] };

const stepOf = (p) => lessonSteps.find((step) => step.pattern === p);
const takesOf = (p) => stepOf(p)?.takes ?? [];
const takeNow = () => (state.take === null ? null : takesOf(state.pattern)[state.take]);

// The moment of the other time that belongs to a moment of the one that plays; null outside of it, and where there is
// no other. Of one recording the other is the typical time.
function otherMoment(time) {
  const take = takeNow();
  if (!take || time < take.start || time > take.stop) return null;
  const other = otherTake();
  return other === null ? null : momentIn(other, time);
}

function chooseTake(p, k) {
  const takes = takesOf(p);
  if (!takes.length) return;
  const take = takes[clamp(k, 0, takes.length - 1)];
  if (state.pattern !== p) state.other = null;
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
  const end = Math.min(take.stop, lastOf(take.start));
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
  const over = state.time >= Math.min(takes.at(-1).stop, lastOf(takes.at(-1).start)) - 1e-6;
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
  if (shown) showView("repeats");
  state.lesson = shown;
  if (!shown && state.take !== null) clearPattern();
  keepHash();
  redraw("change");
}

const LESSON_WORDS = {
  one: "Most frequent first. Choose one to see its typical time, then the others over it.",
  several: "Choose one to see it in two recordings. A time plays as 1; the button 2 compares it with another.",
};

function buildLesson() {
  $("tab-lesson").hidden = !lessonSteps.length;
  if (!lessonSteps.length) {
    lesson.element.remove();
    return;
  }
  $("tab-lesson").addEventListener("click", () => showLesson(true));
  const list = make("ol", "steps", lessonSteps.map(buildStep));
  const arrow = (name, key, d, act) => {
    const button = make("button", "plain icon", [], { type: "button", "aria-label": name, title: `${name}: ${key}` });
    button.innerHTML = `<svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="${d}" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>`;
    button.addEventListener("click", act);
    return button;
  };
  lesson.repeat = make("button", "toggle", [], { type: "button", title: "Loop this one: R" });
  lesson.repeat.innerHTML = '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1 5.5 4 8.5 9 1.5" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>';
  lesson.repeat.append(several ? "Loop" : "Loop this one");
  lesson.repeat.addEventListener("click", toggleRepeat);
  const bar = make("div", "lesson-bar", [
    arrow("Previous", "P", "M10.5 3 5.5 8l5 5", () => stepTake(-1)), arrow("Next", "N", "M5.5 3l5 5-5 5", () => stepTake(1)), lesson.repeat, ...(several ? [inStepToggle()] : []),
  ], { role: "group", "aria-label": "Lesson" });
  const head = make("div", "lesson-head", [make("h2", "", several ? "Movements" : "Lesson", { id: "lesson-title" }), make("p", "", several ? LESSON_WORDS.several : LESSON_WORDS.one)]);
  lesson.element.append(head, ...(several ? [buildBeside()] : []), list, bar);
  lesson.element.setAttribute("aria-labelledby", "lesson-title");
}

function buildStep(step) {
  const p = step.pattern;
  const figure = document.createElement("canvas");
  const [first, second] = [make("strong", ""), make("small", "", step.seconds)];
  const head = make("button", "step-head", [chip(p), figure, make("span", "", [first, " ", second])], { type: "button" });
  head.addEventListener("click", () => chooseTake(p, 0));
  const takes = step.takes.map((take, k) => {
    const name = k ? [make("b", "", momentClock(take.start)), ` ${take.apart} apart`] : [make("b", "", "Typical"), ` ${momentClock(take.start)}`];
    const said = take.words.join(", ").replace(/(\d) (%|cm|s)/g, "$1\u00a0$2");
    const button = make("button", "take", [make("span", "", name), ...(k ? [make("small", "", said)] : [])], { type: "button" });
    button.addEventListener("click", () => chooseTake(p, k));
    return button;
  });
  const others = several ? step.takes.map((take, k) => otherButton(take, k)) : [];
  const list = make("ol", "takes", takes.flatMap((button, k) => [...recordingHead(step.takes, k), make("li", several ? "two-way" : "", [button, ...(several ? [others[k]] : [])])]));
  const element = make("li", "step", [head, list]);
  lesson.steps.push({ step, p, figure, first, head, takes, others, list, element });
  return element;
}

function otherButton(take, k) {
  const button = make("button", "other", "2", { type: "button", title: "Compare with this one", "aria-label": `Compare with ${momentWord(take.start)}` });
  button.addEventListener("click", () => compareWith(k));
  return button;
}

// Among several recordings the name of the one stands over its times.
function recordingHead(takes, k) {
  if (!several || (k && partAt(takes[k].start) === partAt(takes[k - 1].start))) return [];
  return [make("li", "take-part cut-name", cutName(partOf(takes[k].start).name), { title: partOf(takes[k].start).name })];
}

// Where there is room it takes the panel's place, and gives it back while two moments are on show.
function placeLesson() {
  const beside = wide.matches && !state.printing;
  const home = beside ? document.querySelector(".scene") : document.querySelector("main");
  if (lesson.element.parentNode !== home) {
    if (beside) home.append(lesson.element);
    else home.insertBefore(lesson.element, $("timeline"));
  }
  const shown = state.view === "repeats" && (!beside || (state.lesson && !pairOnShow()));
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
    lesson.repeat.setAttribute("aria-pressed", state.repeat);
    for (const { step, p, first, head, takes, others, list, element } of lesson.steps) {
      const chosen = state.take !== null && state.pattern === p;
      const name = state.names[patterns[p].id];
      element.style.setProperty("--c", patternToken(p));
      head.firstChild.style.setProperty("--c", patternToken(p));
      first.textContent = name || step.times;
      head.setAttribute("aria-expanded", chosen);
      head.setAttribute("aria-label", `${name ? name + ", pattern" : "Pattern"} ${patterns[p].id}, ${step.times}, ${step.seconds}. Play its typical time.`);
      list.hidden = !chosen;
      others.forEach((button, k) => {
        button.setAttribute("aria-pressed", chosen && k === otherTake());
        button.disabled = chosen && k === state.take;
      });
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
