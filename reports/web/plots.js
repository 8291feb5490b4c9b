// plots.js: the error distribution and the scan line, as SVG.

const kSvg = document.getElementById("svg").namespaceURI;  // the name, without writing an address

function svg(name, attributes, ...children) {
  const element = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}
const kPlot = { width: 320, height: 130, left: 50, right: 8, top: 8, bottom: 20 };

function frame(label, height = kPlot.height) {
  return svg("svg", { viewBox: `0 0 ${kPlot.width} ${height}`, class: "plot", role: "img", "aria-label": label });
}
const text = (x, y, string, anchor = "middle") =>
  svg("text", { x, y, "text-anchor": anchor }, string);
const line = (x1, y1, x2, y2, name) => svg("line", { x1, y1, x2, y2, class: name });

// How many pixels differ by how much: logarithmic both ways, a bar per quarter of a decade. Edge
// pixels are hatched; lines show what is allowed. Closed forms are held to less than renderers.
function distribution(layer, theirs) {
  const first = theirs.allowed[0] > 0 && theirs.allowed[0] < 1e-11 ? -18 : -12, last = 1, bins = (last - first) * 4;
  const counts = [new Array(bins).fill(0), new Array(bins).fill(0)];
  let equal = 0, bad = 0, covered = 0;
  for (let i = 0; i < layer.edge.length; i++) {
    if (!covers(theirs, i)) continue;
    covered++;
    const d = Math.abs(largestDifference(theirs.difference, i));
    if (Number.isNaN(d)) bad++;
    else if (d === 0) equal++;
    else counts[layer.edge[i] ? 1 : 0][Math.max(0, Math.min(bins - 1, Math.floor((Math.log10(d) - first) * 4)))]++;
  }
  const { width, height, left, right, top, bottom } = kPlot, floor = height - bottom;
  const x = (decade) => left + (decade - first) / (last - first) * (width - left - right);
  const most = Math.max(10, ...counts[0].map((n, i) => n + counts[1][i]));
  const y = (count) => floor - (count > 0 ? (Math.log10(count) + 0.3) / (Math.log10(most) + 0.3) : 0) * (floor - top);
  const plot = frame(`${equal} of ${covered} pixels are equal`);
  for (let n = 1; n <= most; n *= 10) plot.append(line(left, y(n), width - right, y(n), "grid"), text(left - 4, y(n) + 3, n, "end"));
  for (let decade = first; decade <= last; decade += 3) plot.append(text(x(decade), height - 6, decade ? `1e${decade}` : "1"));
  for (let i = 0; i < bins; i++) {
    const inside = counts[0][i], both = inside + counts[1][i], at = x(first + i / 4), wide = x(first + 0.25) - x(first) - 0.5;
    if (both > inside) plot.append(svg("rect", { x: at, y: y(both), width: wide, height: y(inside) - y(both), class: "edge" }));
    if (inside) plot.append(svg("rect", { x: at, y: y(inside), width: wide, height: floor - y(inside), class: "inside" }));
  }
  theirs.allowed.forEach((allowed, r) => {
    if (allowed > 0) plot.append(line(x(Math.log10(allowed)), top, x(Math.log10(allowed)), floor, r ? "allowed edge" : "allowed"));
  });
  const others = layer.edge.length - covered;
  const note = `${equal.toLocaleString("en")} of ${covered.toLocaleString("en")} pixels are equal` +
    (theirs.step > 0 ? ` to within ${short(theirs.step / 2)}` : "") +
    (bad ? `, ${bad} not finite` : "") +
    (others ? `; of ${others.toLocaleString("en")} others the ${theirs.title} says nothing` : "");
  return { plot, note };
}

// The values along the row (or column) of a pixel: luminance of both above, their difference (the
// channel that differs most) below.
function scanLine(data, layer, theirs, [px, py], column) {
  const length = column ? data.height : data.width;
  const index = (t) => column ? t * data.width + px : py * data.width + t;
  const luminance = (values, i) => 0.2126 * values[3 * i] + 0.7152 * values[3 * i + 1] + 0.0722 * values[3 * i + 2];
  const series = [];
  for (let t = 0; t < length; t++) {
    const i = index(t);
    series.push([luminance(layer.ours, i), ...(covers(theirs, i)
      ? [luminance(theirs.values, i), largestDifference(theirs.difference, i)] : [NaN, NaN])]);
  }
  const finite = (k) => series.map((s) => s[k]).filter(Number.isFinite);
  const { width, left, right, top } = kPlot, middle = 84, bottom = 150;
  const x = (t) => left + (t + 0.5) / length * (width - left - right);
  const high = Math.max(1e-12, ...finite(0), ...finite(1)), reach = Math.max(0, ...finite(2).map(Math.abs));
  const upper = (v) => middle - v / high * (middle - top);
  const lower = (v) => (middle + 14 + bottom) / 2 - (reach ? v / reach : 0) * (bottom - middle - 14) / 2;
  const path = (k, y) => {
    let steps = "", pen = "M";
    series.forEach((s, t) => {
      if (!Number.isFinite(s[k])) { pen = "M"; return; }
      steps += `${pen}${x(t).toFixed(1)} ${y(s[k]).toFixed(1)}`;
      pen = "L";
    });
    return steps || "M0 0";
  };
  const plot = frame(`values along ${column ? "column " + px : "row " + py}`, bottom + 18);
  const here = column ? py : px;
  plot.append(
    line(x(here), top, x(here), bottom, "here"), line(left, middle, width - right, middle, "grid"),
    line(left, lower(0), width - right, lower(0), "grid"),
    text(left - 4, top + 8, short(high), "end"), text(left - 4, middle, "0", "end"),
    text(left - 4, middle + 20, short(reach), "end"), text(left - 4, bottom, short(-reach), "end"),
    svg("path", { d: path(1, upper), class: "theirs" }), svg("path", { d: path(0, upper), class: "ours" }),
    svg("path", { d: path(2, lower), class: "difference" }),
    text(x(0), bottom + 14, "0", "start"), text(x(length - 1), bottom + 14, length - 1, "end"));
  return plot;
}
