# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The command `brachisto`, beside which the module is held; and reference values."""

import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROBLEMS = ROOT / "problems"


def run(*arguments, text=None):
    """Standard output of the command, whatever its exit code."""
    return subprocess.run(
        [os.environ["BRACHISTO_APP"], *map(str, arguments)],
        input=text, capture_output=True, encoding="utf-8", check=False,
    ).stdout


def without_times(document):
    """A result's document as text, every digit of it but what a clock has shown."""
    values = json.loads(document)
    del values["seconds"]
    if values["forecast"]:
        del values["forecast"]["seconds"]
    if values["discrete_system"]:
        del values["discrete_system"]["cpu_seconds"]
    return json.dumps(values, indent=1, ensure_ascii=False)


def reference_rows():
    """Of tests/support/reference_values.hpp: name, keys of the scene, τ."""
    text = (ROOT / "tests/support/reference_values.hpp").read_text(encoding="utf-8")
    rows = re.findall(r'ReferenceValue\{"([^"]+)", Shape::(\w+),([^}]+),\s+Source', text)
    for name, shape, numbers in rows:
        L, r, eta_m, theta_m, k, tau = map(float, numbers.split(",")[:6])
        body = {"shape": shape.lower()}
        if shape != "Bead":
            body |= {"radius": r, "eta_m": eta_m, "theta_m": theta_m, "k": k}
        yield name, {"body": body, "finish": {"L": L, "H": 1.0}}, tau
