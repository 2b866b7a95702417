#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The schemas of `brachisto schema`, by a validator that is not ours.

    schema.py BRACHISTO PROBLEMS

Every problem file conforms, its echo does, a result does, and what the program
refuses for a key, a type, a word or a bound of one value does not. Echoes and
results, whole, are read again and mean the same.
"""

import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"{missing}; apt install python3-jsonschema python3-yaml")
    sys.exit(77)

GOOD = """
version: 1
scene:
  body: {shape: cylinder, radius: 1/3, eta_m: 2/3, theta_m: -30 deg, k: 1/2}
  finish: {L: 3, H: 1}
discretisation: {tolerance: 1e-10}
solver: {method: ipopt, polish: true, limits: {iterations: 500, seconds: 60}}
"""

# What may stand in place of its line with the finish.
LIMITED = """  finish: {L: 3, H: 1}
  contact: {end_slope: -10 deg}
  limits:
    friction: 1/2
    normal_force: {min: 0, max: 5}
    curvature: {hump: 2, valley: 2, of: centre}
    fold_margin: 0.1
    floor: 1.5
    clear_of: [{disc: {x: 1, z: 1.3, radius: 0.2}}, {half_plane: {x: 3.7, z: 0, normal: pi}}]
"""

# Each changes one thing of GOOD.
BROKEN = [
    ("k: 1/2", "kk: 1/2"), (", k: 1/2", ""), ("k: 1/2", "k: [1]"), ("k: 1/2", "k: 1/2 m"),
    ("k: 1/2", "k: 1.5"), ("k: 1/2", "k: half"), ("radius: 1/3", "radius: 0"),
    ("radius: 1/3, ", ""), ("eta_m: 2/3", "eta_m: 1"), ("eta_m: 2/3", "eta_m: true"),
    ("-30 deg", "-30 degrees"), ("cylinder", "cilinder"), ("shape: cylinder", "shape: bead"),
    ("shape: cylinder, ", ""), ("L: 3", "L: -3"), ("L: 3, ", ""), ("H: 1", "H: 1, W: 2"),
    ("  finish: {L: 3, H: 1}\n", ""), ("scene:", "szene:"), ("version: 1", "version: 2"),
    ("tolerance: 1e-10", "tolerance: 0.5"), ("tolerance: 1e-10", "degree: 9"),
    ("tolerance: 1e-10", "degree: 2.5"), ("tolerance: 1e-10", "formulation: arc"),
    ("ipopt", "ipot"), ("polish: true", "polish: 1"), ("polish: true", "guess: strait"),
    ("polish: true", "fsolve: {epsilon: 1}"), ("polish: true", "seed: -1"),
    ("iterations: 500", "iterations: 0"), ("seconds: 60", "seconds: 0"), ("limits", "limit"),
    ("solver:", "constraints: {}\nsolver:"), ("solver:", "work_precision: {meshes: []}\nsolver:"),
    ("solver:", "work_precision: {methods: [newton]}\nsolver:"),
    ("solver:", "work_precision: {methods: [{rolling_time: [9]}]}\nsolver:"),
    ("solver:", "sweep: {scene.body.eta: [0]}\nsolver:"),
    ("solver:", "sweep: {scene.body.eta_m: {from: 0, to: 1}}\nsolver:"),
    ("solver:", "sweep: {scene.body.eta_m: [0, x]}\nsolver:"),
    ("solver:", "sweep: {solver.method: [ipopt, none]}\nsolver:"),
    ("solver:", "sweep: {zip: [scene.body.k]}\nsolver:"),
    ("solver:", "sweep: {random: {ranges: {scene.body.k: {from: 0, to: 1}}}}\nsolver:"),
    ("  finish", "  path: {curve: track}\n  finish"),
    ("  finish", "  path: {shape: points, points: [[0, 0, 0]]}\n  finish"),
    ("  finish", "  contact: best\n  finish"), ("  finish", "  contact: {}\n  finish"),
    ("  finish", "  contact: {slope: 1}\n  finish"),
]
BROKEN_LIMITS = [
    ("-10 deg", "4"), ("-10 deg", "down"), ("friction", "frction"), ("friction: 1/2", "friction: 0"),
    ("friction: 1/2", "friction: [1]"), ("max: 5", "max: 0"), ("hump: 2", "hump: -1"),
    ("centre}", "body}"), ("0.1", "1"), ("1.5", "low"), ("0.2", "0"),
    ("radius: 0.2", "r: 0.2"), (", radius: 0.2", ""), ("disc", "disk"), ("pi}", "up}"), ("[{disc: {x: 1, z: 1.3, radius: 0.2}}, ", "[3, "),
]


def main():
    brachisto, problems = sys.argv[1:]
    failures = []

    def run(*arguments, text=None):
        return subprocess.run([brachisto, *arguments], input=text, capture_output=True,
                              encoding="utf-8", check=False)

    def validator(kind):
        schema = json.loads(run("schema", kind).stdout)
        jsonschema.Draft7Validator.check_schema(schema)
        return jsonschema.Draft7Validator(schema)

    def expect(good, check, document, what):
        errors = [f"{'.'.join(map(str, e.path))}: {e.message}" for e in check.iter_errors(document)]
        if good and errors:
            failures.append(f"{what}: {errors[0]}")
        if not good and not errors:
            failures.append(f"{what}: conforms")

    def echo_of(validated):
        """The input of what `validate --json` says: without what it says of it."""
        echo = json.loads(validated)
        echo = echo.get("input", echo)
        return {key: value for key, value in echo.items()
                if key not in ("schema_version", "valid", "forecast")}

    problem, result = validator("problem"), validator("result")
    files = sorted(pathlib.Path(problems).rglob("*.yaml"))
    for path in files:
        validated = run("validate", str(path), "--json")
        if validated.returncode == 3:  # scenes that are there to be refused
            continue
        expect(True, problem, yaml.safe_load(path.read_text(encoding="utf-8")), path)
        again = run("validate", "-", "--json", text=validated.stdout)
        echo = echo_of(validated.stdout)
        if echo_of(again.stdout) != echo:
            failures.append(f"echo of {path}: read again it is another one")
        expect(True, problem, echo, f"echo of {path}")
    expect(True, problem, yaml.safe_load(GOOD), "the good one")
    limited = GOOD.replace("  finish: {L: 3, H: 1}\n", LIMITED)
    expect(True, problem, yaml.safe_load(limited), "the good one with limits")
    validated = run("validate", "-", "--json", text=limited).stdout
    expect(True, problem, echo_of(validated), "echo of limits")
    if echo_of(run("validate", "-", "--json", text=validated).stdout) != echo_of(validated):
        failures.append("echo of limits: read again it is another one")
    for good, changes in ((GOOD, BROKEN), (limited, BROKEN_LIMITS)):
        for old, new in changes:
            text = good.replace(old, new, 1)
            assert text != good, old
            expect(False, problem, yaml.safe_load(text), new)
            if run("validate", "-", text=text).returncode != 3:
                failures.append(f"{new}: brachisto reads it")
    for case in ("paper/fig04_reference_case", "paper/fig06_bead"):
        answer = run("solve", f"{problems}/{case}.yaml", "--json", "--set",
                     "solver.search=global").stdout
        expect(True, result, json.loads(answer), f"result of {case}")
        document = json.loads(answer)
        document["tau"] = "fast"
        expect(False, result, document, "τ as a word")
        given = json.loads(answer)["input"]
        expect(True, problem, given, f"input of {case}")
        again = json.loads(run("validate", "-", "--json", text=answer).stdout)
        if {key: again.get(key) for key in given} != given:
            failures.append(f"result of {case}: read again it is another problem")
    refusal = run("solve", "-", "--json", text=GOOD.replace(*BROKEN[0], 1)).stdout
    expect(True, result, json.loads(refusal), "refusal")
    print("\n".join(failures) or f"{len(files)} problems conform, {len(BROKEN + BROKEN_LIMITS)} broken ones do not")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
