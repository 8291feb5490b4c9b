"use strict";
// data.js: the pictures of a scene as numbers, unpacked when somebody asks for them. The format is
// in reports/packing.h.

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// The value of a half float's bits.
function halfValue(bits) {
  const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, digits = bits & 1023;
  if (exponent === 31) return digits ? NaN : sign * Infinity;
  return exponent ? sign * (1 + digits / 1024) * 2 ** (exponent - 15) : sign * digits * 2 ** -24;
}

// What is kept as distances from a guess becomes words again, in place.
function restore(words, width, guess) {
  for (let i = 0; i < words.length; i++) {
    const left = i && words[i - 1], above = i >= width, column = i % width;
    const guessed = !column ? (above ? words[i - width] : 0)
      : guess === "line" ? (column > 1 ? 2 * left - words[i - 2] : left)
      : above ? left + words[i - width] - words[i - width - 1] : left;
    words[i] = guessed + (words[i] >> 1 ^ -(words[i] & 1));
  }
}

// Red, green, blue, pixel by pixel.
async function unpacked({ exponent, guess, data }, width) {
  const bytes = await inflated(data);
  const length = bytes.length / 2, count = length / 3, scale = 2 ** -exponent;
  const values = new Float64Array(length), words = new Uint16Array(length);
  for (let i = 0; i < length; i++) words[i] = bytes[i] << 8 | bytes[length + i];
  if (guess !== "none") restore(words, width, guess);
  for (let i = 0; i < length; i++) {
    if (i >= count) words[i] += words[i - count];
    values[i % count * 3 + Math.floor(i / count)] = halfValue(words[i]) * scale;
  }
  return values;
}

const sumOf = (pictures) => pictures[0].map((_, i) => pictures.reduce((sum, values) => sum + values[i], 0));

// Whether a reference says anything of a pixel: a closed form may not.
const covers = (theirs, i) => !theirs.known || theirs.known[i] === 1;

// A layer: { light, type, ours, edge, theirs: [{ title, values, difference, allowed, known, ... }] }.
async function unpackedLayer(raw, ours, differenceOf) {
  const theirs = await Promise.all(raw.theirs.map(async (each, r) => {
    const packed = await differenceOf(r);
    const values = new Float64Array(ours.length), difference = new Float64Array(ours.length);
    for (let i = 0; i < ours.length; i++) {
      values[i] = Number.isFinite(ours[i]) ? ours[i] - packed[i] : -packed[i];
      difference[i] = Number.isFinite(ours[i]) ? packed[i] : NaN;
    }
    return { ...each, values, difference, known: each.known && await inflated(each.known) };
  }));
  return { ...raw, ours, theirs, edge: await inflated(raw.edge), flags: await inflated(raw.flags) };
}

// The pictures stand behind this script, so that the page answers before it has read them.
const wholePage = new Promise((resolve) =>
  document.readyState === "loading" ? addEventListener("DOMContentLoaded", resolve) : resolve());

const opened = new Map();  // id of a scene's element -> promise of its pictures

// The pictures of the scene with that anchor ("s3").
function picturesOf(anchor) {
  if (opened.has(anchor)) return opened.get(anchor);
  const promise = (async () => {
    await wholePage;
    const element = document.getElementById("data-" + anchor);
    if (!element) throw new Error("no pictures of " + anchor);
    const raw = JSON.parse(element.textContent);
    const made = new Map();
    const once = (packed, place) => {
      const at = packed.same ?? place;
      if (!made.has(at)) made.set(at, unpacked(packed, raw.width));
      return made.get(at);
    };
    const parts = () => Promise.all(raw.layers.slice(0, -1).map(({ ours }, k) => once(ours, `${k}`)));
    const oursOf = async (layer, k) => layer.ours.sum ? sumOf(await parts()) : once(layer.ours, `${k}`);
    raw.layers = await Promise.all(raw.layers.map(async (layer, k) =>
      unpackedLayer(layer, await oursOf(layer, k),
                    (r) => once(layer.theirs[r].difference, `${k},${r}`))));
    return raw;
  })();
  opened.set(anchor, promise);
  return promise;
}

// The channel that differs most, with its sign; NaN where a value is none.
function largestDifference(difference, i) {
  let largest = 0;
  for (let c = 3 * i; c < 3 * i + 3; c++) {
    if (!Number.isFinite(difference[c])) return NaN;
    if (Math.abs(difference[c]) > Math.abs(largest)) largest = difference[c];
  }
  return largest;
}

// Two digits, or `digits`, as people read them: 0, 0.25, 1.2e-7.
function short(value, digits = 2) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "∞");
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 0.01 && size < 1e4 ? String(Number(value.toPrecision(digits)))
                                          : value.toExponential(digits - 1).replace(/\.?0*e\+?/, "e");
  return text.replace("-", "−").replace("e-", "e−");
}
