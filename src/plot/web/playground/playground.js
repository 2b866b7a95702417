// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

'use strict';

// The page of the playground: controls → scene → Solver → picture and numbers.
// Nothing is computed here that the module computes.

const DRAG_TOLERANCE = 1e-10;  // relative, of T, as one drags
const FULL_TOLERANCE = 1e-13;  // once at rest
const DRAG_SECONDS = 1;        // before an answer is given up
const FULL_SECONDS = 5;
const REST_MS = 250;           // without a change is rest
const ROWS = 241;              // of a drawn path
const AGREEMENT = 1e-9;        // between two answers that count as one
const DURATIONS = 15;          // of answers that the shown one is the median of
const PAUSE = 0.6;             // of the animation at B [s]
const STROKE_POINTS = 10;      // of a track drawn in one stroke
const DEGREE = Math.PI / 180;
const REFERENCE = {radius: 1 / 3, eta: 2 / 3, theta: 0, k: 1 / 2, L: 3, H: 1,
  friction: 0, drag: 0, grip: 2};
const NO_LIMIT = 2;            // of the grip
const OF_BOTH = ['L', 'H', 'drag'];  // controls that both kinds have

/** Sliders, their units, and what they show. */
const SLIDERS = {
  eta: {unit: 1, show: (v) => v.toFixed(3)},
  theta: {unit: DEGREE, show: (v) => signed(`${(v / DEGREE).toFixed(0)}°`)},
  k: {unit: 1, show: (v) => v.toFixed(3)},
  radius: {unit: 1, show: (v) => `${v.toFixed(3)} m`},
  L: {unit: 1, show: (v) => `${v.toFixed(2)} m`},
  H: {unit: 1, show: (v) => `${v.toFixed(2)} m`},
  friction: {unit: 1, show: (v) => v.toFixed(3)},
  drag: {unit: 1, show: (v) => `${v.toFixed(3)} 1/m`},
  grip: {unit: 1, show: (v) => (v < NO_LIMIT ? v.toFixed(2) : 'no limit')},
};

/** With real minus signs. */
const signed = (text) => text.replace(/-(?=\d)/g, '−');

const element = (id) => document.getElementById(id);
const picture = element('picture');
const stillness = matchMedia('(prefers-reduced-motion: reduce)');

/** What the controls say; k is what was asked for, which η may not allow. */
const wanted = {...REFERENCE, bead: false};
/** Of the own track, as shares of L and H; A and B are not among them. */
let ownPoints = [];
let solver = null;
let answer = null;  // {numbers, rows, scene}
let durations = [];   // of the last answers [ms]
let own = null;     // {numbers, rows}, or null
let stroke = null;  // [x, z] of a track that is being drawn, or null
let view = null;    // metres to pixels
let clock = {playing: !stillness.matches, time: 0, last: null};
let changedAt = null;
let restTimer = 0;
let framePending = false;
let dragging = false;

function scene() {
  if (wanted.bead) {
    const {L, H, friction, drag} = wanted;
    return {radius: 0, eta: 0, theta: 0, k: 0, L, H, friction, drag};
  }
  const {radius, eta, theta, k, L, H, drag} = wanted;
  return {radius, eta, theta, k: Math.min(k, 1 - eta * eta), L, H, friction: 0, drag};
}

// The controls.

function showControls() {
  const now = scene();
  for (const [id, {unit, show}] of Object.entries(SLIDERS)) {
    const input = element(id);
    const none = !OF_BOTH.includes(id) && wanted.bead !== (id === 'friction');
    const value = none ? wanted[id] : now[id] ?? wanted[id];
    input.value = value / unit;
    element(`${id}-out`).textContent = show(value);
    input.setAttribute('aria-valuetext', show(value));
    input.disabled = none;
  }
}

function changed() {
  showControls();
  changedAt = performance.now();
  clearTimeout(restTimer);
  restTimer = setTimeout(check, REST_MS);
  requestDraw();
}

function requestDraw() {
  if (framePending) return;
  framePending = true;
  requestAnimationFrame(frame);
}

// Answers.

/** The answer as one drags: from the last one, or else from the cycloid. */
function solveQuickly() {
  const asked = scene();
  const first = answer === null;  // for which the browser compiles the module
  const start = performance.now();
  const accepted = solver.setScene(asked);
  const numbers = accepted &&
    (solver.solve(!first, DRAG_TOLERANCE, DRAG_SECONDS) ||
     solver.solve(false, DRAG_TOLERANCE, DRAG_SECONDS));
  if (numbers) {
    answer = {numbers, scene: asked, rows: solver.sampleExtremal(ROWS)};
    if (first) element('speed').textContent = 'drag to see';
    else showSpeed(performance.now() - start);
  }
  showAnswer(numbers ? '' : solver.text);
  clearChecks();
}

/** The median of the last answers: one that waited for others says nothing. */
function showSpeed(milliseconds) {
  durations = [...durations.slice(1 - DURATIONS), milliseconds];
  const median = [...durations].sort((a, b) => a - b)[durations.length >> 1];
  element('speed').textContent =
    `${median.toFixed(1)} ms, ${(1000 / median).toFixed(0)}/s`;
}

function showAnswer(trouble) {
  element('trouble').hidden = !trouble;
  element('trouble').textContent = trouble &&
    `No answer here: ${trouble}. ${answer ? 'Drawn is the last one.' : ''}`;
  for (const id of ['track', 'body', 'tau', 'transit']) {
    element(id).classList.toggle('stale', Boolean(trouble));
  }
  if (!answer) return;
  element('tau').textContent = answer.numbers.tau.toFixed(10);
  element('transit').textContent = `${answer.numbers.time.toFixed(6)} s`;
}

/** Once at rest: the answer again in the way of the command. */
function check() {
  if (!solver || dragging) return;
  const asked = scene();
  if (!solver.setScene(asked)) return;
  const quick = answer && sameScene(answer.scene, asked) ? answer.numbers : null;
  const full = solver.solve(false, FULL_TOLERANCE, FULL_SECONDS);
  if (!full) {
    showChecks(null, quick, quick
      ? `Not confirmed. What is drawn is an extremal; the way from the cycloid, ` +
        `which the command goes, says: ${solver.text}.` : '');
    return;
  }
  const difference = quick && Math.abs(quick.tau / full.tau - 1);
  answer = {numbers: full, scene: asked, rows: solver.sampleExtremal(ROWS)};
  showAnswer('');
  updateOwn();
  let verdict = `Confirmed: τ = ${full.tau.toFixed(12)} to a relative ` +
    `${signed(full.error.toExponential(0))}, by the indirect method.`;
  if (quick && !(difference <= AGREEMENT)) {
    verdict = `What was drawn as you dragged, τ = ${quick.tau.toFixed(8)}, was ` +
      'another extremal. This is the principal one, which is connected with ' +
      `the cycloid: τ = ${full.tau.toFixed(12)}.`;
  }
  if (full.folds > 0) {
    verdict += ` The branch from the cycloid turned back ${full.folds} times ` +
      'on the way.';
  }
  showChecks(full, quick, verdict);
  requestDraw();
}

function sameScene(one, other) {
  return Object.keys(one).every((key) => one[key] === other[key]);
}

function clearChecks() {
  element('checks').replaceChildren();
  element('verdict').textContent = '…';
  element('verdict').classList.remove('fails');
}

function showChecks(full, quick, verdict) {
  const rows = [];
  if (full) {
    rows.push(['τ from the cycloid', full.tau.toFixed(12), true]);
    if (quick) {
      const difference = Math.abs(quick.tau / full.tau - 1);
      rows.push(['the quick answer differed by', difference.toExponential(1),
        difference <= AGREEMENT]);
    }
    rows.push(
      ['largest residual: ends, junctions, tangency at B',
        full.residual.toExponential(1), full.residual <= AGREEMENT],
      ['error of T: every step halved, and rounding',
        full.error.toExponential(1), full.error <= AGREEMENT],
      ['least ∂²𝓗/∂β², Legendre: above 0', full.legendre.toPrecision(3),
        full.legendre > 0],
      ['Newton steps, on arcs', `${full.steps}, ${full.arcs}`, true]);
  }
  element('checks').replaceChildren(...rows.map(([name, value, passed]) => {
    const row = document.createElement('tr');
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = name;
    const cell = document.createElement('td');
    cell.textContent = signed(passed ? value : `${value} ✗`);
    cell.classList.toggle('fails', !passed);
    row.append(head, cell);
    return row;
  }));
  element('verdict').textContent = verdict;
  element('verdict').classList.toggle('fails', !full && Boolean(verdict));
  element('problem').textContent = problemFile();
}

/** The scene as a file for the command, number for number. */
function problemFile() {
  const {radius, eta, theta, k, L, H, friction, drag} = scene();
  const body = wanted.bead ? '{shape: bead}'
    : `{shape: cylinder, radius: ${radius}, eta_m: ${eta}, ` +
      `theta_m: ${theta}, k: ${k}}`;
  const more = [
    friction > 0 && `losses: {sliding: ${friction}}`,
    drag > 0 && `air: {quadratic: ${drag}}`,
    isLimited() && `limits: {friction: ${wanted.grip}}`];
  return `scene:\n  body: ${body}\n  finish: {L: ${L}, H: ${H}}\n` +
    more.filter(Boolean).map((line) => `  ${line}\n`).join('');
}

// One's own track.

function isLimited() {
  return !wanted.bead && wanted.grip < NO_LIMIT;
}

/** Of 100, by the rules: what touches the track all the way and does not slip. */
function scoreOf(numbers) {
  const lifts = !wanted.bead && numbers.leastForce < -1e-9;
  const slips = isLimited() && !(numbers.grip <= wanted.grip);
  return lifts || slips ? 0 : Math.round(100 * answer.numbers.tau / numbers.tau);
}

function ownTrack() {
  const {L, H} = wanted;
  return [[0, 0], ...ownPoints.map(([x, z]) => [x * L, z * H]), [L, H]];
}

function ownIsOn() {
  return element('own').checked;
}

function updateOwn() {
  own = null;
  if (!ownIsOn() || stroke || !solver?.setScene(scene())) return;
  const numbers = solver.ride(ownTrack());
  const result = element('own-result');
  const remark = element('own-remark');
  remark.textContent = '';
  if (!numbers) {
    result.textContent = `No time: ${solver.text}.`;
    return;
  }
  own = {numbers, rows: solver.sampleRide(ROWS)};
  if (!answer || !sameScene(answer.scene, scene())) {
    result.textContent = `Your track: τ = ${numbers.tau.toFixed(6)}. There is ` +
      'no answer to compare it with.';
    return;
  }
  const share = numbers.tau / answer.numbers.tau - 1;
  const seconds = numbers.time - answer.numbers.time;
  const digits = Math.abs(share) < 1e-4 ? 6 : 3;
  result.textContent = `Your track: τ = ${numbers.tau.toFixed(6)}, ` +
    `${Math.abs(100 * share).toFixed(digits)} % ` +
    `${share < 0 ? 'faster' : 'slower'} than the answer ` +
    `(${seconds < 0 ? '−' : '+'}${Math.abs(1000 * seconds).toFixed(digits)} ms). ` +
    `Score: ${scoreOf(numbers)} of 100.`;
  const remarks = [];
  // The spline's quadrature and the extremal's own error are far below this.
  if (share < -1e-9 && !wanted.bead) {
    remarks.push('That can be: with another slope at B its centre ends ' +
      'elsewhere, and between A and B themselves no track is the fastest for ' +
      'a body with a radius. The answer is stationary among tracks that bring ' +
      'the centre to the place where its own ends.');
  }
  if (isLimited() && !(numbers.grip <= wanted.grip)) {
    remarks.push(`The body would slip: this track takes a grip of ${
      numbers.grip.toFixed(2)}. The answer is that without a limit; the command ` +
      'finds the one with it.');
  }
  if (numbers.leastForce < -1e-9) {
    remarks.push('A real body would lift off near x = ' +
      `${numbers.leastForceX.toFixed(2)} m; the time is that of one that is held.`);
  }
  remark.textContent = remarks.join(' ');
}

function straightPoints(count) {
  return Array.from({length: count},
    (_, i) => [(i + 1) / (count + 1), (i + 1) / (count + 1)]);
}

/** Points of the answer's track, nearer to each other where it bends most. */
function pointsOfAnswer(count) {
  const {L, H} = wanted;
  return Array.from({length: count}, (_, i) => {
    const {trackX, trackZ} =
      answer.rows[Math.round((ROWS - 1) * (i + 1) / (count + 1))];
    return [trackX / L, trackZ / H];
  });
}

function setOwnPoints(points) {
  ownPoints = points;
  const group = element('points');
  group.replaceChildren(...points.map((_, i) => {
    const handle = element('b').cloneNode(true);
    handle.removeAttribute('id');
    handle.setAttribute('tabindex', '0');
    handle.setAttribute('role', 'button');
    handle.setAttribute('aria-roledescription', 'movable point');
    draggable(handle, (place) => movePoint(i, place));
    handle.addEventListener('keydown', (event) => nudge(i, event));
    return handle;
  }));
  ownChanged();
}

/** Waits for a stroke on the picture, or no longer. */
function setDrawing(on) {
  element('draw').setAttribute('aria-pressed', on);
  picture.classList.toggle('drawing', on);
  if (!on) return;
  picture.scrollIntoView({block: 'nearest'});
  element('own-result').textContent =
    'Draw from A to B on the picture, with mouse, pen or finger.';
  element('own-remark').textContent = '';
}

function isDrawing() {
  return picture.classList.contains('drawing');
}

function listenToStrokes() {
  picture.addEventListener('pointerdown', (event) => {
    if (!isDrawing() || !event.isPrimary) return;
    picture.setPointerCapture(event.pointerId);
    stroke = [placeOf(event)];
    dragging = true;
  });
  picture.addEventListener('pointermove', (event) => {
    if (!stroke || !event.isPrimary) return;
    stroke.push(placeOf(event));
    own = null;
    requestDraw();
  });
  const end = (event) => {
    if (!stroke || !event.isPrimary) return;
    const {L, H} = wanted;
    const points = event.type === 'pointerup' &&
      pointsOfStroke(stroke, [L, H], STROKE_POINTS);
    stroke = null;
    dragging = false;
    if (points) {
      setDrawing(false);
      setOwnPoints(points.map(([x, z]) => [x / L, z / H]));
    }
    changed();
  };
  picture.addEventListener('pointerup', end);
  picture.addEventListener('pointercancel', end);
}

function movePoint(i, {x, z}) {
  ownPoints[i] = [x / wanted.L, z / wanted.H];
  ownChanged();
}

function nudge(i, event) {
  const step = event.shiftKey ? 0.1 : 0.01;
  const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
    ArrowDown: [0, 1]}[event.key];
  if (!way) return;
  event.preventDefault();
  ownPoints[i] = ownPoints[i].map((share, j) => share + step * way[j]);
  ownChanged();
}

function ownChanged() {
  element('points').childNodes.forEach((handle, i) => {
    const [x, z] = ownTrack()[i + 1];
    handle.setAttribute('aria-label', `Point ${i + 1} of your track, ` +
      `${x.toFixed(2)} m across, ${z.toFixed(2)} m down`);
  });
  updateOwn();
  requestDraw();
}

// The picture.

/** Fits all that is drawn, unless something is being dragged in it. */
function fit() {
  const {width, height} = picture.getBoundingClientRect();
  if (dragging && view && view.width === width) return;
  const radius = scene().radius;
  const places = [[0, 0], [wanted.L, wanted.H]];
  for (const row of answer?.rows ?? []) {
    places.push([row.trackX, row.trackZ], [row.x - radius, row.z - radius],
      [row.x + radius, row.z + radius]);
  }
  if (ownIsOn()) places.push(...ownTrack());
  for (const row of ownIsOn() && own ? own.rows : []) {
    places.push([row.trackX, row.trackZ], [row.x, row.z - radius]);
  }
  const xs = places.map(([x]) => x);
  const zs = places.map(([, z]) => z);
  const margin = 26;
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...zs), Math.max(...zs)];
  const scale = Math.max(1e-9, Math.min((width - 2 * margin) / (right - left),
    (height - 2 * margin) / (bottom - top)));
  view = {width, height, scale,
    x: width / 2 - scale * (left + right) / 2,
    z: height / 2 - scale * (top + bottom) / 2};
  picture.setAttribute('viewBox', `0 0 ${width} ${height}`);
}

const toPixels = (x, z) => [view.x + view.scale * x, view.z + view.scale * z];

function line(places) {
  return places.map(([x, z], i) => {
    const [px, pz] = toPixels(x, z);
    return `${i ? 'L' : 'M'}${px.toFixed(2)} ${pz.toFixed(2)}`;
  }).join('');
}

function place(id, x, z, dx = 0, dz = 0) {
  const [px, pz] = toPixels(x, z);
  const node = typeof id === 'string' ? element(id) : id;
  if (node.tagName === 'text') {
    node.setAttribute('x', px + dx);
    node.setAttribute('y', pz + dz);
  } else {
    node.setAttribute('transform', `translate(${px.toFixed(2)} ${pz.toFixed(2)})`);
  }
}

/** Between the rows of a path at the time t. */
function rowAt(rows, t) {
  let low = 0;
  let high = rows.length - 1;
  if (t >= rows[high].t) return rows[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rows[middle].t <= t) low = middle; else high = middle;
  }
  const share = (t - rows[low].t) / (rows[high].t - rows[low].t);
  return Object.fromEntries(Solver.ROW.map((name) =>
    [name, rows[low][name] + share * (rows[high][name] - rows[low][name])]));
}

function drawBody(id, rows, {radius, eta}) {
  const group = element(id);
  group.toggleAttribute('hidden', !rows);
  if (!rows) return;
  const {x, z, theta} = rowAt(rows, clock.time);
  const bead = radius === 0;
  const pixels = bead ? 6 : radius * view.scale;
  const [rim, spoke, mass] = group.children;
  place(group, x, z);
  rim.setAttribute('r', pixels);
  const arm = [Math.cos(theta), Math.sin(theta)];
  const tip = arm.map((part) => part * pixels);
  spoke.setAttribute('d', bead ? '' : `M0 0L${tip[0]} ${tip[1]}`);
  mass.setAttribute('r', bead ? 0 : Math.max(2.5, pixels * 0.09));
  mass.setAttribute('cx', tip[0] * eta);
  mass.setAttribute('cy', tip[1] * eta);
}

function lastTime() {
  return Math.max(answer?.numbers.time ?? 0, own?.numbers.time ?? 0);
}

function draw() {
  fit();
  const {L, H} = wanted;
  const [ax, az] = toPixels(0, 0);
  element('level').setAttribute('d', `M0 ${az}H${view.width}`);
  element('track').setAttribute('d',
    answer ? line(answer.rows.map((row) => [row.trackX, row.trackZ])) : '');
  drawBody('body', answer?.rows, answer?.scene ?? {});
  drawBody('own-body', own?.rows, scene());
  element('own-track').setAttribute('d', !ownIsOn() ? '' : line(stroke ??
    own?.rows.map((row) => [row.trackX, row.trackZ]) ?? ownTrack()));
  element('points').toggleAttribute('hidden', !ownIsOn());
  element('points').childNodes.forEach((handle, i) =>
    place(handle, ...ownTrack()[i + 1]));
  element('a').setAttribute('cx', ax);
  element('a').setAttribute('cy', az);
  place('a-name', 0, 0, -18, 5);
  place('b', L, H);
  place('b-name', L, H, -6, 24);
  const time = Math.min(clock.time, lastTime());
  element('time').max = lastTime();
  element('time').value = time;
  element('clock').textContent = `${time.toFixed(3)} s`;
}

/** One picture: what has changed is solved, the body moves on. */
function frame(now) {
  framePending = false;
  if (!solver) return;
  if (changedAt !== null) {
    changedAt = null;
    solveQuickly();
    updateOwn();
  }
  if (clock.playing) {
    clock.time += clock.last === null ? 0 : (now - clock.last) / 1000;
    if (clock.time > lastTime() + PAUSE) clock.time = 0;
    clock.last = now;
    requestDraw();
  } else {
    clock.last = null;
  }
  draw();
}

function setPlaying(playing) {
  clock.playing = playing;
  clock.last = null;
  element('play').textContent = playing ? 'Pause' : 'Play';
  requestDraw();
}

/** Where in metres a pointer is. */
function placeOf(event) {
  const box = picture.getBoundingClientRect();
  return [(event.clientX - box.left - view.x) / view.scale,
    (event.clientY - box.top - view.z) / view.scale];
}

/** Tells `moved` where in metres a handle is dragged to. */
function draggable(handle, moved) {
  let offset = null;
  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    const [hx, hz] = /\(([-\d.]+) ([-\d.]+)\)/.exec(
      handle.getAttribute('transform')).slice(1).map(Number);
    const [x, z] = placeOf(event);
    offset = [(hx - view.x) / view.scale - x, (hz - view.z) / view.scale - z];
    dragging = true;
  });
  handle.addEventListener('pointermove', (event) => {
    if (!offset) return;
    const [x, z] = placeOf(event);
    moved({x: x + offset[0], z: z + offset[1]});
  });
  const release = () => {
    if (!offset) return;
    offset = null;
    dragging = false;
    changed();
  };
  handle.addEventListener('pointerup', release);
  handle.addEventListener('pointercancel', release);
}

function withinSlider(id, value) {
  const {min, max} = element(id);
  return Math.min(Number(max), Math.max(Number(min), value));
}

function listen() {
  for (const [id, {unit}] of Object.entries(SLIDERS)) {
    element(id).addEventListener('input', (event) => {
      wanted[id] = unit * Number(event.target.value);
      changed();
    });
  }
  for (const radio of document.querySelectorAll('input[name="kind"]')) {
    radio.addEventListener('change', () => {
      wanted.bead = radio.value === 'bead' && radio.checked;
      changed();
    });
  }
  element('reset').addEventListener('click', () => {
    Object.assign(wanted, REFERENCE, {bead: false});
    document.querySelector('input[value="cylinder"]').checked = true;
    changed();
  });
  draggable(element('b'), ({x, z}) => {
    wanted.L = withinSlider('L', x);
    wanted.H = withinSlider('H', z);
    changed();
  });
  element('own').addEventListener('change', () => {
    element('own-panel').hidden = !ownIsOn();
    setDrawing(false);
    if (ownIsOn() && ownPoints.length === 0) {
      setOwnPoints([[0.1, 0.45], [0.35, 0.9], [0.65, 1.1]]);
    } else {
      ownChanged();
    }
  });
  element('draw').addEventListener('click', () => {
    setDrawing(!isDrawing());
    if (!isDrawing()) updateOwn();
  });
  listenToStrokes();
  element('more').addEventListener('click', () => {
    const [x, z] = ownPoints[ownPoints.length - 1] ?? [0, 0];
    setOwnPoints([...ownPoints, [(x + 1) / 2, (z + 1) / 2]]);
  });
  element('fewer').addEventListener('click', () =>
    setOwnPoints(ownPoints.slice(0, -1)));
  element('straight').addEventListener('click', () =>
    setOwnPoints(straightPoints(Math.max(2, ownPoints.length))));
  element('copy-optimum').addEventListener('click', () => {
    if (answer) setOwnPoints(pointsOfAnswer(Math.max(12, ownPoints.length)));
  });
  element('play').addEventListener('click', () => setPlaying(!clock.playing));
  element('time').addEventListener('input', (event) => {
    setPlaying(false);
    clock.time = Number(event.target.value);
  });
  element('copy').addEventListener('click', async () => {
    const text = element('problem');
    getSelection().selectAllChildren(text);
    await navigator.clipboard?.writeText(text.textContent).catch(() => {});
  });
  stillness.addEventListener('change', () => setPlaying(!stillness.matches));
  addEventListener('resize', requestDraw);
}

/** Embedded in the page, or beside it on a server. */
async function moduleBytes() {
  const embedded = element('module');
  if (!embedded) return (await fetch('playground.wasm')).arrayBuffer();
  const packed = Uint8Array.from(atob(embedded.textContent),
    (letter) => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(
    new DecompressionStream('gzip'))).arrayBuffer();
}

async function begin() {
  listen();
  showControls();
  try {
    solver = await Solver.load(await moduleBytes());
  } catch (problem) {
    showAnswer(`the solver does not run in this browser (${problem.message})`);
    return;
  }
  setPlaying(!stillness.matches);
  changed();
}

begin();
