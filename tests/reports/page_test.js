// page_test.js: what a person does on the page, done by the page itself. Put behind a copy of a
// report; says what it saw as JSON on the console. page_test.cpp says what that has to be.

// A browser without a window makes no frames: drawing goes by the clock instead.
window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 0);

addEventListener("load", async () => {
  const seen = { errors: window.pageErrors, ready: Number(document.documentElement.dataset.ready) };
  const pause = (ms = 30) => new Promise((resolve) => setTimeout(resolve, ms));
  const until = async (holds) => { for (let i = 0; i < 100 && !holds(); i++) await pause(50); };
  const byId = (id) => document.getElementById(id);
  const key = (name, options = {}) =>
    byId("stage").dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true, ...options }));
  const shown = () => document.querySelector('[id^="show-"][aria-pressed="true"]')?.id;
  const zoomed = () => parseFloat(byId("zoom").textContent);
  const values = () => [...byId("readout-values").rows].map((row) =>
    [...row.cells].slice(1).map((cell) => Number(cell.title)));

  // The pointer over the middle of a pixel.
  function point(type, [x, y], fields = {}) {
    const [pane] = panes(), [left, top] = origin(pane), box = byId("stage").getBoundingClientRect();
    byId("stage").dispatchEvent(new PointerEvent(type, {
      clientX: box.left + left + (x + 0.5) * view.zoom, clientY: box.top + top + (y + 0.5) * view.zoom,
      bubbles: true, pointerId: 1, pointerType: "mouse", ...fields }));
  }

  try {
    Element.prototype.setPointerCapture = () => {};  // made-up events have no pointer to capture
    // Fold a scene open and click a picture.
    const scene = document.querySelector("details.case");
    scene.open = true;
    await until(() => scene.querySelector(".zoom[data-painted] canvas"));
    const canvas = scene.querySelector(".zoom[data-painted] canvas");
    seen.painted = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((v, i) => i % 4 < 3 && v > 0);
    scene.querySelector(".zoom").click();
    await until(() => byId("viewer").open && shown());
    await pause();
    seen.opened = byId("viewer").open;

    // Flip with keys.
    seen.flips = [shown()];
    for (const name of ["f", " ", "F", "4", "5", "1"]) {
      key(name);
      await pause();
      seen.flips.push(shown());
    }

    // Read pixels of every layer and reference.
    seen.pixels = [];
    for (let layer = 0; layer < byId("layer").options.length; layer++)
      for (let reference = 0; reference < byId("reference").options.length; reference++) {
        byId("layer").value = layer;
        byId("layer").dispatchEvent(new Event("change"));
        await pause();
        byId("reference").value = reference;
        byId("reference").dispatchEvent(new Event("change"));
        await pause();
        for (const at of window.wanted) {
          point("pointermove", at);
          await until(() => byId("equation").dataset.at === [view.anchor, ...at].join());
          seen.pixels.push({ layer, reference, at, said: byId("readout-at").textContent, values: values(),
                             share: byId("readout-share").textContent, shown: byId("reference").selectedOptions[0].text,
                             sum: byId("equation").hidden ? "" : byId("equation-lines").lastChild.textContent,
                             lights: [...byId("light-rows").rows].map((row) => Number(row.cells[3].title)) });
        }
      }

    byId("reference").value = 0;
    byId("reference").dispatchEvent(new Event("change"));
    await pause();

    // Zoom and pan, pin, expose.
    const before = zoomed();
    key("+");
    await pause();
    seen.zoomedIn = zoomed() > before;
    point("wheel", [1, 1]);
    byId("stage").dispatchEvent(new WheelEvent("wheel", {
      deltaY: -2400, clientX: innerWidth / 3, clientY: innerHeight / 2, bubbles: true, cancelable: true }));
    await pause();
    seen.zoomMost = zoomed();
    key("0");
    await pause();
    seen.zoomFit = zoomed() === before;
    for (const at of window.wanted.slice(0, 2)) {
      point("pointerdown", at);
      point("pointerup", at);
      await pause();
    }
    seen.pins = byId("pin-rows").tBodies.length;
    key("ArrowRight");
    await pause();
    seen.moved = byId("readout-at").textContent;
    key("]");
    key("3");
    key("l");
    await until(() => location.hash.includes("stops=1"));
    seen.stops = byId("stops").textContent;
    seen.ticks = byId("legend-ticks").children.length;
    seen.plots = document.querySelectorAll("#scan path, #distribution rect").length;
    seen.command = byId("command").textContent;
    seen.address = location.hash;

    // Close, and open the link again.
    byId("viewer-close").click();
    await until(() => !location.hash.startsWith("#view"));
    seen.closed = !byId("viewer").open && !location.hash.startsWith("#view");
    location.hash = seen.address;
    await until(() => byId("viewer").open && view.pins.length);
    await pause(500);  // an address that is written anew is the same
    seen.restored = location.hash;
    byId("viewer").close();

    // Follow the link of the worst failure.
    const look = document.querySelector('.alert a[href^="#view"]');
    if (look) {
      location.hash = look.hash;
      await until(() => byId("viewer").open && shown());
      await pause();
      seen.looked = [byId("viewer-title").textContent, byId("readout-at").textContent.split(" ·")[0], shown()].join(" ");
      byId("viewer-close").click();
      await pause();
    }

    // Filter.
    const rows = () => [...document.querySelectorAll(".matrix tbody tr")].filter((row) => !row.hidden).length;
    const filter = (name, value) => {
      byId("filter-" + name).value = value;
      byId("filter-" + name).dispatchEvent(new Event("change"));
    };
    seen.rows = { all: rows() };
    filter("verdict", "fail");
    seen.rows.fail = rows();
    filter("type", "spot");
    seen.rows.spotFail = rows();
    filter("verdict", "");
    seen.rows.spot = rows();
    filter("renderer", "povray");
    seen.columns = [...document.querySelectorAll(".matrix thead th[data-reference]")].filter((head) => !head.hidden).length;

    // Open every scene, the hostile one too.
    const open = () => { for (const details of document.querySelectorAll("details")) details.open = true; };
    open();
    await until(() => !document.querySelector('[id^="inside-"]'));
    open();
    await until(() => !document.querySelector("details.case .zoom:not([data-painted])"));
    seen.folded = document.querySelectorAll('[id^="inside-"]').length;
    seen.unpainted = document.querySelectorAll("details.case .zoom:not([data-painted])").length;
    seen.foreign = document.querySelectorAll("img, iframe, [onerror], [onload], [onclick]").length;
    seen.alerts = window.alerts;
    seen.requests = performance.getEntriesByType("resource").map((entry) => entry.name.slice(0, 60));
  } catch (error) {
    seen.errors.push(String(error.stack));
  }
  console.log("litmus-seen " + encodeURIComponent(JSON.stringify(seen)));
});
