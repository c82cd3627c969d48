// Playing: one recording, the stretches of a chosen pattern in turn, a lesson, or a pair along its stripe.

const player = { before: 0 };

function goTo(time) {
  if (state.held || state.hover) Object.assign(state, { held: false, second: null, stripe: null, hover: null });
  state.time = clamp(time, 0, clip.last);
  // Among several recordings whoever goes elsewhere leaves the time that was chosen.
  const left = several && state.take !== null && otherMoment(state.time) === null;
  if (left) Object.assign(state, { pattern: null, take: null, other: null });
  keepHash();
  redraw(left ? "change" : "frame");
}

function play() {
  if (state.playing) return;
  if (!state.held && state.take !== null) rewindTakes();
  if (!state.held && state.pattern === null && state.span === null && state.item === null && state.time >= lastOf(state.time) - 1e-6) state.time = partOf(state.time).start;
  if (state.held && state.stripe === null) {
    const near = stripeNear(state.time, state.second);
    if (near) holdAlong(near.stripe, near.step);
  }
  state.playing = true;
  player.before = 0;
  requestAnimationFrame(tick);
  redraw("change");
}

function pause() {
  if (!state.playing) return;
  state.playing = false;
  keepHash();
  redraw("change");
}

const togglePlay = () => (state.playing ? pause() : play());

function tick(now) {
  if (!state.playing) return;
  const seconds = player.before ? Math.min((now - player.before) / 1000, 0.25) * state.speed : 0;
  player.before = now;
  // Time stands still while someone points at a cell.
  if (!state.hover) advance(seconds);
  redraw();
  requestAnimationFrame(tick);
}

function advance(seconds) {
  if (state.held) {
    if (state.stripe !== null) walkStripe(seconds);
    else shiftPair(seconds);
  } else if (itemNow()) loopItem(seconds);
  else if (state.span !== null) loopSpan(seconds);
  else if (state.take !== null) playTakes(seconds);
  else if (state.pattern !== null) loopPattern(seconds);
  else {
    const last = lastOf(state.time);
    state.time = Math.min(state.time + seconds, last);
    if (state.time >= last) pause();
  }
}

// A pair that lies on no stripe goes on at the same pace until one of the two ends.
function shiftPair(seconds) {
  const [one, two] = [state.time, state.second];
  const least = Math.max(partOf(one).start - one, partOf(two).start - two);
  const by = clamp(seconds, least, Math.min(lastOf(one) - one, lastOf(two) - two));
  state.time += by;
  state.second += by;
  if (by < seconds - 1e-9) pause();
}

function loopPattern(seconds) {
  const { stretches } = patterns[state.pattern];
  const stretch = stretches[state.loop];
  state.time = state.time < stretch.start || state.time >= stretch.stop ? stretch.start : state.time + seconds;
  if (state.time < Math.min(stretch.stop, lastOf(stretch.start))) return;
  state.loop = (state.loop + 1) % stretches.length;
  state.time = stretches[state.loop].start;
  redraw("change");
}

// Choose a pattern and loop its stretches in turn; choosing it again clears it.
function choosePattern(p, stretch = null) {
  if (several) {
    chooseShared(p, stretch);
    return;
  }
  if (state.take === null && state.pattern === p && (stretch === null || stretch === state.loop)) {
    clearPattern();
    return;
  }
  const inside = stretchAt(state.time, p);
  state.pattern = p;
  Object.assign(state, { span: null, item: null, visit: 0, take: null, held: false, second: null, stripe: null, hover: null });
  state.loop = stretch ?? (inside ? inside.stretch : 0);
  if (stretch !== null || !inside) state.time = patterns[p].stretches[state.loop].start;
  keepHash();
  redraw("change");
  if (!reducedMotion.matches) play();
}

// Among several recordings a movement plays time by time, each beside another.
function chooseShared(p, stretch) {
  const inside = stretch === null ? null : patterns[p].stretches[stretch];
  if (!inside && state.pattern === p) clearPattern();
  else chooseTake(p, inside ? takeAt(p, inside.start, inside) : 0);
}

function clearPattern() {
  Object.assign(state, { pattern: null, take: null, other: null });
  pause();
  keepHash();
  redraw("change");
}

// One step: along the stripe of a held pair, both of a pair, or the moment.
function stepBy(seconds) {
  pause();
  const near = state.held && state.stripe === null && stripeNear(state.time, state.second);
  if (near) holdAlong(near.stripe, near.step);
  if (state.held && state.stripe !== null) walkStripe(Math.max(seconds, 0));
  if (state.held && state.stripe !== null && seconds < 0) walkBack(-seconds);
  else if (state.held && state.stripe === null) shiftPair(seconds);
  else if (!state.held) state.time = clamp(state.time + seconds, partOf(state.time).start, lastOf(state.time));
  keepHash();
  redraw();
}

function walkBack(seconds) {
  const goal = state.time + state.second - 2 * seconds;
  let step = state.step;
  let pair = pairAlong(state.stripe, step);
  while (step > 0 && pair.one + pair.two > goal) {
    const before = step;
    const previous = Math.max(Math.ceil(step) - 1, 0);
    const at = pairAlong(state.stripe, previous);
    const span = pair.one + pair.two - at.one - at.two;
    if (at.one + at.two < goal && span > 0) step = before - ((before - previous) * (pair.one + pair.two - goal)) / span;
    else step = previous;
    pair = pairAlong(state.stripe, step);
    if (step > previous) break;
  }
  holdAlong(state.stripe, step);
}

function setSpeed(by) {
  state.speed = SPEEDS[clamp(SPEEDS.indexOf(state.speed) + by, 0, SPEEDS.length - 1)];
  keepHash();
  redraw("change");
}

on("frame", () => {
  $("clock").textContent = momentClock(shownTime());
  if (several) {
    const { name, seconds } = partOf(shownTime());
    $("clock-of").textContent = `of ${clockWord(seconds)}${state.pattern === null ? ` · ${name}` : ""}`;
  }
});
on("change", () => {
  $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
  $("play-shape").setAttribute("d", state.playing ? "M4 3h3v10H4zM9 3h3v10H9z" : "M4.5 2.6v10.8L13 8z");
  for (const button of $("speeds").children) button.setAttribute("aria-pressed", Number(button.dataset.speed) === state.speed);
  const looping = $("looping");
  const times = itemNow();
  const chosen = state.pattern !== null || state.span !== null || times !== null;
  looping.hidden = !chosen;
  $("hints").hidden = chosen;
  if (!chosen) return;
  if (times) {
    const { item, lead } = times;
    const which = `, ${times.times.indexOf(lead) + 1} of ${times.times.length}${lead.back ? ", back" : ""}${lead.mirrored ? ", mirrored" : ""}`;
    looping.replaceChildren("Looping ", make("b", "", nameMarks(item)), which);
    return;
  }
  if (state.span !== null) {
    const span = motifSpans[state.span];
    const { name, spans } = symmetry.lanes[span.lane];
    looping.replaceChildren("Looping ", ...(span.pattern === null ? [] : [chip(span.pattern), " "]), `${name}, ${span.number} of ${spans.length}`);
    return;
  }
  if (state.take !== null && several) {
    const [one, two] = [takeNow(), takesOf(state.pattern)[otherTake()]];
    looping.replaceChildren(chip(state.pattern), ` 1 ${partOf(one.start).name}${two ? `, 2 ${partOf(two.start).name}` : ""}`);
    looping.title = looping.textContent;
    return;
  }
  if (state.take !== null) {
    const count = takesOf(state.pattern).length;
    looping.replaceChildren(chip(state.pattern), ` ${state.take + 1} of ${count}${state.take ? "" : ", typical"}`);
    return;
  }
  const count = patterns[state.pattern].stretches.length;
  looping.replaceChildren("Looping ", chip(state.pattern), `, stretch ${state.loop + 1} of ${count}`);
});
