// Pointing at the matrix: a pair under the pointer, held by a click, led along a stripe by a drag.

const pointing = { down: null, dragged: false, along: null, touched: null };

// The cell under the pointer, folded over so that moment 1 comes first; null beside the matrix.
function cellUnder(event) {
  const box = field.top.getBoundingClientRect();
  const zoom = box.width / field.top.offsetWidth || 1;
  const x = (event.clientX - box.left) / zoom;
  const y = (event.clientY - box.top) / zoom;
  const slack = pointing.down ? Infinity : 0;
  const cell = field.shown.shape.cell(x, y);
  if (cell.some((time) => time < -slack || time > clip.seconds + slack)) return null;
  const times = cell.map((time) => clamp(time, 0, clip.last));
  return { one: Math.min(...times), two: Math.max(...times) };
}

function pointAt(pair) {
  state.hover = pair;
  redraw();
}

function hold(pair, keepAlong = false) {
  Object.assign(state, { time: pair.one, second: pair.two, held: true, hover: null });
  if (!keepAlong) state.stripe = null;
  keepHash();
  redraw("change");
}

function release() {
  Object.assign(state, { held: false, second: null, stripe: null, hover: null });
  keepHash();
  redraw("change");
}

// One finger on the cells moves the pair; beside them it scrolls the page.
field.top.addEventListener("touchstart", (event) => {
  if (event.touches.length === 1 && cellUnder(event.touches[0])) event.preventDefault();
}, { passive: false });

field.top.addEventListener("pointerdown", (event) => {
  const pair = cellUnder(event);
  if (!pair) {
    if (state.held || state.hover) release();
    return;
  }
  field.top.setPointerCapture(event.pointerId);
  pause();
  pointing.down = { x: event.clientX, y: event.clientY, pair };
  pointing.dragged = false;
  pointing.along = stripeNear(pair.one, pair.two);
  if (event.pointerType === "touch" && !state.held) pointAt(pair);
});

field.top.addEventListener("pointermove", (event) => {
  const pair = cellUnder(event);
  if (!pointing.down) {
    if (event.pointerType !== "touch" && !state.held) pointAt(pair);
    field.top.style.cursor = pair ? "crosshair" : "default";
    return;
  }
  if (!pair) return;
  const { x, y } = pointing.down;
  if (!pointing.dragged && Math.hypot(event.clientX - x, event.clientY - y) < 4) return;
  pointing.dragged = true;
  const near = stripeNear(pair.one, pair.two);
  if (near) {
    holdAlong(near.stripe, near.step);
    redraw();
  } else {
    Object.assign(state, { time: pair.one, second: pair.two, held: true, hover: null, stripe: null });
    redraw();
  }
});

field.top.addEventListener("pointerup", (event) => {
  const down = pointing.down;
  if (!down) return;
  pointing.down = null;
  if (pointing.dragged) {
    keepHash();
    redraw("change");
    return;
  }
  if (event.pointerType === "touch" && !state.held) {
    const before = pointing.touched;
    const again = before && Math.hypot(before.x - down.x, before.y - down.y) < 24;
    pointing.touched = again ? null : down;
    if (!again) return;
    hold(before.pair);
    return;
  }
  hold(down.pair);
});

field.top.addEventListener("pointercancel", () => (pointing.down = null));
field.top.addEventListener("pointerleave", (event) => {
  if (event.pointerType !== "touch" && state.hover && !pointing.down) pointAt(null);
});

// A click beside everything that acts lets a held pair go.
document.addEventListener("click", (event) => {
  if (!state.held || event.target.closest("button, input, .scene, .timeline, .table, .sheet, #matrix")) return;
  release();
});

// The arrow keys move the cell, Enter holds it.
field.top.addEventListener("keydown", (event) => {
  const move = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
  const pair = pairOnShow() || openingPair();
  if (move) {
    const cell = (event.shiftKey ? 10 : 1) * Math.max(1 / likeness.rate, clip.seconds / field.side);
    const times = [pair.one + move[0] * cell, pair.two + move[1] * cell].map((t) => clamp(t, 0, clip.last));
    const moved = { one: Math.min(...times), two: Math.max(...times) };
    if (state.held) hold(moved);
    else pointAt(moved);
  } else if (event.key === "Enter") {
    hold(pair);
  } else return;
  event.preventDefault();
  event.stopPropagation();
});
field.top.addEventListener("blur", () => state.hover && !field.top.matches(":hover") && pointAt(null));

function openingPair() {
  const [found] = nearestTo(state.time);
  const two = found ? found.time : Math.min(state.time + clip.seconds / 10, clip.last);
  return { one: Math.min(state.time, two), two: Math.max(state.time, two) };
}
