#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Scenes at the edges of what a problem file may say, through the command.

Named cases first, then random scenes: lengths from 1e-12 to 1e12 m whose ratios
reach 1e6, offsets up to 1 - 1e-12 and down to 1e-12, k at its bounds 0 and
1 - eta_m^2 and between, theta_m up to 1e6 rad or 1e18 degrees. Every scene is
solved once and, where the answer is verified, once more by the indirect method.

A fault is

    an exit code that is not 0, 3, 4, 5 or 7, such as 1 or the death by a signal;
    stdout that is not one JSON document, or does not fit the exit code;
    more than a second beyond the limit of time;
    a verified tau that differs from the indirect method's on the same extremal
    by more than both estimated errors together.

Writes a table of all runs and prints the outcomes. Exits with 1 if there is a
fault. Python 3.8 or later, nothing else.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time

EXIT_CODES = {
    0: "solved and verified, feasible",
    3: "refused: outside of the bounds",
    4: "not solved, or not verified",
    5: "solved and verified, infeasible",
    7: "limit of time or memory",
}
SLACK = 1.0  # beyond the limit of time [s]
# tau is printed with 17 digits and computed with a few roundings more than the
# estimates know of.
ROUNDING = 1e-14

COLUMNS = ["case", "shape", "contact", "radius", "eta_m", "theta_m", "k", "L",
           "H", "gravity", "exit", "status", "verified", "tau",
           "estimated_error", "seconds", "witness_exit", "witness_status",
           "witness_tau", "witness_error", "difference", "comparison", "fault",
           "message"]

BASE = {"shape": "cylinder", "radius": "1/3", "eta_m": "2/3",
        "theta_m": "-30 deg", "k": "1/2", "L": "3", "H": "1",
        "gravity": "9.81", "contact": "smooth"}


class Case:
    """A scene, what else is set, and which exit codes it may have."""

    def __init__(self, name, scene=None, settings=(), codes=tuple(EXIT_CODES),
                 path=None, megabytes=None):
        self.name = name
        self.scene = {**BASE, **(scene or {})}
        self.settings = list(settings)
        self.codes = codes
        self.path = path  # lines of x,z
        self.megabytes = megabytes  # limit of the address space


def named_cases():
    """Cases that have failed once."""
    refused, unsolved, limit, right = (3,), (4,), (7,), (0, 5)

    def many_points(n):
        return [(3.0 * i / n, i / n + 0.6 * math.sin(math.pi * i / n))
                for i in range(n + 1)]

    far = {"radius": "0.05", "L": "10"}
    return [
        Case("theta_m 1e12 deg", {"theta_m": "1e12 deg"}, codes=right),
        Case("theta_m 1e18 deg", {"theta_m": "1e18 deg"}, codes=right),
        Case("theta_m 1e6", {"theta_m": "1e6"}, codes=right),
        Case("theta_m 1e12", {"theta_m": "1e12"}, codes=refused),
        Case("gravity 5e-324", {"gravity": "5e-324"}, codes=refused),
        Case("gravity 1.7e308", {"gravity": "1.7e308"}, codes=refused),
        Case("lengths 1e-308",
             {"L": "3e-308", "H": "1e-308", "radius": "3.3e-309"},
             codes=refused),
        Case("lengths 1e-49", {"L": "3e-49", "H": "1e-49", "radius": "3.3e-50"},
             codes=right),
        Case("lengths 1e49", {"L": "3e49", "H": "1e49", "radius": "3.3e48"},
             codes=right),
        Case("eta_m 1e-6", {**far, "eta_m": "1e-6"}, codes=right),
        Case("eta_m 1e-8", {**far, "eta_m": "1e-8"}, codes=right),
        Case("eta_m 1e-50", {**far, "eta_m": "1e-50"}, codes=right),
        Case("eta_m 5e-324", {"eta_m": "5e-324"}, codes=refused),
        Case("eta_m 1 - 2^-53", {"eta_m": "1-2^-53", "k": "0"},
             codes=unsolved + limit),
        Case("H 1e-3", {"H": "1e-3"}, codes=right),
        Case("H 1e-10", {"H": "1e-10"}, codes=unsolved),
        Case("H 1e-15", {"H": "1e-15"}, codes=unsolved),
        Case("H 1e-17", {"H": "1e-17"}, codes=unsolved),
        Case("H 1e-40", {"H": "1e-40"}, codes=unsolved),
        Case("L 1e-40", {"L": "1e-40"}, codes=right),
        Case("r 5e-324", {"radius": "5e-324"}, codes=refused),
        Case("r 1e-9", {"radius": "1e-9"}, codes=limit),
        Case("r 2e-8", {"radius": "2e-8"}, codes=limit),
        Case("r 1e-9, uniform", {"radius": "1e-9", "eta_m": "0"}, codes=right),
        Case("L 1e10", {"L": "1e10"}, codes=limit),
        Case("L 1e5, r 1e-6", {"L": "1e5", "radius": "1e-6"}, codes=limit),
        Case("r 1e-9, extremal", {"radius": "1e-9"},
             ["solver.method=extremal"], codes=limit),
        Case("10 million elements", {},
             ["discretisation.elements=10000000"], codes=limit),
        Case("fsolve, 100 000 nodes", {},
             ["solver.method=fsolve", "discretisation.nodes=100000"],
             codes=limit),
        Case("40 001 nodes in 170 MB", {}, ["discretisation.elements=8000"],
             codes=limit, megabytes=170),
        Case("40 001 nodes in 190 MB, Newton", {},
             ["discretisation.elements=8000", "solver.method=newton_kkt"],
             codes=right + limit, megabytes=190),
        Case("40 001 nodes in 250 MB, MUMPS", {},
             ["discretisation.elements=8000", "solver.linear_solver=mumps"],
             codes=right + limit, megabytes=250),
        Case("path that ends at 2 H", {"shape": "bead", "H": "1e-6"},
             path=[(0, 0), (1, 4e-7), (3, 2e-6)], codes=refused),
        Case("path of 20 000 points", {"shape": "bead"},
             path=many_points(20000), codes=right),
        Case("path of points next to each other", {"shape": "bead"},
             path=[(0, 0), (1, 0.5), (1, 0.5 + 1e-16), (3, 1)],
             codes=unsolved + refused),
    ]


def random_case(seed, index):
    """The same on every machine: random() alone is used, and is defined."""
    source = random.Random(1000003 * seed + index)
    uniform = lambda low, high: low + (high - low) * source.random()
    power = lambda low, high: 10.0 ** uniform(low, high)
    sign = lambda: -1.0 if source.random() < 0.5 else 1.0
    pick = lambda *ways: ways[int(source.random() * len(ways))]()

    size = power(-12, 12)
    length = lambda: min(1e12, max(1e-12, size * power(-3, 3)))
    scene = {"L": length(), "H": length(), "gravity": power(-6, 6),
             "contact": pick(*[lambda: "smooth"] * 4, lambda: "centre")}
    if source.random() < 0.1:
        scene["shape"] = "bead"
    else:
        eta = pick(lambda: 1.0 - power(-12, 0), lambda: power(-12, 0),
                   lambda: source.random(), lambda: 0.0)
        largest = (1.0 - eta) * (1.0 + eta)
        scene.update(
            radius=length(), eta_m=eta,
            k=pick(lambda: 0.0, lambda: largest,
                   lambda: largest * source.random()),
            theta_m=pick(lambda: uniform(-math.pi, math.pi),
                         lambda: sign() * power(0, 6),
                         lambda: f"{sign() * power(0, 18)!r} deg"))
    return Case(str(index), {key: value if isinstance(value, str)
                             else repr(value) for key, value in scene.items()})


def problem_text(case, folder):
    scene = case.scene
    body = {"shape": scene["shape"]}
    if scene["shape"] == "cylinder":
        body.update({key: scene[key]
                     for key in ("radius", "eta_m", "theta_m", "k")})
    flow = lambda entries: ", ".join(f"{k}: {v}" for k, v in entries.items())
    lines = ["scene:", f"  body: {{{flow(body)}}}",
             f"  finish: {{L: {scene['L']}, H: {scene['H']}}}",
             f"  gravity: {scene['gravity']}",
             f"  contact: {scene['contact']}"]
    if case.path:
        file = pathlib.Path(folder) / "path.csv"
        file.write_text("x,z\n" + "".join(f"{x!r},{z!r}\n"
                                          for x, z in case.path))
        lines.append("  path: {curve: track, shape: points, file: path.csv}")
    return "\n".join(lines) + "\n"


def finite(text):
    """json.loads() takes NaN and Infinity, which are no JSON."""
    raise ValueError(f"{text} is no JSON")


class Run:
    """One call of the command."""

    def __init__(self, program, file, case, settings, limit):
        command = [program, "solve", str(file), "--json", "--quiet",
                   "--set", f"solver.limits.seconds={limit}"]
        for setting in settings:
            command += ["--set", setting]

        def confine():
            size = case.megabytes << 20
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

        begin = time.monotonic()
        try:
            done = subprocess.run(
                command, capture_output=True, timeout=10 * limit + 60,
                preexec_fn=confine if case.megabytes else None)
            self.code, self.out = done.returncode, done.stdout
            self.err = done.stderr.decode("utf-8", "replace")
        except subprocess.TimeoutExpired:
            self.code, self.out, self.err = None, b"", "it did not end"
        self.seconds = time.monotonic() - begin
        self.limit = limit
        try:
            self.document = json.loads(self.out, parse_constant=finite)
        except ValueError:
            self.document = None

    def get(self, key):
        return (self.document or {}).get(key)

    @property
    def verified(self):
        return self.code in (0, 5)

    def faults(self):
        found = []
        if self.code not in EXIT_CODES:
            found.append(f"exit code {self.code}: {self.err.strip()[-200:]}")
        if not isinstance(self.document, dict):
            found.append("no JSON document")
        elif self.get("verified") is not self.verified:
            found.append(f"verified: {self.get('verified')} with exit code "
                         f"{self.code}")
        elif self.verified and not isinstance(self.get("tau"), float):
            found.append(f"verified with tau {self.get('tau')}")
        if self.seconds > self.limit + SLACK:
            found.append(f"{self.seconds:.1f} s, with a limit of "
                         f"{self.limit:g} s")
        return found


def same_extremal(one, other):
    """Whether two verified results may be the same path."""
    return (abs(one.get("end_angle") - other.get("end_angle")) < 1e-3 and
            abs(one.get("centre_path_length") /
                other.get("centre_path_length") - 1) < 1e-3)


def compare(first, witness, row):
    """Fills in the comparison; returns what is wrong."""
    row.update(witness_exit=witness.code,
               witness_status=witness.get("status"),
               witness_tau=witness.get("tau"),
               witness_error=witness.get("estimated_error"))
    if not witness.verified:
        row["comparison"] = "no witness"
        return []
    tau, other = first.get("tau"), witness.get("tau")
    row["difference"] = abs(tau - other) / other
    allowed = (first.get("estimated_error") + witness.get("estimated_error") +
               ROUNDING)
    if row["difference"] <= allowed:
        row["comparison"] = "agrees"
        return []
    if not same_extremal(first, witness):
        row["comparison"] = "another extremal"
        return []
    row["comparison"] = "differs"
    return [f"tau differs by {row['difference']:.1e}, estimated are "
            f"{allowed:.1e}"]


def examine(program, case, limit):
    """Runs a case; its row of the table."""
    row = dict.fromkeys(COLUMNS)
    row["case"] = case.name
    row.update({key: value for key, value in case.scene.items()
                if case.scene["shape"] == "cylinder" or
                key not in ("radius", "eta_m", "theta_m", "k")})
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.yaml"
        file.write_text(problem_text(case, folder))
        first = Run(program, file, case, case.settings, limit)
        faults = first.faults()
        if first.code in EXIT_CODES and first.code not in case.codes:
            faults.append(f"exit code {first.code}, expected "
                          f"{' or '.join(map(str, case.codes))}")
        if first.verified and not faults and not case.settings and \
                not case.path:
            witness = Run(program, file, case, ["solver.method=extremal"],
                          limit)
            faults += [f"indirect method: {fault}"
                       for fault in witness.faults()]
            faults += compare(first, witness, row)
    row.update(exit=first.code, status=first.get("status"),
               verified=first.verified, tau=first.get("tau"),
               estimated_error=first.get("estimated_error"),
               seconds=round(first.seconds, 3), fault="; ".join(faults),
               message=(first.get("message") or "").replace("\n", " | ")[:300])
    return row


def print_table(title, rows):
    print(f"\n{title}: {len(rows)}\n")
    print("| exit | outcome | status | scenes | longest [s] |")
    print("| --- | --- | --- | --- | --- |")
    groups = collections.defaultdict(list)
    for row in rows:
        groups[(row["exit"] if row["exit"] is not None else 999,
                row["status"] or "-")].append(row)
    for (code, status), group in sorted(groups.items()):
        longest = max(row["seconds"] for row in group)
        print(f"| {code} | {EXIT_CODES.get(code, 'FAULT')} | {status} | "
              f"{len(group)} | {longest:.1f} |")
    compared = collections.Counter(row["comparison"] for row in rows
                                   if row["comparison"])
    if compared:
        print("\nVerified tau against the indirect method: " +
              ", ".join(f"{count} {what}" for what, count
                        in sorted(compared.items())) + ".")


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = here.parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, metavar="FILE",
                        default=root / "build/release/src/app/brachisto",
                        help="the command (%(default)s)")
    parser.add_argument("--out", type=pathlib.Path, metavar="FILE",
                        default=root / "benchmarks/results/hostile.csv",
                        help="the table of all runs (%(default)s)")
    parser.add_argument("--scenes", type=int, default=1000, metavar="N",
                        help="random ones (%(default)s)")
    parser.add_argument("--first", type=int, default=0, metavar="I",
                        help="number of the first of them (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, metavar="S")
    parser.add_argument("--seconds", type=float, default=10.0, metavar="S",
                        help="limit of each solve (%(default)s)")
    parser.add_argument("--jobs", type=int, metavar="N",
                        default=os.cpu_count() or 1,
                        help="processes at a time (%(default)s)")
    options = parser.parse_args()
    if not options.program.is_file():
        parser.error(f"{options.program} is not there")

    named = named_cases()
    cases = named + [random_case(options.seed, options.first + i)
                     for i in range(options.scenes)]
    begin = time.monotonic()
    rows = [None] * len(cases)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        waiting = {pool.submit(examine, str(options.program), case,
                               options.seconds): i
                   for i, case in enumerate(cases)}
        for done, future in enumerate(
                concurrent.futures.as_completed(waiting), 1):
            rows[waiting[future]] = future.result()
            if sys.stderr.isatty():
                print(f"\r{done} of {len(cases)}", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print(file=sys.stderr)

    options.out.parent.mkdir(parents=True, exist_ok=True)
    with open(options.out, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)

    print_table("Named cases", rows[:len(named)])
    if options.scenes:
        print_table(f"Random scenes, seed {options.seed}", rows[len(named):])
    faults = [row for row in rows if row["fault"]]
    print(f"\n{len(faults)} faults, {time.monotonic() - begin:.0f} s.")
    for row in faults:
        print(f"  {row['case']}: {row['fault']}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
