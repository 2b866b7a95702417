#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Does compare.py notice? Thirty faults, one at a time, in a copy of the tree.

    faults.py REFERENCE
    faults.py --check     only whether each text stands once

The reference is an executable built from the tree as it stands. Each fault
replaces a text that stands once in src or include, wherever that is by now, and
is built and compared until the first difference. Exits with 1 if one is not
noticed, does not build, or its text is no longer found once.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

FAULTS = [
    # columns and keys
    ("z of the centre of mass in the CSV as its x", "return p.motion.mass_centre.x;",
     "return p.motion.mass_centre.z;"),
    ("R_n called R_t in the head of the CSV", '{{"R_n", "m g", "normal', '{{"R_t", "m g", "normal'),
    ("rail and centre length swapped in JSON",
     "&Motion::rail_length}", "&Motion::centre_path_length}"),
    ("a column of the sweep's table takes another figure", '"/normal_force/max",', '"/curvature/max",'),
    ("a shared figure of friction", '"share_above_0.3", "", "0.3", &D::friction_above_0_3',
     '"share_above_0.3", "", "0.3", &D::friction_above_0_5'),
    # units
    ("natural unit of time", "return {length, std::sqrt(length / (2.0 * scene.gravity))};",
     "return {length, std::sqrt(length / scene.gravity)};"),
    ("degrees of the summary", "degrees(*path.rotation()))", "*path.rotation())"),
    ("forces in newtons by one component", "const double R_x = x_ddot / gravity - acting.pull_x;",
     "const double R_x = x_ddot - acting.pull_x;"),
    ("scaled scene keeps its H", "scaled.H /= length;", ""),
    # defaults
    ("limit of iterations", "int iterations = 3000;", "int iterations = 30;"),
    ("tolerance of the tangency", "double tolerance = 1e-12;        ///< on |β_end",
     "double tolerance = 1e-6;        ///< on |β_end"),
    ("polishing", "bool polish = true;  ///< last digits", "bool polish = false;  ///< last digits"),
    ("seed", "std::uint64_t seed = 1;  ///< of Guess", "std::uint64_t seed = 2;  ///< of Guess"),
    # signs
    ("tangential force", "out.R_t = R_x * cos_beta + R_z * sin_beta;",
     "out.R_t = R_x * cos_beta - R_z * sin_beta;"),
    ("rate of the inertia", "const double v_dot = acting.w_rate / A - w * A_rate / (2.0 * A * A);",
     "const double v_dot = acting.w_rate / A + w * A_rate / (2.0 * A * A);"),
    ("centripetal term", "swing * cos_theta - centripetal * sin_theta;",
     "swing * cos_theta + centripetal * sin_theta;"),
    ("margin of a fold", "const double along_track = w - r * state.beta_rate;",
     "const double along_track = w + r * state.beta_rate;"),
    # branches
    ("infeasible is success", "return can_run(solution, design) ? kSuccess : kInfeasible;",
     "return kSuccess;"),
    ("out of memory is not solved", "case Status::OutOfMemory:\n      return kLimit;",
     "return kLimit;\n    case Status::OutOfMemory:\n      return kNotSolved;"),
    ("a bead may lift off",
     "if (!scene.body.rolls()) return reasons;\n  if (scene.contact == Contact::Smooth)",
     "if (scene.contact == Contact::Smooth)"),
    ("every solve searches",
     "if (posed.options.searches() && (posed.cycloid || start.curve)) {",
     "if (posed.cycloid || start.curve) {"),
    ("ends of the centre judged by one of them",
     "std::max(at_A, at_B)", "std::max(at_B, at_B)"),
    ("a message without its advice", 'outcome.message += ". To try: " + advice;', "{}"),
    ("nearest known key not told", '"; did you mean {}?", found', '"; is it {}?", found'),
    # thresholds
    ("residual of the certificate", "double kkt_residual = 1e-9;", "double kkt_residual = 1e-16;"),
    ("interior of the certificate", "double interior_factor = 100.0;", "double interior_factor = 1.0;"),
    ("friction", "friction_share(*this, of_friction, 0.3)", "friction_share(*this, of_friction, 0.31)"),
    ("deepest nesting", "kMaxNesting = 32", "kMaxNesting = 2"),
    ("least tolerance of T", "kSmallestTolerance = 1e-13", "kSmallestTolerance = 1e-9"),
    ("largest number of points", "kMostPoints = 100'000", "kMostPoints = 3"),
]


def pattern(text):
    """The text, however its lines are broken."""
    return re.compile(r"\s+".join(re.escape(word) for word in text.split()))


def sources(tree):
    for room in ("src", "include"):
        for path in sorted((tree / room).rglob("*.[ch]pp")):
            yield path


def place(tree, text):
    """The one file that has the text once."""
    wanted = pattern(text)
    hits = [path for path in sources(tree)
            for _ in wanted.finditer(path.read_text(encoding="utf-8"))]
    return hits[0] if len(hits) == 1 else None


def run(command, **keywords):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", **keywords)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reference", type=pathlib.Path, nargs="?")
    parser.add_argument("--check", action="store_true", help="build nothing")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="faults whose name contains this")
    flags = parser.parse_args()
    chosen = [fault for fault in FAULTS if flags.only in fault[0]]
    lost = [name for name, old, _ in chosen if place(ROOT, old) is None]
    for name in lost:
        print(f"{name}: its text does not stand once in the tree", flush=True)
    if lost or flags.check:
        print(f"{len(chosen) - len(lost)} of {len(chosen)} texts stand once")
        return 1 if lost else 0
    if flags.reference is None:
        parser.error("the executable to compare with is missing")

    reference = flags.reference.resolve()
    missed = 0
    with tempfile.TemporaryDirectory(dir=ROOT.parent) as folder:
        tree = pathlib.Path(folder)
        for part in ("CMakeLists.txt", "CMakePresets.json", "src", "include", "problems", "tests/frozen"):
            source = ROOT / part
            if source.is_dir():
                shutil.copytree(source, tree / part)
            elif source.exists():
                shutil.copy(source, tree / part)
        build = tree / "build/release"
        made = run(["cmake", "--preset", "release", "-DBRACHISTO_BUILD_TESTS=OFF"], cwd=tree)
        if made.returncode:
            print(made.stdout)
            return 1
        for name, old, new in chosen:
            path = place(tree, old)
            before = path.read_text(encoding="utf-8")
            path.write_text(pattern(old).sub(lambda _: new, before), encoding="utf-8")
            built = run(["cmake", "--build", build, "--target", "brachisto_app", "--",
                         f"-j{flags.jobs}"])
            if built.returncode:
                outcome = "does not build\n" + built.stdout[-2000:]
                missed += 1
            else:
                found = run([sys.executable, tree / "tests/frozen/compare.py", "--until-different",
                             "--jobs", str(flags.jobs), reference, build / "src/app/brachisto"],
                            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
                first = found.stdout.strip().splitlines()[:2] or ["nothing"]
                outcome = " | ".join(line.strip() for line in first) if found.returncode else "MISSED"
                missed += found.returncode == 0
            print(f"{name}: {outcome}", flush=True)
            path.write_text(before, encoding="utf-8")
    print(f"{len(chosen) - missed} of {len(chosen)} faults noticed")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
