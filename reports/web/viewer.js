// viewer.js: one layer of one scene against one reference, large: what is shown, and drawing it.
// What the keys, the pointer and the address do is in controls.js.

const $ = (id) => document.getElementById(id);
const kShows = ["ours", "theirs", "difference", "slider", "side"];
const kMostZoom = 96, kSignZoom = 9;  // screen pixels per pixel; from there on signs are drawn

const view = {
  anchor: "", data: null, layer: 0, reference: 0, show: "ours", kind: "share", grey: false,
  zoom: 1, fitted: true, center: [0, 0], stops: 0, split: 0.5, cursor: [0, 0], pins: [], column: false,
};
const layerNow = () => view.data.layers[view.layer];
const theirsNow = () => layerNow().theirs[view.reference];
const titleOf = (layer) => layer.light === "all" ? "whole picture"
  : layer.light === "ambient" ? "ambient light"
  : layer.light === layer.type ? layer.light : `${layer.light} (${layer.type})`;

// ---- Where things are on the stage ----------------------------------------------------------

// The panes: rectangles of the stage in screen pixels, and what each shows.
function panes() {
  const { clientWidth: width, clientHeight: height } = $("stage");
  if (view.show !== "side") return [{ x: 0, y: 0, width, height, show: view.show }];
  const three = ["ours", "theirs", "difference"], gap = 6, shape = view.data.width / view.data.height;
  const wide = Math.min(width / 3 / shape, height) > Math.min(width / shape, height / 3);
  const share = ((wide ? width : height) - 2 * gap) / 3;
  return three.map((show, i) => wide ? { x: i * (share + gap), y: 0, width: share, height, show }
                                     : { x: 0, y: i * (share + gap), width, height: share, show });
}

function fit() {
  const [pane] = panes(), { width, height } = view.data;
  const room = Math.min(pane.width / width, pane.height / height);
  view.zoom = Math.max(0.1, room >= 1 ? Math.min(kMostZoom, Math.floor(room * 4) / 4) : room);
  view.center = [width / 2, height / 2];
  view.fitted = true;
}

// The screen place of a picture's corner in a pane.
const origin = (pane) => [pane.x + pane.width / 2 - view.center[0] * view.zoom,
                          pane.y + pane.height / 2 - view.center[1] * view.zoom];

// The pixel under a place of the stage, or null; also the place in the picture, with fractions.
function pixelAt(px, py) {
  const pane = panes().find((p) => px >= p.x && px < p.x + p.width && py >= p.y && py < p.y + p.height);
  if (!pane) return null;
  const [left, top] = origin(pane), at = [(px - left) / view.zoom, (py - top) / view.zoom];
  const pixel = at.map(Math.floor);
  const inside = pixel[0] >= 0 && pixel[1] >= 0 && pixel[0] < view.data.width && pixel[1] < view.data.height;
  return { at, pixel: inside ? pixel : null };
}

function zoomTo(zoom, about = view.center) {
  const next = Math.max(0.25, Math.min(kMostZoom, zoom));
  view.center = view.center.map((c, i) => about[i] + (c - about[i]) * view.zoom / next);
  view.zoom = next;
  view.fitted = false;
}

// The cursor's pixel stays in sight.
function follow() {
  const [pane] = panes();
  [pane.width, pane.height].forEach((size, i) => {
    const reach = Math.max(0, size / view.zoom / 2 - 1.5), at = view.cursor[i] + 0.5;
    if (Math.abs(at - view.center[i]) > reach) view.center[i] = at - Math.sign(at - view.center[i]) * reach;
  });
}

// ---- Pictures -------------------------------------------------------------------------------

const painting = new Map();  // what was painted last, by what it depends on
function pictureOf(show) {
  const { width, height } = view.data, theirs = theirsNow();
  const key = [view.anchor, view.layer, show,
               ...(show === "ours" ? [view.stops] : show === "theirs" ? [view.reference, view.stops]
                   : [view.reference, view.kind, view.grey, kDark.matches])].join();
  if (!painting.has(key)) {
    if (painting.size > 24) painting.clear();
    painting.set(key, show === "ours" ? paintedPicture(layerNow().ours, width, height, view.stops)
      : show === "theirs" ? paintedPicture(theirs.values, width, height, view.stops, (i) => covers(theirs, i))
      : paintedDifference(layerNow(), theirs, width, height, view.kind, view.grey));
  }
  return painting.get(key);
}

function drawPicture(context, pane, show) {
  const [left, top] = origin(pane), { width, height } = view.data;
  context.imageSmoothingEnabled = view.zoom < 1;
  context.drawImage(pictureOf(show), left, top, width * view.zoom, height * view.zoom);
  if (show === "difference" && view.zoom >= kSignZoom) drawSigns(context, pane);
}

// Plus and minus on the pixels, for eyes that do not tell blue from red.
function drawSigns(context, pane) {
  const [left, top] = origin(pane), { width, height } = view.data, zoom = view.zoom;
  const first = [pane.x - left, pane.y - top].map((v) => Math.max(0, Math.floor(v / zoom)));
  const last = [Math.min(width, Math.ceil((pane.x + pane.width - left) / zoom)),
                Math.min(height, Math.ceil((pane.y + pane.height - top) / zoom))];
  context.strokeStyle = kDark.matches && !view.grey ? "#fff9" : "#0009";
  context.lineWidth = Math.max(1, zoom / 16);
  context.beginPath();
  for (let y = first[1]; y < last[1]; y++)
    for (let x = first[0]; x < last[0]; x++) {
      const d = largestDifference(theirsNow().difference, y * width + x);
      if (!d || !covers(theirsNow(), y * width + x)) continue;
      const cx = left + (x + 0.5) * zoom, cy = top + (y + 0.5) * zoom, arm = zoom / 6;
      context.moveTo(cx - arm, cy);
      context.lineTo(cx + arm, cy);
      if (d < 0) continue;
      context.moveTo(cx, cy - arm);
      context.lineTo(cx, cy + arm);
    }
  context.stroke();
}

function drawMark(context, pane, [x, y], label) {
  const [left, top] = origin(pane), size = Math.max(view.zoom, 5);
  const cx = left + (x + 0.5) * view.zoom - size / 2, cy = top + (y + 0.5) * view.zoom - size / 2;
  for (const [color, grow] of [["#000", 1.5], ["#fff", 0.5]]) {
    context.strokeStyle = color;
    context.lineWidth = 1;
    context.strokeRect(cx - grow, cy - grow, size + 2 * grow, size + 2 * grow);
  }
  if (!label) return;
  context.font = "600 12px system-ui, sans-serif";
  context.lineWidth = 3;
  context.strokeStyle = "#000";
  context.strokeText(label, cx + size + 3, cy);
  context.fillStyle = "#fff";
  context.fillText(label, cx + size + 3, cy);
}

const paneTitle = (show) => show === "ours" ? "litmus" : show === "theirs" ? theirsNow().title : "difference";

function drawStage() {
  const stage = $("stage"), ratio = devicePixelRatio || 1, context = stage.getContext("2d");
  const wide = Math.round(stage.clientWidth * ratio), high = Math.round(stage.clientHeight * ratio);
  if (stage.width !== wide || stage.height !== high) {
    stage.width = wide;
    stage.height = high;
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, stage.clientWidth, stage.clientHeight);
  for (const pane of panes()) {
    context.save();
    context.beginPath();
    context.rect(pane.x, pane.y, pane.width, pane.height);
    context.clip();
    if (pane.show === "slider") {
      drawPicture(context, pane, "theirs");
      const divide = pane.x + view.split * pane.width;
      context.save();
      context.beginPath();
      context.rect(pane.x, pane.y, divide - pane.x, pane.height);
      context.clip();
      context.clearRect(pane.x, pane.y, pane.width, pane.height);
      drawPicture(context, pane, "ours");
      context.restore();
      context.fillStyle = "#000";
      context.fillRect(divide - 2, pane.y, 4, pane.height);
      context.fillStyle = "#fff";
      context.fillRect(divide - 1, pane.y, 2, pane.height);
    } else {
      drawPicture(context, pane, pane.show);
    }
    view.pins.forEach((pin, i) => drawMark(context, pane, pin, String(i + 1)));
    drawMark(context, pane, view.cursor);
    context.restore();
  }
  $("pane-titles").replaceChildren(...panes().map((pane) => {
    const label = document.createElement("span");
    label.textContent = pane.show === "slider" ? `litmus | ${theirsNow().title}` : paneTitle(pane.show);
    label.style.left = `${pane.x + 6}px`;
    label.style.top = `${pane.y + 6}px`;
    return label;
  }));
}

// ---- Text and figures beside the stage ------------------------------------------------------

function cells(name, values, exact) {
  const row = document.createElement("tr"), head = document.createElement("th");
  head.scope = "row";
  head.textContent = name;
  row.append(head, ...[...values].map((value) => {
    const cell = document.createElement("td");
    cell.textContent = typeof value === "string" ? value : short(value, exact);
    if (typeof value !== "string") cell.title = value;
    return cell;
  }));
  return row;
}

// What a light does at a pixel: the bits are those of scene/picture.h.
function regionsOf(bits = 0) {
  const shadow = bits & 7, named = { 0: "", 1: "lit", 4: "umbra" };
  return [named[shadow] ?? "penumbra", bits & 8 ? "highlight" : ""].filter(Boolean);
}

const kNothing = ["–", "–", "–"];  // where the reference says nothing

// The values of a pixel: of ours, theirs and their difference, all channels.
function valuesAt([x, y]) {
  const i = y * view.data.width + x, of = (values) => values.slice(3 * i, 3 * i + 3);
  const layer = layerNow(), theirs = theirsNow(), edge = layer.edge[i] ? 1 : 0, covered = covers(theirs, i);
  return { ours: of(layer.ours), theirs: covered ? of(theirs.values) : kNothing, covered,
           difference: covered ? of(theirs.difference) : kNothing,
           region: edge ? "edge" : ["interior", ...regionsOf(layer.flags[i])].join(", "), allowed: theirs.allowed[edge],
           largest: largestDifference(theirs.difference, i) };
}

function writeReadout() {
  const at = valuesAt(view.cursor), share = Math.abs(at.largest) / at.allowed;
  $("readout-at").textContent = `pixel ${view.cursor.join(", ")} · ${at.region}`;
  $("readout-values").replaceChildren(
    cells("litmus", at.ours, 4), cells(theirsNow().title, at.theirs, 4), cells("difference", at.difference, 3));
  const verdict = $("readout-share");
  verdict.textContent = !at.covered ? `the ${theirsNow().title} says nothing of this pixel`
    : Number.isNaN(at.largest) ? "✗ not a finite value"
    : !(at.allowed > 0) ? "" : share > 1 ? `✗ ${short(share)} times what is allowed (${short(at.allowed)})`
    : `✓ ${short(100 * share)} % of what is allowed (${short(at.allowed)})`;
  if (at.covered && theirsNow().step > at.allowed / 16)
    verdict.textContent += `; this file keeps it to ±${short(theirsNow().step / 2)}`;
  verdict.className = at.covered && (Number.isNaN(at.largest) || share > 1) ? "bad" : "dim";
  $("command").textContent = `litmus run ${view.data.word} ${theirsNow().source === "computed" ? "--with closed-form" : `--references ${theirsNow().source || "auto"}`}\n` +
    `litmus explain ${view.data.word} ${view.cursor.join(" ")}`;
  writeLights();
  writeEquation();
  $("scan").replaceChildren(scanLine(view.data, layerNow(), theirsNow(), view.cursor, view.column));
  $("scan-title").textContent = view.column ? `Along column ${view.cursor[0]}` : `Along row ${view.cursor[1]}`;
}

// What each light has at the pixel, of the channel that differs most: whose error is it?
function writeLights() {
  const { reference } = theirsNow(), i = view.cursor[1] * view.data.width + view.cursor[0];
  $("light-rows").replaceChildren(...view.data.layers.flatMap((layer, k) => {
    const theirs = layer.theirs.find((each) => each.reference === reference);
    if (!theirs) return [];
    const size = (c) => Math.abs(theirs.difference[c]);
    const at = [3 * i, 3 * i + 1, 3 * i + 2].reduce((a, b) => size(b) > size(a) || Number.isNaN(size(b)) ? b : a);
    const covered = covers(theirs, i), over = covered && !(size(at) <= theirs.allowed[layer.edge[i] ? 1 : 0]);
    const row = cells("", [layer.ours[at], ...(covered ? [theirs.values[at], theirs.difference[at]] : ["–", "–"])], 3);
    const choose = Object.assign(document.createElement("button"), { type: "button", className: "plain", textContent: titleOf(layer) });
    choose.addEventListener("click", () => chooseLayer(k));
    row.firstChild.append(over ? "✗ " : "", choose);
    row.className = over ? "bad" : k === view.layer ? "now" : "";
    return [row];
  }));
}
function writePins() {
  $("pins").hidden = view.pins.length === 0;
  $("pin-rows").replaceChildren(...view.pins.map((pin, i) => {
    const at = valuesAt(pin), body = document.createElement("tbody");
    const head = cells(`${i + 1}: ${pin.join(", ")}`, ["", "", ""]);
    const remove = document.createElement("button");
    remove.type = "button";
    remove.textContent = "✕";
    remove.setAttribute("aria-label", `remove pin ${i + 1}`);
    remove.addEventListener("click", () => { view.pins.splice(i, 1); refresh(); });
    head.lastChild.append(remove);
    body.append(head, cells("litmus", at.ours, 4), cells(theirsNow().title, at.theirs, 4),
                cells("difference", at.difference, 3));
    return body;
  }));
}

// The scale of the difference, with numbers.
function writeLegend() {
  const shown = ["difference", "side"].includes(view.show), scale = scaleNow(view.grey);
  $("legend").hidden = !shown;
  $("exposure-tools").hidden = view.show === "difference";
  $("split").hidden = view.show !== "slider";
  $("legend-under").style.background = `rgb(${scale.under})`;
  $("legend-over").style.background = `rgb(${scale.over})`;
  $("legend-ramp").style.background = gradientOf(scale);
  for (const cap of [$("legend-under"), $("legend-over")]) cap.hidden = view.kind !== "share";
  const theirs = theirsNow(), top = topOf(theirs.difference);
  $("stripes").hidden = !theirs.known || view.show === "ours";
  $("stripes").textContent = `striped: the ${theirs.title} says nothing there`;
  const ticks = view.kind === "share"
    ? [-1, -0.25, -0.04, 0, 0.04, 0.25, 1].map((s) => [Math.sign(s) * Math.sqrt(Math.abs(s)), s * theirs.allowed[0]])
    : [-6, -4, -2, 0, 2, 4, 6].map((n) => [n / kDecades, n ? Math.sign(n) * top * 10 ** (Math.abs(n) - kDecades) : 0]);
  $("legend-ticks").replaceChildren(...ticks.map(([position, value]) => {
    const tick = document.createElement("span");
    tick.textContent = (value > 0 ? "+" : "") + short(value);
    tick.style.left = `${50 + 50 * position}%`;
    return tick;
  }));
  $("legend-note").textContent = view.kind === "share"
    ? `root scale up to what is allowed; edges up to ±${short(theirs.allowed[1])}; the strong colours are beyond`
    : `logarithmic scale: ${kDecades} decades below ±${short(top)}, then blank`;
}
