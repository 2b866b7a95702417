// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/**
 * How many answers a second there are as somebody drags a slider, for each of
 * them. It refers to nothing outside, so that a page can be given its text.
 * @param {() => number} seconds  a clock
 * @returns {[string, number, number][]} the slider, answers a second, and how
 *     many had to begin at the cycloid
 */
export function answersASecond(solver, seconds) {
  const STEPS = 120;
  const TOLERANCE = 1e-10;
  const PATIENCE = 60;  // [s]
  const base = {radius: 1 / 3, eta: 2 / 3, theta: 0, k: 1 / 2, L: 3, H: 1};
  const drags = {
    eta: [0.3, 0.67], theta: [-1, 1], k: [0.1, 0.55], radius: [0.2, 0.5],
    L: [2, 4], H: [0.7, 1.5],
  };
  return Object.entries(drags).map(([key, [from, to]]) => {
    let answers = 0;
    let fallbacks = 0;
    let spent = 0;
    for (let i = 0; i <= STEPS; ++i) {
      solver.setScene({...base, [key]: from + (to - from) * i / STEPS});
      const start = seconds();
      let found = i > 0 && solver.solve(true, TOLERANCE, PATIENCE);
      if (i > 0 && !found) ++fallbacks;
      found ||= solver.solve(false, TOLERANCE, PATIENCE);
      solver.sampleExtremal(241);
      if (i === 0) continue;  // nothing was there to go on from
      spent += seconds() - start;
      answers += found ? 1 : 0;
    }
    return [key, answers / spent, fallbacks];
  });
}
