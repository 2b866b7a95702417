# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""A wheel of the package serves a virtual environment that has nothing but NumPy.

    python3 wheel.py BUILD

makes it from a build tree, without the network, installs it where the package is not, and
solves, draws and compares there. Exit code 77: there is no pip, or no venv.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
USE = """
import pathlib, subprocess, sys
import brachisto
prefix = pathlib.Path(sys.prefix)
assert prefix in pathlib.Path(brachisto.__file__).parents, brachisto.__file__
scene = brachisto.Scene(body={"shape": "bead"}, finish={"L": 3, "H": 1})
result = brachisto.solve(scene)
assert abs(result.tau / 4.510563136747 - 1) < 2e-10, result.tau  # of the cycloid
assert "<svg" in result._repr_html_()
result.write_page("bead.html")
assert brachisto.compare(scene, nodes=11, repetitions=1).table()["method"]
assert (pathlib.Path(brachisto.__file__).parent / "py.typed").exists()
told = subprocess.run([prefix / "bin/brachisto", "solve", "-"], text=True, check=True,
                      capture_output=True,
                      input="scene: {body: {shape: bead}, finish: {L: 3, H: 1}}").stdout
assert "4.51056313" in told, told
print("used")
"""


def main(build):
    missing = subprocess.run([sys.executable, "-c", "import pip, venv, ensurepip"],
                             stderr=subprocess.DEVNULL, check=False).returncode
    if missing:
        print("skipped: there is no pip or no venv (Debian: python3-pip python3-venv)")
        return 77
    clean = {key: value for key, value in os.environ.items()
             if not key.startswith(("PYTHON", "BRACHISTO", "PIP"))}
    with tempfile.TemporaryDirectory() as directory:
        def run(*command):
            return subprocess.run(command, check=True, cwd=directory, env=clean, text=True,
                                  stdout=subprocess.PIPE).stdout

        run(sys.executable, "-m", "pip", "wheel", str(ROOT), "--no-deps", "--no-index",
            "--disable-pip-version-check", "--config-settings", f"build-dir={build}",
            "--wheel-dir", "wheels")
        (wheel,) = pathlib.Path(directory, "wheels").iterdir()
        # NumPy is Debian's; nothing else of the system is used.
        run(sys.executable, "-m", "venv", "--system-site-packages", "clean")
        python = f"{directory}/clean/bin/python"
        run(python, "-m", "pip", "install", "--no-index", "--no-deps",
            "--disable-pip-version-check", str(wheel))
        print(run(python, "-c", USE), end="")
        # pip has compared every file with its sum; those that are there are all that are told.
        with zipfile.ZipFile(wheel) as file:
            (record,) = [name for name in file.namelist() if name.endswith("RECORD")]
            told = {line.split(",")[0] for line in file.read(record).decode().splitlines()}
            assert told == set(file.namelist())
        run(python, "-m", "pip", "uninstall", "--yes", "brachisto")
        assert not pathlib.Path(directory, "clean/bin/brachisto").exists()
        print(f"{wheel.name}, {wheel.stat().st_size / 1e6:.1f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
