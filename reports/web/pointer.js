// pointer.js: mouse, pen and touch on the stage: hover, drag, pinch, wheel, pin.

const stage = $("stage");
const pointers = new Map();  // the fingers, or the button, that are down
let travelled = 0, dividing = false;

const placeOf = (event) => {
  const box = stage.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};
const apart = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);

stage.addEventListener("pointerdown", (event) => {
  if (event.button) return;
  const place = placeOf(event);
  stage.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, place);
  if (pointers.size === 1) travelled = 0;
  dividing = view.show === "slider" && Math.abs(place[0] - view.split * stage.clientWidth) < 14;
});

stage.addEventListener("pointermove", (event) => {
  if (!view.data) return;
  const place = placeOf(event), before = pointers.get(event.pointerId);
  if (!before) {
    const under = pixelAt(...place);
    if (under && under.pixel && event.pointerType !== "touch") change({ cursor: under.pixel });
    return;
  }
  travelled += apart([place, before]);
  if (dividing) {
    pointers.set(event.pointerId, place);
    change({ split: Math.max(0, Math.min(1, place[0] / stage.clientWidth)) });
  } else if (pointers.size === 2) {
    const width = apart([...pointers.values()]);
    pointers.set(event.pointerId, place);
    const [a, b] = [...pointers.values()], under = pixelAt((a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    if (under && width > 0) zoomBy(apart([a, b]) / width, under.at);
  } else if (travelled > 4) {
    view.center = view.center.map((c, i) => c - (place[i] - before[i]) / view.zoom);
    view.fitted = false;
    pointers.set(event.pointerId, place);
    refresh();
  }
});

function release(event) {
  const known = pointers.delete(event.pointerId);
  if (!known || event.type === "pointercancel" || dividing || travelled > 4 || pointers.size) return;
  const under = pixelAt(...placeOf(event));
  if (!under || !under.pixel) return;
  view.cursor = under.pixel;
  // A finger cannot hover: its tap reads a pixel, and the button pins it.
  if (event.pointerType === "touch") refresh();
  else togglePin();
}
stage.addEventListener("pointerup", release);
stage.addEventListener("pointercancel", release);

stage.addEventListener("wheel", (event) => {
  event.preventDefault();
  const under = pixelAt(...placeOf(event));
  const lines = event.deltaMode === 1 ? 16 : 1;
  if (under) zoomBy(2 ** (-event.deltaY * lines / 240), under.at);
}, { passive: false });

new ResizeObserver(refresh).observe(stage);
kDark.addEventListener("change", refresh);
