// peers.js: the plot of peers.html. `peers` is peers.json.
"use strict";

const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
// Okabe and Ito; told apart by the shape of the points, too.
const colours = ["#0072b2", "#d55e00"], shapes = ["circle", "rect"];
const least = row => Math.min(...row.seconds);

function points(task) {
  return task.rows.filter(row => row.missing === "" && row.triangles > 0)
    .map(row => ({x: row.triangles, y: least(row) / task.units * 1e9}));
}

function line(label, data, index, dashed) {
  const colour = colours[index % colours.length];
  return {
    label, data, borderColor: colour, backgroundColor: colour, showLine: true, tension: 0,
    borderWidth: dashed ? 1.2 : 1.8, borderDash: dashed ? [4, 4] : [],
    pointRadius: dashed ? 0 : 5, pointStyle: dashed ? "line" : shapes[index % shapes.length],
  };
}

function datasets() {
  return peers.tasks.map(task => ({task, data: points(task)})).filter(one => one.data.length > 1)
    .flatMap(({task, data}, i) => {
      const like = data.map(p => ({x: p.x, y: data[0].y * Math.log(p.x) / Math.log(data[0].x)}));
      return [line(task.title, data, i, false), line("in proportion to the logarithm", like, i, true)];
    });
}

function options() {
  const ink = style("--ink"), dim = style("--dim"), grid = {color: style("--line")};
  const axis = (text, more) => ({
    title: {display: true, text, color: dim}, grid, border: grid, ...more, ticks: {color: dim, ...more.ticks},
  });
  const first = Math.min(...peers.tasks.flatMap(points).map(p => p.x));
  const power = value => (Number.isInteger(Math.log10(value)) ? value.toLocaleString("en") : "");
  return {
    responsive: true, maintainAspectRatio: false, animation: false, color: ink,
    interaction: {mode: "nearest", intersect: false},
    scales: {
      x: axis("triangles", {type: "logarithmic", min: first / 1.5, ticks: {callback: power, autoSkip: false, maxRotation: 0}}),
      y: axis("a ray, ns", {min: 0, ticks: {}}),
    },
    plugins: {
      legend: {position: "bottom", align: "start", labels: {color: ink, usePointStyle: true, boxWidth: 28, padding: 12}},
      tooltip: {callbacks: {
        label: item => `${item.dataset.label}: ${item.raw.x.toLocaleString("en")} triangles, ${item.raw.y.toFixed(0)} ns`,
      }},
    },
  };
}

Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
let chart;
function draw() {
  if (chart) chart.destroy();
  chart = new Chart(document.getElementById("growth"), {type: "scatter", data: {datasets: datasets()}, options: options()});
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
draw();
