// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of an answer: the body rolling on its track, and curves with one
// cursor that moves with it. What it shares with other pages is in motion.js.
"use strict";

(() => {

const data = JSON.parse(document.getElementById("data").textContent);
const { rows, box } = data;
const { byId, draw, drawPlane, liftedPath, markEnds, moveBody, pathOf, shown, tick, ticksIn,
  kSector, kSteps } = Motion;
const full = Motion.motionOf(data);
const { body, T, at, value } = full;

// --------------------------------------------------------------- the drawing

const stage = byId("stage");
const lens = byId("lens");

const view = {};  // what the drawing consists of, made anew for each width

function layOut() {
  // A body that is small is seen through the lens from the start. It takes room.
  const useLens = byId("use-lens");
  if (useLens.dataset.touched === undefined) {
    const small = 0.025 * Math.max(box[1][0] - box[0][0], box[1][1] - box[0][1]);
    useLens.checked = body.rolls && Motion.outerRadius(body) < small;
  }
  lens.hidden = !useLens.checked;
  const plane = drawPlane(stage, box);
  const { svg, scale, X, Y, h } = plane;
  Object.assign(view, plane);
  Motion.drawObstacles(svg, data.obstacles, plane);

  // Lines: as many decimals as the lens needs.
  const R = scale * Motion.outerRadius(body);
  const lensRadius = 58;
  view.magnified = body.rolls ? lensRadius / R : 1;
  const decimals = 2 + Math.max(0, Math.ceil(Math.log10(view.magnified)));
  const place = (x, z) => `${X(x).toFixed(decimals)} ${Y(z).toFixed(decimals)}`;
  const line = (poses, x, z) => pathOf(poses, x, z, place);
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
  const lifted = liftedPath(full.poses, place);
  draw("path", { id: "lifted", class: "lifted", d: lifted }, svg);
  byId("lift-key").hidden = lifted === "";

  for (let i = 0; i <= kSteps; ++i) {
    const pose = at(T * i / kSteps);
    draw("circle", { cx: X(pose.x), cy: Y(pose.z), r: Math.max(R, 3) }, ghosts);
    if (body.eta > 0 && R > 6) {
      draw("circle", { class: "mass", cx: X(pose.xm), cy: Y(pose.zm), r: 2 }, ghosts);
    }
  }
  markEnds(svg, full.poses, plane);

  // The body, and what acts on it.
  view.body = Motion.bodyShape(svg, scale, "body", body);
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
    view.near = Motion.bodyShape(glass, scale * view.magnified, "near-body", body);
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
  all.push({ id: "speed", letter: "v", title: off ? "Speed of the centre and of the centre of mass"
                                     : "Speed",
    unit: "m/s", series: speeds, range: union(...speeds.map((s) => extent(s.of))),
    also: body.rolls ? [series("ω", (p) => p.v / body.radius, "rad/s")] : [] });

  const forces = [series("R<sub>n</sub>", (p) => p.normal, "m g")];
  if (body.rolls) forces.push(series("R<sub>t</sub>", (p) => p.tangential, "m g"));
  all.push({ id: "force", letter: "R", title: body.rolls ? "Normal force and friction force" : "Normal force",
    unit: "m g", series: forces,
    range: union([0, 0], ranges.R_n, ...(body.rolls ? [ranges.R_t] : [])),
    lines: [0, bounds.least, bounds.greatest].filter((b) => b !== null) });

  if (body.rolls) {
    const walls = (p) => p.normal * (body.walls ?? 1);  // what presses, in sum
    const needed = (p) => (p.normal > 0 ? Math.abs(p.tangential) / walls(p) : null);
    const most = Math.max(...full.poses.filter((p) => p.t > 0.02 * T).map(needed));
    all.push({ id: "friction", letter: "μ", title: "Friction needed", unit: "",
      series: [series("|R<sub>t</sub>|/R<sub>n</sub>", needed)],
      range: [0, Math.min(2, 1.08 * (Number.isFinite(most) ? most : 2))],
      lines: bounds.friction === null ? [] : [bounds.friction] });
  }

  all.push({ id: "curvature", letter: "κ", title: "Curvature of the track, downwards positive",
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
  all.push({ id: "energy", letter: "E/m", title: "Energy per mass", unit: "J/kg", series: energies,
    range: union(...energies.map((s) => extent(s.of))) });

  const slacks = Object.keys(rows).filter((name) => name.startsWith("slack_"));
  if (slacks.length > 0) {
    all.push({ id: "slack", letter: "share", title: "Distance from each limit, as share of its largest",
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

const axisName = (plan) => `${plan.letter} [${plan.unit || "–"}]`;

/** Where curves leave their picture: the time nearest to what is seen, and
    whether they do so at its top. */
function leaves(plan) {
  const [low, top] = plan.range;
  const found = [];
  for (const [i, s] of plan.series.entries()) {
    const values = full.poses.map(s.of);
    const seen = values.map((v) => v !== null && v >= low && v <= top);
    for (let j = 0; j + 1 < values.length; ++j) {
      if (seen[j] === seen[j + 1]) continue;
      const [inner, outer] = seen[j] ? [j, j + 1] : [j + 1, j];
      let up = values[outer] > top;
      if (values[outer] === null) {
        // Without bound at the start, if the curve makes for the rim there.
        const before = values[inner] - values[inner + 1];
        up = before > 0;
        const room = up ? top - values[inner] : values[inner] - low;
        if (outer > inner || room > 0.15 * (top - low)) continue;
      }
      found.push({ series: i, t: full.poses[inner].t, up });
    }
  }
  return found;
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
    const { series } = colours();
    for (const mark of plan.leaves) {
      const x = Math.max(graph.toDomXCoord(mark.t), area.x + 4);
      const [tip, foot] = mark.up ? [area.y, area.y + 8] : [area.y + area.h, area.y + area.h - 8];
      context.fillStyle = series[mark.series % 6];
      context.beginPath();
      context.moveTo(x, tip);
      context.lineTo(x - 5, foot);
      context.lineTo(x + 5, foot);
      context.fill();
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
    plan.leaves = leaves(plan);
    if (plan.leaves.length > 0) byId("beyond-words").hidden = false;
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
      xlabel: "t [s]", ylabel: axisName(plan), xLabelHeight: 16, yLabelWidth: 18,
      labels: ["t", ...plan.series.map((s, i) => `${i} ${s.name}`)],
      colors: plan.series.map((_, i) => colour.series[i % 6]),
      strokeWidth: 1.6, legend: "never", valueRange: plan.range,
      dateWindow: [0, T], highlightCircleSize: 0, animatedZooms: false,
      gridLineColor: colour.faint, axisLineColor: colour.line,
      axes: {
        x: { axisLabelFormatter: (t) => tick(t), pixelsPerLabel: 64,
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
      player.goTo(graph.toDataXCoord(x));
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
  player.again();
}

function recolour() {
  const colour = colours();
  for (const { graph, plan } of charts) {
    graph.updateOptions({ colors: plan.series.map((_, i) => colour.series[i % 6]),
      gridLineColor: colour.faint, axisLineColor: colour.line });
  }
  player.again();
}

/** A curve for paper: lines that are as sharp as the printer, in place of a
    canvas. */
function curveOnPaper({ plan, part }) {
  const width = 660, high = 166, left = 62, right = 8, bottom = 36;
  const [low, top] = plan.range;
  const X = (t) => left + (width - left - right) * t / T;
  const Y = (y) => (high - bottom) * (top - y) / (top - low);
  const svg = draw("svg", { class: "paper-plot", viewBox: `0 0 ${width} ${high}` }, part);
  const clip = `clip-${plan.id}`;
  draw("rect", { x: left, y: 0, width: width - left - right, height: high - bottom },
      draw("clipPath", { id: clip }, svg));
  const grid = draw("g", { class: "grid" }, svg), words = draw("g", { class: "ticks" }, svg);
  draw("text", { x: left + 0.5 * (width - left - right), y: high - 4, "text-anchor": "middle" },
      words).textContent = "t [s]";
  draw("text", { transform: `translate(12 ${0.5 * (high - bottom)}) rotate(-90)`,
    "text-anchor": "middle" }, words).textContent = axisName(plan);
  for (const t of ticksIn(0, T, 8)) {
    draw("path", { d: `M${X(t)} 0V${high - bottom}` }, grid);
    draw("text", { x: X(t), y: high - 20, "text-anchor": "middle" }, words).textContent = tick(t);
  }
  for (const y of ticksIn(low, top, 4)) {
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
  draw("path", { class: "paper-cursor", d: `M${X(player.now())} 0V${high - bottom}` }, inside);
}

// ------------------------------------------------------------------ the time

/** Shows the body at a time, and the cursor there. */
function show(t) {
  const p = at(t);
  const { X, Y } = view;
  const degrees = moveBody(view.body, p, view);
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
}

const player = Motion.player(T, show);

// ------------------------------------------------------------- what is asked

function listen() {
  for (const [id, layer] of [["use-forces", "forces"], ["use-ghosts", "ghosts"]]) {
    const set = () => stage.classList.toggle(`no-${layer}`, !byId(id).checked);
    byId(id).addEventListener("change", set);
    set();
  }
  byId("use-lens").addEventListener("change", (event) => {
    event.target.dataset.touched = "";
    layOut();
    player.again();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => recolour());
  Motion.onResize(stage, () => {
    layOut();
    for (const { graph } of charts) graph.resize();
    player.again();
  });
  addEventListener("beforeprint", () => charts.forEach(curveOnPaper));
  addEventListener("afterprint", () => {
    for (const svg of document.querySelectorAll(".paper-plot")) svg.remove();
  });
}

layOut();
makeCharts();
listen();
Motion.letTablesScroll();
player.start();

})();
