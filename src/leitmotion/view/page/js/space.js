// A camera and what it sees: from metres in the room to pixels on a canvas.

// `yaw` 0 stands before a person who faces +Z; `lift` is how far it looks down, radians.
function cameraAt({ yaw, lift, distance, target, focal, centre }) {
  const [sy, cy, sl, cl] = [Math.sin(yaw), Math.cos(yaw), Math.sin(lift), Math.cos(lift)];
  return {
    yaw, distance, target, focal, centre,
    right: [cy, 0, -sy],
    up: [-sy * sl, cl, -cy * sl],
    back: [sy * cl, sl, cy * cl],
  };
}

// Writes x, y and the pixels per metre there; `depth` grows away from the camera.
function project(camera, x, y, z, out) {
  const { right, up, back, target, focal, centre } = camera;
  const dx = x - target[0];
  const dy = y - target[1];
  const dz = z - target[2];
  const depth = camera.distance - (dx * back[0] + dy * back[1] + dz * back[2]);
  const scale = focal / depth;
  out.x = centre[0] + scale * (dx * right[0] + dz * right[2]);
  out.y = centre[1] - scale * (dx * up[0] + dy * up[1] + dz * up[2]);
  out.scale = scale;
  out.depth = depth;
  return out;
}

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => {
  const length = norm(a);
  return length > 1e-6 ? a.map((v) => v / length) : [NaN, NaN, NaN];
};
const along = (a, b, part) => a.map((v, k) => v + (b[k] - v) * part);
const known = (...points) => points.every((p) => p && !Number.isNaN(p[0]));
