#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Times in the comments of problem files against what the program prints.

    problem_comments.py BRACHISTO

A comment says "here: tau = 5.093", "Pass: tau = 5.093", "here: T = 1.228 s", or, of a design,
"tau = 3.97" of what it finds. Each has to be right to its last digit. Files whose
solve takes long are in SLOW: benchmark_gallery has those of problems/hard.
"""

import json
import pathlib
import re
import subprocess
import sys

from program import Program

ROOT = pathlib.Path(__file__).resolve().parents[2]
SLOW = {"hard/r_0.001.yaml", "hard/H_100.yaml", "hard/global_search.yaml",
        "hard/global_search_r_0.1.yaml"}
STATED = re.compile(r"^#.*?(?:here: |Pass: )(tau|T) = (\d+\.\d+)", re.M)
DESIGNED = re.compile(r"^#.*\btau = (\d+\.\d+)", re.M)
# A file with a list of times, or none, is no mistake; a folder without any is.
FEWEST = 60


def objection(name, key, stated, found):
    # Half a unit of the last digit and what the solve may be off, 1e-10.
    allowed = 0.501 * 10.0 ** -len(stated.partition(".")[2]) + 1e-10 * found
    if abs(found - float(stated)) <= allowed:
        return []
    return [f"problems/{name}: says {key} = {stated}, and {found:.13g} is found"]


def main():
    with Program(sys.argv[1], ROOT) as program:
        files, wrong, count = [], [], 0
        for path in sorted((ROOT / "problems").rglob("*.yaml")):
            name = path.relative_to(ROOT / "problems").as_posix()
            match = STATED.search(path.read_text(encoding="utf-8"))
            if match and name not in SLOW:
                files.append((name, *match.groups()))
        answers = program.solve_all([name for name, _, _ in files], may_fail=True)
        for (name, key, stated), answer in zip(files, answers):
            count += 1
            found = answer["tau" if key == "tau" else "transit_time"]
            if not answer["verified"]:
                wrong.append(f"problems/{name}: is not verified")
            else:
                wrong += objection(name, key, stated, found)
        for path in sorted((ROOT / "problems/design").glob("*.yaml")):
            match = DESIGNED.search(path.read_text(encoding="utf-8"))
            if not match:
                continue
            count += 1
            done = subprocess.run([program.executable, "design", str(path), "--json"],
                                  capture_output=True, text=True, check=True)
            wrong += objection(f"design/{path.name}", "tau", match.group(1),
                               json.loads(done.stdout)["tau"])
    if count < FEWEST:
        wrong.append(f"only {count} files state a time")
    print("\n".join(wrong), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
