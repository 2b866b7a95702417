#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The paper's discrete system, eqs. (13)-(19), solved by scipy.optimize.fsolve
(MINPACK's hybrd) from the cycloid; one line of JSON.

Quadrature: the time of a chord of length l is 2 l / (v + v') with the speeds at its
ends. Lengths are in H, times in sqrt(H / 2g), so that T is tau.
"""
import argparse
import json
import math
import os
import resource
import sys
import time

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
import scipy
from scipy.optimize import brentq, fsolve


class TimeLimit(Exception):
    pass


class DiscreteSystem:
    """The 2n + 1 equations for u = (x_1 ... x_n, z_1 ... z_n, S)."""

    def __init__(self, o):
        self.o = o
        self.n = o.n
        self.r = o.r / o.H
        self.L = o.L / o.H
        self.calls = 0
        self.deadline = time.process_time() + o.seconds
        # Each row of the perturbed paths has one inner node moved.
        self.moved = o.epsilon * np.eye(o.n)[1:-1]

    def transit(self, x, z):
        """T of the paths (x, z[i]), all at once."""
        o = self.o
        dx, dz = np.diff(x), np.diff(z)
        l = np.hypot(dx, dz)
        theta = np.full(z.shape, o.theta)
        theta[..., 1:] += np.cumsum(l, axis=-1) / self.r
        E = z + self.r * o.eta * (np.sin(theta) - math.sin(o.theta))
        if o.datum == "release":
            E = E - z[..., :1]
        if o.datum != "printed":
            E[..., 0] = 0.0

        # A has sin(theta - beta) of the chord on either side of a node.
        sine, cosine = np.sin(theta), np.cos(theta)
        c, s = dx / l, dz / l

        def speed(node):
            A = 1 + o.eta**2 + o.k - 2 * o.eta * (sine[..., node] * c - cosine[..., node] * s)
            return np.sqrt(E[..., node] / A)

        return np.sum(2 * l / (speed(slice(None, -1)) + speed(slice(1, None))), axis=-1)

    def slope(self, dx, dz):
        if self.o.slopes == "smooth":
            return dz / math.hypot(dx, dz), dx / math.hypot(dx, dz)
        t = dz / dx
        return t / math.sqrt(1 + t * t), 1 / math.sqrt(1 + t * t)

    def __call__(self, u):
        self.calls += 1
        if time.process_time() > self.deadline:
            raise TimeLimit(f"stopped after {self.o.seconds:g} s")
        n = self.n
        x, z, S = u[:n], u[n:-1], u[-1]
        s_A, c_A = self.slope(x[1] - x[0], z[1] - z[0])
        s_B, c_B = self.slope(x[-1] - x[-2], z[-1] - z[-2])
        dT = self.transit(x, z + self.moved) - self.transit(x, z - self.moved)
        return np.concatenate([
            [x[0] - self.r * s_A],
            np.hypot(np.diff(x), np.diff(z)) - S / (n - 1),
            [z[0] + self.r * c_A],
            dT / (2 * self.o.epsilon),
            [z[-1] + self.r * c_B - 1],
            [x[-1] - self.r * s_B - self.L],
        ])

    def cycloid(self):
        """The centre of the uniform cylinder, x = r + a (p - sin p),
        z = a (1 - cos p), whose slope at the end is that of the track at B."""
        def radius(p):
            return (1 - self.r * math.sin(p / 2)) / (1 - math.cos(p))

        def reach(p):
            return radius(p) * (p - math.sin(p)) - (self.L - self.r + self.r * math.cos(p / 2))

        grid = np.linspace(0.05, 2 * math.pi - 0.05, 400)
        for low, high in zip(grid, grid[1:]):
            if reach(low) * reach(high) <= 0:
                break
        else:
            raise ValueError("no cycloid")
        p = brentq(reach, low, high)
        a = radius(p)
        S = 4 * a * (1 - math.cos(p / 2))
        q = 2 * np.arccos(1 - np.linspace(0, S, self.n) / (4 * a))
        return np.concatenate([self.r + a * (q - np.sin(q)), a * (1 - np.cos(q)), [S]])


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--n", type=int, default=100)
    parser.add_argument("--datum", choices=["release", "rest", "printed"], default="release")
    parser.add_argument("--slopes", choices=["literal", "smooth"], default="literal")
    parser.add_argument("--epsilon", type=float, default=1e-3)
    parser.add_argument("--xtol", type=float, default=1.49012e-8, help="as fsolve has it")
    parser.add_argument("--seconds", type=float, default=600, help="of processor time")
    for name, value in dict(L=3.0, H=1.0, r=1 / 3, eta=2 / 3, theta=0.0, k=0.5).items():
        parser.add_argument("--" + name, type=float, default=value)
    return parser.parse_args()


def main():
    o = arguments()
    system = DiscreteSystem(o)
    result = dict(program="scipy", version=scipy.__version__, numpy=np.__version__,
                  python=sys.version.split()[0], n=o.n, datum=o.datum, slopes=o.slopes,
                  epsilon=o.epsilon, xtol=o.xtol, solved=False, tau=None, message="")
    begin = time.process_time()
    try:
        with np.errstate(all="ignore"):
            start = system.cycloid()
            begin = time.process_time()
            u, info, code, message = fsolve(system, start, full_output=True, xtol=o.xtol)
            residual = float(np.linalg.norm(info["fvec"]))
        result.update(info=code, message=" ".join(message.split()), residual=residual,
                      S=u[-1] * o.H, solved=residual <= 1e-6)
        if result["solved"]:
            result["tau"] = float(system.transit(u[:o.n], u[o.n:-1]))
    except (TimeLimit, ValueError) as problem:
        result["message"] = str(problem)
    result.update(seconds_cpu=time.process_time() - begin, calls=system.calls,
                  peak_kb=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    # NaN is no JSON.
    result = {key: None if isinstance(value, float) and math.isnan(value) else value
              for key, value in result.items()}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
