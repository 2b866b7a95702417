// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

'use strict';

/** The module of src/playground: scenes in, numbers and tables out. */
class Solver {
  /** The columns of a sampled path. */
  static ROW = ['t', 'x', 'z', 'theta', 'beta', 'trackX', 'trackZ'];

  /** @param {BufferSource} bytes  of playground.wasm */
  static async load(bytes) {
    let memory;
    const seconds = {
      // Of the imports that the C library asks for only its clock has to work.
      clock_time_get: (clock, precision, result) => {
        const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
        new DataView(memory.buffer).setBigUint64(result, nanoseconds, true);
        return 0;
      },
    };
    const compiled = await WebAssembly.compile(bytes);
    const imports = {};
    for (const {module, name} of WebAssembly.Module.imports(compiled)) {
      imports[module] ??= {};
      imports[module][name] = seconds[name] ?? (() => 0);
    }
    const instance = await WebAssembly.instantiate(compiled, imports);
    memory = instance.exports.memory;
    instance.exports._initialize?.();
    return new Solver(instance.exports);
  }

  constructor(exports) {
    this.module = exports;
  }

  /** What the last call that failed says. */
  get text() {
    const bytes = new Uint8Array(this.module.memory.buffer, this.module.text());
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** @returns {boolean} false if the scene is refused; see text */
  setScene({radius, eta, theta, k, L, H, friction = 0, drag = 0}) {
    return this.module.set_scene(radius, eta, theta, k, L, H, friction, drag) === 0;
  }

  /**
   * The extremal of the scene.
   * @param {boolean} nearby  from the one found last; else from the cycloid
   * @returns its numbers, or null; see text
   */
  solve(nearby, tolerance, seconds) {
    if (this.module.solve(nearby ? 1 : 0, tolerance, seconds) !== 0) return null;
    const [tau, time, phi, startAngle, length, rotation, residual, error, steps,
      arcs, legendre, folds] = this.numbers(12);
    return {tau, time, phi, startAngle, length, rotation, residual, error,
      steps, arcs, legendre, folds};
  }

  /**
   * The body of the scene on a track of one's own.
   * @param {[number, number][]} points  from A to B
   * @returns its numbers, or null; see text
   */
  ride(points) {
    const at = this.module.table(2 * points.length);
    new Float64Array(this.module.memory.buffer, at).set(points.flat());
    if (this.module.ride(points.length) !== 0) return null;
    const [tau, time, error, leastForce, leastForceX, foldMargin, grip] =
      this.numbers(7);
    return {tau, time, error, leastForce, leastForceX, foldMargin, grip};
  }

  sampleExtremal(rows) {
    return this.rowsAt(this.module.sample_extremal(rows), rows);
  }

  sampleRide(rows) {
    return this.rowsAt(this.module.sample_ride(rows), rows);
  }

  numbers(count) {
    return new Float64Array(this.module.memory.buffer, this.module.numbers(),
      count);
  }

  rowsAt(place, rows) {
    const width = Solver.ROW.length;
    const all = new Float64Array(this.module.memory.buffer, place, rows * width);
    return Array.from({length: rows}, (_, i) => Object.fromEntries(
      Solver.ROW.map((name, j) => [name, all[i * width + j]])));
  }
}
