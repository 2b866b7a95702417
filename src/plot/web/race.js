// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of a race: bodies that start together, each on its own track, and
// their clocks. What it shares with other pages is in motion.js.
"use strict";

(() => {

const { byId, draw, pathOf } = Motion;
const data = JSON.parse(byId("data").textContent);
const stage = byId("stage");
const racers = data.racers.map((racer, i) => ({
  motion: Motion.motionOf(racer), obstacles: racer.obstacles, clock: byId(`clock-${i}`),
  row: byId(`racer-${i}`), style: [...byId(`racer-${i}`).classList],
}));
const T = Math.max(...racers.map(({ motion }) => motion.T));
const first = Math.min(...racers.map(({ motion }) => motion.T));
const view = {};
document.querySelector(".arrivals").classList.add("guess");

function layOut() {
  const plane = Motion.drawPlane(stage, data.box);
  const { svg, scale, X, Y } = plane;
  Object.assign(view, plane);
  const place = (x, z) => `${X(x).toFixed(2)} ${Y(z).toFixed(2)}`;
  for (const { obstacles } of racers) Motion.drawObstacles(svg, obstacles, plane);
  let lifts = false;
  const together = coincident(2.5 / scale);
  racers.forEach(({ motion, style }, i) => {
    const track = draw("path", { id: `track-${i}`, class: `track ${style.join(" ")}`,
      d: pathOf(motion.poses, "xb", "zb", place) }, svg);
    // Those that run on each other are dashes by turns, so that none hides another.
    const group = together[i], dash = 12;
    if (group.length > 1) {
      track.style.strokeDasharray = `${dash} ${dash * (group.length - 1)}`;
      track.style.strokeDashoffset = -dash * group.indexOf(i);
    }
    const lifted = Motion.liftedPath(motion.poses, place);
    draw("path", { class: "lifted", d: lifted }, svg);
    lifts = lifts || lifted !== "";
  });
  byId("lift-key").hidden = !lifts;
  // The first one's places serve: all tracks have the same ends.
  Motion.markEnds(svg, racers[0].motion.poses, plane);
  // The first one is drawn last, above the others.
  [...racers.keys()].reverse().forEach((i) => {
    const { motion, style } = racers[i];
    racers[i].shape = Motion.bodyShape(svg, scale, `body-${i}`, motion.body);
    racers[i].shape.classList.add(...style);
  });
  // A number beside each body and, where its track keeps away from the others,
  // on the track: colours alone do not tell them apart.
  racers.forEach((racer, i) => {
    const number = (kind) => {
      const text = draw("text", { class: `number ${kind} ${racer.style.join(" ")}` }, svg);
      text.textContent = String(i + 1);
      return text;
    };
    const p = clearestPose(racer);
    const onTrack = number("of-track");
    onTrack.setAttribute("x", X(p.xb));
    onTrack.setAttribute("y", Y(p.zb) + 4);
    racer.number = number("of-body");
  });
}

/** Of each racer those whose tracks are nowhere farther from its own than that
    in metres, itself among them. */
function coincident(close) {
  const near = (a, b) => a.every((p) => b.some((q, i) => {
    const o = b[Math.max(i - 1, 0)];
    const dx = q.xb - o.xb, dz = q.zb - o.zb, length = dx * dx + dz * dz;
    const s = length === 0 ? 0 : ((p.xb - o.xb) * dx + (p.zb - o.zb) * dz) / length;
    const along = Math.min(Math.max(s, 0), 1);
    return Math.hypot(o.xb + along * dx - p.xb, o.zb + along * dz - p.zb) < close;
  }));
  const some = racers.map(({ motion }) => motion.poses.filter((_, i, all) =>
      i % 12 === 0 || i + 1 === all.length));
  return racers.map((_, i) => [...racers.keys()].filter((j) => i === j ||
      (near(some[i], some[j]) && near(some[j], some[i]))));
}

/** Where a track is farthest from all others, of some places. */
function clearestPose(racer) {
  const some = ({ motion }) => motion.poses.filter((_, i) => i % 12 === 0);
  const others = racers.filter((other) => other !== racer).flatMap(some);
  const far = (p) => Math.min(...others.map((o) => Math.hypot(o.xb - p.xb, o.zb - p.zb)));
  let best = racer.motion.poses[0], most = -1;
  for (const p of some(racer)) {
    const distance = far(p);
    if (distance > most) [best, most] = [p, distance];
  }
  return best;
}

function show(t) {
  const { scale, X, Y } = view;
  racers.forEach(({ motion, shape, number, clock, row }, i) => {
    const arrived = t >= motion.T;
    const p = motion.at(Math.min(t, motion.T));
    Motion.moveBody(shape, p, view);
    const above = scale * Motion.outerRadius(motion.body) + 6;
    number.setAttribute("x", X(p.x));
    // Above those of bodies at the same place.
    const there = racers.slice(0, i).filter((other) => Math.hypot(
        Number(other.number.getAttribute("x")) - X(p.x), other.y - (Y(p.z) - above)) < 12);
    racers[i].y = Y(p.z) - above;
    number.setAttribute("y", racers[i].y - 15 * there.length);
    clock.textContent = `${Math.min(t, motion.T).toFixed(data.decimals)} s`;
    row.classList.toggle("arrived", arrived);
  });
  judge(t);
}

/** Whether the guess was right, once one has come first. */
function judge(t) {
  const guesses = [...document.querySelectorAll("input[name=guess]")];
  const over = t >= first;
  for (const guess of guesses) guess.disabled = over;
  const guess = guesses.find((one) => one.checked);
  const right = guess !== undefined && racers[Number(guess.value)].motion.T === first;
  const said = !over || guess === undefined ? "" : right
      ? "You guessed right." : "You guessed another one.";
  if (byId("guessed").textContent !== said) byId("guessed").textContent = said;
}

const player = Motion.player(T, show);
layOut();
Motion.onResize(stage, () => {
  layOut();
  player.again();
});
Motion.letTablesScroll();
player.start(0);

})();
