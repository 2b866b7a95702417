#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The pages with motion in a browser, Chromium without a window.

    browser.py BRACHISTO PROBLEMS

At the time that the address names the body is where trajectory.csv has it and
touches the drawn track, whatever the width of the window and the colours asked
for, and the browser has nothing to say about the page. So are all bodies of a
race, those that have arrived at B. SKIPs (77) without Chromium.
"""

import csv
import html.parser
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FLAGS = ["--headless=new", "--disable-gpu", "--no-first-run", "--disable-extensions",
         "--virtual-time-budget=3000", "--enable-logging=stderr", "--dump-dom"]


class Elements(html.parser.HTMLParser):
    """Attributes of the elements that have an identifier, and their text."""

    def __init__(self, document):
        super().__init__()
        self.found, self.texts, self.inside = {}, {}, None
        self.feed(document)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside = attributes.get("id")
        if self.inside:
            self.found[self.inside] = attributes

    def handle_data(self, text):
        if self.inside:
            self.texts[self.inside] = self.texts.get(self.inside, "") + text

    def handle_endtag(self, tag):
        self.inside = None


def browser():
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if shutil.which(name):
            return shutil.which(name)
    print("no chromium; see CONTRIBUTING.md, page checks")
    sys.exit(77)


def shown(program, page, t, more, home):
    """The page as the browser has it at a time, and what it said."""
    flags = FLAGS + [f"--user-data-dir={home}"] + more
    if os.geteuid() == 0:
        flags.append("--no-sandbox")
    run = subprocess.run([program, *flags, f"{page.as_uri()}#t={t}"], text=True,
                         capture_output=True, timeout=120, check=True)
    said = [line for line in run.stderr.splitlines() if "CONSOLE" in line]
    return Elements(run.stdout), said


def distance_to_line(x, y, path):
    points = [tuple(map(float, p.split())) for p in re.split("[ML]", path)[1:]]
    best = math.inf
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        length = (bx - ax) ** 2 + (by - ay) ** 2
        s = 0.0 if length == 0 else ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length
        s = min(max(s, 0.0), 1.0)
        best = min(best, math.hypot(ax + s * (bx - ax) - x, ay + s * (by - ay) - y))
    return best


def place_faults(name, body, row):
    """Where a body is not where the row of its table has it."""
    faults = []
    for mine, theirs in (("data-x", "x_c"), ("data-z", "z_c"), ("data-contact-x", "x_b"),
                         ("data-contact-z", "z_b"), ("data-theta", "theta")):
        if not row[theirs]:
            continue  # a bead has no θ
        there = float(row[theirs])
        # Seven digits of times, places and angles up to 10 m and rad, speeds of
        # some m/s, some hundred rad/s.
        if not abs(float(body.get(mine, "nan")) - there) < 1e-5 * max(1, abs(there)):
            faults.append(f"{name}: {mine} is {body.get(mine)}, not {there}")
    return faults


def solved(brachisto, scene, out, changes=()):
    """The rows of the trajectory of a scene."""
    sets = [word for change in changes for word in ("--set", change)]
    subprocess.run([brachisto, "solve", scene, "--out", out, "--quiet", *sets], check=False,
                   stderr=subprocess.DEVNULL)
    with open(out / "trajectory.csv", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def race_faults(brachisto, program, scenes, scratch, views):
    """At a time that is a row of one of them this one is there, and those that
    have arrived are where their tables end."""
    page = scratch / "race.html"
    subprocess.run([brachisto, "race", *scenes, "--out", page, "--quiet"], check=True)
    tables = [solved(brachisto, scene, scratch / scene.stem) for scene in scenes]
    tables.sort(key=lambda rows: float(rows[-1]["t"]))
    faults = []
    for k, view in enumerate(views):
        number = k % len(tables)
        row = tables[number][-1 - k * len(tables[number]) // (len(views) + 1)]
        name = f"race {' '.join(view)}"
        found, said = shown(program, page, row["t"], view, scratch / "home")
        faults += [f"{name}: {line}" for line in said]
        faults += place_faults(name, found.found.get(f"body-{number}", {}), row)
        for i, rows in enumerate(tables):
            end = float(rows[-1]["t"])
            if end < float(row["t"]):
                faults += place_faults(f"{name} body {i + 1}", found.found.get(f"body-{i}", {}),
                                       rows[-1])
            clock = f"{min(float(row['t']), end):.4f} s"
            if found.texts.get(f"clock-{i}") != clock:
                faults.append(f"{name}: clock {i + 1} has {found.texts.get(f'clock-{i}')}, "
                              f"not {clock}")
    return faults


def main():
    brachisto, problems = sys.argv[1], pathlib.Path(sys.argv[2])
    program = browser()
    faults = []
    views = [["--window-size=1280,1000"], ["--window-size=420,800"],
             ["--window-size=900,900", "--blink-settings=preferredColorScheme=0"],
             ["--window-size=1280,1000", "--force-prefers-reduced-motion"]]
    scenes = [("paper/fig04_reference_case.yaml", []), ("limits/coaster.yaml", []),
              ("paper/fig06_bead.yaml", []),
              ("paper/fig04_reference_case.yaml", ["scene.body.radius=0.02"])]
    with tempfile.TemporaryDirectory() as scratch:
        for number, (scene, changes) in enumerate(scenes):
            out = pathlib.Path(scratch) / f"out{number}"
            rows = solved(brachisto, problems / scene, out, changes)
            for k, view in enumerate(views):
                row = rows[(k + 1) * len(rows) // (len(views) + 1)]
                name = f"{scene} {' '.join(changes)} {' '.join(view)}"
                page, said = shown(program, out / "index.html", row["t"], view,
                                   pathlib.Path(scratch) / "home")
                faults += [f"{name}: {line}" for line in said]
                body = page.found.get("body", {})
                faults += place_faults(name, body, row)
                mark = page.found.get("contact", {})
                off = distance_to_line(float(mark.get("cx", "nan")), float(mark.get("cy", "nan")),
                                       page.found.get("track", {}).get("d", ""))
                if not off < 0.2:  # pixels
                    faults.append(f"{name}: the mark of the contact is {off} px off the track")
                if not page.texts.get("clock", "").startswith("t = "):
                    faults.append(f"{name}: no time is shown")
        faults += race_faults(brachisto, program, sorted((problems / "race").glob("*.yaml")),
                              pathlib.Path(scratch), views)
    print("\n".join(faults) if faults else f"{(len(scenes) + 1) * len(views)} views are right")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
