// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The module of the playground against the command, and how fast it answers:
//
//   node playground_test.mjs PLAYGROUND.wasm WEB BRACHISTO
//
// where WEB is the folder of the page's parts.
//
// Exits with 77 where the module has not been built.

import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from
  'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {answersASecond} from './drags.mjs';

const [wasm, web, brachisto] = process.argv.slice(2);
if (!existsSync(wasm) || !existsSync(brachisto)) process.exit(77);

/** What a script of the page defines. */
const defined = (script, name) =>
  new Function(`${readFileSync(join(web, script))}; return ${name};`)();
const solver = await defined('solver.js', 'Solver').load(readFileSync(wasm));
const pointsOfStroke = defined('stroke.js', 'pointsOfStroke');

// Both ask for at least 1e-10 of T and run the same formulas, compiled
// differently: what is left between them is their error.
const AGREEMENT = 1e-9;
const TOLERANCE = 1e-13;
const SECONDS = 60;

const base = {radius: 1 / 3, eta: 2 / 3, theta: 0, k: 1 / 2, L: 3, H: 1};
const bead = {radius: 0, eta: 0, theta: 0, k: 0, L: 3, H: 1};
const scenes = {
  'reference case': base,
  'uniform cylinder': {...base, eta: 0},
  'mass ahead and up': {...base, theta: -Math.PI / 6},
  'mass on top': {...base, theta: -Math.PI / 2, eta: 0.3},
  'small radius': {...base, radius: 0.1},
  'little inertia': {...base, k: 0.1},
  'near and deep': {...base, L: 2, H: 1.5, radius: 0.25, eta: 0.4, theta: 2},
  'bead': bead,
  'drag': {...base, drag: 0.1},
  'bead that rubs': {...bead, friction: 0.05},
};

function ofCommand({radius, eta, theta, k, L, H, friction = 0, drag = 0}, path = '') {
  const body = radius > 0
    ? `{shape: cylinder, radius: ${radius}, eta_m: ${eta}, theta_m: ${theta}, k: ${k}}`
    : '{shape: bead}';
  const folder = mkdtempSync(join(tmpdir(), 'playground-'));
  const file = join(folder, 'scene.yaml');
  try {
    let scene = `scene:\n  body: ${body}\n  finish: {L: ${L}, H: ${H}}\n` +
      `  air: {quadratic: ${drag}}\n` +
      (friction > 0 ? `  losses: {sliding: ${friction}}\n` : '');
    if (path) {
      writeFileSync(join(folder, 'track.csv'), path);
      scene += '  path: {curve: track, shape: points, file: track.csv}\n';
    } else {
      scene += 'solver: {method: extremal}\n';
    }
    writeFileSync(file, scene);
    const json = execFileSync(brachisto, ['solve', file, '--json'],
      {stdio: ['ignore', 'pipe', 'ignore']});
    return JSON.parse(json).tau;
  } catch (failure) {
    // Verified, but physically infeasible, is an answer as well.
    if (failure.status !== 5) throw failure;
    return JSON.parse(failure.stdout).tau;
  } finally {
    rmSync(folder, {recursive: true});
  }
}

let failures = 0;
function expectClose(what, ours, theirs) {
  const difference = Math.abs(ours / theirs - 1);
  const close = difference <= AGREEMENT;
  failures += close ? 0 : 1;
  console.log(`${close ? 'ok  ' : 'FAIL'} ${what.padEnd(28)} ` +
    `${ours.toPrecision(15)} ${theirs.toPrecision(15)} ` +
    difference.toExponential(1));
}
function expect(what, holds) {
  failures += holds ? 0 : 1;
  console.log(`${holds ? 'ok  ' : 'FAIL'} ${what}`);
}

console.log('     scene                        module          command');
for (const [name, scene] of Object.entries(scenes)) {
  const tau = ofCommand(scene);
  const accepted = solver.setScene(scene);
  const fromCycloid = accepted && solver.solve(false, TOLERANCE, SECONDS);
  const again = fromCycloid && solver.solve(true, TOLERANCE, SECONDS);
  expectClose(name, fromCycloid ? fromCycloid.tau : NaN, tau);
  expectClose('  from itself', again ? again.tau : NaN, tau);
}

// A track of one's own, evaluated by both.
const track = [[0, 0], [0.2, 0.4], [0.9, 0.9], [1.9, 1.15], [3, 1]];
for (const [name, scene] of [['own track', base], ['own track, bead', bead]]) {
  const csv = `x,z\n${track.map((point) => point.join(',')).join('\n')}\n`;
  solver.setScene(scene);
  expectClose(name, solver.ride(track)?.tau ?? NaN, ofCommand(scene, csv));
}

// A track drawn in one stroke. Straight down to B a cylinder with its mass on the
// axis accelerates by g sin α / (1 + k): τ = 2 √(1 + k) √(L² + H²) / H.
const STROKE_POINTS = 10;
const uniform = {...base, eta: 0};
const {L, H, k} = uniform;
const timeOn = (stroke) => {
  const points = pointsOfStroke(stroke, [L, H], STROKE_POINTS);
  return solver.ride([[0, 0], ...points, [L, H]])?.tau ?? NaN;
};
const straight = Array.from({length: 7}, (_, i) => [L * (i / 6) ** 2, H * (i / 6) ** 2]);
const straightTau = 2 * Math.sqrt(1 + k) * Math.hypot(L, H) / H;
solver.setScene(uniform);
expectClose('drawn straight', timeOn(straight), straightTau);
expectClose('  from B to A', timeOn([...straight].reverse()), straightTau);
expectClose('  not as far as A and B', timeOn(straight.slice(1, -1)), straightTau);
// Friction turns it: R_t = k/(1 + k) m g sin α. A bead it brakes by μ m g cos α.
const slope = H / L, rubbing = 0.05;
const straightPoints = [[0, 0], [L / 2, H / 2], [L, H]];
expectClose('  grip that it takes', solver.ride(straightPoints)?.grip ?? NaN,
  k / (1 + k) * slope);
solver.setScene({...bead, friction: rubbing});
expectClose('  of a bead that rubs', solver.ride(straightPoints)?.tau ?? NaN,
  straightTau / Math.sqrt((1 + k) * (1 - rubbing / slope)));
expect('a click is no track',
  pointsOfStroke([[1, 1], [1.01, 1]], [L, H], STROKE_POINTS) === null);

// By a hand that shakes by δ = 1 cm, along the cycloid, which no track of a bead
// beats. As T is stationary there, slopes that are off by δ over the distance of
// the points, 0.3 m, cost some 10⁻³ of it, and that there are no more points as much.
const cycloid = (phi) => [phi - Math.sin(phi), 1 - Math.cos(phi)];
let [low, high] = [Math.PI / 2, 2 * Math.PI];  // of φ at B
while (high - low > 1e-14) {
  const middle = (low + high) / 2;
  const [x, z] = cycloid(middle);
  if (x / z < L / H) low = middle; else high = middle;
}
const size = H / cycloid(low)[1];
let seed = 1;
const shaken = (part) => {
  seed = seed * 16807 % 2147483647;  // minimal standard, Park and Miller
  return size * part + 0.01 * (2 * seed / 2147483647 - 1);
};
solver.setScene(bead);
const excess = timeOn(Array.from({length: 80}, (_, i) =>
  cycloid(low * (i + 0.5) / 80).map(shaken))) / (low * Math.sqrt(2 * size / H)) - 1;
expect(`drawn along the cycloid: ${(100 * excess).toFixed(2)} % slower`,
  excess > 0 && excess < 0.01);

// What cannot be: said, and the module goes on.
expect('k above 1 - eta^2 is refused', !solver.setScene({...base, k: 0.9}) &&
  solver.text.includes('scene.body.k'));
solver.setScene(bead);
expect('a track over a hill is none',
  solver.ride([[0, 0], [1, 0.6], [2, -0.3], [3, 1]]) === null &&
  solver.text.includes('stalls'));
expect('equal points are refused',
  solver.ride([[0, 0], [1, 1], [1, 1], [3, 1]]) === null &&
  solver.text.length > 0);
solver.setScene(base);
expect('time runs out', solver.solve(false, TOLERANCE, 1e-4) === null);

for (const [key, rate, fallbacks] of answersASecond(solver, () => {
  const {user, system} = process.cpuUsage();
  return (user + system) / 1e6;
})) {
  console.log(`     dragging ${key.padEnd(7)} ${rate.toFixed(0)
  } answers a second, ${fallbacks} from the cycloid`);
}
process.exit(failures === 0 ? 0 : 1);
