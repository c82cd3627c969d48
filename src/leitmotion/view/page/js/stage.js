// The stage: floor, way, shadow, ghost, trails, figure; redrawn in every frame.

const stage = { canvas: $("stage"), field: $("stage-field"), width: 0, height: 0, pen: null, camera: null };
const ghostLayer = document.createElement("canvas");
const shadowLayer = document.createElement("canvas");
const blurLayer = document.createElement("canvas");
const posture = newPosture();
const other = newPosture();
const placed = newPosture();
const TRAIL_S = 0.75;
const GRID = 5;

on("layout", () => {
  stage.width = stage.field.clientWidth;
  stage.height = stage.field.clientHeight;
  sized(stage.canvas, stage.width, stage.height);
});

on("frame", drawStage);

function drawStage() {
  const { width, height } = stage;
  const pen = (stage.pen = sized(stage.canvas, width, height));
  const now = shownTime();
  const pair = pairOnShow() || variationOnShow(now);
  imageAt(now, isLeadMirrored(), posture);
  const camera = (stage.camera = stageCamera(now));
  if (!clip.flat) drawGrid(pen, camera);
  if (isBeside()) {
    drawBeside(pen, camera, now);
    return;
  }
  if (!clip.flat) drawWay(pen, camera);
  const seen = !Number.isNaN(rootOf(posture)[0]);
  if (seen && !clip.flat) drawShadow(pen, camera, posture);
  const ghosts = isGraphShown() ? overlaidOn(now) : [ghostMoment(pair, now)];
  for (const ghost of ghosts) if (ghost && seen) drawGhost(pen, camera, ghost, pair, ghosts.length);
  if (state.trails && !isLeadMirrored()) drawTrails(pen, camera, now);
  drawFigure(pen, posture, camera);
  if (pair && seen) drawDifferences(pen, camera, pair);
  else if (figureHeight(camera) >= 240) drawSides(pen, camera);
}

// In a lesson a variation is shown over the typical time, among several recordings over any other.
function variationOnShow(now) {
  const other = state.ghost ? otherMoment(now) : null;
  return other === null ? null : { one: now, two: other, pattern: state.pattern };
}

// The moment that is laid under the figure: the second of a pair, else the one most like now.
function ghostMoment(pair, now) {
  if (pair) return { time: pair.two, mirrored: pair.mirrored, pattern: pair.pattern ?? sharedPattern(pair.one, pair.two) };
  if (!state.ghost) return null;
  if (state.view === "symmetry") return { pattern: null, ...mirrorMoment(now) };
  const [found] = nearestTo(now);
  return found ? { time: found.time, pattern: sharedPattern(now, found.time) } : null;
}

function drawGhost(pen, camera, ghost, pair, count = 1) {
  imageAt(ghost.time, ghost.mirrored, other);
  placeOnto(posture, other, facingAt(shownTime()) - facingAt(ghost.time), placed);
  const layer = sized(ghostLayer, stage.width, stage.height);
  const colour = ghost.mirrored ? theme.tokens.mirror : (ghost.pattern ?? null) === null ? theme.tokens.ink2 : patternColour(ghost.pattern);
  drawFigure(layer, placed, camera, { colour });
  pen.globalAlpha = pair || state.span !== null ? 0.62 : Math.max(0.45 / Math.sqrt(count + 0.75), 0.18);
  pen.drawImage(ghostLayer, 0, 0, stage.width, stage.height);
  pen.globalAlpha = 1;
}

// Pixels from the lowest to the highest point of the figure.
function figureHeight(camera) {
  return (clip.height * camera.focal) / camera.distance;
}

// A grid of 1 m on the floor, faded out by 5 m from where the camera looks.
function drawGrid(pen, camera) {
  const [cx, , cz] = camera.target;
  const levels = new Map();
  const [a, b] = [{}, {}];
  for (let axis = 0; axis < 2; axis++) {
    const [middle, cross] = axis ? [cz, cx] : [cx, cz];
    for (let line = Math.ceil(middle - GRID); line <= middle + GRID; line++) {
      for (let from = Math.floor(cross - GRID); from < cross + GRID; from += 0.5) {
        const far = Math.hypot(line - middle, from + 0.25 - cross) / GRID;
        if (far >= 1) continue;
        project(camera, axis ? from : line, clip.floor, axis ? line : from, a);
        project(camera, axis ? from + 0.5 : line, clip.floor, axis ? line : from + 0.5, b);
        if (a.depth < 0.2 || b.depth < 0.2) continue;
        const level = Math.ceil((1 - far) * 6);
        if (!levels.has(level)) levels.set(level, new Path2D());
        levels.get(level).moveTo(a.x, a.y);
        levels.get(level).lineTo(b.x, b.y);
      }
    }
  }
  pen.lineWidth = 1;
  pen.lineCap = "butt";
  pen.strokeStyle = theme.tokens.line;
  for (const [level, path] of levels) {
    pen.globalAlpha = level / 6;
    pen.stroke(path);
  }
  pen.globalAlpha = 1;
}

// The pelvis's way over the whole recording, thinned once: a point each 6 cm or 0.4 s, with its pattern.
const way = (() => {
  const points = [];
  const at = newPosture();
  const root = [0, 0, 0];
  for (let frame = 0; frame < clip.frames; frame++) {
    const time = frame / clip.rate;
    if (frame && firstFrames.has(frame)) points.push(null);
    rootOf(postureAt(time, at), root);
    if (Number.isNaN(root[0])) {
      if (points.length) points.push(null);
      continue;
    }
    const before = points.at(-1);
    const part = partAt(time);
    const held = stretchAt(time);
    const pattern = held ? held.pattern : null;
    const moved = before ? Math.hypot(root[0] - before.x, root[2] - before.z) : 1;
    if (before && moved < 0.06 && (before.pattern === pattern || moved < 0.015)) continue;
    points.push({ x: root[0], z: root[2], pattern, part });
  }
  return points;
})();

function drawWay(pen, camera) {
  const at = {};
  const runs = new Map();
  let before = null;
  const part = partAt(shownTime());
  for (const point of way) {
    const seen = point && point.part === part && project(camera, point.x, clip.floor, point.z, at).depth > 0.3;
    const here = seen ? { x: at.x, y: at.y, pattern: point.pattern } : null;
    if (here && before) {
      if (!runs.has(here.pattern)) runs.set(here.pattern, new Path2D());
      const path = runs.get(here.pattern);
      if (path.end !== before) path.moveTo(before.x, before.y);
      path.lineTo(here.x, here.y);
      path.end = here;
    }
    before = here;
  }
  pen.lineWidth = 2;
  pen.lineJoin = "round";
  for (const [pattern, path] of runs) {
    pen.globalAlpha = state.pattern === null || state.pattern === pattern ? 0.55 : 0.12;
    pen.strokeStyle = pattern === null ? theme.tokens.line2 : patternColour(pattern);
    pen.stroke(path);
  }
  pen.globalAlpha = 1;
}

// The same capsules laid flat on the floor, drawn small and enlarged: a blur without a filter.
function drawShadow(pen, camera, body) {
  const scale = 1 / clamp(stage.height * 0.012, 3, 8);
  const [w, h] = [Math.ceil(stage.width * scale), Math.ceil(stage.height * scale)];
  for (const layer of [shadowLayer, blurLayer]) {
    layer.width = w;
    layer.height = h;
  }
  const soft = shadowLayer.getContext("2d");
  soft.setTransform(scale, 0, 0, scale, 0, 0);
  soft.strokeStyle = soft.fillStyle = "#000";
  soft.lineCap = soft.lineJoin = "round";
  for (const part of partsOf(body)) {
    const seen = part.points.map((p) => project(camera, p[0], clip.floor, p[2], {}));
    if (seen.some((p) => p.depth < 0.3)) continue;
    const radius = part.radii ? (part.radii[0] + part.radii[1]) / 2 : part.kind === "torso" ? TORSO_STROKE / 2 : part.kind === "head" ? HEAD[0] : 0.02;
    soft.lineWidth = Math.max(2 * radius * clip.girth * seen[0].scale * (0.55 + 0.45 * Math.abs(camera.back[1])), 1.5);
    soft.beginPath();
    seen.forEach((p, k) => (k ? soft.lineTo(p.x, p.y) : soft.moveTo(p.x, p.y)));
    if (seen.length < 3) soft.lineTo(seen.at(-1).x + 0.01, seen.at(-1).y);
    soft.stroke();
  }
  const blur = blurLayer.getContext("2d");
  blur.globalAlpha = 1 / 4;
  for (const [x, y] of [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]]) blur.drawImage(shadowLayer, x, y);
  pen.imageSmoothingEnabled = true;
  pen.imageSmoothingQuality = "high";
  let soften = blurLayer;
  if (state.printing) {
    soften = ghostLayer;
    const large = sized(ghostLayer, w / scale, h / scale);
    large.imageSmoothingQuality = "high";
    large.drawImage(blurLayer, 0, 0, w / scale, h / scale);
  }
  pen.globalAlpha = theme.shadow * 1.6;
  pen.drawImage(soften, 0, 0, w / scale, h / scale);
  pen.globalAlpha = 1;
}

const TIPS = ["left", "right"].flatMap((side) =>
  [["hand", "wrist"], ["toe", "ankle"]].map((names) => ({ side, role: names.map((n) => `${side}_${n}`).find((r) => r in clip.role) })),
).filter((tip) => tip.role);

// Where hands and feet were in the last 0.75 s, fading; right solid, left dashed.
function drawTrails(pen, camera, now) {
  const steps = 20;
  const at = trailPosture;
  const points = TIPS.map(() => []);
  for (let k = 0; k <= steps; k++) {
    const time = now - TRAIL_S * (1 - k / steps);
    if (time < partOf(now).start) continue;
    postureAt(time, at);
    TIPS.forEach((tip, n) => {
      const p = pointOf(at, tip.role);
      points[n].push(known(p) ? { ...project(camera, p[0], p[1], p[2], {}), part: k / steps } : null);
    });
  }
  pen.lineWidth = 1.6;
  pen.lineCap = "round";
  TIPS.forEach((tip, n) => {
    const right = tip.side === "right";
    pen.strokeStyle = right ? theme.tokens.ink : theme.tokens.left;
    pen.setLineDash(right ? [] : [6, 5]);
    let run = 0;
    for (let k = 1; k < points[n].length; k++) {
      const [a, b] = [points[n][k - 1], points[n][k]];
      if (!a || !b) continue;
      pen.globalAlpha = 0.6 * b.part ** 1.5;
      pen.lineDashOffset = run;
      pen.beginPath();
      pen.moveTo(a.x, a.y);
      pen.lineTo(b.x, b.y);
      pen.stroke();
      run += Math.hypot(b.x - a.x, b.y - a.y);
    }
  });
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}
const trailPosture = newPosture();
