#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The pictures of docs/building.md, which are sheets of its build.

    building_pictures.py BRACHISTO            # makes them
    building_pictures.py BRACHISTO --check    # compares them with those that are there

Numbers may differ by what compilers make of them, a few thousandths of a millimetre.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURES = {"sheet-01": "build_sheet", "assembly-01": "build_assembly",
            "assembly-02": "build_numbers"}
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?")
ALLOWED = 5e-3


def differs(one, other):
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return True
    return any(abs(float(a) - float(b)) > ALLOWED * max(1.0, abs(float(a)) * 1e-2)
               for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)))


def main():
    command, check = sys.argv[1], "--check" in sys.argv[2:]
    stale = []
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([command, "solve", str(ROOT / "problems/build/cylinder.yaml"), "--quiet",
                        "--track-svg", scratch], check=True)
        for sheet, picture in PICTURES.items():
            made = (pathlib.Path(scratch) / f"{sheet}.svg").read_text(encoding="utf-8")
            path = ROOT / "docs/images" / f"{picture}.svg"
            if not check:
                path.write_text(made, encoding="utf-8")
            elif not path.exists() or differs(path.read_text(encoding="utf-8"), made):
                stale.append(path.name)
    for name in stale:
        print(f"docs/images/{name} is not what the command draws; make it anew with\n"
              f"    tests/documents/building_pictures.py {command}")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
