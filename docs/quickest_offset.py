# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Where the centre of mass has to be for the quickest body of a given inertia.

A script in cells, for editors that run them one by one. `brachisto design` does the same
with bounds, feasibility and several starts.
"""

# %% The body: nearly all of its mass near its centre of mass, k = 0.1.
import numpy as np

import brachisto

scene = brachisto.Scene(
    body={"shape": "cylinder", "radius": "1/3", "eta_m": 0.5, "theta_m": "-20 deg", "k": 0.1},
    finish={"L": 3, "H": 1},
)


# %% τ with its gradient and second derivatives by η_m and θ_m, the contacts moving along.
def expansion(eta_m, theta_m, near=None):
    here = scene.changed(body={"eta_m": eta_m, "theta_m": theta_m})
    result = brachisto.solve(here, solver={"sensitivities": "second"}, near=near)
    assert result.verified, result.message
    slopes = result.sensitivities
    gradient = np.array([slopes.eta_m.tau, slopes.theta_m.tau])
    return result, gradient, np.array(slopes.second)[:2, :2]


# %% Newton's method: each body begins with the track of the one before.
offset = np.array([0.5, np.radians(-20)])
result = None
while True:
    result, gradient, hessian = expansion(*offset, near=result)
    print(f"η_m = {offset[0]:.9f}  θ_m = {offset[1]:+.9f}  τ = {result.tau:.10f}  "
          f"|∇τ| = {np.linalg.norm(gradient):.0e}")
    if np.linalg.norm(gradient) < 1e-8:
        break
    offset = offset - np.linalg.solve(hessian, gradient)
    assert np.all(np.linalg.eigvalsh(hessian) > 0), "no minimum near here"

# %% What `brachisto design` finds (docs/validation.md).
assert abs(result.tau - 4.258368999) < 1e-9, result.tau
assert result.feasible

# %% Its track against that of the body with the mass on the axis.
uniform = brachisto.solve(scene.changed(body={"eta_m": 0}))
gain = 1 - result.transit_time / uniform.transit_time
path = result.trajectory
print(f"{gain:.1%} quicker than on the axis; the track goes down to z = {path['z_b'].max():.3f} m")
