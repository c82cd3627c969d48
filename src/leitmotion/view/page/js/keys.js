// Every pointer action has a key.

addEventListener("keydown", (event) => {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.closest("input, textarea")) return;
  const key = event.key;
  const letter = key.length === 1 ? key.toUpperCase() : "";
  const chosen = patterns.findIndex((p) => p.id === letter);
  const onButton = event.target.closest("button");
  if (key === " " && !onButton) togglePlay();
  else if (key === "ArrowLeft" || key === "ArrowRight") {
    const way = key === "ArrowLeft" ? -1 : 1;
    stepBy(way * (event.shiftKey ? 1 : 1 / clip.rate));
  } else if (key === "Escape") escape();
  else if (key === "[" || key === "]") setSpeed(key === "[" ? -1 : 1);
  else if (CAMERAS[Number(key) - 1]) setCamera(CAMERAS[Number(key) - 1]);
  else if (key === "?") toggleHelp();
  else if (letter === "M" && !several) showView(state.view === "symmetry" ? "repeats" : "symmetry");
  else if (letter === "G" && graph) showView(state.view === "graph" ? "repeats" : "graph");
  else if (state.view === "graph" && (letter === "N" || letter === "P")) stepItem(letter === "N" ? 1 : -1);
  else if (state.view === "graph" && letter === "I" && hasImages) toggleImages();
  else if (state.view === "graph" && stateOfKey(letter, event.shiftKey)) chooseItem(stateOfKey(letter, event.shiftKey).name);
  else if ((letter === "N" || letter === "P") && state.view === "symmetry") stepSpan(letter === "N" ? 1 : -1);
  else if (state.view !== "repeats" && letter && "LR".includes(letter)) return;
  else if (letter === "L" && lessonSteps.length) showLesson(!state.lesson);
  else if ((letter === "N" || letter === "P") && event.shiftKey && several) stepOther(letter === "N" ? 1 : -1);
  else if (letter === "S" && several && lessonSteps.length) setView("beside", !state.beside);
  else if (letter === "T" && several && lessonSteps.length) setView("inStep", !state.inStep);
  else if ((letter === "N" || letter === "P") && lessonSteps.length) stepTake(letter === "N" ? 1 : -1);
  else if (letter === "R" && lessonSteps.length) toggleRepeat();
  else if (letter && "ABCDEFGH".includes(letter) && chosen >= 0) choosePattern(chosen);
  else if (event.target === stage.canvas && (key === "+" || key === "-")) zoomCamera(key === "+" ? 1.1 : 1 / 1.1);
  else if (event.target === stage.canvas && (key === "ArrowUp" || key === "ArrowDown")) turnCamera(0, key === "ArrowUp" ? 8 : -8);
  else if (event.target === stage.canvas && (key === "," || key === ".")) turnCamera(key === "," ? -12 : 12, 0);
  else return;
  event.preventDefault();
});

// Escape clears one thing at a time: a sheet, a pair, a chosen pattern.
function escape() {
  if (closeSheet()) return;
  if (state.held || state.hover) release();
  else if (state.span !== null) clearSpan();
  else if (state.item !== null) clearItem();
  else if (state.pattern !== null) clearPattern();
}

// A button pressed by the pointer gives the keys back to the page, so that space plays on.
document.addEventListener("click", (event) => {
  const button = event.target.closest("button");
  if (event.detail && button && document.activeElement === button && !button.closest(".sheet")) button.blur();
});
