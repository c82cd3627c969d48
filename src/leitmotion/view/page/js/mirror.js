// The body in the mirror: the mirror image of a posture, how far it is, and which moment should look like now.

const motifSpans = symmetry
  ? symmetry.lanes.flatMap((lane, l) => lane.spans.map((span, k) => ({ ...span, lane: l, number: k + 1 })))
  : [];

// Both likenesses share one square: above its diagonal each moment with each, below with each mirror image.
const twoLikenesses = symmetry && (() => {
  const values = decode(symmetry.matrix.values);
  const cells = symmetry.matrix.values.shape[0];
  const own = (i, j) => (i === j ? (values[i * cells + i] === 255 ? 255 : 254) : values[Math.min(i, j) * cells + Math.max(i, j)]);
  const mirror = (i, j) => values[Math.max(i, j) * cells + Math.min(i, j)];
  return { own, mirror, cells, rate: symmetry.matrix.rate };
})();

const lopsidedness = symmetry && { values: decode(symmetry.lopsidedness.values), quantum: symmetry.lopsidedness.quantum };
const axisSpeed = symmetry && { values: decode(symmetry.speed.values), most: symmetry.speed.most };

// How far the body is from its own mirror image, as the library measured it, metres of the drawing.
function lopsidednessAt(time) {
  const byte = lopsidedness.values[frameAt(time)];
  return byte === 65535 ? NaN : byte * lopsidedness.quantum;
}

// The mirror image in the plane through the pelvis that the body faces along: sides exchanged, left for right.
const mirrorPartner = payload.symmetry?.partner ?? payload.graph?.partner;
function mirrorPosture(posture, facing, out) {
  const root = rootOf(posture);
  const [nx, nz] = [Math.cos(facing), -Math.sin(facing)];
  for (let r = 0; r < clip.count; r++) {
    const from = mirrorPartner[r];
    if (from < 0) {
      out.fill(NaN, 3 * r, 3 * r + 3);
      continue;
    }
    const [x, y, z] = [posture[3 * from], posture[3 * from + 1], posture[3 * from + 2]];
    const off = 2 * ((x - root[0]) * nx + (z - root[2]) * nz);
    out[3 * r] = x - off * nx;
    out[3 * r + 1] = y;
    out[3 * r + 2] = z - off * nz;
  }
  return out;
}

// The posture at a moment, or its mirror image.
const unmirrored = newPosture();
function imageAt(time, mirrored, out) {
  if (!mirrored) return postureAt(time, out);
  return mirrorPosture(postureAt(time, unmirrored), facingAt(time), out);
}

// How far two moments are apart, joint by joint, the second mirrored or not.
const compareSides = (() => {
  const [a, b, placed] = [newPosture(), newPosture(), newPosture()];
  return (one, two, mirrored) => {
    postureAt(one, a);
    placeOnto(a, imageAt(two, mirrored, b), facingAt(one) - facingAt(two), placed);
    const joints = [];
    for (const r of symmetry.compared) {
      const apart = Math.hypot(placed[3 * r] - a[3 * r], placed[3 * r + 1] - a[3 * r + 1], placed[3 * r + 2] - a[3 * r + 2]);
      if (!Number.isNaN(apart)) joints.push({ index: r, word: clip.words[r], apart });
    }
    joints.sort((x, y) => y.apart - x.apart);
    const distance = joints.length ? joints.reduce((sum, joint) => sum + joint.apart, 0) / joints.length : NaN;
    return { distance, joints, farther: false };
  };
})();

// Whether a moment is nearer to the mirror image of another than to it. Asked many times a frame, of one pair.
const isNearerMirrored = (() => {
  const last = { one: NaN, two: NaN, nearer: false };
  return (one, two) => {
    if (one !== last.one || two !== last.two) {
      const [own, mirror] = [false, true].map((mirrored) => compareSides(one, two, mirrored).distance);
      Object.assign(last, { one, two, nearer: mirror < own });
    }
    return last.nearer;
  };
})();

const comparePair = (pair) => (state.view === "symmetry" ? compareSides(pair.one, pair.two, pair.mirrored) : compare(pair.one, pair.two));
const sidesNumber = (distance) => (distance * symmetry.told.factor).toFixed(1);
const sidesWord = (distance) => `${sidesNumber(distance)} ${symmetry.told.unit}`;

// The stretch that tells about a moment: the chosen one, else the surest that holds it and tells how the sides move.
function spanAt(time) {
  const holds = (span) => (time >= span.start && time < span.stop) || (span.partner && time >= span.partner[0] && time < span.partner[1]);
  if (state.span !== null && holds(motifSpans[state.span])) return motifSpans[state.span];
  const held = motifSpans.filter((span) => !span.partner && holds(span));
  const chief = held.filter((span) => symmetry.lanes[span.lane].chief);
  return (chief.length ? chief : held).reduce((best, span) => (best && best.confidence >= span.confidence ? best : span), null);
}

// The stretch that plays: the chosen one, or the surest of the chosen pattern.
function spanInPlay(time) {
  if (state.span !== null) return motifSpans[state.span];
  const span = state.pattern === null ? null : spanAt(time);
  return span && span.pattern === state.pattern && symmetry.lanes[span.lane].chief ? span : null;
}

// The other moment that is laid under the figure while a stretch plays; null where it is now itself.
function mirroredMoment(time) {
  if (state.view !== "symmetry" || !state.ghost || !spanInPlay(time)) return null;
  const { time: there } = mirrorMoment(time);
  return Math.abs(there - time) > 1e-3 ? there : null;
}

const MILLISECOND = 1e-3; // moments of a fit are rounded to it

// What is laid under the figure in this view: now in the mirror, in a chosen stretch what its motif says is like it.
function mirrorMoment(time) {
  const span = spanInPlay(time);
  const way = span ? span.fit.at.findIndex((at) => time >= at[0] - MILLISECOND && time <= at.at(-1) + MILLISECOND) : -1;
  if (way < 0) return { time, mirrored: true, words: "its mirror image" };
  const [at, to] = [span.fit.at[way], span.fit.to[way]];
  const k = clamp(at.findIndex((moment) => moment >= time), 1, at.length - 1);
  const there = to[k - 1] + ((time - at[k - 1]) / Math.max(at[k] - at[k - 1], 1e-6)) * (to[k] - to[k - 1]);
  return { time: clamp(there, 0, clip.last), mirrored: span.fit.mirrored, words: span.fit.words };
}

function mirrorSentence(pair) {
  const { distance } = comparePair(pair);
  const moments = `Moments ${momentWord(pair.one)} and ${momentWord(pair.two)}`;
  if (Number.isNaN(distance)) return `${moments}. ${WORDS.unknown}`;
  return `${moments} are ${sidesWord(distance)} apart, on average${pair.mirrored ? ", the second in the mirror" : ""}.`;
}

// A stretch is chosen: it plays again and again, over what it is like; choosing it again lets it go.
function chooseSpan(k) {
  if (state.span === k) {
    clearSpan();
    return;
  }
  Object.assign(state, { span: k, pattern: null, take: null, held: false, second: null, stripe: null, hover: null, time: motifSpans[k].start });
  if (!symmetry.lanes[motifSpans[k].lane].chief) state.more = true;
  keepHash();
  redraw("layout");
  if (!reducedMotion.matches) play();
}

function clearSpan() {
  state.span = null;
  pause();
  keepHash();
  redraw("change");
}

// The next stretch or the one before, of the lanes that are shown.
function stepSpan(by) {
  const shown = motifSpans.map((span, k) => k).filter((k) => isLaneShown(motifSpans[k].lane));
  if (!shown.length) return;
  const at = shown.indexOf(state.span);
  chooseSpan(shown[at < 0 ? (by > 0 ? 0 : shown.length - 1) : (at + by + shown.length) % shown.length]);
}

function loopSpan(seconds) {
  const { start, stop } = motifSpans[state.span];
  state.time = state.time < start || state.time >= Math.min(stop, clip.last) ? start : state.time + seconds;
}
