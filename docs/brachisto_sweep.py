# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Reads the results of `brachisto sweep`. Needs the command and nothing else.

    python3 brachisto_sweep.py DIR    the fastest verified scene
"""

import json
import subprocess
import sys


def read_sweep(directory, command="brachisto"):
    """Finished scenes of a sweep as a list of dicts.

    Keys are the columns of `brachisto export`: "scene", the swept keys, "tau",
    ...; what a scene does not have is None.
    """
    run = subprocess.run([command, "export", str(directory), "--json"],
                         capture_output=True, text=True, encoding="utf-8")
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip())
    return json.loads(run.stdout)["rows"]


def as_frame(rows):
    """The same as a pandas DataFrame with the scene as index."""
    import pandas

    return pandas.DataFrame(rows).set_index("scene")


def main(arguments):
    rows = [row for row in read_sweep(*arguments) if row["verified"]]
    if not rows:
        print("no verified scene")
        return 1
    for key, value in min(rows, key=lambda row: row["tau"]).items():
        if value is not None:
            print(f"{key:28} {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:3]))
