# SPDX-License-Identifier: LGPL-2.1-or-later
"""Script and looks of the page in which a simulated program is cut."""

LOOKS = """
.stage{margin:8px 0 18px;outline:none}
.stage canvas{display:block;width:100%;border:1px solid var(--faint);border-radius:4px}
.stage:focus-visible canvas{border-color:var(--excess)}
#scope{cursor:pointer;margin-top:4px}
.controls{display:flex;gap:12px;align-items:center;margin:8px 0 4px}
.controls input{flex:1;min-width:0;accent-color:var(--excess)}
.controls button{font:inherit;font-weight:600;min-width:5.5em;padding:4px 12px;color:var(--paper);
background:var(--ink);border:0;border-radius:4px;cursor:pointer}
.controls select{font:inherit}
.readout{display:grid;grid-template-columns:repeat(auto-fit,minmax(105px,1fr));gap:2px 12px;margin:6px 0;
font-variant-numeric:tabular-nums}
.readout span{color:var(--soft);font-size:12px;display:block;line-height:1.2}
@media print{.controls,#scope,.readout{display:none}}
"""

SCRIPT = r"""
"use strict";
(() => {
const d = JSON.parse(document.getElementById("data").textContent);
const $ = id => document.getElementById(id);
const scene = $("scene"), scope = $("scope"), scrub = $("scrub"), play = $("play"), speed = $("speed");
const n = d.t.length, total = d.t[n - 1];
let now = 0, running = false, last = 0, ink = {}, ratio = 1, view = null, stockLayer = null, cutTo = -1;

function colours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["ink", "soft", "faint", "paper", "material", "raw", "predicted", "excess", "within", "undercut"])
    ink[name] = style.getPropertyValue("--" + name).trim();
}
function size(canvas, height) {
  ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  canvas.width = Math.round(width * ratio); canvas.height = Math.round(height * ratio);
  canvas.style.height = height + "px";
  return width;
}
// Place between steps: k and how far to the next one.
function at(t) {
  let a = 0, b = n - 1;
  while (b - a > 1) { const m = (a + b) >> 1; if (d.t[m] <= t) a = m; else b = m; }
  if (t >= d.t[n - 1]) return [n - 1, 0];
  const w = d.t[a + 1] - d.t[a];
  return [a, w > 0 ? Math.min(1, Math.max(0, (t - d.t[a]) / w)) : 0];
}
const mix = (list, k, f) => k + 1 < n ? list[k] * (1 - f) + list[k + 1] * f : list[k];
function centre(k, f) {
  const a = d.actual[k], b = d.actual[Math.min(k + 1, n - 1)];
  if (starts.has(k + 1)) return a;
  return [a[0] * (1 - f) + b[0] * f, a[1] * (1 - f) + b[1] * f];
}
const starts = new Set(d.begins);

function layout() {
  colours();
  const [x0, y0, x1, y1] = d.box, width = scene.clientWidth;
  const height = Math.max(240, Math.min(520, width * (y1 - y0) / (x1 - x0)));
  size(scene, height); size(scope, 40 + 84 * d.strips.length);
  const k = Math.min(width / (x1 - x0), height / (y1 - y0));
  view = {k, x: (width - k * (x1 - x0)) / 2 - k * x0, y: (height + k * (y1 - y0)) / 2 + k * y0, width, height};
  stockLayer = document.createElement("canvas");
  stockLayer.width = scene.width; stockLayer.height = scene.height;
  cutTo = -1; draw();
}
const X = x => view.x + view.k * x, Y = y => view.y - view.k * y;
function trace(g, points) {
  g.beginPath();
  points.forEach((p, i) => i ? g.lineTo(X(p[0]), Y(p[1])) : g.moveTo(X(p[0]), Y(p[1])));
}
// The stock is a layer of its own; what the cutter has passed is erased from it.
function stock(k) {
  const g = stockLayer.getContext("2d");
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  if (cutTo < 0 || k < cutTo) {
    g.globalCompositeOperation = "source-over";
    g.clearRect(0, 0, view.width, view.height);
    g.fillStyle = ink.raw; g.globalAlpha = 0.45; g.beginPath();
    for (const ring of d.stock) ring.forEach((p, i) => i ? g.lineTo(X(p[0]), Y(p[1])) : g.moveTo(X(p[0]), Y(p[1])));
    g.fill("evenodd"); g.globalAlpha = 1; cutTo = 0;
  }
  g.globalCompositeOperation = "destination-out";
  g.lineWidth = 2 * d.radius * view.k; g.lineCap = g.lineJoin = "round";
  g.beginPath();
  for (let i = cutTo; i <= k; i++) {
    const p = d.actual[i];
    if (i === cutTo || starts.has(i)) { g.moveTo(X(p[0]), Y(p[1])); g.lineTo(X(p[0]), Y(p[1]) + 1e-3); }
    else g.lineTo(X(p[0]), Y(p[1]));
  }
  g.stroke(); cutTo = k;
}
function erase(p) {
  const g = stockLayer.getContext("2d");
  g.beginPath(); g.arc(X(p[0]), Y(p[1]), d.radius * view.k, 0, 7); g.fill();
}
function draw() {
  const [k, f] = at(now), p = centre(k, f), g = scene.getContext("2d");
  stock(k); erase(p);
  g.setTransform(1, 0, 0, 1, 0, 0); g.clearRect(0, 0, scene.width, scene.height);
  g.drawImage(stockLayer, 0, 0);
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  const stroke = (points, colour, width, dash) => {
    trace(g, points); g.strokeStyle = colour; g.lineWidth = width; g.setLineDash(dash || []); g.stroke();
    g.setLineDash([]);
  };
  for (const part of d.corrected) stroke(part, ink.within, 1.3, [5, 3]);
  for (const part of d.machined) stroke(part, ink.undercut, 1.3);
  for (const part of d.nominal) stroke(part, ink.ink, 1.6);
  g.beginPath();
  for (let i = 0; i < n; i++) {
    const q = d.actual[i];
    if (i === 0 || starts.has(i)) g.moveTo(X(q[0]), Y(q[1])); else g.lineTo(X(q[0]), Y(q[1]));
  }
  g.strokeStyle = ink.soft; g.lineWidth = 0.8; g.setLineDash([2, 4]); g.stroke(); g.setLineDash([]);
  cutter(g, p, k); legend(g); read(k, f); signals(k, f);
  scrub.value = 1000 * now / (total || 1);
}
function cutter(g, p, k) {
  const r = d.radius * view.k, x = X(p[0]), y = Y(p[1]);
  g.beginPath(); g.arc(x, y, r, 0, 7); g.fillStyle = ink.excess; g.globalAlpha = 0.12; g.fill(); g.globalAlpha = 1;
  g.strokeStyle = ink.excess; g.lineWidth = 1.4; g.stroke();
  if (d.cuts[k]) {
    g.beginPath();
    g.arc(x, y, r, -d.from[k], -d.to[k], !d.clockwise);
    g.lineWidth = 5; g.strokeStyle = ink.undercut; g.lineCap = "butt"; g.stroke();
    const most = largest, size = Math.hypot(...d.force[k]);
    if (size > 0) {
      const long = 1.6 * r * size / most, ux = d.force[k][0] / size, uy = -d.force[k][1] / size;
      const ex = x + long * ux, ey = y + long * uy, h = Math.min(9, long / 2);
      g.beginPath(); g.moveTo(x, y); g.lineTo(ex, ey);
      g.moveTo(ex - h * ux - h / 2 * uy, ey - h * uy + h / 2 * ux); g.lineTo(ex, ey);
      g.lineTo(ex - h * ux + h / 2 * uy, ey - h * uy - h / 2 * ux);
      g.lineWidth = 2.4; g.strokeStyle = ink.predicted; g.stroke();
    }
  }
  g.beginPath(); g.arc(x, y, 2, 0, 7); g.fillStyle = ink.excess; g.fill();
  // Which way the spindle turns.
  const turn = d.clockwise ? 1 : -1, b = 0.45 * r;
  g.beginPath(); g.arc(x, y, b, -2.2 * turn, -0.6 * turn, turn < 0); g.lineWidth = 1.2; g.strokeStyle = ink.excess;
  const ax = x + b * Math.cos(-0.6 * turn), ay = y + b * Math.sin(-0.6 * turn);
  g.moveTo(ax - 6, ay - 2 * turn); g.lineTo(ax, ay); g.lineTo(ax + 1, ay - 6 * turn); g.stroke();
}
const largest = Math.max(1e-9, ...d.force.map(f => Math.hypot(...f)));
function legend(g) {
  const rows = [["theoretical contour", ink.ink, []],
    ["machined, error \u00d7" + d.times, ink.undercut, []]];
  if (d.corrected.length) rows.push(["after the correction, error \u00d7" + d.times, ink.within, [5, 3]]);
  rows.push(["path of the centre", ink.soft, [2, 4]], ["force on the tool", ink.predicted, []],
    ["engaged arc", ink.undercut, [], 5]);
  g.font = "12px sans-serif"; g.textBaseline = "middle";
  const width = 34 + Math.max(...rows.map(r => g.measureText(r[0]).width)) + 8;
  g.fillStyle = ink.paper; g.globalAlpha = 0.85; g.fillRect(6, 6, width, 17 * rows.length + 8); g.globalAlpha = 1;
  rows.forEach(([text, colour, dash, thick], i) => {
    const y = 19 + 17 * i;
    g.beginPath(); g.moveTo(12, y); g.lineTo(34, y); g.strokeStyle = colour; g.lineWidth = thick || 1.8;
    g.setLineDash(dash); g.stroke(); g.setLineDash([]);
    g.fillStyle = ink.ink; g.textAlign = "left"; g.fillText(text, 40, y);
  });
  // A length to go by.
  const k = view.k * d.unit.mm;
  let bar = d.unit.mm > 1 ? 0.1 : 1;
  while (bar * k < 50) bar = Number((bar * (/2/.test(bar) ? 2.5 : 2)).toPrecision(2));
  const x = view.width - 14, y = view.height - 14;
  g.beginPath(); g.moveTo(x - bar * k, y - 4); g.lineTo(x - bar * k, y); g.lineTo(x, y); g.lineTo(x, y - 4);
  g.strokeStyle = ink.ink; g.lineWidth = 1.2; g.stroke();
  g.textAlign = "right"; g.fillStyle = ink.ink; g.fillText(bar + " " + d.unit.name, x, y - 12);
}
function along(mm, digits) { return (mm / d.unit.mm).toFixed(d.unit.mm > 1 ? digits + 1 : digits) + " " + d.unit.name; }
function read(k, f) {
  const words = [["time", mix(d.t, k, f).toFixed(2) + " s"], ["path", along(mix(d.s, k, f), 1)],
    ["program line", d.line[k]]];
  for (const strip of d.strips) strip.values.forEach((v, i) => {
    const value = mix(v, k, f).toFixed(strip.unit === "\u00b0" || d.unit.mm > 1 ? 1 : 0);
    words.push([strip.labels[i] || strip.name, value + " " + strip.unit]);
  });
  const out = $("readout");
  while (out.children.length < words.length) out.appendChild(document.createElement("div"));
  words.forEach(([name, value], i) => {
    out.children[i].innerHTML = "<span></span><b></b>";
    out.children[i].firstChild.textContent = name; out.children[i].lastChild.textContent = value;
  });
}
const left = 58;
function signals(k, f) {
  const g = scope.getContext("2d"), width = scope.clientWidth, right = width - 12;
  g.setTransform(ratio, 0, 0, ratio, 0, 0); g.clearRect(0, 0, width, scope.clientHeight);
  g.font = "11px sans-serif"; g.textBaseline = "middle";
  const px = i => left + (right - left) * d.s[i] / (d.s[n - 1] || 1);
  d.strips.forEach((strip, row) => {
    const top = 22 + 84 * row, high = 60;
    let low = 0, up = 0;
    for (const v of strip.values) for (const w of v) { if (w < low) low = w; if (w > up) up = w; }
    if (up === low) up = low + 1;
    const py = v => top + high - high * (v - low) / (up - low);
    g.strokeStyle = ink.faint; g.lineWidth = 1; g.fillStyle = ink.soft; g.textAlign = "right";
    for (const v of [low, 0, up]) {
      g.beginPath(); g.moveTo(left, py(v)); g.lineTo(right, py(v)); g.stroke();
      if (v === 0 || Math.abs(py(v) - py(0)) > 10) g.fillText(v.toFixed(0), left - 6, py(v));
    }
    g.textAlign = "left"; let x = left;
    strip.values.forEach((v, i) => {
      const colour = strip.values.length === 1 ? ink.ink : [ink.excess, ink.undercut][i];
      const label = (strip.labels[i] || strip.name) + " / " + strip.unit;
      g.fillStyle = colour; g.fillText(label, x, top - 9); x += g.measureText(label).width + 18;
      g.strokeStyle = colour; g.lineWidth = 1.5; g.beginPath();
      for (let j = 0; j < n; j++) j ? g.lineTo(px(j), py(v[j])) : g.moveTo(px(j), py(v[j]));
      g.stroke();
    });
  });
  const x = left + (right - left) * mix(d.s, k, f) / (d.s[n - 1] || 1);
  g.beginPath(); g.moveTo(x, 6); g.lineTo(x, 22 + 84 * d.strips.length - 16);
  g.strokeStyle = ink.predicted; g.lineWidth = 1.6; g.stroke();
  g.fillStyle = ink.soft; g.textAlign = "center";
  g.fillText("path length 0 to " + along(d.s[n - 1], 0), (left + right) / 2, 84 * d.strips.length + 26);
}
function go(t) { now = Math.min(total, Math.max(0, t)); draw(); }
function run(on) {
  running = on; play.textContent = on ? "Pause" : "Play";
  if (on) { if (now >= total) now = 0; last = performance.now(); requestAnimationFrame(step); }
}
function step(time) {
  if (!running) return;
  now += (time - last) / 1000 * Number(speed.value); last = time;
  if (now >= total) { now = total; run(false); }
  draw();
  if (running) requestAnimationFrame(step);
}
play.addEventListener("click", () => run(!running));
scrub.addEventListener("input", () => { run(false); go(total * scrub.value / 1000); });
scope.addEventListener("click", event => {
  const box = scope.getBoundingClientRect();
  const s = (event.clientX - box.left - left) / (box.width - left - 12) * d.s[n - 1];
  let k = d.s.findIndex(v => v >= s); if (k < 0) k = n - 1;
  go(d.t[k]);
});
$("stage").addEventListener("keydown", event => {
  if (event.target === scrub || event.target === speed) return;
  const [k] = at(now);
  if (event.key === " ") { if (event.target !== play) { run(!running); event.preventDefault(); } }
  else if (event.key === "ArrowRight") { run(false); go(d.t[Math.min(k + 1, n - 1)]); event.preventDefault(); }
  else if (event.key === "ArrowLeft") { run(false); go(d.t[Math.max(k - 1, 0)]); event.preventDefault(); }
});
window.addEventListener("resize", layout);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", layout);
const place = /^#t=([0-9.]+)$/.exec(location.hash);
if (place) now = Math.min(total, Number(place[1]));
layout();
})();
"""
