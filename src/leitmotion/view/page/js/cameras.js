// Four cameras, and the hands that turn them.

const LIFT = { room: 0.2, front: 0.1, side: 0.1, top: 1.45 };
const DISTANCE = 4.6;
const SMOOTH_S = 0.5;
const EASE_MS = 200;

// Pelvis and front smoothed over 0.5 s, once: the camera is a function of the moment, however one got there.
const smooth = (() => {
  const roots = new Float32Array(clip.frames * 3);
  const at = newPosture();
  const root = [0, 0, 0];
  let last = [0, clip.floor + 0.55 * clip.height, 0];
  for (let f = 0; f < clip.frames; f++) {
    rootOf(postureAt(f / clip.rate, at), root);
    if (!Number.isNaN(root[0])) last = [...root];
    roots.set(last, 3 * f);
  }
  const half = Math.max(1, Math.round((SMOOTH_S * clip.rate) / 2));
  const borders = clip.parts.map((part) => [part.start, part.stop].map((time) => Math.round(time * clip.rate)));
  const mean = (values, width) => {
    const out = new Float32Array(values.length);
    for (let c = 0; c < width; c++) {
      const sums = new Float64Array(clip.frames + 1);
      for (let f = 0; f < clip.frames; f++) sums[f + 1] = sums[f] + values[f * width + c];
      for (const [from, to] of borders) {
        for (let f = from; f < Math.min(to, clip.frames); f++) {
          const [a, b] = [Math.max(f - half, from), Math.min(f + half + 1, to, clip.frames)];
          out[f * width + c] = (sums[b] - sums[a]) / (b - a);
        }
      }
    }
    return out;
  };
  return { roots: mean(mean(roots, 3), 3), facing: mean(clip.facing, 1) };
})();

function smoothAt(values, width, time) {
  const exact = clamp(time, 0, clip.last) * clip.rate;
  const first = Math.min(Math.floor(exact + 1e-4), clip.frames - 1);
  const second = firstFrames.has(first + 1) ? first : Math.min(first + 1, clip.frames - 1);
  return Array.from({ length: width }, (_, c) => {
    const [a, b] = [values[first * width + c], values[second * width + c]];
    return a + (b - a) * (exact - first);
  });
}

// The middle and the reach of the whole way: what is seen when the camera does not follow.
const grounds = clip.parts.map((_, part) => {
  const seen = way.filter((point) => point && point.part === part);
  const xs = seen.map((p) => p.x);
  const zs = seen.map((p) => p.z);
  const [x0, x1, z0, z1] = [Math.min(...xs, 0), Math.max(...xs, 0), Math.min(...zs, 0), Math.max(...zs, 0)];
  return { middle: [(x0 + x1) / 2, (z0 + z1) / 2], reach: Math.hypot(x1 - x0, z1 - z0) / 2 };
});

function cameraPose(name, time) {
  const [x, , z] = smoothAt(smooth.roots, 3, time);
  const front = smoothAt(smooth.facing, 1, time)[0];
  const ground = grounds[partAt(time)];
  const room = partOf(time).yaw;
  const yaw = clip.flat ? 0 : { room, front, side: front + Math.PI / 2, top: room }[name];
  const lift = clip.flat ? 0 : LIFT[name];
  const target = state.follow ? [x, clip.floor + 0.47 * clip.height, z] : [ground.middle[0], clip.floor + 0.4 * clip.height, ground.middle[1]];
  return { yaw, lift, target, reach: state.follow ? 0 : ground.reach };
}

const ease = { from: null, start: 0 };

function stageCamera(time) {
  const pose = cameraPose(state.camera, time);
  if (ease.from) {
    const part = clamp((performance.now() - ease.start) / EASE_MS, 0, 1);
    const eased = 1 - (1 - part) ** 3;
    pose.yaw = ease.from.yaw + wrapped(pose.yaw - ease.from.yaw) * eased;
    pose.lift = ease.from.lift + (pose.lift - ease.from.lift) * eased;
    pose.target = along(ease.from.target, pose.target, eased);
    pose.reach = ease.from.reach + (pose.reach - ease.from.reach) * eased;
    if (part < 1) redraw();
    else ease.from = null;
  }
  stage.pose = pose;
  const size = clip.height * clip.girth > 0 ? clip.height / 1.7 : 1;
  const distance = (DISTANCE * size + pose.reach * 1.2) / state.zoom;
  // The body takes 70 % of the height, less where a wide view is narrow.
  const room = Math.min(stage.height * 0.7, stage.width * 0.95);
  const focal = (room * DISTANCE * size) / clip.height;
  return cameraAt({
    yaw: pose.yaw + state.turn, lift: clamp(pose.lift + state.tilt, -0.2, 1.55), distance, focal, target: pose.target,
    centre: [stage.width / 2, stage.height * (state.camera === "top" ? 0.5 : 0.54)],
  });
}

const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

function setCamera(name) {
  if (clip.flat) name = "room";
  if (!reducedMotion.matches && stage.pose) {
    ease.from = { ...stage.pose, yaw: stage.pose.yaw + state.turn, lift: stage.pose.lift + state.tilt };
    ease.start = performance.now();
  }
  Object.assign(state, { camera: name, turn: 0, tilt: 0, zoom: 1 });
  keepHash();
  redraw("change");
}

function toggle(what) {
  if (what === "follow" && stage.pose && !reducedMotion.matches) {
    ease.from = { ...stage.pose };
    ease.start = performance.now();
  }
  state[what] = !state[what];
  keepHash();
  redraw("change");
}

function turnCamera(x, y) {
  if (clip.flat) return;
  state.turn = wrapped(state.turn - x * 0.008);
  state.tilt = clamp(state.tilt + y * 0.006, -0.2 - LIFT[state.camera], 1.55 - LIFT[state.camera]);
  keepHash();
  redraw();
}

function zoomCamera(by) {
  state.zoom = clamp(state.zoom * by, 0.3, 6);
  keepHash();
  redraw();
}

(() => {
  const { canvas } = stage;
  const touching = new Map();
  let spread = 0;
  canvas.addEventListener("pointerdown", (event) => {
    touching.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("turning");
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = touching.get(event.pointerId);
    if (!before) return;
    touching.set(event.pointerId, [event.clientX, event.clientY]);
    if (touching.size === 2) {
      const [a, b] = [...touching.values()];
      const now = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (spread) zoomCamera(now / spread);
      spread = now;
    } else turnCamera(event.clientX - before[0], event.clientY - before[1]);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => {
      touching.delete(event.pointerId);
      spread = 0;
      canvas.classList.remove("turning");
    });
  }
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomCamera(Math.exp(-event.deltaY * 0.0015));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => setCamera(state.camera));
})();
