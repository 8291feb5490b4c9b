// page.js: the page around the viewer: links, filters, figures, the results to save.

// What a scene's fold holds is packed until somebody opens it.
const unfolding = new Map();
function unfold(details) {
  const packed = $("inside-" + details.id);
  if (packed && !unfolding.has(details))
    unfolding.set(details, inflated(packed.textContent).then((bytes) => {
      details.querySelector(".inside").innerHTML = new TextDecoder().decode(bytes);
      packed.remove();
    }));
  return unfolding.get(details);
}

// Links open whatever they point into.
async function reveal() {
  if (location.hash.startsWith("#view?")) {
    await openAddress(location.hash);
    return;
  }
  if (viewer.open) viewer.close();
  const fold = document.querySelector(`details.case[id="${location.hash.match(/^#(s\d+)/)?.[1]}"]`);
  if (fold) await unfold(fold);
  const target = location.hash && document.getElementById(location.hash.slice(1));
  if (!target) return;
  for (let e = target; e; e = e.parentElement) if (e.tagName === "DETAILS") e.open = true;
  target.scrollIntoView();
}
addEventListener("hashchange", reveal);
addEventListener("click", (event) => {
  const link = event.target.closest('a[href^="#s"]');
  if (link && link.hash === location.hash) reveal();
});

// The figures of a scene are painted when it is folded open.
async function paint(details) {
  if (!details.open) return;
  await unfold(details);
  await paintFigures(details);
}
document.addEventListener("toggle", (event) => {
  const details = event.target.closest("details.case");
  if (details && event.target.matches("details.case, details.layer")) paint(details);
}, true);
kDark.addEventListener("change", () => document.querySelectorAll("details.case[open]").forEach(paint));

// Filters: the lines with a cell of the type, renderer and verdict in them; the columns of both.
const filters = ["type", "renderer", "verdict"].map((name) => $("filter-" + name));
const lines = [...document.querySelectorAll(".matrix tbody tr")];
const anchors = (some) => new Set(some.map((line) => line.dataset.anchor));
function filter() {
  const [type, renderer, verdict] = filters.map((select) => select.value);
  const group = ["", "ambient", "all"].includes(type) ? type : "light";
  const in_group = (e) => !group || e.dataset.group === group;
  const by = (e) => !renderer || e.dataset.reference === renderer;
  const asked = (cell) => (!type || cell.dataset.type === type) && by(cell) &&
      (!verdict || (verdict === "bad" ? !cell.matches(".pass") : cell.matches("." + verdict)));
  for (const cell of document.querySelectorAll(".matrix [data-reference]")) cell.hidden = !in_group(cell) || !by(cell);
  for (const head of document.querySelectorAll(".matrix th[data-references]")) {
    head.hidden = !in_group(head);
    head.colSpan = renderer ? 1 : head.dataset.references;
  }
  for (const line of lines) line.hidden = ![...line.querySelectorAll("td[data-type]")].some(asked);
  const left = anchors(lines.filter((line) => !line.hidden));
  for (const anchor of anchors(lines)) document.getElementById(anchor).hidden = !left.has(anchor);
  $("filter-note").textContent = type || renderer || verdict ? `${left.size} of ${anchors(lines).size} scenes` : "";
}
for (const select of filters) select.addEventListener("change", filter);
filter();

// The command that approves a failure, for the results beside this page.
document.addEventListener("click", async (event) => {
  const button = event.target.closest("[data-copy]");
  if (!button) return;
  let command = button.previousElementSibling.textContent;
  if (location.protocol === "file:") {
    const results = decodeURIComponent(location.pathname).replace(/[^/]*$/, "results.json");
    command += ` --results '${results.replaceAll("'", "'\\''")}'`;
  }
  try {
    await navigator.clipboard.writeText(command);
    button.textContent = "copied";
  } catch {
    button.textContent = "select it by hand";
  }
});

$("save").addEventListener("click", async () => {
  const link = document.createElement("a");
  const results = JSON.parse(new TextDecoder().decode(await inflated($("results").textContent)));
  results.provenance = JSON.parse($("provenance").textContent);
  link.href = URL.createObjectURL(new Blob([JSON.stringify(results, null, 2)], { type: "application/json" }));
  link.download = "results.json";
  link.click();
});

// Times vary, so they stand in the provenance; with a baseline they are wanted beside it, too.
if ($("slower") && $("baseline")) $("baseline").append(...$("slower").cloneNode(true).children);

document.querySelectorAll("details.case[open]").forEach(paint);
reveal();
document.documentElement.dataset.ready = Math.round(performance.now());  // ms until it answers
