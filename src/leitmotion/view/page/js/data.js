// What the library found, decoded once: typed arrays, postures by drawn frame.

const $ = (id) => document.getElementById(id);
const payload = JSON.parse($("payload").textContent);

function decode(array) {
  const text = atob(array.data);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new { Int16Array, Int32Array, Uint8Array, Uint16Array, Float32Array }[array.type](bytes.buffer);
}

const clip = (() => {
  const { body, clock, source } = payload;
  const positions = decode(body.positions);
  const role = Object.fromEntries(body.roles.map((name, index) => [name, index]));
  return {
    ...body,
    positions,
    missing: body.positions.type === "Int16Array" ? -32768 : -2147483648,
    facing: decode(body.facing),
    role,
    count: body.roles.length,
    frames: clock.frames,
    rate: clock.rate,
    seconds: source.seconds,
    last: (clock.frames - 1) / clock.rate,
    parts: payload.parts ?? [{ name: source.name, start: 0, stop: source.seconds, yaw: body.yaw }],
  };
})();

// Several recordings are one time, one after another; each is a part of it, and a person reads its own seconds.
const several = clip.parts.length > 1;
const partAt = (time) => {
  let k = clip.parts.length - 1;
  while (k > 0 && clip.parts[k].start > time + 1e-6) k--;
  return k;
};
const partOf = (time) => clip.parts[partAt(time)];
const ownTime = (time) => time - partOf(time).start;
// The last moment of the part that holds a moment.
const lastOf = (time) => (several ? Math.min(partOf(time).stop - 1 / clip.rate, clip.last) : clip.last);
clip.span = Math.max(...clip.parts.map((part) => part.stop - part.start));
const firstFrames = new Set(clip.parts.map((part) => Math.round(part.start * clip.rate)));

const likeness = { ...payload.matrix, values: decode(payload.matrix.values), cells: payload.matrix.values.shape[0] };
const nearest = {
  rate: payload.nearest.rate,
  seconds: decode(payload.nearest.seconds),
  distances: decode(payload.nearest.distances),
  quantum: payload.nearest.quantum,
  count: payload.nearest.seconds.shape[0],
  each: payload.nearest.seconds.shape[1],
};
const patterns = payload.patterns;
// What was found of symmetry; null where a sentence says why there is none.
const symmetry = payload.symmetry?.lanes ? payload.symmetry : null;
const strips = payload.strips.map(decode);

// A stripe is a warping path: seconds of moment 1 and of moment 2, step by step.
const stripes = (() => {
  const points = decode(payload.stripes.points);
  let at = 0;
  return payload.stripes.length.map((length, k) => {
    const path = points.subarray(2 * at, 2 * (at + length));
    at += length;
    return { pattern: payload.stripes.pattern[k], path, length };
  });
})();

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const frameAt = (time) => clamp(Math.round(time * clip.rate), 0, clip.frames - 1);
const cellAt = (time) => clamp(Math.floor(time * likeness.rate), 0, likeness.cells - 1);
const timeOfCell = (cell) => Math.min((cell + 0.5) / likeness.rate, clip.last);

// The moments most like a moment, nearest first: fewer than three where less comes within the cap.
function nearestTo(time) {
  const row = clamp(Math.round(time * nearest.rate), 0, nearest.count - 1);
  const found = [];
  for (let k = row * nearest.each; k < (row + 1) * nearest.each; k++) {
    if (Number.isNaN(nearest.seconds[k])) break;
    // Between two rows the likeness runs on at the same pace.
    const there = clamp(nearest.seconds[k] + time - row / nearest.rate, 0, clip.last);
    found.push({ time: there, distance: nearest.distances[k] * nearest.quantum });
  }
  return found;
}

// The posture at a moment, between two drawn frames: metres, NaN where a point was not seen.
function postureAt(time, out) {
  const exact = clamp(time, 0, clip.last) * clip.rate;
  const first = Math.min(Math.floor(exact + 1e-4), clip.frames - 1);
  const second = firstFrames.has(first + 1) ? first : Math.min(first + 1, clip.frames - 1);
  const part = Math.max(exact - first, 0);
  const { positions, missing, count } = clip;
  const size = count * 3;
  for (let i = 0; i < size; i++) {
    const a = positions[first * size + i];
    const b = positions[second * size + i];
    if (a === missing && b === missing) out[i] = NaN;
    else if (a === missing) out[i] = part > 0.5 ? b / 1000 : NaN;
    else if (b === missing) out[i] = part <= 0.5 ? a / 1000 : NaN;
    else out[i] = (a + (b - a) * part) / 1000;
  }
  return out;
}

function facingAt(time) {
  const exact = clamp(time, 0, clip.last) * clip.rate;
  const first = Math.min(Math.floor(exact + 1e-4), clip.frames - 1);
  const second = firstFrames.has(first + 1) ? first : Math.min(first + 1, clip.frames - 1);
  return clip.facing[first] + (clip.facing[second] - clip.facing[first]) * (exact - first);
}

// Where the body stands: its pelvis, else the middle of what is seen.
function rootOf(posture, out = [0, 0, 0]) {
  const pelvis = clip.role.pelvis;
  if (pelvis !== undefined && !Number.isNaN(posture[3 * pelvis])) {
    for (let k = 0; k < 3; k++) out[k] = posture[3 * pelvis + k];
    return out;
  }
  let seen = 0;
  out.fill(0);
  for (let r = 0; r < clip.count; r++) {
    if (Number.isNaN(posture[3 * r])) continue;
    for (let k = 0; k < 3; k++) out[k] += posture[3 * r + k];
    seen++;
  }
  for (let k = 0; k < 3; k++) out[k] = seen ? out[k] / seen : NaN;
  return out;
}

// Turn and place posture `b` so that it stands where `a` stands and faces as `a` faces.
function placeOnto(a, b, turn, out) {
  const from = rootOf(b);
  const to = rootOf(a);
  const c = Math.cos(turn);
  const s = Math.sin(turn);
  for (let r = 0; r < clip.count; r++) {
    const x = b[3 * r] - from[0];
    const z = b[3 * r + 2] - from[2];
    out[3 * r] = to[0] + c * x + s * z;
    out[3 * r + 1] = b[3 * r + 1];
    out[3 * r + 2] = to[2] + c * z - s * x;
  }
  return out;
}

const newPosture = () => new Float32Array(clip.count * 3);

// How far two moments are apart: the lengths that the stage draws from joint to joint, and their mean.
const compare = (() => {
  const a = newPosture();
  const b = newPosture();
  const placed = newPosture();
  return (one, two) => {
    postureAt(one, a);
    postureAt(two, b);
    placeOnto(a, b, facingAt(one) - facingAt(two), placed);
    const joints = [];
    let sum = 0;
    for (const r of clip.compared) {
      const apart = Math.hypot(placed[3 * r] - a[3 * r], placed[3 * r + 1] - a[3 * r + 1], placed[3 * r + 2] - a[3 * r + 2]);
      if (Number.isNaN(apart)) continue;
      joints.push({ index: r, word: clip.words[r], apart });
      sum += apart;
    }
    joints.sort((x, y) => y.apart - x.apart);
    if (clip.compared.length) return { distance: joints.length ? sum / joints.length : NaN, joints, farther: false };
    const byte = likeness.values[cellAt(one) * likeness.cells + cellAt(two)];
    return { distance: byte === 255 ? NaN : (byte / 254) * likeness.top, joints, farther: byte === 254 };
  };
})();

// Which stretch of which pattern holds a moment: the first pattern that has one.
function stretchAt(time, only = null) {
  for (let p = 0; p < patterns.length; p++) {
    if (only !== null && p !== only) continue;
    const k = patterns[p].stretches.findIndex((s) => time >= s.start && time < s.stop);
    if (k >= 0) return { pattern: p, stretch: k };
  }
  return null;
}

function sharedPattern(one, two) {
  const holds = (p, time) => patterns[p].stretches.some((s) => time >= s.start && time < s.stop);
  for (let p = 0; p < patterns.length; p++) if (holds(p, one) && holds(p, two)) return p;
  return null;
}
