// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What pages with motion share: the motion from the rows of its table, the
// plane it is drawn on, bodies, and a time that is played. The data stand in
// the page; nothing is loaded.
"use strict";

const Motion = (() => {

const byId = (id) => document.getElementById(id);

// ---------------------------------------------------------------- the motion

/** The motion of a body from the rows of its table. Where these have no forces
    there are the times between which it would lift off. */
function motionOf({ body, rows, lifts }) {
  const times = rows.t;
  const last = times.length - 1;
  const T = times[last];

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

  const liftedAt = (t) => lifts.some(([from, to]) => from <= t && t <= to);

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
    now.normal = rows.R_n ? value("R_n", t, i) : liftedAt(t) ? -Infinity : Infinity;
    now.tangential = body.rolls && rows.R_t ? value("R_t", t, i) : 0;
    return now;
  }

  /** Times so close that what is drawn between them is straight: the rows, and
      between them more where there are few or the body turns far. */
  function sample() {
    const close = [];
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
        close.push(times[i] + (times[i + 1] - times[i]) * j / n);
      }
    }
    close.push(T);
    return close.map(at);
  }

  return { body, T, at, value, poses: sample() };
}

// --------------------------------------------------------------- the drawing

const kSector = Math.PI / 6;  // of the rim, dark and light by turns
const kSteps = 10;            // places at equal times, where nothing moves

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

/** The multiples of such a step in a range, the places of ticks. */
function ticksIn(low, high, count) {
  const step = niceStep(high - low, count);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) ticks.push(i * step);
  return ticks;
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

/** A drawing of a box of the plane in place of what a holder has: its grid, and
    how points come onto it. */
function drawPlane(stage, box) {
  const width = widthOf(stage);
  const wide = box[1][0] - box[0][0], high = box[1][1] - box[0][1];
  const left = 54, bottom = 34, tallest = Math.max(300, 0.62 * width);
  const scale = Math.min((width - left - 2) / wide, tallest / high);
  const w = scale * wide, h = scale * high;
  const x0 = left + 0.5 * (width - left - w);
  const X = (x) => x0 + scale * (x - box[0][0]);
  const Y = (z) => scale * (z - box[0][1]) + 2;
  stage.textContent = "";
  const svg = draw("svg", {
    viewBox: `0 0 ${width.toFixed(1)} ${(h + bottom).toFixed(1)}`,
    role: "img", "aria-labelledby": "motion-heading motion-words",
  }, stage);
  const grid = draw("g", { class: "grid" }, svg);
  const words = draw("g", { class: "ticks" }, svg);
  for (const x of ticksIn(box[0][0], box[1][0], width < 600 ? 4 : 8)) {
    draw("path", { d: `M${X(x)} 2V${h + 2}` }, grid);
    // Not a number of which the rim would cut off a half.
    if (X(x) > width - 4 * String(tick(x)).length) continue;
    draw("text", { x: X(x), y: h + 16, "text-anchor": "middle" }, words)
        .textContent = tick(x);
  }
  for (const z of ticksIn(box[0][1], box[1][1], width < 600 ? 3 : 5)) {
    draw("path", { d: `M${x0} ${Y(z)}H${x0 + w}` }, grid);
    draw("text", { x: x0 - 6, y: Y(z) + 4, "text-anchor": "end" }, words)
        .textContent = tick(z);
  }
  draw("text", { x: x0 + 0.5 * w, y: h + 31, "text-anchor": "middle" }, words)
      .textContent = "x [m], to the right";
  draw("text", { transform: `translate(${x0 - left + 12} ${0.5 * h}) rotate(-90)`,
    "text-anchor": "middle" }, words).textContent = "z [m], down";
  return { svg, width, scale, X, Y, h };
}

function drawObstacles(svg, obstacles, { X, Y }) {
  for (const area of obstacles) {
    draw("polygon", {
      class: "obstacle",
      points: area.map(([x, z]) => `${X(x).toFixed(1)},${Y(z).toFixed(1)}`).join(" "),
    }, svg);
  }
}

/** The line through poses; x and z name which of their points. */
function pathOf(poses, x, z, place) {
  return poses.length < 2 ? "" : "M" + poses.map((p) => place(p[x], p[z])).join("L");
}

/** The pieces of the track on which the body would lift off. */
function liftedPath(poses, place) {
  let lifted = "";
  let run = [];
  for (const pose of [...poses, null]) {
    if (pose !== null && pose.t > 0 && pose.normal !== null && pose.normal <= 0) {
      run.push(pose);
    } else {
      lifted += pathOf(run, "xb", "zb", place);
      run = [];
    }
  }
  return lifted;
}

/** A and B. */
function markEnds(svg, poses, { X, Y }) {
  for (const [name, pose, side] of [["A", poses[0], -1], ["B", poses[poses.length - 1], 1]]) {
    const g = draw("g", { class: "end" }, svg);
    draw("circle", { cx: X(pose.xb), cy: Y(pose.zb), r: 3.2 }, g);
    draw("text", {
      x: X(pose.xb) + 9 * side, y: Y(pose.zb) + (side < 0 ? -7 : 14),
      "text-anchor": side < 0 ? "end" : "start",
    }, g).textContent = name;
  }
}

/** How far a body reaches; of a ball beyond what it rolls on. */
function outerRadius(body) {
  return body.radius * (body.walls ?? 1);
}

/** A body on a screen of so many pixels a metre, its middle at the origin. */
function bodyShape(parent, scale, id, body) {
  const R = scale * outerRadius(body), arm = (scale * body.radius * body.eta).toFixed(2);
  const g = draw("g", { id, class: "body" }, parent);
  if (!body.rolls || R < 3) {
    draw("circle", { class: "bead", r: body.rolls ? 3 : 5 }, g);
    return g;
  }
  draw("circle", { class: "disc", r: R }, g);
  // Of what it rolls on, whose sectors are as long as the pieces they leave.
  const rim = scale * body.radius - 2.2;
  if (rim > 0) {
    draw("circle", {
      class: "rim", r: rim, "stroke-dasharray": `${(rim * kSector).toFixed(3)}`,
    }, g);
  }
  draw("circle", { class: "axis", r: 1.8 }, g);
  if (body.eta > 0) {
    draw("path", { class: "arm", d: `M0 0H${arm}` }, g);
    draw("circle", { class: "mass", cx: arm, r: Math.min(5, 0.3 * R) }, g);
  }
  return g;
}

/** Puts a body where it is. \return how far it is turned, in degrees */
function moveBody(shape, p, { X, Y }) {
  const degrees = p.theta * 180 / Math.PI;
  shape.setAttribute("transform", `translate(${X(p.x)} ${Y(p.z)}) rotate(${degrees})`);
  Object.assign(shape.dataset, { t: p.t, x: p.x, z: p.z, theta: p.theta,
    contactX: p.xb, contactZ: p.zb });
  shape.classList.toggle("lifts", p.normal <= 0 && p.t > 0);
  return degrees;
}

const widthOf = (stage) => Math.max(280, stage.clientWidth);

/** Calls when a holder has got another width. */
function onResize(stage, fit) {
  let width = widthOf(stage);
  const look = () => {
    if (Math.abs(widthOf(stage) - width) < 1) return;
    width = widthOf(stage);
    fit();
  };
  new ResizeObserver(() => requestAnimationFrame(look)).observe(stage);
}

// ------------------------------------------------------------------ the time

/** The time from 0 to T, to be played, moved by hand and by keys, or named by
    the address. The page has the controls.
    \param show  draws what there is at a time */
function player(T, show) {
  let now = 0.4 * T;

  function showAt(t) {
    now = t;
    show(t);
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
    if (now >= T) showAt(0);
    byId("play").textContent = "Pause";
    playing = {};
    // Whoever wants no motion sees one place after the other.
    if (still.matches) {
      const step = () => {
        showAt(Math.min(T, (Math.floor(now * kSteps / T + 1e-9) + 1) * T / kSteps));
        if (now >= T) stop(); else playing.timer = setTimeout(step, 800);
      };
      step();
      return;
    }
    let before = null;
    const frame = (clock) => {
      if (before !== null) showAt(Math.min(T, now + 1e-3 * (clock - before) * rate()));
      before = clock;
      if (now >= T) stop(); else playing.frame = requestAnimationFrame(frame);
    };
    playing.frame = requestAnimationFrame(frame);
  }
  const toggle = () => (playing === null ? play() : stop());
  const rate = () => Number(document.querySelector("input[name=rate]:checked").value);

  /** Stops there. */
  function goTo(t) {
    stop();
    showAt(Math.min(Math.max(t, 0), T));
  }

  /** As it is, ten times slower, and what lasts some seconds if neither does. */
  function offerRates() {
    const rates = [1, 0.1];
    if (T > 20) rates.push(Math.pow(10, Math.ceil(Math.log10(T / 20))));
    if (T < 0.2) rates.push(Math.pow(10, Math.floor(Math.log10(T / 2))));
    const lasts = (r) => Math.abs(Math.log(T / r / 8));
    const best = rates.reduce((a, b) => (lasts(b) < lasts(a) ? b : a));
    const holder = byId("rates");
    holder.textContent = "";
    for (const r of rates) {
      const label = document.createElement("label");
      label.innerHTML = `<input type="radio" name="rate" value="${r}"/> ` +
          (r === 1 ? "real time" : r > 1 ? `${tick(r)} times faster` :
              `slow motion, ${tick(1 / r)} times`);
      label.firstChild.checked = r === best;
      holder.appendChild(label);
    }
  }

  function fromAddress() {
    const found = /[#&]t=([0-9.eE+-]+)/.exec(location.hash);
    if (found === null || !Number.isFinite(Number(found[1]))) return false;
    goTo(Number(found[1]));
    return true;
  }

  function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const on = event.target.closest("button, summary, a, input");
    const slider = on !== null && on.id === "time";
    const step = (event.shiftKey ? 0.1 : 0.01) * T;
    const moves = { ArrowLeft: now - step, ArrowRight: now + step, Home: 0, End: T };
    if (event.key === " " && (on === null || slider)) {
      toggle();
    } else if (event.key in moves && (on === null || slider || on.tagName === "BUTTON")) {
      goTo(moves[event.key]);
    } else {
      return;
    }
    event.preventDefault();
  }

  /** Begins to listen, and shows the first time. */
  function start(at = now) {
    offerRates();
    byId("play").addEventListener("click", toggle);
    byId("time").addEventListener("input", (event) => goTo(Number(event.target.value) * T));
    document.addEventListener("keydown", onKey);
    addEventListener("hashchange", fromAddress);
    addEventListener("beforeprint", stop);
    if (!fromAddress()) showAt(at);
  }

  /** The same for another motion. */
  function restart(otherT) {
    stop();
    T = otherT;
    offerRates();
    showAt(0.4 * T);
  }

  return { start, restart, goTo, now: () => now, again: () => showAt(now) };
}

/** Tables that scroll can be scrolled by keys, those that are folded too. */
function letTablesScroll() {
  for (const details of document.querySelectorAll("details")) {
    details.ontoggle = letTablesScroll;
  }
  for (const wide of document.querySelectorAll(".wide")) {
    if (wide.scrollWidth <= wide.clientWidth) continue;
    wide.tabIndex = 0;
    wide.setAttribute("role", "region");
    let title = wide.previousElementSibling;
    while (title !== null && !/^(H[1-6]|SUMMARY)$/.test(title.tagName)) {
      title = title.previousElementSibling;
    }
    wide.setAttribute("aria-label", title === null ? "table" : `table: ${title.textContent}`);
  }
}

return { byId, draw, drawPlane, drawObstacles, bodyShape, outerRadius, letTablesScroll, liftedPath, markEnds,
  motionOf, moveBody, onResize, pathOf, player, shown, tick, ticksIn, kSector, kSteps };

})();
