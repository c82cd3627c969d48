// The body: tapered capsules, torso, head and nose, painted from far to near with a halo in the surface's colour.

const LIMBS = [
  // from, to, radius there, radius here (metres of a person of 1.7 m)
  ["shoulder", "elbow", 0.047, 0.039],
  ["elbow", "wrist", 0.039, 0.029],
  ["wrist", "hand", 0.029, 0.02],
  ["hip", "knee", 0.069, 0.05],
  ["knee", "ankle", 0.05, 0.034],
  ["ankle", "toe", 0.034, 0.026],
];
const TORSO_STROKE = 0.125;
const HEAD = [0.095, 0.122];
const NOSE = { radius: 0.022, forward: 0.1 };
const FADE = 0.42;

const pointOf = (posture, role) => {
  const index = clip.role[role];
  return index === undefined ? null : [posture[3 * index], posture[3 * index + 1], posture[3 * index + 2]];
};

// The parts of a posture: capsules of limbs, torso polygon, head. What was not seen is absent, never guessed.
function partsOf(posture) {
  if (clip.dots) return dotsOf(posture);
  const at = (role) => pointOf(posture, role);
  const parts = [];
  for (const side of ["left", "right"]) {
    for (const [from, to, wide, narrow] of LIMBS) {
      const [a, b] = [at(`${side}_${from}`), at(`${side}_${to}`)];
      if (known(a, b)) parts.push({ kind: "limb", side, points: [a, b], radii: [wide * clip.girth, narrow * clip.girth] });
    }
  }
  const torso = torsoOf(at);
  if (torso) parts.push({ kind: "torso", points: torso.polygon });
  const head = headOf(at, torso);
  if (head) parts.push(head);
  if (torso && head && known(torso.neck)) {
    parts.push({ kind: "neck", points: [torso.neck, head.points[0]], radii: [0.05 * clip.girth, 0.045 * clip.girth] });
  }
  return parts;
}

function torsoOf(at) {
  const [ls, rs, lh, rh] = ["left_shoulder", "right_shoulder", "left_hip", "right_hip"].map(at);
  if (!known(ls, rs, lh, rh)) return null;
  const shoulders = along(ls, rs, 0.5);
  const hips = along(lh, rh, 0.5);
  const neck = known(at("neck")) ? at("neck") : shoulders;
  const waist = along(hips, shoulders, 0.34);
  const half = subtract(along(lh, ls, 0.34), along(rh, rs, 0.34)).map((v) => v * 0.36);
  const polygon = [
    along(ls, shoulders, 0.16), along(neck, shoulders, 0.5), along(rs, shoulders, 0.16), subtract(waist, half),
    along(rh, hips, 0.12), along(lh, hips, 0.12), waist.map((v, k) => v + half[k]),
  ];
  const up = unit(subtract(shoulders, hips));
  const left = unit(subtract(ls, rs));
  return { polygon, neck, shoulders, up, forward: unit(cross(left, up)) };
}

function headOf(at, torso) {
  const [neck, top] = [known(at("neck")) ? at("neck") : torso && torso.shoulders, at("head")];
  if (!known(top)) return null;
  const up = known(neck) ? unit(subtract(top, neck)) : [0, 1, 0];
  // The joint "head" lies at the base of the skull in some files and at its middle or top in others.
  const reach = known(neck) ? clamp(norm(subtract(top, neck)), 0.19 * clip.girth, 0.25 * clip.girth) : 0;
  const centre = known(neck) && known(up) ? neck.map((v, k) => v + up[k] * reach) : top;
  const head = { kind: "head", points: [centre], up: known(up) ? up : [0, 1, 0] };
  if (torso && known(torso.forward)) {
    const off = torso.forward[0] * head.up[0] + torso.forward[1] * head.up[1] + torso.forward[2] * head.up[2];
    const ahead = unit(torso.forward.map((v, k) => v - off * head.up[k]));
    if (known(ahead)) head.nose = centre.map((v, k) => v + ahead[k] * NOSE.forward * clip.girth);
  }
  return head;
}

// Points whose place on the body is unknown: dots, and the links that the file gives.
function dotsOf(posture) {
  const point = (r) => [posture[3 * r], posture[3 * r + 1], posture[3 * r + 2]];
  const parts = [];
  for (const [a, b] of clip.links) if (known(point(a), point(b))) parts.push({ kind: "link", points: [point(a), point(b)] });
  for (let r = 0; r < clip.count; r++) if (known(point(r))) parts.push({ kind: "dot", points: [point(r)], side: sideOf(r) });
  return parts;
}

const sideOf = (r) => (/^(left|right)_/.exec(clip.roles[r]) || [])[1];

// How parts look: the main figure in ink and left blue, a ghost or second moment all in one colour.
function styleOf(colour = null) {
  const { surface, ink, left } = theme.tokens;
  const solid = colour || ink;
  return { surface, right: solid, left: colour || left, hollow: mix(surface, colour || left, 0.1), trunk: mix(solid, surface, 0.34), nose: solid };
}

// Draw a posture. `halo` and `outline` in pixels; `fade` off draws small figures flat.
function drawFigure(pen, posture, camera, { colour = null, halo = 1.6, outline = 1.7, fade = true, nose = true } = {}) {
  const style = styleOf(colour);
  const parts = partsOf(posture);
  for (const part of parts) {
    part.seen = part.points.map((p) => project(camera, p[0], p[1], p[2], {}));
    part.depth = part.seen.reduce((sum, p) => sum + p.depth, 0) / part.seen.length;
  }
  parts.sort((a, b) => b.depth - a.depth);
  const root = rootOf(posture);
  const middle = project(camera, root[0], root[1], root[2], {}).depth;
  pen.lineJoin = "round";
  pen.lineCap = "round";
  for (const part of parts) {
    const behind = fade ? clamp((part.depth - middle) / 0.5, 0, 1) * FADE : 0;
    const tone = (hex) => (behind > 0.01 ? mix(hex, style.surface, behind) : hex);
    PAINTERS[part.kind](pen, part, { style, tone, halo, outline, nose, camera });
  }
}

const PAINTERS = {
  limb(pen, part, { style, tone, halo, outline }) {
    const radii = part.radii.map((r, k) => Math.max(r * part.seen[k].scale, 0.6));
    capsule(pen, part.seen, radii);
    pen.strokeStyle = style.surface;
    pen.lineWidth = 2 * halo;
    pen.stroke();
    if (part.side === "right") {
      pen.fillStyle = tone(style.right);
      pen.fill();
      return;
    }
    const width = Math.min(outline, Math.min(...radii) * 0.9);
    capsule(pen, part.seen, radii.map((r) => r - width / 2));
    pen.fillStyle = style.hollow;
    pen.fill();
    pen.strokeStyle = tone(style.left);
    pen.lineWidth = width;
    pen.stroke();
  },
  torso(pen, part, { style, tone, halo }) {
    const scale = part.seen.reduce((sum, p) => sum + p.scale, 0) / part.seen.length;
    const width = TORSO_STROKE * clip.girth * scale;
    pen.beginPath();
    part.seen.forEach((p, k) => (k ? pen.lineTo(p.x, p.y) : pen.moveTo(p.x, p.y)));
    pen.closePath();
    pen.strokeStyle = style.surface;
    pen.lineWidth = width + 2 * halo;
    pen.stroke();
    pen.strokeStyle = pen.fillStyle = tone(style.trunk);
    pen.lineWidth = width;
    pen.stroke();
    pen.fill();
  },
  neck(pen, part, { style, tone }) {
    capsule(pen, part.seen, part.radii.map((r, k) => r * part.seen[k].scale));
    pen.fillStyle = tone(style.trunk);
    pen.fill();
  },
  head(pen, part, { style, tone, halo, nose, camera }) {
    const at = part.seen[0];
    const tip = part.points[0].map((v, k) => v + part.up[k] * 0.1);
    const top = project(camera, tip[0], tip[1], tip[2], {});
    const length = Math.hypot(top.x - at.x, top.y - at.y);
    // Seen along its axis the head is round: the long radius shrinks to the short one.
    const upright = clamp(length / (0.1 * at.scale), 0, 1);
    const [rx, ry] = [HEAD[0], HEAD[0] + (HEAD[1] - HEAD[0]) * upright].map((r) => r * clip.girth * at.scale);
    const front = part.nose && project(camera, part.nose[0], part.nose[1], part.nose[2], {});
    const paintNose = () => {
      const r = NOSE.radius * clip.girth * front.scale;
      disc(pen, front.x, front.y, r + 1);
      pen.fillStyle = style.surface;
      pen.fill();
      disc(pen, front.x, front.y, r);
      pen.fillStyle = tone(style.nose);
      pen.fill();
    };
    if (nose && front && front.depth > at.depth) paintNose();
    pen.beginPath();
    pen.ellipse(at.x, at.y, rx, ry, Math.atan2(top.y - at.y, top.x - at.x) + Math.PI / 2, 0, 2 * Math.PI);
    pen.strokeStyle = style.surface;
    pen.lineWidth = 2 * halo;
    pen.stroke();
    pen.fillStyle = tone(style.trunk);
    pen.fill();
    if (nose && front && front.depth <= at.depth) paintNose();
  },
  link(pen, part, { style, tone, outline }) {
    pen.beginPath();
    pen.moveTo(part.seen[0].x, part.seen[0].y);
    pen.lineTo(part.seen[1].x, part.seen[1].y);
    pen.strokeStyle = tone(style.trunk);
    pen.lineWidth = outline;
    pen.stroke();
  },
  dot(pen, part, { style, tone, halo, outline }) {
    const at = part.seen[0];
    const r = Math.max(0.02 * clip.girth * at.scale, 1.2);
    disc(pen, at.x, at.y, r + halo * 0.6);
    pen.fillStyle = style.surface;
    pen.fill();
    disc(pen, at.x, at.y, part.side === "left" ? r - outline / 3 : r);
    if (part.side === "left") {
      pen.strokeStyle = tone(style.left);
      pen.lineWidth = Math.min(outline, r * 0.8);
      pen.stroke();
    } else {
      pen.fillStyle = tone(style.right);
      pen.fill();
    }
  },
};

function capsule(pen, [a, b], [ra, rb]) {
  pen.beginPath();
  const apart = Math.hypot(b.x - a.x, b.y - a.y);
  if (apart <= Math.abs(ra - rb) + 1e-3) {
    const [at, r] = ra > rb ? [a, ra] : [b, rb];
    pen.arc(at.x, at.y, Math.max(r, 0.3), 0, 2 * Math.PI);
    return;
  }
  const angle = Math.atan2(b.y - a.y, b.x - a.x);
  const open = Math.acos((ra - rb) / apart);
  pen.arc(a.x, a.y, Math.max(ra, 0.3), angle + open, angle - open + 2 * Math.PI);
  pen.arc(b.x, b.y, Math.max(rb, 0.3), angle - open, angle + open);
  pen.closePath();
}

function disc(pen, x, y, r) {
  pen.beginPath();
  pen.arc(x, y, Math.max(r, 0.3), 0, 2 * Math.PI);
}

// A small figure: yaw removed, seen from .45 rad to its left, standing on `base` in the middle of its place.
const smallPosture = newPosture();
// Figures that stand in a row share the scale at which the tallest posture of the recording fits.
function drawSmall(pen, time, { x, base, height, width = Infinity, colour = null, row = false, mirrored = false }) {
  imageAt(time, mirrored, smallPosture);
  const root = rootOf(smallPosture);
  if (Number.isNaN(root[0])) return;
  let pixels = height / Math.max(clip.height * 1.04, row ? clip.reach : topOf(smallPosture));
  const yaw = clip.flat ? 0 : facingAt(time) + 0.45;
  const view = (scale) => cameraAt({
    yaw, lift: clip.flat ? 0 : 0.1, distance: 9, target: [root[0], clip.floor, root[2]], focal: scale * 9, centre: [x, base],
  });
  let camera = view(pixels);
  const span = breadth(camera, smallPosture);
  if (span.right - span.left > width) {
    pixels *= width / (span.right - span.left);
    camera = view(pixels);
  }
  const shifted = breadth(camera, smallPosture);
  camera.centre = [x - ((shifted.left + shifted.right) / 2 - x), base];
  drawFigure(pen, smallPosture, camera, { colour, halo: 0.7, outline: 1.05, fade: false, nose: false });
}

// How high above the floor a posture reaches, with a little air.
function topOf(posture) {
  let top = clip.floor;
  for (let r = 0; r < clip.count; r++) if (posture[3 * r + 1] > top) top = posture[3 * r + 1];
  return top - clip.floor + 0.06 * clip.girth;
}

function breadth(camera, posture) {
  const at = {};
  let [left, right] = [Infinity, -Infinity];
  for (let r = 0; r < clip.count; r++) {
    if (Number.isNaN(posture[3 * r])) continue;
    project(camera, posture[3 * r], posture[3 * r + 1], posture[3 * r + 2], at);
    left = Math.min(left, at.x);
    right = Math.max(right, at.x);
  }
  return { left, right };
}
