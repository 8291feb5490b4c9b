// controls.js: what opens the viewer, and what keys, pointer and address do to it.

const viewer = $("viewer");
const pressed = (id, value) => $(id).setAttribute("aria-pressed", String(value));

function writeChoices() {
  const option = (text, value) => Object.assign(document.createElement("option"), { textContent: text, value });
  $("viewer-title").textContent = view.data.scene;
  $("layer").replaceChildren(...view.data.layers.map((layer, k) => option(titleOf(layer), k)));
  $("reference").replaceChildren(...layerNow().theirs.map((theirs, r) =>
    option(theirs.title + (theirs.judged === false ? " (not judged)" : ""), r)));
  $("layer").value = view.layer;
  $("reference").value = view.reference;
  $("show-theirs").textContent = theirsNow().title;
  for (const show of kShows) pressed("show-" + show, view.show === show);
  pressed("kind-share", view.kind === "share");
  pressed("kind-log", view.kind === "log");
  pressed("grey", view.grey);
  pressed("column", view.column);
  $("stops").textContent = view.stops ? `${view.stops > 0 ? "+" : "−"}${Math.abs(view.stops)} stop${Math.abs(view.stops) === 1 ? "" : "s"}` : "exposure";
  $("split").value = view.split;
}

let waiting = 0, address = 0;
// Draws once per frame, however much has changed.
function refresh() {
  if (!waiting) waiting = requestAnimationFrame(refreshNow);
  clearTimeout(address);
  address = setTimeout(writeAddress, 250);
}
function refreshNow() {
  waiting = 0;
  if (!viewer.open || !view.data) return;
  writeChoices();
  writeLegend();
  if (view.fitted) fit();
  drawStage();
  $("zoom").textContent = `${short(view.zoom)}×`;
  writeReadout();
  writePins();
  const key = [view.anchor, view.layer, view.reference].join();
  if ($("distribution").dataset.of === key) return;
  $("distribution").dataset.of = key;
  const { plot, note } = distribution(layerNow(), theirsNow());
  $("distribution").replaceChildren(plot);
  $("distribution-note").textContent = note;
}

// ---- The address: a link restores the view ----------------------------------------------------

function addressNow() {
  const fields = new URLSearchParams({
    scene: view.data.scene, light: layerNow().light, with: theirsNow().reference, show: view.show,
    at: view.cursor.join(), scale: view.kind });
  if (!view.fitted) {
    fields.set("zoom", view.zoom.toFixed(2));
    fields.set("center", view.center.map((c) => c.toFixed(2)).join());
  }
  if (view.stops) fields.set("stops", view.stops);
  if (view.show === "slider") fields.set("split", view.split.toFixed(3));
  if (view.grey) fields.set("grey", 1);
  if (view.column) fields.set("column", 1);
  if (view.pins.length) fields.set("pins", view.pins.map((pin) => pin.join()).join(";"));
  return "#view?" + fields;
}
function writeAddress() {
  if (viewer.open && view.data) history.replaceState(null, "", addressNow());
}

const numbers = (text, fallback) => {
  const list = (text || "").split(",").map(Number);
  return list.length === 2 && list.every(Number.isFinite) ? list : fallback;
};
const pixel = (pair) => pair && [0, 1].map((i) =>
  Math.max(0, Math.min([view.data.width, view.data.height][i] - 1, Math.round(pair[i]))));

// Opens the view that an address describes; false if it describes none of this page.
async function openAddress(hash) {
  if (!hash.startsWith("#view?")) return false;
  const fields = new URLSearchParams(hash.slice(6));
  const element = [...document.querySelectorAll("details.case")].find((e) => e.dataset.scene === fields.get("scene"));
  if (!element) return false;
  const number = (name, fallback) => Number.isFinite(parseFloat(fields.get(name))) ? parseFloat(fields.get(name)) : fallback;
  const chosen = { show: kShows.includes(fields.get("show")) ? fields.get("show") : "ours",
                   kind: ["log", "share"].find((kind) => kind === fields.get("scale")), grey: fields.has("grey"),
                   column: fields.has("column"), stops: number("stops", 0), split: number("split", 0.5) };
  await openViewer(element.id, fields.get("light"), fields.get("with"), chosen);
  view.cursor = pixel(numbers(fields.get("at"), view.cursor));
  view.pins = (fields.get("pins") || "").split(";").map((p) => pixel(numbers(p, null))).filter(Boolean);
  if (fields.has("zoom")) {
    view.center = numbers(fields.get("center"), view.center);
    zoomTo(number("zoom", 1));
  }
  refresh();
  return true;
}

// Where the pixel that differs most of what is allowed is.
function worstPixel(data, layer, theirs) {
  let worst = 0, most = -1;
  for (let i = 0; i < layer.edge.length; i++) {
    if (!covers(theirs, i)) continue;
    const d = largestDifference(theirs.difference, i);
    const share = Number.isNaN(d) ? Infinity : Math.abs(d) / (theirs.allowed[layer.edge[i] ? 1 : 0] || 1);
    if (share > most) [worst, most] = [i, share];
  }
  return [worst % data.width, Math.floor(worst / data.width)];
}

async function openViewer(anchor, light, reference, chosen) {
  const data = await picturesOf(anchor);
  const k = Math.max(0, data.layers.findIndex((each) => each.light === light));
  if (!data.layers[k].theirs.length) return;
  Object.assign(view, { anchor, data, layer: k, fitted: true, pins: [], stops: 0 }, chosen);
  view.reference = Math.max(0, layerNow().theirs.findIndex((each) => each.reference === reference));
  view.cursor = worstPixel(data, layerNow(), theirsNow());
  // What is far beyond its tolerance needs decades.
  const worst = valuesAt(view.cursor);
  view.kind = chosen.kind || (Math.abs(worst.largest) > worst.allowed ? "log" : "share");
  if (!viewer.open) viewer.showModal();
  $("stage").focus();
  refreshNow();
  refresh();
}

addEventListener("click", (event) => {
  const button = event.target.closest(".zoom");
  if (!button) return;
  const { scene, layer, reference, show } = button.dataset;
  picturesOf(scene).then((data) => openViewer(scene, data.layers[layer].light, reference, { show }));
});
function closeViewer() {
  clearTimeout(address);
  viewer.close();
  history.replaceState(null, "", `#${view.anchor}-l${view.layer}`);
}
viewer.addEventListener("cancel", (event) => {  // Escape
  event.preventDefault();
  closeViewer();
});

// ---- Buttons and keys ------------------------------------------------------------------------

const kFlips = ["ours", "theirs", "difference"];
const change = (fields) => { Object.assign(view, fields); refresh(); };
const flip = (step) => change({ show: kFlips[(kFlips.indexOf(view.show) + step + 3) % 3] });
const expose = (step) => change({ stops: Math.max(-10, Math.min(20, view.stops + step)) });
function zoomBy(factor, about) { zoomTo(view.zoom * factor, about); refresh(); }
function togglePin(at = view.cursor) {
  const known = view.pins.findIndex((pin) => pin.join() === at.join());
  if (known >= 0) view.pins.splice(known, 1);
  else view.pins.push([...at]);
  refresh();
}
function move(dx, dy) {
  view.cursor = pixel([view.cursor[0] + dx, view.cursor[1] + dy]);
  if (!view.fitted) follow();
  refresh();
}
function chooseLayer(k) {
  const reference = theirsNow().reference;
  if (!view.data.layers[k].theirs.length) return refresh();
  view.layer = k;
  view.reference = Math.max(0, layerNow().theirs.findIndex((each) => each.reference === reference));
  refresh();
}
const cycle = (length, at, step) => (at + step + length) % length;

const kActions = {
  f: () => flip(1), " ": () => flip(1), F: () => flip(-1),
  1: () => change({ show: "ours" }), 2: () => change({ show: "theirs" }), 3: () => change({ show: "difference" }),
  4: () => change({ show: "slider" }), 5: () => change({ show: "side" }),
  "+": () => zoomBy(1.5, view.cursor), "=": () => zoomBy(1.5, view.cursor), "-": () => zoomBy(1 / 1.5, view.cursor),
  0: () => change({ fitted: true }), "[": () => expose(-1), "]": () => expose(1),
  p: () => togglePin(), Enter: () => togglePin(),
  l: () => change({ kind: view.kind === "log" ? "share" : "log" }), g: () => change({ grey: !view.grey }),
  c: () => change({ column: !view.column }),
  n: () => chooseLayer(cycle(view.data.layers.length, view.layer, 1)),
  r: () => change({ reference: cycle(layerNow().theirs.length, view.reference, 1) }),
  w: () => { view.cursor = worstPixel(view.data, layerNow(), theirsNow()); follow(); refresh(); },
  ",": () => change({ split: Math.max(0, view.split - 0.02) }), ".": () => change({ split: Math.min(1, view.split + 0.02) }),
};
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
viewer.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || !view.data) return;
  const field = event.target.closest("select, input"), button = event.target.closest("button, summary");
  if (field || (button && [" ", "Enter"].includes(event.key))) return;
  const arrow = kArrows[event.key];
  if (arrow) move(...arrow.map((v) => v * (event.shiftKey ? 10 : 1)));
  else if (kActions[event.key]) kActions[event.key]();
  else return;
  event.preventDefault();
});

for (const show of kShows) $("show-" + show).addEventListener("click", () => change({ show }));
for (const [id, action] of Object.entries({
  "kind-share": () => change({ kind: "share" }), "kind-log": () => change({ kind: "log" }),
  grey: kActions.g, column: kActions.c, "zoom-in": () => zoomBy(1.5), "zoom-out": () => zoomBy(1 / 1.5),
  "zoom-fit": kActions[0], darker: () => expose(-1), brighter: () => expose(1), stops: () => change({ stops: 0 }),
  pin: () => togglePin(), worst: kActions.w, "viewer-close": closeViewer,
  "copy-link": () => copy(location.href.split("#")[0] + addressNow(), "copy-link"),
  "copy-command": () => copy($("command").textContent, "copy-command"),
})) $(id).addEventListener("click", action);
$("layer").addEventListener("change", () => chooseLayer(Number($("layer").value)));
$("reference").addEventListener("change", () => change({ reference: Number($("reference").value) }));
$("split").addEventListener("input", () => change({ split: Number($("split").value) }));

async function copy(text, id) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // no clipboard: leave the text for the person to take
    prompt("Copy this", text);
    return;
  }
  const button = $(id), before = button.textContent;
  button.textContent = "copied";
  setTimeout(() => { button.textContent = before; }, 1200);
}
