#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The pages with motion in a browser, Chromium without a window.

    browser.py BRACHISTO PROBLEMS

At the time that the address names the body is where trajectory.csv has it and
touches the drawn track, whatever the width of the window and the colours asked
for, and the browser has nothing to say about the page. So are all bodies of a
race, those that have arrived at B, and the body of a scene of a sweep, whose
page has a cell for each scene and tells its values. SKIPs (77) without Chromium.
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
        self.document = document
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


def height_faults(program, page, home):
    """A page is no taller than three windows, with everything folded that can be."""
    most = 3000  # px at a width of 1280
    told = ("<script>addEventListener('load', () => document.body.setAttribute("
            "'data-height', document.documentElement.scrollHeight))</script></body>")
    measured = page.with_name("measured.html")
    measured.write_text(page.read_text(encoding="utf-8").replace("</body>", told),
                        encoding="utf-8")
    found, _ = shown(program, measured, "0", ["--window-size=1280,1000"], home)
    measured.unlink()
    height = re.search(r'data-height="(\d+)"', found.document)
    if height is None or not 500 < int(height[1]) <= most:
        return [f"{page.parent.name}: {height and height[1]} px tall, not {most} at most"]
    return []


def distance_to_line(x, y, path):
    points = [tuple(map(float, p.split())) for p in re.split("[ML]", path)[1:]]
    best = math.inf
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        length = (bx - ax) ** 2 + (by - ay) ** 2
        s = 0.0 if length == 0 else ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length
        s = min(max(s, 0.0), 1.0)
        best = min(best, math.hypot(ax + s * (bx - ax) - x, ay + s * (by - ay) - y))
    return best


def place_faults(name, body, row, kept=0.0):
    """Where a body is not where the row of its table has it, and what is kept of it may be off by
    so much."""
    faults = []
    for mine, theirs in (("data-x", "x_c"), ("data-z", "z_c"), ("data-contact-x", "x_b"),
                         ("data-contact-z", "z_b"), ("data-theta", "theta")):
        if not row[theirs]:
            continue  # a bead has no θ
        there = float(row[theirs])
        # Seven digits of times, places and angles up to 10 m and rad, speeds of
        # some m/s, some hundred rad/s.
        if not abs(float(body.get(mine, "nan")) - there) < kept + 1e-5 * max(1, abs(there)):
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
            arrived = "arrived" in found.found.get(f"racer-{i}", {}).get("class", "").split()
            # Seven digits of times.
            if abs(end - float(row["t"])) > 1e-6 and arrived != (end < float(row["t"])):
                faults.append(f"{name}: result {i + 1} is {'' if arrived else 'not '}shown")
            clock = f"{min(float(row['t']), end):.4f} s"
            if found.texts.get(f"clock-{i}") != clock:
                faults.append(f"{name}: clock {i + 1} has {found.texts.get(f'clock-{i}')}, "
                              f"not {clock}")
    return faults


def sweep_faults(brachisto, program, problems, scratch, views):
    """Each scene has its cell; one that the address names tells its row and shows its body."""
    problem = problems / "sweeps" / "small.yaml"
    out = scratch / "sweep"
    subprocess.run([brachisto, "sweep", problem, "--out", out, "--quiet", "--set",
                    "sweep.keep=tracks"], check=True)
    subprocess.run([brachisto, "show", out, "--quiet"], check=True)
    with open(out / "report" / "scenes.csv", encoding="utf-8") as table:
        scenes = list(csv.DictReader(table))
    faults = height_faults(program, out / "report" / "index.html", scratch / "home")
    for k, view in enumerate(views):
        scene = scenes[(k + 1) * len(scenes) // (len(views) + 1)]
        name = f"sweep scene {scene['scene']} {' '.join(view)}"
        changes = [f"{key}={scene[key]}" for key in scene if key.startswith("scene.")]
        # The same body and finish as in the sweep.
        rows = solved(brachisto, problems / "paper" / "fig04_reference_case.yaml",
                      scratch / f"scene{scene['scene']}", changes)
        row = rows[(k + 1) * len(rows) // (len(views) + 1)]
        found, said = shown(program, out / "report" / "index.html",
                            f"{row['t']}&scene={scene['scene']}", view, scratch / "home")
        faults += [f"{name}: {line}" for line in said]
        error = float(found.texts.get("track-error", "nan").replace("−", "-"))
        # Of angles by the rim, whose radius is a third of a metre.
        faults += place_faults(name, found.found.get("body", {}), row, 3 * error)
        layer = re.search('<svg class="cells.*?</svg>', found.document, re.DOTALL)[0]
        cells = re.findall('data-scene="([0-9]+)"', layer)
        if sorted(map(int, cells)) != list(range(len(scenes))):
            faults.append(f"{name}: {len(cells)} cells of {len(scenes)} scenes")
        told = re.search(r"<dt><i>τ</i></dt><dd>([0-9.]+)</dd>", found.document)
        tau = float(scene["tau"])
        if told is None or not abs(float(told[1]) - tau) < float(scene["estimated_error"]) * tau:
            faults.append(f"{name}: τ is told as {told and told[1]}, not {tau}")
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
            faults += height_faults(program, out / "index.html", pathlib.Path(scratch) / "home")
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
        faults += sweep_faults(brachisto, program, problems, pathlib.Path(scratch), views)
    print("\n".join(faults) if faults else f"{(len(scenes) + 2) * len(views)} views are right")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
