#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Two builds of the command at the same work, in turn.

Runs each piece of work with the first and the second program one after the
other, as often as --runs says, and prints as a Markdown table the medians of
user + system CPU time of the process and its children, peak memory and page
faults of its largest one, and the ratio of the times. Single scenes take too
little for a clock: of them valgrind, if it is there, counts instructions, start
of the program included. Python 3.8 or later, nothing else.

    paired.py old/brachisto build/release/src/app/brachisto --runs 5
    paired.py old/brachisto new/brachisto --only map
"""

import argparse
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

PROBLEMS = pathlib.Path(__file__).resolve().parents[2] / "problems"
SOLVED = (0, 5)  # 5: verified, but the body would lift off
IPOPT = ["--set", "solver.method=ipopt"]

# What is counted in instructions.
SCENES = {
    "base case": ["case.yaml"],
    "base case to 1e-12": ["case.yaml", "--set", "discretisation.tolerance=1e-12"],
    "reference case": ["paper/fig04_reference_case.yaml"],
    "114 turns": ["hard/r_0.005.yaml"],
    "friction": ["limits/friction_1.yaml"],
}
# What is timed: verb, file, options.
LARGE = {
    "map of 2 501 scenes": ["sweep", "sweeps/map_eta_theta.yaml", "--jobs", "1"],
    "arc_length 1e6": ["solve", "large/million_pieces.yaml"],
    "rolling_time p 5, 1e6": ["solve", "large/million_nodes.yaml"],
    "arc_length 1e6, Ipopt": ["solve", "large/million_pieces.yaml", *IPOPT],
    "rolling_time 1e6, Ipopt": ["solve", "large/million_nodes.yaml", *IPOPT],
}


def command(program, verb, file, *options):
    return [str(program), verb, str(PROBLEMS / file), "--quiet", *options]


def run(argv):
    """CPU seconds, peak memory [GB] and page faults of one run."""
    with tempfile.TemporaryDirectory() as folder:
        if argv[1] == "sweep":
            argv = [*argv, "--out", folder + "/out"]
        child = subprocess.Popen(argv, stdout=subprocess.DEVNULL)
        _, status, use = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) not in SOLVED:
        raise SystemExit(f"{' '.join(argv)} ended with status {status}")
    return (use.ru_utime + use.ru_stime, use.ru_maxrss * 1024 / 1e9,
            use.ru_minflt + use.ru_majflt)


def instructions(argv):
    """Millions of instructions, all libraries and the start included."""
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run(
            ["valgrind", "--tool=callgrind",
             f"--callgrind-out-file={folder}/callgrind", *argv],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if out.returncode not in SOLVED:
        raise SystemExit(f"{' '.join(argv)} ended with {out.returncode}")
    return int(re.search(r"Collected : (\d+)", out.stderr)[1]) / 1e6


def medians(programs, argv_of, runs):
    seen = [[], []]
    for _ in range(runs):
        for i, program in enumerate(programs):
            seen[i].append(run(argv_of(program)))
    return [[statistics.median(one) for one in zip(*each)] for each in seen]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("first", type=pathlib.Path)
    parser.add_argument("second", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3, help="of each program")
    parser.add_argument("--only", default="", help="work whose name has this")
    args = parser.parse_args()
    programs = (args.first.resolve(), args.second.resolve())

    if shutil.which("valgrind"):
        print("| million instructions | first | second | ratio |")
        print("| --- | --- | --- | --- |")
        for name, work in SCENES.items():
            if args.only not in name:
                continue
            a, b = (instructions(command(p, "solve", *work)) for p in programs)
            print(f"| {name} | {a:.1f} | {b:.1f} | {a / b:.2f} |", flush=True)
        print()
    else:
        print("No valgrind: instructions are not counted.", file=sys.stderr)

    print("| CPU time, peak memory, page faults | first | second | ratio |")
    print("| --- | --- | --- | --- |")
    for name, work in LARGE.items():
        if args.only not in name:
            continue
        pair = medians(programs, lambda p: command(p, *work), args.runs)
        cells = [f"{s:.2f} s, {gb:.2f} GB, {faults / 1e3:.0f} k"
                 for s, gb, faults in pair]
        print(f"| {name} | {cells[0]} | {cells[1]} | "
              f"{pair[0][0] / pair[1][0]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
