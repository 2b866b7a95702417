#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Random scenes solved side by side, beside the same scenes solved each by itself.

    side_by_side.py build/release/src/app/brachisto --count 10000 --seed 17
    side_by_side.py build/release/src/app/brachisto --count 1000 --seed 17 --air
    side_by_side.py build/release/src/app/brachisto --count 1000 --seed 17 --push --extremals
    side_by_side.py build/release/src/app/brachisto --count 300 --seed 17 --planet outside
    side_by_side.py build/release/src/app/brachisto --count 30 --seed 5 --push --rates
    side_by_side.py build/release/src/app/brachisto --count 300 --seed 17 --limits

Makes a sweep of random scenes, runs it with `solver.method: auto` and with `ipopt` and tells how
many were left to their own solves, whether verdicts are equal, and by how much T differs. What is
tested is the difference against the sum of both estimated errors: which of the two is wrong, and
whether one is below its own error while the other makes up for it, is not seen. `--extremals`
compares with extremals to 1e-13 instead, whose errors are far below those of lanes, and tests the
estimate of the lanes alone. `--rates` compares with own solves to 1e-13, and first derivatives of τ
too, whose differences it tells and does not test. Exit code 1 if verdicts differ, a difference is
above what it is tested against, a scene is missing from a sweep, or none was solved side by side
and verified by both.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

PROBLEM = """
scene:
  body: {{shape: cylinder}}
  finish: {{H: 1}}
sweep:
  random:
    seed: {seed}
    count: {count}
    ranges:
      scene.body.eta_m: {{from: 0, to: 0.85}}
      scene.body.theta_m: {{from: -180 deg, to: 180 deg}}
      scene.body.k: {{from: 0, to: 0.25}}
      scene.body.radius: {{from: 0.15, to: 0.6}}
      scene.finish.L: {{from: 1.5, to: 5}}
"""
AIR = """      scene.air.linear: {from: 0, to: 0.5}
      scene.air.quadratic: {from: 0, to: 0.2}
"""
PUSH = "      scene.start.speed: {from: 0.1, to: 3}\n"
# Of a planet of some bodies' size, its surface below all of them or above.
PLANET = """      scene.field.sphere.centre.x: {{from: 1, to: 5}}
      scene.field.sphere.centre.z: {{from: 9.5, to: 15}}
      scene.field.sphere.radius: {{from: {least}, to: {most}}}
      scene.field.sphere.surface_gravity: {{from: 3, to: 20}}
"""
PLANETS = {"outside": PLANET.format(least=2, most=7), "inside": PLANET.format(least=17.5, most=30)}
# Some paths keep within them and some do not.
LIMITS = """      scene.limits.floor: {from: 1.2, to: 2.2}
      scene.limits.normal_force.max: {from: 2, to: 8}
      scene.limits.fold_margin: {from: 0, to: 0.5}
"""
VERDICTS = ("verified", "feasible", "status")
ALONE = ("solver.method=ipopt",)
TO_LAST_DIGITS = ("discretisation.tolerance=1e-13",)
BY_EXTREMALS = ("solver.method=extremal", *TO_LAST_DIGITS)
RATES = ("solver.sensitivities=true",)


def rows(program, problem, out, jobs, settings):
    """The rows of a sweep by the numbers of their scenes."""
    subprocess.run([program, "sweep", str(problem), "--out", out, "--quiet", "--jobs", str(jobs)]
                   + [word for setting in settings for word in ("--set", setting)], check=False)
    text = subprocess.run([program, "export", out, "--json"], check=True, capture_output=True).stdout
    return {row["scene"]: row for row in json.loads(text)["rows"]}


def share(some, of):
    return f"{some} of {of} ({100 * some / of:.1f} %)" if of else "none"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=17)
    parser.add_argument("--air", action="store_true", help="each scene in an air of its own")
    parser.add_argument("--push", action="store_true", help="each scene with a start speed of its own")
    parser.add_argument("--planet", choices=PLANETS, help="each scene in the field of a sphere of its own")
    parser.add_argument("--limits", action="store_true", help="each scene under limits of its own")
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--extremals", action="store_true", help="compare with extremals to 1e-13")
    how.add_argument("--rates", action="store_true", help="compare first derivatives too")
    parser.add_argument("--jobs", type=int, default=1)
    asked = parser.parse_args()
    text = PROBLEM.format(seed=asked.seed, count=asked.count)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        problem = folder / "scenes.yaml"
        problem.write_text(text + (AIR if asked.air else "") + (PUSH if asked.push else "")
                           + (LIMITS if asked.limits else "") + PLANETS.get(asked.planet, ""))
        beside, alone = (
            rows(asked.program, problem, str(folder / out), asked.jobs, settings)
            for out, settings in (("beside", ("solver.method=auto", *(RATES if asked.rates else ()))),
                                  ("alone", BY_EXTREMALS if asked.extremals else
                                   (*ALONE, *RATES, *TO_LAST_DIGITS) if asked.rates else ALONE)))

    pairs = [(beside[scene], alone[scene]) for scene in sorted(beside.keys() & alone.keys())]
    served = [(a, b) for a, b in pairs if a["engine"] == "lanes"]
    missing = asked.count - len(pairs)
    others = [[a[v] for v in ("scene", *VERDICTS)] for a, b in served
              if any(a[v] != b[v] for v in VERDICTS)]
    differences = [(abs(a["tau"] / b["tau"] - 1),
                    a["estimated_error"] + (0 if asked.extremals else b["estimated_error"]))
                   for a, b in served if a["verified"] and b["verified"]]
    print(f"{asked.count} scenes, {missing} missing; {share(len(served), len(pairs))} "
          f"side by side, {len(pairs) - len(served)} left to their own solves")
    print(f"verdicts that differ: {len(others)} of {len(served)} {others[:5]}")
    if not differences:
        print("none to compare")
        sys.exit(1)
    most = max(d for d, _ in differences)
    share_of = max(d / estimate for d, estimate in differences)
    estimate = "the estimated error" if asked.extremals else "the sum of both estimated errors"
    print(f"{len(differences)} compared: T differs relatively by at most {most:.1e}, at most "
          f"{share_of:.2f} of {estimate}")
    if asked.rates:
        rates = [(abs(a[column] - b[column]), column, a["scene"])
                 for a, b in served if a["verified"] and b["verified"]
                 for column in a if column.startswith("sensitivities.") and column.endswith(".tau")]
        print("derivatives of tau differ by at most {:.1e}: {}, scene {}".format(*max(rates)))
    sys.exit(1 if missing or others or share_of > 1 else 0)


if __name__ == "__main__":
    main()
