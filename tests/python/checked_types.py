# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""A type checker accepts what the guide does, and finds what is wrong.

Exit code 77: there is no mypy (Debian: mypy).
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import brachisto

RIGHT = """\
import brachisto

scene = brachisto.Scene(body={"shape": "bead"}, finish={"L": 3, "H": 1})
result: brachisto.Result = brachisto.solve(scene, solver={"polish": False})
tau: float | None = result.tau
result.write_page("page.html", force=True)
race: brachisto.Race = brachisto.race({"a": scene, "b": result})
race.write_page("race.html")
best: brachisto.Result = brachisto.design(scene, free=["eta_m"])
text: str = brachisto.compare(scene, nodes=51).summary() + result._repr_html_()
frame = brachisto.sweep("sweep.yaml", jobs=2)
"""
# Each line has one fault.
WRONG = """\
brachisto.race([scene])
result.write_page(3)
brachisto.compare(scene, nodes="many")
brachisto.sweep(scene)
brachisto.design(result)
result.transit
length: str = result.rail_length
"""

if subprocess.run([sys.executable, "-c", "import mypy"], stderr=subprocess.DEVNULL,
                  check=False).returncode:
    print("skipped: there is no mypy")
    sys.exit(77)
with tempfile.TemporaryDirectory() as directory:
    program = pathlib.Path(directory, "program.py")
    program.write_text(RIGHT + WRONG, encoding="utf-8")
    told = subprocess.run(
        [sys.executable, "-m", "mypy", "--cache-dir", f"{directory}/cache", "--python-version",
         "3.11", str(program)], cwd=directory, text=True, capture_output=True, check=False,
        env={"MYPYPATH": str(pathlib.Path(brachisto.__file__).parents[1])}).stdout
first = len(RIGHT.splitlines()) + 1
faults = {int(line) for line in re.findall(r"program.py:(\d+): error", told)}
expected = set(range(first, first + len(WRONG.splitlines())))
assert faults == expected, f"lines {sorted(faults ^ expected)} are judged otherwise:\n{told}"
print(told, end="")
