// Stripes: the warping paths of pairs of stretches, drawn above the diagonal, and the walk along them.

const SNAP = 8;

// Called with the base canvas: stripes are drawn once per size, theme, choice and pointed-at bar.
function drawStripes(pen) {
  pen.save();
  pen.beginPath();
  pen.rect(field.left, field.upper, field.side, field.side);
  pen.clip();
  pen.lineJoin = pen.lineCap = "round";
  const scale = field.side / clip.seconds;
  const rest = state.pattern;
  const layers = [
    stripes.filter((s) => rest !== null && s.pattern !== rest),
    stripes.filter((s) => rest === null || s.pattern === rest),
  ];
  layers.forEach((layer, chosen) => {
    const drawn = layer.map((stripe) => ({ stripe, path: stripePath(stripe, scale) }));
    pen.globalAlpha = 1;
    if (chosen) {
      pen.strokeStyle = theme.tokens.surface;
      for (const { stripe, path } of drawn) {
        pen.lineWidth = stripe.pattern === state.bar ? 5.4 : 4.6;
        pen.stroke(path);
      }
    }
    pen.globalAlpha = chosen ? 1 : 0.25;
    for (const { stripe, path } of drawn) {
      pen.lineWidth = !chosen ? 1.4 : stripe.pattern === state.bar ? 3.2 : 2.4;
      pen.strokeStyle = patternColour(stripe.pattern);
      pen.stroke(path);
    }
  });
  pen.restore();
}

function stripePath({ path, length }, scale) {
  const line = new Path2D();
  const at = (k) => [field.left + path[2 * k + 1] * scale, field.upper + path[2 * k] * scale];
  line.moveTo(...at(0));
  // A path turns in whole frames: rounded between the middles of its steps.
  for (let k = 1; k < length - 1; k++) {
    const [here, next] = [at(k), at(k + 1)];
    line.quadraticCurveTo(...here, (here[0] + next[0]) / 2, (here[1] + next[1]) / 2);
  }
  line.lineTo(...at(length - 1));
  return line;
}

// The stripe nearest to a pair and the step along it, within `reach` pixels; of the chosen pattern when one is.
function stripeNear(one, two, reach = SNAP) {
  if (!field.shown.stripes) return null;
  const scale = field.side / clip.seconds;
  let best = null;
  stripes.forEach((stripe, index) => {
    if (state.pattern !== null && stripe.pattern !== state.pattern) return;
    const { path, length } = stripe;
    const slack = reach / scale;
    if (one < path[0] - slack || one > path[2 * length - 2] + slack) return;
    if (two < path[1] - slack || two > path[2 * length - 1] + slack) return;
    for (let k = 0; k < length - 1; k++) {
      const [a, b] = [path[2 * k], path[2 * k + 1]];
      const [da, db] = [path[2 * k + 2] - a, path[2 * k + 3] - b];
      const square = da * da + db * db;
      const part = square ? clamp(((one - a) * da + (two - b) * db) / square, 0, 1) : 0;
      const away = Math.hypot(a + part * da - one, b + part * db - two) * scale;
      if (away <= reach && (!best || away < best.away)) best = { stripe: index, step: k + part, away };
    }
  });
  return best;
}

// The two moments at a step of a stripe, between two steps of its path.
function pairAlong(index, step) {
  const { path, length } = stripes[index];
  const k = clamp(Math.floor(step), 0, Math.max(length - 2, 0));
  const part = clamp(step - k, 0, 1);
  const next = Math.min(k + 1, length - 1);
  return { one: path[2 * k] + (path[2 * next] - path[2 * k]) * part, two: path[2 * k + 1] + (path[2 * next + 1] - path[2 * k + 1]) * part };
}

// Go on along a stripe for some seconds of its mean pace: moment 1 and moment 2 together, each at its own speed.
function walkStripe(seconds) {
  const { path, length } = stripes[state.stripe];
  const lasts = (path[2 * length - 2] - path[0] + path[2 * length - 1] - path[1]) / 2;
  const pair = pairAlong(state.stripe, state.step);
  let left = seconds;
  let step = state.step;
  let from = pair;
  while (left > 0 && step < length - 1) {
    const end = Math.min(Math.floor(step) + 1, length - 1);
    const to = pairAlong(state.stripe, end);
    const takes = (to.one - from.one + to.two - from.two) / 2;
    if (takes > left) step += ((end - step) * left) / takes;
    else step = end;
    left -= takes;
    from = to;
  }
  if (step >= length - 1 && seconds > 0) step = lasts > 0 ? 0 : step;
  holdAlong(state.stripe, step);
}

function holdAlong(index, step) {
  const pair = pairAlong(index, step);
  Object.assign(state, { stripe: index, step, time: pair.one, second: pair.two, held: true, hover: null });
}
