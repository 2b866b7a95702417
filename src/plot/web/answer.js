// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of an answer: the body rolling on its track, and curves with one
// cursor that moves with it. The data stand in the page; nothing is loaded.
"use strict";

(() => {

const data = JSON.parse(document.getElementById("data").textContent);
const { body, rows, box } = data;
const times = rows.t;
const last = times.length - 1;
const T = times[last];
const byId = (id) => document.getElementById(id);

// ---------------------------------------------------------------- the motion

/** The row from which on a time lies, not the last one. */
function rowBefore(t) {
  let low = 0, high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle; else high = middle;
  }
  return low;
}

/** Slope at a row of the parabola through it and its neighbours. */
function parabolaSlope(values, row) {
  if (last === 1) return (values[1] - values[0]) / T;
  const i = Math.min(Math.max(row, 1), last - 1);
  const h = times[i] - times[i - 1], k = times[i + 1] - times[i];
  const before = (values[i] - values[i - 1]) / h;
  const after = (values[i + 1] - values[i]) / k;
  const middle = (k * before + h * after) / (h + k);
  if (row === i) return middle;
  return row < i ? 2 * before - middle : 2 * after - middle;
}

const limited = Object.keys(rows).some((name) => name.startsWith("slack_"));

/** The same of a curve. Under limits, where forces jump, it is no steeper than
    three times the flatter of the chords beside it. */
function curveSlope(values, row) {
  const slope = parabolaSlope(values, row);
  if (!limited) return slope;
  const chord = (i) => Math.abs((values[i + 1] - values[i]) / (times[i + 1] - times[i]));
  const most = 3 * Math.min(chord(Math.max(row - 1, 0)), chord(Math.min(row, last - 1)));
  return Math.min(Math.max(slope, -most), most);
}

/** The cubic with the values of two rows and slopes there, as in
    plot/trajectory_table.cpp. */
function between(i, t, values, slope) {
  const a = values[i], b = values[i + 1];
  if (a === null || b === null) return null;
  const h = times[i + 1] - times[i], s = (t - times[i]) / h, r = 1 - s;
  return r * r * ((1 + 2 * s) * a + s * h * slope(i)) +
         s * s * ((1 + 2 * r) * b - r * h * slope(i + 1));
}

function value(column, t, i = rowBefore(t)) {
  const values = rows[column];
  // What is not known at a row, such as −∞, has no slope beside it either.
  const around = values.slice(Math.max(i - 1, 0), i + 3);
  if (around.includes(null)) {
    const a = values[i], b = values[i + 1];
    if (a === null || b === null) return null;
    return a + (b - a) * (t - times[i]) / (times[i + 1] - times[i]);
  }
  return between(i, t, values, (j) => curveSlope(values, j));
}

/** All that is drawn of the body at a time. */
function at(t) {
  const i = rowBefore(t);
  const { v_c, beta, theta } = rows;
  const now = {
    t,
    x: between(i, t, rows.x_c, (j) => v_c[j] * Math.cos(beta[j])),
    z: between(i, t, rows.z_c, (j) => v_c[j] * Math.sin(beta[j])),
    beta: between(i, t, beta, (j) => parabolaSlope(beta, j)),
    theta: body.rolls ? between(i, t, theta, (j) => v_c[j] / body.radius) : 0,
  };
  now.xb = now.x - body.radius * Math.sin(now.beta);
  now.zb = now.z + body.radius * Math.cos(now.beta);
  const offset = body.radius * body.eta;
  now.xm = now.x + offset * Math.cos(now.theta);
  now.zm = now.z + offset * Math.sin(now.theta);
  now.v = value("v_c", t, i);
  now.normal = value("R_n", t, i);
  now.tangential = body.rolls ? value("R_t", t, i) : 0;
  return now;
}

const full = { times: [], poses: [] };

/** Times so close that what is drawn between them is straight: the rows, and
    between them more where there are few or the body turns far. */
function sample() {
  const most = 20000;
  const turn = Math.PI / 18;
  const least = Math.ceil(900 / last);
  let wanted = 0;
  const counts = [];
  for (let i = 0; i < last; ++i) {
    const turned = Math.abs(rows.beta[i + 1] - rows.beta[i]) +
        (body.rolls ? Math.abs(rows.theta[i + 1] - rows.theta[i]) : 0);
    counts.push(Math.max(least, Math.ceil(turned / turn)));
    wanted += counts[i];
  }
  const share = Math.min(1, most / wanted);
  for (let i = 0; i < last; ++i) {
    const n = Math.max(1, Math.floor(counts[i] * share));
    for (let j = 0; j < n; ++j) {
      full.times.push(times[i] + (times[i + 1] - times[i]) * j / n);
    }
  }
  full.times.push(T);
  full.poses = full.times.map(at);
}
sample();

// --------------------------------------------------------------- the drawing

const stage = byId("stage");
const lens = byId("lens");
const kSector = Math.PI / 6;  // of the rim, dark and light by turns
const kSteps = 10;            // bodies at equal times

function draw(name, attributes, parent) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, text] of Object.entries(attributes)) {
    element.setAttribute(key, text);
  }
  parent.appendChild(element);
  return element;
}

/** A step of 1, 2 or 5 times a power of ten, about `count` of them in a range. */
function niceStep(range, count) {
  const raw = range / count;
  const power = Math.pow(10, Math.floor(Math.log10(raw)));
  for (const factor of [1, 2, 5]) {
    if (raw <= factor * power) return factor * power;
  }
  return 10 * power;
}

const minus = (text) => text.replace(/-/g, "−");
function shown(number, digits = 4) {
  if (number === null || !Number.isFinite(number)) return "–";
  let text = Number(number).toPrecision(digits);
  if (Math.abs(number) < 1e-12) text = "0";
  if (/e/.test(text)) {
    const [mantissa, power] = text.split("e");
    return minus(`${Number(mantissa)}e${Number(power)}`);
  }
  return minus(text);
}
function tick(number) {
  const size = Math.abs(number);
  return size !== 0 && (size >= 1e5 || size < 1e-3)
      ? minus(Number(number.toPrecision(6)).toExponential().replace("e+", "e"))
      : minus(String(Number(number.toPrecision(6))));
}

const view = {};  // what the drawing consists of, made anew for each width

function layOut() {
  // A body that is small is seen through the lens from the start. It takes room.
  const useLens = byId("use-lens");
  if (useLens.dataset.touched === undefined) {
    const small = 0.025 * Math.max(box[1][0] - box[0][0], box[1][1] - box[0][1]);
    useLens.checked = body.rolls && body.radius < small;
  }
  lens.hidden = !useLens.checked;
  const width = Math.max(280, stage.clientWidth);
  const wide = box[1][0] - box[0][0], high = box[1][1] - box[0][1];
  const left = 38, bottom = 34, tallest = Math.max(300, 0.62 * width);
  const scale = Math.min((width - left - 2) / wide, tallest / high);
  const w = scale * wide, h = scale * high;
  const x0 = left + 0.5 * (width - left - w);
  const X = (x) => x0 + scale * (x - box[0][0]);
  const Y = (z) => scale * (z - box[0][1]) + 2;
  Object.assign(view, { width, scale, X, Y, h });
  stage.textContent = "";
  const svg = draw("svg", {
    viewBox: `0 0 ${width.toFixed(1)} ${(h + bottom).toFixed(1)}`,
    role: "img", "aria-labelledby": "motion-heading motion-words",
  }, stage);

  // Place: grid, what is out of bounds, A and B.
  const grid = draw("g", { class: "grid" }, svg);
  const words = draw("g", { class: "ticks" }, svg);
  const stepX = niceStep(wide, width < 600 ? 4 : 8);
  for (let x = Math.ceil(box[0][0] / stepX) * stepX; x <= box[1][0]; x += stepX) {
    draw("path", { d: `M${X(x)} 2V${h + 2}` }, grid);
    draw("text", { x: X(x), y: h + 16, "text-anchor": "middle" }, words)
        .textContent = tick(x);
  }
  const stepZ = niceStep(high, width < 600 ? 3 : 5);
  for (let z = Math.ceil(box[0][1] / stepZ) * stepZ; z <= box[1][1]; z += stepZ) {
    draw("path", { d: `M${x0} ${Y(z)}H${x0 + w}` }, grid);
    draw("text", { x: x0 - 6, y: Y(z) + 4, "text-anchor": "end" }, words)
        .textContent = tick(z);
  }
  draw("text", { x: x0 + w, y: h + 31, "text-anchor": "end" }, words)
      .textContent = "x [m] to the right, z [m] down";
  for (const area of data.obstacles) {
    draw("polygon", {
      class: "obstacle",
      points: area.map(([x, z]) => `${X(x).toFixed(1)},${Y(z).toFixed(1)}`).join(" "),
    }, svg);
  }

  // Lines: as many decimals as the lens needs.
  const R = scale * body.radius;
  const lensRadius = 58;
  view.magnified = body.rolls ? lensRadius / R : 1;
  const decimals = 2 + Math.max(0, Math.ceil(Math.log10(view.magnified)));
  const place = (x, z) => `${X(x).toFixed(decimals)} ${Y(z).toFixed(decimals)}`;
  const line = (poses, x, z) =>
      poses.length < 2 ? "" : "M" + poses.map((p) => place(p[x], p[z])).join("L");
  const ghosts = draw("g", { class: "ghosts" }, svg);
  const arcs = draw("g", { class: "arcs" }, svg);
  data.arcs.forEach((arc) => {
    const poses = [at(arc.from),
        ...full.poses.filter((p) => arc.from < p.t && p.t < arc.to), at(arc.to)];
    draw("path", { class: `arc band${bandOf(arc.name)}`, d: line(poses, "xb", "zb") }, arcs);
  });
  if (body.rolls) {
    draw("path", { class: "centre-path", d: line(full.poses, "x", "z") }, svg);
  }
  if (body.eta > 0) {
    draw("path", { class: "mass-path", d: line(full.poses, "xm", "zm") }, svg);
  }
  draw("path", { id: "track", class: "track", d: line(full.poses, "xb", "zb") }, svg);
  const dashes = draw("path", { id: "inked", class: "inked", d: inked(place) }, svg);
  if (R * kSector < 4) dashes.setAttribute("class", "inked unseen");
  let lifted = "";
  let run = [];
  for (const pose of [...full.poses, null]) {
    if (pose !== null && pose.t > 0 && pose.normal !== null && pose.normal <= 0) {
      run.push(pose);
    } else {
      lifted += line(run, "xb", "zb");
      run = [];
    }
  }
  draw("path", { id: "lifted", class: "lifted", d: lifted }, svg);
  byId("lift-key").hidden = lifted === "";

  for (let i = 0; i <= kSteps; ++i) {
    const pose = at(T * i / kSteps);
    draw("circle", { cx: X(pose.x), cy: Y(pose.z), r: Math.max(R, 3) }, ghosts);
    if (body.eta > 0 && R > 6) {
      draw("circle", { class: "mass", cx: X(pose.xm), cy: Y(pose.zm), r: 2 }, ghosts);
    }
  }
  for (const [name, pose, side] of [["A", full.poses[0], -1],
                                    ["B", full.poses[full.poses.length - 1], 1]]) {
    const g = draw("g", { class: "end" }, svg);
    draw("circle", { cx: X(pose.xb), cy: Y(pose.zb), r: 3.2 }, g);
    draw("text", {
      x: X(pose.xb) + 9 * side, y: Y(pose.zb) + (side < 0 ? -7 : 14),
      "text-anchor": side < 0 ? "end" : "start",
    }, g).textContent = name;
  }

  // The body, and what acts on it.
  view.body = bodyShape(svg, R, "body");
  view.forces = draw("g", { class: "forces" }, svg);
  view.normal = arrow(view.forces, "force-normal");
  view.tangential = arrow(view.forces, "force-tangential");
  view.weight = data.weight ? arrow(view.forces, "force-weight") : null;
  view.contact = draw("circle", { id: "contact", class: "contact", r: 3.6 }, svg);
  const [low, top] = data.ranges.R_n;
  view.perWeight = 0.3 * Math.min(h, 420) / Math.max(1, Math.abs(low), Math.abs(top));

  // The same through a lens.
  lens.textContent = "";
  if (body.rolls) {
    const size = 220;
    const glass = draw("svg", {
      viewBox: `0 0 ${size} ${size}`, role: "img",
      "aria-label": "The body at its contact with the track, enlarged",
    }, lens);
    view.through = draw("g", {}, glass);
    for (const id of ["track", "inked", "lifted"]) {
      draw("use", { href: `#${id}`, class: `lens-${id}` }, view.through);
    }
    view.near = bodyShape(glass, lensRadius, "near-body");
    view.nearContact = draw("circle", { class: "contact", r: 4 }, glass);
    view.middle = 0.5 * size;
    view.lensRadius = lensRadius;
  }
}

/** The track as sectors of the rim would ink it: those that are dark. A sector
    is as long as its piece of the track, or the body would slip. */
function inked(place) {
  if (!body.rolls) return "";
  const sector = (p) => (p.theta - p.beta) / kSector;
  let path = "";
  let drawing = false;
  const pen = (dark, x, z) => {
    if (dark) path += (drawing ? "L" : "M") + place(x, z);
    drawing = dark;
  };
  const isDark = (n) => ((n % 2) + 2) % 2 === 0;
  for (let i = 0; i + 1 < full.poses.length; ++i) {
    const a = full.poses[i], b = full.poses[i + 1];
    const from = sector(a), to = sector(b);
    pen(isDark(Math.floor(from)), a.xb, a.zb);
    const up = to >= from;
    let n = up ? Math.floor(from) + 1 : Math.ceil(from) - 1;
    for (; up ? n <= to : n >= to; n += up ? 1 : -1) {
      const s = (n - from) / (to - from);
      if (!(s > 0 && s < 1)) continue;
      const x = a.xb + s * (b.xb - a.xb), z = a.zb + s * (b.zb - a.zb);
      const dark = isDark(up ? n : n - 1);
      if (drawing) path += "L" + place(x, z);
      drawing = false;
      if (dark) pen(true, x, z);
    }
  }
  const end = full.poses[full.poses.length - 1];
  if (drawing) path += "L" + place(end.xb, end.zb);
  return path;
}

function bodyShape(parent, R, id) {
  const g = draw("g", { id, class: "body" }, parent);
  if (!body.rolls || R < 3) {
    draw("circle", { class: "bead", r: body.rolls ? 3 : 5 }, g);
    return g;
  }
  draw("circle", { class: "disc", r: R }, g);
  draw("circle", {
    class: "rim", r: R - 2.2,
    "stroke-dasharray": `${((R - 2.2) * kSector).toFixed(3)}`,
  }, g);
  draw("circle", { class: "axis", r: 1.8 }, g);
  if (body.eta > 0) {
    draw("path", { class: "arm", d: `M0 0H${(R * body.eta).toFixed(2)}` }, g);
    draw("circle", { class: "mass", cx: (R * body.eta).toFixed(2), r: Math.min(5, 0.3 * R) }, g);
  }
  return g;
}

function arrow(parent, id) {
  const g = draw("g", { id }, parent);
  return { line: draw("path", {}, g), head: draw("polygon", {}, g), g };
}

function pointArrow(one, x, y, dx, dy) {
  const length = Math.hypot(dx, dy);
  one.g.setAttribute("visibility", length < 2 ? "hidden" : "inherit");
  if (length < 2) return;
  const ux = dx / length, uy = dy / length;
  const head = Math.min(9, length), half = 0.4 * head;
  const bx = x + dx - head * ux, by = y + dy - head * uy;
  one.line.setAttribute("d", `M${x} ${y}L${bx} ${by}`);
  one.head.setAttribute("points",
      `${x + dx},${y + dy} ${bx - half * uy},${by + half * ux} ${bx + half * uy},${by - half * ux}`);
}

const bandNames = [...new Set(data.arcs.map((arc) => arc.name))];
const bandOf = (name) => bandNames.indexOf(name) % 6;

// ---------------------------------------------------------------- the curves

const charts = [];
const colours = () => {
  const style = getComputedStyle(document.documentElement);
  const of = (name) => style.getPropertyValue(name).trim();
  return { series: [1, 2, 3, 4, 5, 6].map((i) => of(`--series-${i}`)),
    line: of("--line"), faint: of("--faint"), soft: of("--soft"),
    bands: [1, 2, 3, 4, 5, 6].map((i) => of(`--band-${i}`)) };
};

/** Speed of the centre of mass: that of the centre and of turning about it. */
function massSpeed(p) {
  const turning = body.rolls ? p.v * body.eta : 0;  // r η ω
  return Math.hypot(p.v * Math.cos(p.beta) - turning * Math.sin(p.theta),
                    p.v * Math.sin(p.beta) + turning * Math.cos(p.theta));
}

/** What is plotted: series with their names and values, and the range shown. */
function plans() {
  const all = [];
  const off = body.eta > 0;
  const union = (...ranges) => {
    const low = Math.min(...ranges.map((r) => r[0]));
    const high = Math.max(...ranges.map((r) => r[1]));
    const room = 0.06 * (high - low || Math.abs(high) || 1);
    return [low - room, high + room];
  };
  const extent = (of) => {
    const values = full.poses.map(of).filter((v) => v !== null && Number.isFinite(v));
    return [Math.min(...values, 0), Math.max(...values, 0)];
  };
  const series = (name, of, unit = "", value = of) => ({ name, of, unit, value });
  const { ranges, bounds } = data;

  const speeds = [series("v<sub>c</sub>", (p) => p.v, "m/s")];
  if (off) speeds.push(series("v<sub>cm</sub>", massSpeed, "m/s"));
  all.push({ id: "speed", title: off ? "Speed of the centre and of the centre of mass"
                                     : "Speed",
    unit: "m/s", series: speeds, range: union(...speeds.map((s) => extent(s.of))),
    also: body.rolls ? [series("ω", (p) => p.v / body.radius, "rad/s")] : [] });

  const forces = [series("R<sub>n</sub>", (p) => p.normal, "m g")];
  if (body.rolls) forces.push(series("R<sub>t</sub>", (p) => p.tangential, "m g"));
  all.push({ id: "force", title: body.rolls ? "Normal force and friction force" : "Normal force",
    unit: "m g", series: forces,
    range: union([0, 0], ranges.R_n, ...(body.rolls ? [ranges.R_t] : [])),
    lines: [0, bounds.least, bounds.greatest].filter((b) => b !== null) });

  if (body.rolls) {
    const needed = (p) => (p.normal > 0 ? Math.abs(p.tangential) / p.normal : null);
    const most = Math.max(...full.poses.filter((p) => p.t > 0.02 * T).map(needed));
    all.push({ id: "friction", title: "Friction needed", unit: "",
      series: [series("|R<sub>t</sub>|/R<sub>n</sub>", needed)],
      range: [0, Math.min(2, 1.08 * (Number.isFinite(most) ? most : 2))],
      lines: bounds.friction === null ? [] : [bounds.friction] });
  }

  all.push({ id: "curvature", title: "Curvature of the track, downwards positive",
    unit: "1/m", series: [series("κ<sub>b</sub>", (p) => value("kappa_b", p.t), "1/m")],
    range: union([0, 0], ranges.kappa_b), lines: [0] });

  const moving = (p) => 0.5 * massSpeed(p) ** 2;
  const turning = (p) => 0.5 * body.k * p.v * p.v;
  const energies = [series("translation", moving, "J/kg")];
  if (body.rolls) energies.push(series("rotation", turning, "J/kg"));
  if (data.gravity !== null) {
    const start = full.poses[0];
    const given = moving(start) + (body.rolls ? turning(start) : 0);
    energies.push(series("given by the fall",
        (p) => data.gravity * (p.zm - start.zm) + given, "J/kg"));
  }
  all.push({ id: "energy", title: "Energy per mass", unit: "J/kg", series: energies,
    range: union(...energies.map((s) => extent(s.of))) });

  const slacks = Object.keys(rows).filter((name) => name.startsWith("slack_"));
  if (slacks.length > 0) {
    all.push({ id: "slack", title: "Distance from each limit, as share of its largest",
      unit: "", range: [-0.05, 1.06], lines: [0],
      series: slacks.map((column) => {
        const [low, high] = ranges[column];
        const largest = Math.max(Math.abs(low), Math.abs(high)) || 1;
        return series(column.slice(6).replace(/_/g, " "),
            (p) => value(column, p.t) / largest, "", (p) => value(column, p.t));
      }) });
  }
  return all;
}

/** Active arcs as bands, and lines at bounds. */
function underlay(plan) {
  return (context, area, graph) => {
    const { soft, bands } = colours();
    for (const arc of data.arcs) {
      const from = graph.toDomXCoord(arc.from), to = graph.toDomXCoord(arc.to);
      context.fillStyle = bands[bandOf(arc.name)];
      context.globalAlpha = 0.16;
      context.fillRect(from, area.y, Math.max(1, to - from), area.h);
    }
    context.globalAlpha = 1;
    for (const line of plan.lines || []) {
      if (line < plan.range[0] || line > plan.range[1]) continue;
      const y = Math.round(graph.toDomYCoord(line)) + 0.5;
      context.strokeStyle = soft;
      context.setLineDash(line === 0 ? [] : [5, 4]);
      context.lineWidth = line === 0 ? 0.6 : 1;
      context.beginPath();
      context.moveTo(area.x, y);
      context.lineTo(area.x + area.w, y);
      context.stroke();
      context.setLineDash([]);
    }
  };
}

function makeCharts() {
  const holder = byId("curves");
  const all = plans();
  // Of a track with very many turns a curve needs no more points than these.
  const most = 6000;
  const step = Math.ceil(full.poses.length / most);
  const poses = full.poses.filter((_, i) => i % step === 0 || i === full.poses.length - 1);
  const colour = colours();
  all.forEach((plan) => {
    const part = document.createElement("section");
    part.className = "curve";
    part.innerHTML =
        `<h3 id="curve-${plan.id}">${plan.title}${plan.unit ? ` [${plan.unit}]` : ""}</h3>` +
        `<p class="readout">${[...plan.series, ...(plan.also || [])].map((s, i) =>
            `<span class="${i < plan.series.length ? `series${i % 6 + 1}` : ""}">` +
            `<i>${s.name}</i> <b></b> ${s.unit}</span>`).join(" ")}</p>` +
        `<div class="plot"><div class="canvas" role="img" aria-labelledby="curve-${plan.id}">` +
        "</div><div class=\"cursor\"></div></div>";
    holder.appendChild(part);
    const graph = new Dygraph(part.querySelector(".canvas"),
        poses.map((p) => [p.t, ...plan.series.map((s) => s.of(p))]), {
      labels: ["t", ...plan.series.map((s, i) => `${i} ${s.name}`)],
      colors: plan.series.map((_, i) => colour.series[i % 6]),
      strokeWidth: 1.6, legend: "never", valueRange: plan.range,
      dateWindow: [0, T], highlightCircleSize: 0, animatedZooms: false,
      gridLineColor: colour.faint, axisLineColor: colour.line,
      axes: {
        x: { axisLabelFormatter: (t) => tick(t), pixelsPerLabel: 70,
             axisLabelWidth: 60, axisHeight: 22 },
        y: { axisLabelFormatter: (y) => tick(y), axisLabelWidth: 44, pixelsPerLabel: 28 },
      },
      underlayCallback: underlay(plan),
      interactionModel: {
        mousedown(event, g, context) {
          if (!event.shiftKey) return;
          context.initializeMouseDown(event, g, context);
          Dygraph.startZoom(event, g, context);
        },
        mousemove(event, g, context) {
          if (context.isZooming) Dygraph.moveZoom(event, g, context);
        },
        mouseup(event, g, context) {
          if (context.isZooming) Dygraph.endZoom(event, g, context);
        },
        dblclick() { zoomTo(0, T); },
      },
      zoomCallback: (from, to) => zoomTo(from, to),
    });
    const plot = part.querySelector(".plot");
    const scrub = (event) => {
      if (event.shiftKey || event.buttons === 0) return;
      const x = event.clientX - plot.getBoundingClientRect().left;
      stop();
      show(Math.min(Math.max(graph.toDataXCoord(x), 0), T));
    };
    plot.addEventListener("pointerdown", scrub);
    plot.addEventListener("pointermove", scrub);
    charts.push({ plan, part, graph, cursor: part.querySelector(".cursor"),
      values: [...part.querySelectorAll(".readout b")] });
  });
}

let zooming = false;
function zoomTo(from, to) {
  if (zooming) return;
  zooming = true;
  for (const { graph, plan } of charts) {
    graph.updateOptions({ dateWindow: [Math.max(0, from), Math.min(T, to)],
                          valueRange: plan.range });
  }
  zooming = false;
  show(now);
}

function recolour() {
  const colour = colours();
  for (const { graph, plan } of charts) {
    graph.updateOptions({ colors: plan.series.map((_, i) => colour.series[i % 6]),
      gridLineColor: colour.faint, axisLineColor: colour.line });
  }
  show(now);
}

/** A curve for paper: lines that are as sharp as the printer, in place of a
    canvas. */
function curveOnPaper({ plan, part }) {
  const width = 660, high = 150, left = 46, right = 8, bottom = 20;
  const [low, top] = plan.range;
  const X = (t) => left + (width - left - right) * t / T;
  const Y = (y) => (high - bottom) * (top - y) / (top - low);
  const svg = draw("svg", { class: "paper-plot", viewBox: `0 0 ${width} ${high}` }, part);
  const clip = `clip-${plan.id}`;
  draw("rect", { x: left, y: 0, width: width - left - right, height: high - bottom },
      draw("clipPath", { id: clip }, svg));
  const grid = draw("g", { class: "grid" }, svg), words = draw("g", { class: "ticks" }, svg);
  const stepX = niceStep(T, 8), stepY = niceStep(top - low, 4);
  for (let t = 0; t <= T; t += stepX) {
    draw("path", { d: `M${X(t)} 0V${high - bottom}` }, grid);
    draw("text", { x: X(t), y: high - 4, "text-anchor": "middle" }, words).textContent = tick(t);
  }
  for (let y = Math.ceil(low / stepY) * stepY; y <= top; y += stepY) {
    draw("path", { d: `M${left} ${Y(y)}H${width - right}` }, grid);
    draw("text", { x: left - 6, y: Y(y) + 4, "text-anchor": "end" }, words).textContent = tick(y);
  }
  const inside = draw("g", { "clip-path": `url(#${clip})` }, svg);
  for (const arc of data.arcs) {
    draw("rect", { class: `paper-band band${bandOf(arc.name)}`, x: X(arc.from), y: 0,
      width: X(arc.to) - X(arc.from), height: high - bottom }, inside);
  }
  for (const line of plan.lines || []) {
    draw("path", { class: "paper-bound", d: `M${left} ${Y(line)}H${width}` }, inside);
  }
  plan.series.forEach((series, i) => {
    let path = "", drawing = false;
    for (const pose of full.poses) {
      const y = series.of(pose);
      const there = y !== null && Number.isFinite(y);
      if (there) path += `${drawing ? "L" : "M"}${X(pose.t).toFixed(1)} ${Y(y).toFixed(1)}`;
      drawing = there;
    }
    draw("path", { class: `paper-curve series${i % 6 + 1}`, d: path }, inside);
  });
  draw("path", { class: "paper-cursor", d: `M${X(now)} 0V${high - bottom}` }, inside);
}

// ------------------------------------------------------------------ the time

let now = 0.4 * T;

/** Shows the body at a time, and the cursor there. */
function show(t) {
  now = t;
  const p = at(t);
  const { X, Y } = view;
  const degrees = p.theta * 180 / Math.PI;
  view.body.setAttribute("transform", `translate(${X(p.x)} ${Y(p.z)}) rotate(${degrees})`);
  Object.assign(view.body.dataset, { t: p.t, x: p.x, z: p.z, theta: p.theta,
    contactX: p.xb, contactZ: p.zb });
  view.body.classList.toggle("lifts", p.normal <= 0 && p.t > 0);
  view.contact.setAttribute("cx", X(p.xb));
  view.contact.setAttribute("cy", Y(p.zb));
  const f = view.perWeight, sin = Math.sin(p.beta), cos = Math.cos(p.beta);
  pointArrow(view.normal, X(p.xb), Y(p.zb), f * p.normal * sin, -f * p.normal * cos);
  pointArrow(view.tangential, X(p.xb), Y(p.zb), f * p.tangential * cos, f * p.tangential * sin);
  if (view.weight) pointArrow(view.weight, X(p.xm), Y(p.zm), 0, f);
  if (!lens.hidden && body.rolls) {
    const m = view.middle, k = view.magnified;
    view.through.setAttribute("transform",
        `translate(${m} ${m}) scale(${k}) translate(${-X(p.x)} ${-Y(p.z)})`);
    view.near.setAttribute("transform", `translate(${m} ${m}) rotate(${degrees})`);
    view.nearContact.setAttribute("cx", m - view.lensRadius * sin);
    view.nearContact.setAttribute("cy", m + view.lensRadius * cos);
  }
  for (const { graph, plan, cursor, values } of charts) {
    const x = graph.toDomXCoord(t);
    const [from, to] = graph.xAxisRange();
    cursor.style.transform = `translateX(${x}px)`;
    cursor.hidden = t < from || t > to;
    [...plan.series, ...(plan.also || [])].forEach((s, i) => {
      values[i].textContent = shown(s.value(p));
    });
  }
  const words = `${shown(t)} s of ${shown(T)} s`;
  byId("clock").textContent = `t = ${words}`;
  const slider = byId("time");
  slider.value = String(t / T);
  slider.setAttribute("aria-valuetext", words);
}

const still = matchMedia("(prefers-reduced-motion: reduce)");
let playing = null;  // the frame or the timer that comes next

function stop() {
  if (playing === null) return;
  cancelAnimationFrame(playing.frame);
  clearTimeout(playing.timer);
  playing = null;
  byId("play").textContent = "Play";
}

function play() {
  if (now >= T) show(0);
  byId("play").textContent = "Pause";
  playing = {};
  // Whoever wants no motion sees one place after the other.
  if (still.matches) {
    const step = () => {
      show(Math.min(T, (Math.floor(now * kSteps / T + 1e-9) + 1) * T / kSteps));
      if (now >= T) stop(); else playing.timer = setTimeout(step, 800);
    };
    step();
    return;
  }
  let before = null;
  const frame = (clock) => {
    if (before !== null) show(Math.min(T, now + 1e-3 * (clock - before) * rate()));
    before = clock;
    if (now >= T) stop(); else playing.frame = requestAnimationFrame(frame);
  };
  playing.frame = requestAnimationFrame(frame);
}
const toggle = () => (playing === null ? play() : stop());
const rate = () => Number(document.querySelector("input[name=rate]:checked").value);

/** As it is, ten times slower, and what lasts some seconds if neither does. */
function offerRates() {
  const rates = [1, 0.1];
  if (T > 20) rates.push(Math.pow(10, Math.ceil(Math.log10(T / 20))));
  if (T < 0.2) rates.push(Math.pow(10, Math.floor(Math.log10(T / 2))));
  const lasts = (r) => Math.abs(Math.log(T / r / 8));
  const best = rates.reduce((a, b) => (lasts(b) < lasts(a) ? b : a));
  const holder = byId("rates");
  for (const r of rates) {
    const label = document.createElement("label");
    label.innerHTML = `<input type="radio" name="rate" value="${r}"/> ` +
        (r >= 1 ? `${tick(r)}:1` : `1:${tick(1 / r)}`);
    label.firstChild.checked = r === best;
    holder.appendChild(label);
  }
}

// ------------------------------------------------------------- what is asked

function fromAddress() {
  const found = /[#&]t=([0-9.eE+-]+)/.exec(location.hash);
  if (found === null || !Number.isFinite(Number(found[1]))) return false;
  stop();
  show(Math.min(Math.max(Number(found[1]), 0), T));
  return true;
}

function listen() {
  byId("play").addEventListener("click", toggle);
  byId("time").addEventListener("input", (event) => {
    stop();
    show(Number(event.target.value) * T);
  });
  for (const [id, layer] of [["use-forces", "forces"], ["use-ghosts", "ghosts"]]) {
    const set = () => stage.classList.toggle(`no-${layer}`, !byId(id).checked);
    byId(id).addEventListener("change", set);
    set();
  }
  byId("use-lens").addEventListener("change", (event) => {
    event.target.dataset.touched = "";
    layOut();
    show(now);
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const on = event.target.closest("button, summary, a, input");
    const slider = on !== null && on.id === "time";
    const step = (event.shiftKey ? 0.1 : 0.01) * T;
    const moves = { ArrowLeft: now - step, ArrowRight: now + step, Home: 0, End: T };
    if (event.key === " " && (on === null || slider)) {
      toggle();
    } else if (event.key in moves && (on === null || slider || on.tagName === "BUTTON")) {
      stop();
      show(Math.min(Math.max(moves[event.key], 0), T));
    } else {
      return;
    }
    event.preventDefault();
  });
  addEventListener("hashchange", fromAddress);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => recolour());
  const fit = () => {
    if (Math.abs(Math.max(280, stage.clientWidth) - view.width) < 1) return;
    layOut();
    for (const { graph } of charts) graph.resize();
    show(now);
  };
  new ResizeObserver(() => requestAnimationFrame(fit)).observe(stage);
  addEventListener("beforeprint", () => {
    stop();
    charts.forEach(curveOnPaper);
  });
  addEventListener("afterprint", () => {
    for (const svg of document.querySelectorAll(".paper-plot")) svg.remove();
  });
}

/** Tables that scroll can be scrolled by keys. */
function letTablesScroll() {
  for (const wide of document.querySelectorAll(".wide")) {
    if (wide.scrollWidth <= wide.clientWidth) continue;
    wide.tabIndex = 0;
    wide.setAttribute("role", "region");
    wide.setAttribute("aria-label", "table");
  }
}

layOut();
makeCharts();
offerRates();
listen();
letTablesScroll();
if (!fromAddress()) show(now);

})();
