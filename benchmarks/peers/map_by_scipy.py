#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The map over eta_m and theta_m by SciPy's solve_bvp, for comparison.

    brachisto sweep problems/sweeps/map_eta_theta.yaml --set solver.method=auto --out map
    brachisto export map --csv | /usr/bin/python3 map_by_scipy.py [EVERY]

Takes every EVERY-th row of the table (default 50), solves the same boundary-value problem from the
same cycloid, tells the processor time of a scene and the largest difference of T. The formulas are
those of docs/theory.md: dT = sqrt(A) du, and the slope angle beta minimises the Hamiltonian.
"""

import csv
import sys
import time

import numpy
from scipy.integrate import solve_bvp
from scipy.optimize import brentq

GRAVITY, RADIUS, K, LENGTH, HEIGHT = 9.81, 1.0 / 3.0, 0.5, 3.0, 1.0
OFFSETS = 8  # equal steps from the cycloid
TOLERANCE = 1e-9


def inertia(eta, theta, beta):
    return 1.0 + eta * eta + K - 2.0 * eta * numpy.sin(theta - beta)


def start_angle(eta, theta):
    def stationary(beta):
        rise = numpy.sin(beta) + eta * numpy.cos(theta)
        return (inertia(eta, theta, beta) * numpy.cos(beta)
                - rise * eta * numpy.cos(theta - beta))
    margin = numpy.arcsin(eta * numpy.cos(theta))
    return brentq(stationary, -margin, numpy.pi + margin, xtol=1e-15)


def control(eta, y, p):
    """The slope angle by Newton's method, from that of a body without offset."""
    theta, w, p_w = y[2], y[3], y[5]
    across, down = p[0] * w, p[1] * w + p_w * GRAVITY
    beta = numpy.arctan2(-down, -across)
    for _ in range(30):
        sine, cosine = numpy.sin(theta - beta), numpy.cos(theta - beta)
        root = numpy.sqrt(inertia(eta, theta, beta))
        first = eta * cosine / root - across * numpy.sin(beta) + down * numpy.cos(beta)
        second = (eta * sine / root - (eta * cosine) ** 2 / root ** 3
                  - across * numpy.cos(beta) - down * numpy.sin(beta))
        step = first / second
        beta = beta - step
        if numpy.max(numpy.abs(step)) < 1e-12:
            break
    return beta


def rates(eta):
    def of(_, y, p):
        theta, w, p_w = y[2], y[3], y[5]
        beta = control(eta, y, p)
        root = numpy.sqrt(inertia(eta, theta, beta))
        cosine, sine = numpy.cos(beta), numpy.sin(beta)
        by_theta = (-eta * numpy.cos(theta - beta) / root
                    - p_w * GRAVITY * eta * numpy.sin(theta))
        by_w = p[0] * cosine + p[1] * sine + y[4] / RADIUS
        return p[2] * numpy.vstack((
            w * cosine, w * sine, w / RADIUS, GRAVITY * (sine + eta * numpy.cos(theta)),
            -by_theta, -by_w, root))
    return of


def ends(eta, theta_m):
    beta = start_angle(eta, theta_m)
    root = numpy.sqrt(inertia(eta, theta_m, beta))
    p_w = -root / (GRAVITY * (numpy.sin(beta) + eta * numpy.cos(theta_m)))
    x, z = RADIUS * numpy.sin(beta), -RADIUS * numpy.cos(beta)

    def of(a, b, p):
        phi = control(eta, b[:, None], p)[0]
        return numpy.array((
            a[0] - x, a[1] - z, a[2] - theta_m, a[3], a[5] - p_w, a[6],
            b[0] - LENGTH - RADIUS * numpy.sin(phi), b[1] - HEIGHT + RADIUS * numpy.cos(phi),
            b[4], b[5]))
    return of


def cycloid(theta_m):
    """Of a body without offset: its centre goes from below A to B, touching both tracks."""
    def missed(phi):
        # x = a (q - sin q), z = a (1 - cos q) from (r, 0); beta = (pi - q)/2.
        q = numpy.pi - 2.0 * phi
        width = LENGTH + RADIUS * numpy.sin(phi) - RADIUS
        drop = HEIGHT - RADIUS * numpy.cos(phi)
        return (q - numpy.sin(q)) * drop - (1.0 - numpy.cos(q)) * width
    phi = brentq(missed, -1.2, 1.2)
    q = numpy.linspace(0.0, numpy.pi - 2.0 * phi, 33)
    a = (HEIGHT - RADIUS * numpy.cos(phi)) / (1.0 - numpy.cos(q[-1]))
    root = numpy.sqrt(1.0 + K)
    # w = 2 sqrt(a g) sin(q/2) and du = sqrt(a/g) dq.
    u = numpy.sqrt(a / GRAVITY) * q
    w = 2.0 * numpy.sqrt(a * GRAVITY) * numpy.sin(q / 2.0)
    s = 4.0 * a * (1.0 - numpy.cos(q / 2.0))
    # H = 0 along the path: p_x = -sqrt(1 + k)/(2 sqrt(a g)), p_z = p_x tan(phi).
    p_x = -root / (2.0 * numpy.sqrt(a * GRAVITY))
    p_z = p_x * numpy.tan(phi)
    beta = (numpy.pi - q) / 2.0
    p_w = (-root * numpy.sin(beta) - p_z * w) / GRAVITY
    y = numpy.vstack((RADIUS + a * (q - numpy.sin(q)), a * (1.0 - numpy.cos(q)),
                      theta_m + s / RADIUS, w, 0.0 * q, p_w, root * u))
    return u / u[-1], y, numpy.array((p_x, p_z, u[-1]))


def solve(eta_m, theta_m):
    mesh, y, p = cycloid(theta_m)
    for step in range(1, OFFSETS + 1):
        eta = eta_m * step / OFFSETS
        last = step == OFFSETS
        found = solve_bvp(rates(eta), ends(eta, theta_m), mesh, y, p,
                          tol=TOLERANCE if last else 1e-3, max_nodes=20000)
        if not found.success:
            return None
        mesh, y, p = found.x, found.y, found.p
    return y[6, -1]


def main():
    every = int(sys.argv[1]) if len(sys.argv) > 1 else 50
    rows = list(csv.DictReader(sys.stdin))[::every]
    worst, failed = 0.0, 0
    begin = time.process_time()
    for row in rows:
        T = solve(float(row["scene.body.eta_m"]), float(row["scene.body.theta_m"]))
        if T is None:
            failed += 1
            continue
        worst = max(worst, abs(T / float(row["transit_time"]) - 1.0))
    seconds = time.process_time() - begin
    print(f"{len(rows)} scenes, {failed} without an answer, {1e3 * seconds / len(rows):.3g} ms each, "
          f"T differs relatively by at most {worst:.2g}")


if __name__ == "__main__":
    main()
