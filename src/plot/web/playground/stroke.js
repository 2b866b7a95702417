// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

'use strict';

/**
 * Points of a track that was drawn in one stroke: between A at the origin and
 * B, at equal distances along the stroke. Each is the mean of what was drawn
 * around it, so that a hand that shakes draws a smooth track.
 * @param {[number, number][]} stroke  where the pointer was, from A to B or back
 * @param {[number, number]} end  B
 * @param {number} count  how many points
 * @returns null where the stroke is hardly longer than a click
 */
function pointsOfStroke(stroke, end, count) {
  const LEAST = 0.1;   // length of a stroke, of the distance from A to B
  const SAMPLES = 32;  // of each mean
  const start = [0, 0];
  const distance = ([x, z], [X, Z]) => Math.hypot(X - x, Z - z);
  const [first, last] = [stroke[0], stroke[stroke.length - 1]];
  const backwards = distance(start, first) + distance(last, end) >
    distance(start, last) + distance(first, end);
  const places = [start, ...(backwards ? [...stroke].reverse() : stroke), end];

  const along = [0];  // how far it is from A to each place
  for (let i = 1; i < places.length; ++i) {
    along.push(along[i - 1] + distance(places[i - 1], places[i]));
  }
  if (along[stroke.length] - along[1] < LEAST * distance(start, end)) return null;
  const spacing = along[along.length - 1] / (count + 1);
  let i = 1;  // of the place that comes next
  const at = (s) => {  // for s that grow
    while (i < places.length - 1 && along[i] <= s) ++i;
    const share = (s - along[i - 1]) / (along[i] - along[i - 1]);
    return places[i].map((b, j) => (1 - share) * places[i - 1][j] + share * b);
  };
  return Array.from({length: count}, (_, point) => {
    const sum = [0, 0];
    for (let k = 0; k < SAMPLES; ++k) {
      const [x, z] = at(spacing * (point + 0.5 + (k + 0.5) / SAMPLES));
      sum[0] += x;
      sum[1] += z;
    }
    return sum.map((part) => part / SAMPLES);
  });
}
