# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Sentences of the documents with numbers of the program.

A template has {EXPRESSION:FORMAT} for every number; names stand for answers.
"""

import re

from blocks import LIMITED, limited_scene, minus

# Names of answers in templates.
ANSWERS = {
    "reference": "paper/fig04_reference_case.yaml",
    "uniform": "paper/fig06_uniform_cylinder.yaml",
    "bead": "paper/fig06_bead.yaml",
    "coaster": "limits/coaster.yaml",
    "K2": limited_scene("reference", "optimal", LIMITED[10][4]),
    "K4": limited_scene("reference", "optimal", LIMITED[11][4]),
    "uniform_K2": limited_scene("uniform", "optimal", LIMITED[12][4]),
    "half_arch": "paper/check_uniform_half_arch.yaml",
}
RATES = {"rates": "paper/fig04_reference_case.yaml"}

SENTENCES = {
    "README.md": [
        "τ = {reference.tau:.4f}. brachisto computes this one",
        "τ = {coaster.tau:.4f}. With bounds on curvature and load",
    ],
    "docs/theory.md": [
        "where the answer is $\\tau={reference.tau:.4f}$, following",
        "closed form $\\tau={uniform.tau:.4f}$ to",
        "$d\\tau/d\\eta={rates.sensitivities.eta_m.tau:.4f}$, and "
        "${rates.sensitivities.eta_m.tau_at_fixed_contacts:.4f}$ at fixed contacts",
        "With both bounds $\\tau={K2.tau:.4f}$ at $K_h=K_v=2$ and ${K4.tau:.4f}$ at",
        "instead of ${uniform_K2.tau:.5f}$",
    ],
    "docs/validation.md": [
        "({half_arch.transit_time:.12f} s); found",
        "has τ = {coaster.tau:.12f}, R_n ≥ 0.2",
    ],
}
HOLE = re.compile(r"\{([\w.]+):(\.\d+f)\}")


def answer(name, program):
    if name in RATES:
        return program.solve(RATES[name], "--set", "solver.sensitivities=true")
    return program.solve(ANSWERS[name])


def filled(template, program):
    def number(match):
        name, *keys = match.group(1).split(".")
        found = answer(name, program)
        for key in keys:
            found = found[key]
        return minus(format(found, match.group(2)))
    return HOLE.sub(number, template)


def places(template, text):
    """Where a page says this with whatever numbers; a line may end anywhere."""
    pattern = r"[−-]?\d+\.\d+".join(re.escape(part) for part in HOLE.split(template)[::3])
    return [" ".join(found.split())
            for found in re.findall(pattern.replace(r"\ ", r"\s+"), text)]
