// cost.js: the plots of cost.html. `study` is cost.json.
"use strict";

const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
// Told apart by colour (Okabe and Ito), by the shape of the points and by the dashes of the line.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#999999"];
const shapes = ["circle", "rect", "triangle", "rectRot", "star", "cross", "crossRot"];
const dashes = {litmus: [], povray: [7, 4], blender: [2, 3]};
const least = topic => Math.min(...topic.series.flatMap(s => s.points.map(p => p.seconds.least)));
const number = value => Number(value.toPrecision(2)).toString();

function dataset(topic, series, index, region, metric, small) {
  const unit = least(topic);
  const floor = 3 * (topic.truth_error[region]?.[metric] ?? 0);
  const front = new Set(topic.front[metric].filter(f => f.series === series.name).map(f => f.knob));
  const points = series.points.filter(p => p.errors[region]?.[metric] > 0);
  const colour = colours[index % colours.length];
  return {
    label: series.title,
    data: points.map(p => ({x: p.seconds.least / unit, y: p.errors[region][metric], point: p})),
    borderColor: colour, backgroundColor: colour, borderWidth: small ? 1.2 : 1.8,
    borderDash: dashes[series.renderer], pointStyle: shapes[index % shapes.length], showLine: true, tension: 0,
    pointRadius: points.map(p => (region === "all" && front.has(p.knob) ? 7 : 4) - (small ? 1 : 0)),
    pointBackgroundColor: points.map(p => (p.errors[region][metric] < floor ? "transparent" : colour)),
    pointBorderColor: colour,
  };
}

const powers = {
  callback: value => {
    const exponent = Math.log10(value);
    return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? number(value) : "";
  },
  autoSkip: false, maxRotation: 0,
};

function options(topic, region, metric, small) {
  const ink = style("--ink"), dim = style("--dim"), line = style("--line");
  const axis = (text, type) => ({
    type: "logarithmic", title: {display: true, text, color: dim}, grid: {color: line},
    ticks: {...powers, color: dim}, border: {color: line},
  });
  return {
    responsive: true, maintainAspectRatio: false, animation: false, color: ink,
    interaction: {mode: "nearest", intersect: false},
    scales: {x: axis("time, as a multiple of the cheapest setting's"), y: axis(`${metric} error`)},
    plugins: {
      legend: {display: !small, position: "bottom", align: "start",
               labels: {color: ink, usePointStyle: true, boxWidth: 28, padding: 12}},
      title: {display: small, text: region, color: ink, align: "start", font: {size: 14}},
      tooltip: {callbacks: {
        label: item => {
          const point = item.raw.point;
          return [`${item.dataset.label}: ${point.setting}`,
                  `${metric} error ${number(item.raw.y)}, ${number(point.seconds.least)} s (${number(item.raw.x)}x)`];
        },
      }},
    },
  };
}

const charts = [];
function draw(metric) {
  for (const chart of charts.splice(0)) chart.destroy();
  for (const canvas of document.querySelectorAll("canvas[data-topic]")) {
    const topic = study.topics.find(t => t.name === canvas.dataset.topic);
    const region = canvas.dataset.region, small = region !== "all";
    const datasets = topic.series.map((s, i) => dataset(topic, s, i, region, metric, small));
    charts.push(new Chart(canvas, {type: "scatter", data: {datasets}, options: options(topic, region, metric, small)}));
  }
}

const chosen = document.getElementById("metric");
const redraw = () => draw(chosen ? chosen.value : "max");
if (chosen) chosen.addEventListener("change", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
redraw();
