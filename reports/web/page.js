"use strict";
// Links open whatever they point into.
function reveal() {
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
reveal();

// Only what does not pass.
const only = document.getElementById("only");
if (only) only.addEventListener("change", () =>
  document.body.classList.toggle("only-bad", only.checked));

// One picture, large; the arrow keys flip between the pictures of a layer in place.
const viewer = document.getElementById("viewer");
const image = document.getElementById("viewer-image");
let shown = [], index = 0;

function show(next) {
  index = (next + shown.length) % shown.length;
  const { img, difference, legend } = shown[index];
  const room = Math.min((innerWidth * 0.92 - 32) / img.naturalWidth,
                        (innerHeight * 0.92 - 180) / img.naturalHeight);
  // Whole steps keep pixels square; a picture larger than the window shrinks to fit.
  const scale = room >= 1 ? Math.floor(room) : room;
  image.src = img.src;
  image.alt = img.alt;
  image.width = img.naturalWidth * scale;
  image.height = img.naturalHeight * scale;
  image.classList.toggle("difference", difference);
  document.getElementById("viewer-title").textContent = img.alt;
  document.getElementById("viewer-legend").replaceChildren(...legend.map((e) => e.cloneNode(true)));
  const tabs = [...document.getElementById("viewer-tabs").children];
  tabs.forEach((tab, i) => tab.setAttribute("aria-pressed", String(i === index)));
  tabs[index].focus();
}

addEventListener("click", (event) => {
  const button = event.target.closest(".zoom");
  if (!button) return;
  const figures = [...button.closest(".pictures").querySelectorAll("figure")];
  shown = figures.map((figure) => ({
    img: figure.querySelector("img"),
    difference: figure.classList.contains("difference"),
    legend: [...figure.querySelectorAll("figcaption > *")] }));
  document.getElementById("viewer-tabs").replaceChildren(...shown.map(({ img }, i) => {
    const tab = document.createElement("button");
    tab.type = "button";
    tab.textContent = img.alt;
    tab.addEventListener("click", () => show(i));
    return tab;
  }));
  viewer.showModal();
  show(figures.indexOf(button.closest("figure")));
});
viewer.addEventListener("keydown", (event) => {
  if (event.key === "ArrowRight") show(index + 1);
  if (event.key === "ArrowLeft") show(index - 1);
});
viewer.addEventListener("click", (event) => { if (event.target === viewer) viewer.close(); });

document.getElementById("save").addEventListener("click", (event) => {
  const text = document.getElementById("results").textContent;
  event.currentTarget.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
});
