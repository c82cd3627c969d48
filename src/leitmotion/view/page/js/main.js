// Put the page together, open the view that the address names, and draw.

function buildHeader() {
  const { name, seconds, frames, rate } = payload.source;
  $("name").textContent = name;
  const hertz = Number.isInteger(rate) ? rate : Number(rate.toFixed(2));
  const length = seconds >= 60 ? clockWord(seconds) : `${seconds.toFixed(1)} s`;
  $("facts").textContent = payload.source.facts ?? `${length} · ${frames.toLocaleString("en")} ${frames === 1 ? "frame" : "frames"} at ${hertz} Hz`;
  $("clock-of").textContent = `of ${clockWord(clip.seconds)}`;
}

function buildControls() {
  const names = { room: "Room", front: "Front", side: "Side", top: "Top" };
  for (const camera of CAMERAS) {
    const button = make("button", camera === "top" ? "top-camera" : "", names[camera], { type: "button", "data-camera": camera });
    button.addEventListener("click", () => setCamera(camera));
    $("cameras").append(button);
  }
  for (const speed of SPEEDS) {
    const button = make("button", "", `${speed === 0.5 ? "½" : speed}×`, { type: "button", "data-speed": speed });
    button.addEventListener("click", () => setSpeed(SPEEDS.indexOf(speed) - SPEEDS.indexOf(state.speed)));
    $("speeds").append(button);
  }
  for (const where of [$("toggles"), $("stage-sheet")]) {
    for (const what of ["follow", "trails", "ghost"]) {
      const button = make("button", "toggle", [], { type: "button", "data-toggle": what });
      button.innerHTML = '<svg viewBox="0 0 10 10" width="9" height="9" aria-hidden="true"><path d="M1 5.5 4 8.5 9 1.5" fill="none" stroke="currentColor" stroke-width="1.6"/></svg>';
      button.append(what[0].toUpperCase() + what.slice(1));
      button.addEventListener("click", () => toggle(what));
      where.append(button);
    }
  }
  const top = menuButton("Top camera", () => setCamera("top"));
  top.dataset.camera = "top";
  $("stage-sheet").prepend(top);
  $("stage-sheet").classList.add("menu");
  const letters = patterns.slice(0, 8).map((p) => p.id);
  const hint = (keys, what) => make("span", "", [make("kbd", "", keys), what]);
  $("hints").append(hint("space", "play"), hint("← →", "frame"));
  if (letters.length) $("hints").append(hint(letters.length > 1 ? `${letters[0]}–${letters.at(-1)}` : letters[0], "pattern"));
  if (motifSpans.length) $("hints").append(Object.assign(hint("N P", "motif"), { className: "of-symmetry" }));
  $("play").addEventListener("click", togglePlay);
  for (const [button, sheet] of [["help", "help-sheet"], ["save", "save-sheet"], ["more", "more-sheet"], ["stage-more", "stage-sheet"]]) {
    $(button).addEventListener("click", () => openSheet($(sheet), $(button)));
  }
  $("theme").addEventListener("click", () => {
    state.theme = theme.dark ? "light" : "dark";
    keepHash();
    applyTheme();
  });
  if (several) {
    $("app").classList.add("several-parts");
    $("tab-repeats").textContent = "Like now";
    $("tab-lesson").textContent = "Movements";
  }
  // A flat recording has one side.
  $("cameras").hidden = clip.flat;
  $("grid-note").hidden = clip.flat || !clip.metres;
  $("sides").hidden = clip.dots && !clip.roles.some((role) => /^(left|right)_/.test(role));
}

on("change", () => {
  for (const button of document.querySelectorAll("[data-camera]")) button.setAttribute("aria-pressed", button.dataset.camera === state.camera);
  for (const button of document.querySelectorAll("[data-toggle]")) button.setAttribute("aria-pressed", state[button.dataset.toggle]);
  for (const made of $("lead").querySelectorAll(".chip")) made.style.setProperty("--c", patternToken(patterns.findIndex((p) => p.id === made.textContent)));
});

function applyTheme() {
  theme.dark = !state.printing && (state.theme ? state.theme === "dark" : systemDark.matches);
  root.classList.toggle("dark", theme.dark);
  readTheme();
  redraw("layout");
}

// Printing is light, at a width of its own, with canvases twice as fine; afterwards all is as it was.
function setPrinting(printing) {
  if (state.printing === printing) return;
  state.printing = printing;
  closeSheet();
  root.classList.toggle("printing", printing);
  applyTheme();
  drawNow();
}
addEventListener("beforeprint", () => setPrinting(true));
addEventListener("afterprint", () => setPrinting(false));
matchMedia("print").addEventListener("change", (event) => setPrinting(event.matches));

systemDark.addEventListener("change", applyTheme);
addEventListener("hashchange", (event) => {
  pause();
  // A write that was due would bring the old view back.
  clearTimeout(writing);
  writing = 0;
  readHash(new URL(event.newURL).hash);
  applyTheme();
});
new ResizeObserver(() => redraw("layout")).observe($("app"));
new ResizeObserver(() => redraw("layout")).observe(stage.field);

readHash();
buildViews();
buildHeader();
buildControls();
buildHelp();
buildSaves();
buildForms();
buildGraphField();
buildGraphList();
buildTimeline();
buildTable();
buildLesson();
applyTheme();
drawNow();

// What the page tells of itself: read only, for those who test it or build on it (docs/page.md).
window.leitmotion = Object.freeze({
  get state() {
    return { ...state, names: { ...state.names }, hover: state.hover && { ...state.hover } };
  },
  get pair() {
    return pairOnShow() && { ...pairOnShow() };
  },
  get cost() {
    return { ...cost };
  },
  get matrix() {
    const { left, upper, side, shown } = field;
    return { left, upper, side, id: shown.id };
  },
  // Where on the matrix a pair lies, px.
  place: (one, two) => field.shown.shape.place(one, two),
  // The moment whose posture is laid under that of a moment in the view of symmetry, and whether in the mirror.
  mirrorMoment: (time) => symmetry && mirrorMoment(time),
  compareSides: (one, two, mirrored) => symmetry && compareSides(one, two, mirrored),
  get timeline() {
    const { left, width } = timeline;
    return { left, width };
  },
  get payload() {
    return payload;
  },
  stripes: stripes.map(({ pattern, path }) => ({ pattern, path: Array.from(path) })),
  compare,
  overlaid: overlaidOn,
  // Draw the frame of now at once and tell how many milliseconds it took.
  draw() {
    redraw();
    drawNow();
    return cost.last;
  },
});
