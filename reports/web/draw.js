// draw.js: numbers as colours.

const kDark = matchMedia("(prefers-color-scheme: dark)");

// Differences: blue where ours is darker, red where it is brighter, blank at 0; the ends beyond
// what is allowed. Dark pages have a dark blank. Grey needs no colour vision: black is darker.
const kScales = {
  light: { stops: [[67, 147, 195], [172, 210, 230], [250, 250, 250], [250, 196, 168], [222, 110, 84]],
           under: [5, 40, 120], over: [140, 0, 20] },
  dark: { stops: [[70, 155, 225], [35, 80, 125], [14, 16, 20], [130, 62, 38], [226, 112, 78]],
          under: [185, 220, 255], over: [255, 205, 190] },
  grey: { stops: [[60, 60, 60], [95, 95, 95], [128, 128, 128], [170, 170, 170], [205, 205, 205]],
          under: [0, 0, 0], over: [255, 255, 255] },
};
const kNotFinite = [255, 0, 255];
// Stripes where a reference says nothing.
const unknownAt = (i, width) => (i % width + Math.floor(i / width)) % 6 < 3 ? [104, 104, 112] : [136, 136, 144];
const kDecades = 6;  // of the logarithmic scale

const scaleNow = (grey) => kScales[grey ? "grey" : kDark.matches ? "dark" : "light"];

// The colour of a position in [-1, 1] on a scale.
function scaleColor({ stops }, position) {
  const at = (Math.max(-1, Math.min(1, position)) + 1) / 2 * (stops.length - 1);
  const lower = Math.min(Math.floor(at), stops.length - 2), part = at - lower;
  return stops[lower].map((low, c) => Math.round(low + part * (stops[lower + 1][c] - low)));
}

const gradientOf = (scale) =>
  `linear-gradient(to right, ${scale.stops.map((s) => `rgb(${s})`).join(", ")})`;

// Where a difference stands on the scale. "share": the root of its share of what is allowed at the
// pixel, so that what rounding leaves over can be seen. "log": decades up to `top`.
function scalePosition(d, kind, allowed, top) {
  const size = Math.abs(d);
  if (size === 0) return 0;
  if (kind === "share") return Math.sign(d) * Math.sqrt(size / allowed);
  return Math.sign(d) * Math.max(0, 1 + Math.log10(size / top) / kDecades);
}

// The largest finite difference, rounded up to a power of ten: the top of the logarithmic scale.
function topOf(difference) {
  let top = 0;
  for (const d of difference) if (Number.isFinite(d)) top = Math.max(top, Math.abs(d));
  return top > 0 ? 10 ** Math.ceil(Math.log10(top) - 1e-9) : 1;
}

function blank(width, height) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  return canvas;
}

function painted(width, height, colorOf) {
  const canvas = blank(width, height), context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    image.data.set(colorOf(i), 4 * i);
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

function srgb(linear) {
  const v = Math.max(0, Math.min(1, linear));
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
}

// A picture as people see it, at 2^stops of its light. `covered` says where it says anything.
function paintedPicture(values, width, height, stops = 0, covered = () => true) {
  const gain = 2 ** stops;
  return painted(width, height, (i) => {
    if (!covered(i)) return unknownAt(i, width);
    const color = [0, 1, 2].map((c) => values[3 * i + c] * gain);
    return color.every((v) => !Number.isNaN(v)) && color.every(Number.isFinite)
      ? color.map(srgb) : kNotFinite;
  });
}

// The difference of a reference, on a scale.
function paintedDifference(layer, theirs, width, height, kind = "share", grey = false) {
  const scale = scaleNow(grey), top = topOf(theirs.difference);
  return painted(width, height, (i) => {
    if (!covers(theirs, i)) return unknownAt(i, width);
    const d = largestDifference(theirs.difference, i);
    if (Number.isNaN(d)) return kNotFinite;
    const position = scalePosition(d, kind, theirs.allowed[layer.edge[i] ? 1 : 0], top);
    if (kind === "share" && Math.abs(position) > 1) return position > 0 ? scale.over : scale.under;
    return scaleColor(scale, position);
  });
}

// The figures of the layers that are folded open get their pictures.
async function paintFigures(details) {
  const buttons = [...details.querySelectorAll(".zoom")].filter((b) => b.closest("details.layer").open);
  for (const button of buttons) {
    if (button.dataset.painting === String(kDark.matches)) continue;
    button.dataset.painting = String(kDark.matches);
    const { scene, layer, reference, show } = button.dataset;
    const data = await picturesOf(scene), whole = data.layers[layer];
    const theirs = whole.theirs.find((each) => each.reference === reference);
    const made = show === "ours" ? paintedPicture(whole.ours, data.width, data.height)
      : show === "theirs" ? paintedPicture(theirs.values, data.width, data.height, 0, (i) => covers(theirs, i))
      : paintedDifference(whole, theirs, data.width, data.height);
    const canvas = button.querySelector("canvas");
    canvas.getContext("2d").drawImage(made, 0, 0);
    button.dataset.painted = button.dataset.painting;
  }
}
