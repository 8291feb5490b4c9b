// terms.js: slide 5 with the numbers of one pixel, light by light. The data are those of
// reports/page_terms.h.

const explained = new Map();  // anchor of a scene -> promise of its terms

function termsOf(anchor) {
  if (explained.has(anchor)) return explained.get(anchor);
  const promise = (async () => {
    await wholePage;
    const element = document.getElementById("terms-" + anchor);
    if (!element) return null;
    const raw = JSON.parse(element.textContent);
    raw.seen = await inflated(raw.seen);
    for (const light of raw.lights) {
      light.gates = await inflated(light.gates);
      light.blockers = await inflated(light.blockers);
      for (const term of light.terms) term.values = await unpacked(term, raw.width);
    }
    return raw;
  })();
  explained.set(anchor, promise);
  return promise;
}

const rgb = (color) => color[0] === color[1] && color[1] === color[2]
  ? short(color[0], 3) : `(${color.map((v) => short(v, 3)).join(", ")})`;
const times = (...factors) => [0, 1, 2].map((c) =>
  factors.reduce((product, f) => product * (typeof f === "number" ? f : f[c]), 1));
const plus = (...colors) => [0, 1, 2].map((c) => colors.reduce((sum, color) => sum + color[c], 0));

const kUnits = { alpha: (v) => `${short(v * 180 / Math.PI, 3)}°` };

function element(name, text, kind = "") {
  const made = document.createElement(name);
  made.textContent = text;
  if (kind) made.className = kind;
  return made;
}

// Why a light adds nothing, or not all: "in shadow: ball is in between".
function stopOf(terms, light, at) {
  const gate = light.gates[at], blocker = terms.objects[light.blockers[at] - 1];
  if (gate && terms.reasons[gate] !== "something is in between") return terms.reasons[gate];
  if (!gate && !blocker) return "";
  return `${gate ? "in shadow" : "partly in shadow"}: ${blocker ? blocker.name : "something"} is in between`;
}

// What one light adds, as lines: its terms, then the two products.
function lightLines(light, object, at) {
  const value = Object.fromEntries(light.terms.map((term) => [term.name, term.values[3 * at]]));
  const { diffuse: D = 0, specular: S = 0 } = value;
  const lines = light.terms.filter((term) => !["diffuse", "specular"].includes(term.name))
    .map((term) => `${term.name} ${(kUnits[term.name] || ((v) => short(v, 3)))(value[term.name])}`);
  const color = [times(object.kd, light.diffuse, D), times(object.ks, light.specular, S)];
  const sums = [`kd Id D = ${rgb(object.kd)} · ${rgb(light.diffuse)} · ${short(D, 3)} = ${rgb(color[0])}`];
  if (object.ks.some((v) => v > 0))
    sums.push(`ks Is S = ${rgb(object.ks)} · ${rgb(light.specular)} · ${short(S, 3)} = ${rgb(color[1])}`);
  return { terms: lines.join(" · "), sums, color: plus(...color) };
}

// The equation at a pixel, for the layer that is shown.
function equationAt(terms, layer, at) {
  const object = terms.objects[terms.seen[at] - 1];
  if (!object) return [element("p", "Nothing is seen at the pixel's centre.", "dim")];
  const lines = [element("p", `${object.name}: ka ${rgb(object.ka)}, kd ${rgb(object.kd)}, ks ${rgb(object.ks)}, ns ${short(object.ns)}`)];
  let sum = [0, 0, 0];
  if (["all", "ambient"].includes(layer.light)) {
    sum = times(object.ka, terms.ambient);
    lines.push(element("p", `ka Ia = ${rgb(object.ka)} · ${rgb(terms.ambient)} = ${rgb(sum)}`, "sum"));
  }
  for (const light of terms.lights) {
    if (!["all", light.name].includes(layer.light)) continue;
    const said = lightLines(light, object, at);
    const stop = stopOf(terms, light, at);
    lines.push(element("h4", `${light.name}${light.name === light.type ? "" : `, ${light.type}`}${light.lamps > 1 ? `, mean of ${light.lamps} lamps` : ""}`),
               element("p", said.terms, "dim"), ...(stop ? [element("p", stop, "stop")] : []),
               ...said.sums.map((text) => element("p", text, "sum")));
    sum = plus(sum, said.color);
  }
  lines.push(element("p", `sum ${rgb(sum)}${terms.samples > 1 ? " at the centre; the pixel is a mean" : ""}`, "sum"));
  if (terms.planted) lines.push(element("p", `This run has a planted mistake, and so have these numbers: ${terms.planted}.`, "dim"));
  return lines;
}

// Fills the section, if the page has the terms of the scene.
async function writeEquation() {
  const { anchor, cursor } = view, terms = await termsOf(anchor);
  if (view.anchor !== anchor || view.cursor !== cursor) return;
  $("equation").hidden = !terms || terms.code;
  $("equation").dataset.at = [anchor, ...cursor].join();
  if (!$("equation").hidden)
    $("equation-lines").replaceChildren(...equationAt(terms, layerNow(), cursor[1] * view.data.width + cursor[0]));
}
