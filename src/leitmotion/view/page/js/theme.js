// Colours come from the style sheet, so that canvases and page agree in both themes.

const root = document.documentElement;
const theme = { dark: false, tokens: {}, map: null };
const systemDark = matchMedia("(prefers-color-scheme: dark)");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

const rgb = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

// Mix `part` of colour b into colour a.
const mixed = new Map();
function mix(a, b, part) {
  const level = Math.round(part * 100);
  const key = a + b + level;
  let made = mixed.get(key);
  if (!made) {
    const [x, y] = [rgb(a), rgb(b)];
    made = "#" + x.map((v, k) => Math.round(v + ((y[k] - v) * level) / 100).toString(16).padStart(2, "0")).join("");
    mixed.set(key, made);
  }
  return made;
}

function readTheme() {
  const style = getComputedStyle(root);
  const names = ["page", "surface", "sunken", "ink", "ink2", "ink3", "line", "line2", "left", "diff", "mirror", "focus", "chip"];
  for (const name of [...names, ..."ABCDEFGH"]) theme.tokens[name] = style.getPropertyValue("--" + name).trim();
  theme.font = getComputedStyle(document.body).fontFamily;
  theme.shadow = Number(style.getPropertyValue("--shadow"));
  theme.map = distanceColours(style.getPropertyValue("--map").trim().split(/\s+/));
}

// 256 colours of the distance map, far at 0 and near at 255, lightness linear in distance (OKLab).
function distanceColours(stops) {
  const labs = stops.map((hex) => toLab(rgb(hex)));
  const table = new Uint32Array(256);
  for (let i = 0; i < 256; i++) {
    const at = (i / 255) * (labs.length - 1);
    const k = Math.min(Math.floor(at), labs.length - 2);
    const lab = labs[k].map((v, c) => v + (labs[k + 1][c] - v) * (at - k));
    const [r, g, b] = fromLab(lab);
    table[i] = (255 << 24) | (b << 16) | (g << 8) | r;
  }
  return table;
}

function toLab(colour) {
  const [r, g, b] = colour.map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function fromLab([L, a, b]) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((v) => Math.round(255 * clamp(v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055, 0, 1)));
}

// Past the eighth pattern the letter does the work; colour only while it is chosen.
function patternColour(p) {
  const letter = "ABCDEFGH"[p];
  if (letter) return theme.tokens[letter];
  return state.pattern === p ? theme.tokens.A : theme.tokens.ink2;
}

const patternToken = (p) => (p < 8 ? `var(--${"ABCDEFGH"[p]})` : state.pattern === p ? "var(--A)" : "var(--ink2)");

// Set a canvas to a size in CSS pixels at the screen's density (2 in print) and hand out its pen.
function sized(canvas, width, height) {
  const density = state.printing ? 2 : Math.min(devicePixelRatio || 1, 3);
  const [w, h] = [Math.max(1, Math.round(width * density)), Math.max(1, Math.round(height * density))];
  // Setting the size clears. On paper a canvas is drawn anew stroke by stroke, where clearRect would be a white sheet
  // over what lies beneath.
  const fresh = canvas.width !== w || canvas.height !== h || state.printing;
  if (fresh) {
    canvas.width = w;
    canvas.height = h;
  }
  canvas.style.width = width + "px";
  canvas.style.height = height + "px";
  const pen = canvas.getContext("2d");
  pen.setTransform(density, 0, 0, density, 0, 0);
  if (!fresh) pen.clearRect(0, 0, width, height);
  return pen;
}
