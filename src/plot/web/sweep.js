// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of a sweep: over each picture its scenes as cells, which tell what
// the table says of them and show the track that was kept. What it shares with
// other pages is in motion.js.
"use strict";

(() => {

const { byId, draw, pathOf } = Motion;
const data = JSON.parse(byId("data").textContent);
const table = byId("scenes");

// ---------------------------------------------------------------- the scenes

/** What the table says of a scene, by its columns. */
function valuesOf(scene) {
  const heads = table.tHead.rows[0].cells;
  return [...table.tBodies[0].rows[scene].cells].map((cell, i) => [heads[i], cell]);
}

/** "scene 17, θ_m [°] −30, …": the same to be said. */
const inWords = (scene) => [...valuesOf(scene).map(([head, cell]) =>
    `${head.textContent} ${cell.textContent}`),
  ...(data.remarks[scene] ? [data.remarks[scene]] : [])].join(", ");

/** Sides that a scene is on or not, with an edge between. */
const kEdges = [
  ["infeasible", "edge of infeasible scenes: the body would lift off or come to a fold of its path"],
  ["unsolved", "edge of scenes without a verified result"],
  ["missing", "edge of scenes that were not run yet"],
  ["folded", "edge of scenes whose branch from the cycloid turned at folds"],
].map(([kind, words]) => ({ kind, words, scenes: new Set(data[kind]) }));

// ----------------------------------------------------------------- the cells

/** Corners of the cells of a map: in the middle between scenes, and at its rim
    on it. */
function cornersOf({ row, x, y }) {
  const rows = x.length / row;
  const within = (i, n) => Math.min(Math.max(i, 0), n - 1);
  const mean = (values, i, j) => [i - 1, i].flatMap((a) => [j - 1, j].map((b) =>
      values[within(a, rows) * row + within(b, row)])).reduce((a, b) => a + b) / 4;
  return (i, j) => `${mean(x, i, j).toFixed(1)} ${mean(y, i, j).toFixed(1)}`;
}

/** The outline of each cell: of a dot a circle about it. */
function outlinesOf(figure) {
  if (!figure.meet) {
    const r = 6;
    return figure.x.map((x, i) =>
        `M${x - r} ${figure.y[i]}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`);
  }
  const at = cornersOf(figure);
  return figure.scenes.map((_, cell) => {
    const i = Math.floor(cell / figure.row), j = cell % figure.row;
    return `M${at(i, j)}L${at(i, j + 1)}L${at(i + 1, j + 1)}L${at(i + 1, j)}Z`;
  });
}

/** The lines between cells of which one alone belongs to a set. */
function edgeOf(figure, scenes) {
  const { row } = figure;
  const at = cornersOf(figure);
  const inside = figure.scenes.map((scene) => scenes.has(scene));
  let path = "";
  inside.forEach((here, cell) => {
    const i = Math.floor(cell / row), j = cell % row;
    if (j + 1 < row && inside[cell + 1] !== here) path += `M${at(i, j + 1)}L${at(i + 1, j + 1)}`;
    if (cell + row < inside.length && inside[cell + row] !== here) {
      path += `M${at(i + 1, j)}L${at(i + 1, j + 1)}`;
    }
  });
  return path;
}

/** The cell to which an arrow leads; the same if there is none. */
function neighbour(figure, cell, dx, dy) {
  const { row, x, y } = figure;
  const along = dx === 0 ? y : x;
  const sign = dx + dy;
  if (figure.meet) {
    // The step of the grid that goes that way.
    let best = cell, most = 1e-9;
    for (const step of [1, -1, row, -row]) {
      const next = cell + step;
      const sameRow = Math.floor(next / row) === Math.floor(cell / row);
      if (next < 0 || next >= x.length || (Math.abs(step) === 1 && !sameRow)) continue;
      const way = sign * (along[next] - along[cell]) /
          Math.hypot(x[next] - x[cell], y[next] - y[cell]);
      if (way > most) [best, most] = [next, way];
    }
    return most > 0.5 ? best : cell;
  }
  // Along a curve; from curve to curve at one place; else in the order of places.
  const candidates = [...x.keys()].filter((i) => row === 0 ||
      (dx === 0 ? i % row === cell % row : Math.floor(i / row) === Math.floor(cell / row)));
  const order = (a, b) => sign * (along[a] - along[b]) || sign * (a - b);
  candidates.sort(order);
  return candidates[candidates.indexOf(cell) + 1] ?? cell;
}

/** The layer over a picture. */
function layerOf(figure) {
  const holder = byId(`drawing-${figure.name}`);
  const [width, height] = figure.size;
  const layer = draw("svg", {
    class: player ? "cells tracks" : "cells", viewBox: `0 0 ${width} ${height}`, tabindex: 0, role: "application",
    "aria-label": `Scenes of ${figure.name}: arrow keys move from scene to scene` +
        (player ? ", Enter shows a track" : ""),
    "aria-roledescription": "map of scenes",
  }, holder);
  const outlines = outlinesOf(figure);
  const key = document.createElement("p");
  key.className = "key edges";
  if (figure.meet) {
    for (const { kind, words, scenes } of kEdges) {
      const path = edgeOf(figure, scenes);
      if (path === "") continue;
      draw("path", { class: "halo", d: path }, layer);
      draw("path", { class: `edge ${kind}`, d: path }, layer);
      const item = document.createElement("span");
      const line = draw("svg", { viewBox: "0 0 36 8", "aria-hidden": "true" }, item);
      draw("path", { class: `edge ${kind}`, d: "M0 4H36" }, line);
      item.append(words);
      key.append(item);
    }
  }
  const marks = ["chosen", "here"].map((name) => [name, ["halo", "line"].map((kind) =>
      draw("path", { class: `${name} ${kind}` }, layer))]);
  const mark = Object.fromEntries(marks.map(([name, paths]) =>
      [name, (cell) => paths.forEach((path) =>
          path.setAttribute("d", cell === null ? "" : outlines[cell]))]));
  outlines.forEach((outline, cell) => {
    draw("path", { class: "cell", d: outline, "data-cell": cell,
      "data-scene": figure.scenes[cell] }, layer);
  });

  // What is said of the scene, for the eye and for the ear.
  const told = document.createElement("div");
  told.className = "told";
  told.innerHTML = `<dl class="numbers"></dl><p class="remark"></p>`;
  const spoken = document.createElement("p");
  spoken.className = "spoken";
  spoken.setAttribute("role", "status");
  holder.after(key);
  const around = holder.closest("figure");
  around.append(told, spoken);
  let here = null, chosen = null;

  function tell(cell) {
    mark.here(cell);
    if (cell === null) return;
    const scene = figure.scenes[cell];
    told.firstChild.innerHTML = valuesOf(scene).map(([head, value]) =>
        `<div><dt>${head.innerHTML}</dt><dd>${value.innerHTML}</dd></div>`).join("");
    told.lastChild.textContent = data.remarks[scene] ?? "";
    told.dataset.scene = scene;
  }
  function moveTo(cell) {
    here = cell;
    tell(cell);
    spoken.textContent = inWords(figure.scenes[cell]);
  }
  function choose(cell) {
    moveTo(cell);
    const shown = showTrack(figure.scenes[cell], around);
    if (!shown) return;
    chosen = cell;
    for (const other of layers) other.unmark();
    mark.chosen(chosen);
  }

  const cellOf = (event) => event.target.dataset.cell === undefined
      ? null : Number(event.target.dataset.cell);
  layer.addEventListener("pointermove", (event) => {
    const cell = cellOf(event);
    if (cell !== null) tell(cell);
  });
  layer.addEventListener("pointerleave", () => tell(here));
  layer.addEventListener("click", (event) => {
    const cell = cellOf(event);
    if (cell !== null) choose(cell);
  });
  layer.addEventListener("focus", () => {
    if (here === null && layer.matches(":focus-visible")) moveTo(0);
  });
  const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  layer.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key in kArrows) {
      moveTo(here === null ? 0 : neighbour(figure, here, ...kArrows[event.key]));
    } else if (event.key === "Home" || event.key === "End") {
      moveTo(event.key === "Home" ? 0 : outlines.length - 1);
    } else if ((event.key === "Enter" || event.key === " ") && here !== null) {
      choose(here);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  });
  return { figure, choose, unmark: () => mark.chosen(null) };
}

// ----------------------------------------------------------------- the track

const stage = byId("stage");
const section = byId("track-section");
const kColumns = ["t", "x_c", "z_c", "beta", "v_c", "theta"];  // as plot/thinning.cpp has them
const view = {};
let motion = null, box = null, obstacles = [];

/** The rows of a kept track: sums of differences, in units of a step. */
function rowsOf({ rows, steps }) {
  return Object.fromEntries(rows.map((moves, c) => {
    let sum = 0;
    return [kColumns[c], moves.map((move) => (sum += move) * steps[c])];
  }));
}

function layOut() {
  const plane = Motion.drawPlane(stage, box);
  const { svg, scale, X, Y } = plane;
  Object.assign(view, plane);
  Motion.drawObstacles(svg, obstacles, plane);
  const place = (x, z) => `${X(x).toFixed(2)} ${Y(z).toFixed(2)}`;
  const { body, poses } = motion;
  if (body.rolls) draw("path", { class: "centre-path", d: pathOf(poses, "x", "z", place) }, svg);
  if (body.eta > 0) {
    draw("path", { class: "mass-path", d: pathOf(poses, "xm", "zm", place) }, svg);
  }
  draw("path", { id: "track", class: "track", d: pathOf(poses, "xb", "zb", place) }, svg);
  const lifted = Motion.liftedPath(poses, place);
  draw("path", { class: "lifted", d: lifted }, svg);
  byId("lift-key").hidden = lifted === "";
  Motion.markEnds(svg, poses, plane);
  view.body = Motion.bodyShape(svg, scale, "body", body);
}

function show(t) {
  Motion.moveBody(view.body, motion.at(t), view);
}

const player = section === null ? null : Motion.player(1, show);
let started = false;

/** Shows the track below a figure. \return whether there is one */
function showTrack(scene, around) {
  const kept = data.tracks[scene];
  if (kept === undefined || player === null) return false;
  motion = Motion.motionOf({ ...kept, rows: rowsOf(kept) });
  ({ box, obstacles } = kept);
  around.after(section);
  section.hidden = false;
  byId("track-scene").textContent = scene;
  byId("track-rows").textContent = `${kept.rows[0].length} of ${kept.of_rows}`;
  byId("track-error").textContent = Motion.tick(kept.path_error);
  layOut();
  player.restart(motion.T);
  if (!started) {
    started = true;
    player.start();
    Motion.onResize(stage, () => {
      layOut();
      player.again();
    });
  }
  return true;
}

// --------------------------------------------------------------------- begin

const layers = [];
for (const figure of data.figures) layers.push(layerOf(figure));

/** "#scene=17&t=0.3" names a scene and a time. */
function fromAddress() {
  const found = /[#&]scene=([0-9]+)/.exec(location.hash);
  if (found === null) return;
  for (const { figure, choose } of layers) {
    const cell = figure.scenes.indexOf(Number(found[1]));
    if (cell >= 0) return choose(cell);
  }
}
fromAddress();
addEventListener("hashchange", fromAddress);
Motion.letTablesScroll();

})();
