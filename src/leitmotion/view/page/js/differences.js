// What stands beside the figure: L and R at the hands, or how far the joints of a pair are apart.

const NAMED = 3;
const THIN = 3;
const WORTH_NAMING = clip.metres ? 0.03 : 0.02 * clip.height;

function label(pen, text, x, y, colour, { align = "left", size = 13, weight = 600 } = {}) {
  pen.font = `${weight} ${size}px ${theme.font}`;
  pen.textAlign = align;
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  pen.strokeStyle = theme.tokens.surface;
  pen.lineWidth = 4;
  pen.strokeText(text, x, y);
  pen.fillStyle = colour;
  pen.fillText(text, x, y);
}

function drawSides(pen, camera) {
  const hands = ["left", "right"].map((side) => {
    const tip = TIPS.find((t) => t.side === side && /hand|wrist/.test(t.role));
    const [hand, elbow] = [tip && pointOf(posture, tip.role), pointOf(posture, `${side}_elbow`)];
    if (!known(hand, elbow)) return null;
    const [h, e] = [hand, elbow].map((p) => project(camera, p[0], p[1], p[2], {}));
    const length = Math.hypot(h.x - e.x, h.y - e.y) || 1;
    const at = { side, x: h.x + (12 * (h.x - e.x)) / length, y: h.y + (12 * (h.y - e.y)) / length };
    return besideTrunk(camera, at);
  });
  const [l, r] = hands;
  if (l && r && Math.hypot(l.x - r.x, l.y - r.y) < 15) {
    const [low, high] = l.x < r.x ? [l, r] : [r, l];
    low.x -= 8;
    high.x += 8;
  }
  for (const hand of hands) {
    if (!hand) continue;
    const colour = hand.side === "left" ? theme.tokens.left : theme.tokens.ink;
    label(pen, hand.side === "left" ? "L" : "R", hand.x, hand.y, colour, { align: "center", size: 11.5 });
  }
}

// A letter never stands on the trunk: it moves to the nearer side of it.
function besideTrunk(camera, at) {
  const corners = ["left_shoulder", "right_shoulder", "left_hip", "right_hip"].map((role) => pointOf(posture, role));
  if (!known(...corners)) return at;
  const seen = corners.map((p) => project(camera, p[0], p[1], p[2], {}));
  const edge = (TORSO_STROKE / 2) * clip.girth * seen[0].scale + 9;
  const [low, high] = [Math.min(...seen.map((p) => p.x)) - edge, Math.max(...seen.map((p) => p.x)) + edge];
  const [top, foot] = [Math.min(...seen.map((p) => p.y)) - edge, Math.max(...seen.map((p) => p.y)) + edge];
  const way = at.x - low < high - at.x ? low - at.x : high - at.x;
  if (at.x > low && at.x < high && at.y > top && at.y < foot && Math.abs(way) < 26) at.x += way;
  return at;
}

// Joint to joint, filled at 1 and hollow at 2; the three largest with a name and a number, three more thin.
function drawDifferences(pen, camera, pair) {
  const { joints } = comparePair(pair);
  const end = (body, r) => project(camera, body[3 * r], body[3 * r + 1], body[3 * r + 2], {});
  const lines = joints.slice(0, NAMED + THIN).map((joint, rank) => ({
    ...joint, a: end(posture, joint.index), b: end(placed, joint.index),
    named: rank < NAMED && joint.apart >= WORTH_NAMING,
  }));
  for (const line of [...lines].reverse()) drawDifference(pen, line);
  const middle = project(camera, ...rootOf(posture), {}).x;
  const taken = [...bodyBoxes(camera), ...lines.flatMap(({ a, b }) => [0, 0.33, 0.67, 1].map((part) => spot({ x: a.x + (b.x - a.x) * part, y: a.y + (b.y - a.y) * part }, 7)))];
  for (const line of lines) if (line.named) nameDifference(pen, line, middle, taken);
}

const spot = (at, r) => ({ left: at.x - r, right: at.x + r, top: at.y - r, bottom: at.y + r });

// What a name should not cover: the parts of the figure, as boxes along them.
function bodyBoxes(camera) {
  const boxes = [];
  for (const part of partsOf(posture)) {
    const seen = part.points.map((p) => project(camera, p[0], p[1], p[2], {}));
    if (part.kind === "torso") {
      const [xs, ys] = [seen.map((p) => p.x), seen.map((p) => p.y)];
      boxes.push({ left: Math.min(...xs) - 8, right: Math.max(...xs) + 8, top: Math.min(...ys) - 8, bottom: Math.max(...ys) + 8 });
    } else if (part.kind === "head") boxes.push(spot(seen[0], HEAD[1] * clip.girth * seen[0].scale));
    else if (seen.length === 2) {
      for (const along of [0, 0.25, 0.5, 0.75, 1]) {
        const at = { x: seen[0].x + (seen[1].x - seen[0].x) * along, y: seen[0].y + (seen[1].y - seen[0].y) * along };
        boxes.push(spot(at, 7));
      }
    }
  }
  return boxes;
}

function drawDifference(pen, { a, b, named }) {
  const [r, width] = named ? [4.2, 2.2] : [2.6, 1.1];
  pen.globalAlpha = named ? 1 : 0.7;
  pen.strokeStyle = pen.fillStyle = theme.tokens.diff;
  pen.lineWidth = width;
  pen.beginPath();
  pen.moveTo(a.x, a.y);
  pen.lineTo(b.x, b.y);
  pen.stroke();
  disc(pen, a.x, a.y, r);
  pen.fill();
  disc(pen, b.x, b.y, r - width / 2 + 0.4);
  pen.fillStyle = theme.tokens.surface;
  pen.fill();
  pen.lineWidth = named ? 1.8 : 1.1;
  pen.stroke();
  pen.globalAlpha = 1;
}

// The name stands beside its joint, on the side away from the body, at the nearest place where it covers nothing.
function nameDifference(pen, line, middle, taken) {
  const text = `${line.word} ${apartWhole(line.apart)}`;
  pen.font = `600 13px ${theme.font}`;
  const width = pen.measureText(text).width;
  const onRight = (line.a.x + line.b.x) / 2 >= middle;
  const wanted = onRight === line.b.x > line.a.x ? line.b.y : line.a.y;
  let best = null;
  for (const side of [onRight, !onRight]) {
    for (let away = 0; away <= 90; away += 10) {
      for (let k = 0; k < 17; k++) {
        const off = (k % 2 ? 1 : -1) * Math.ceil(k / 2) * 8;
        const from = side ? Math.max(line.a.x, line.b.x) + 12 + away : Math.min(line.a.x, line.b.x) - 12 - away - width;
        const x = clamp(from, 6, Math.max(stage.width - width - 6, 6));
        const y = clamp(wanted + off, 52, stage.height - 36);
        const box = { left: x - 3, right: x + width + 3, top: y - 9, bottom: y + 9 };
        const hit = taken.some((t) => t.left < box.right && t.right > box.left && t.top < box.bottom && t.bottom > box.top);
        const price = Math.abs(off) + 0.8 * away + (side === onRight ? 0 : 40) + (hit ? 1000 : 0);
        if (!best || price < best.price) best = { price, x, y, box };
      }
    }
  }
  taken.push(best.box);
  label(pen, text, best.x, best.y, theme.tokens.diff);
}
