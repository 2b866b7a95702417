#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The DXF of tracks to be built, read by ezdxf (Debian: python3-ezdxf).

    sheets.py BRACHISTO PROBLEMS

Of each scene of problems/build, with and without rails, a ball with its own, and of two coasters: units, layers and sizes are as
docs/building.md says, and pieces joined, each turned until the word "level" on it is level, are as
long as the track of the result and end at B. Without ezdxf it ends with 77, which skips the test; tests/report reads the same text by its own reader.
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import ezdxf
except ImportError:
    print("there is no ezdxf (Debian: python3-ezdxf)")
    sys.exit(77)

MILLIMETRES = 4
NUMBER = re.compile(r"(\d+)([LR]?) of (\d+) -> B")
# Chords are within 0.005 mm of the track.
ALLOWED = 0.05


def within(p, area):
    inside = False
    for a, b in zip(area, area[1:] + area[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]) and \
                p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]):
            inside = not inside
    return inside


def length(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


def hanging(points, degrees):
    """Turned back to how they hang."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(c * x + s * y, c * y - s * x) for x, y in points]


def corners(polyline):
    return [(p[0], p[1]) for p in polyline.points()]


def read(path, sheet, wrong):
    """The rolled edges of a file by side and number; objections go to `wrong`."""
    drawing = ezdxf.readfile(path)
    if drawing.header.get("$INSUNITS") != MILLIMETRES:
        wrong.append(f"{path.name}: the unit is {drawing.header.get('$INSUNITS')}")
    errors = drawing.audit().errors
    if errors:
        wrong.append(f"{path.name}: {errors[0].message}")
    space = drawing.modelspace()
    places = []
    for entity in space:
        if entity.dxf.layer not in ("CUT", "ENGRAVE"):
            wrong.append(f"{path.name}: layer {entity.dxf.layer}")
        if entity.dxf.layer == "CUT" and path.name.startswith("assembly"):
            wrong.append(f"{path.name}: cuts")
        if entity.dxftype() == "POLYLINE":
            places += corners(entity)
        elif entity.dxftype() == "CIRCLE":
            (x, y, _), r = entity.dxf.center, entity.dxf.radius
            places += [(x - r, y - r), (x + r, y + r)]
        else:
            places.append(tuple(entity.dxf.insert)[:2])
    for x, y in places:
        if not (0 <= x <= sheet[0] and 0 <= y <= sheet[1]):
            wrong.append(f"{path.name}: ({x}, {y}) is outside the sheet")
    outlines = [corners(e) for e in space.query('POLYLINE[layer=="CUT"]')]
    edges = {}
    for words in space.query("TEXT"):
        match = NUMBER.fullmatch(words.dxf.text)
        if match:
            at = tuple(words.dxf.insert)[:2]
            outline = next(area for area in outlines if within(at, area))
            level = next(mark for mark in space.query('TEXT[text=="level"]')
                         if within(tuple(mark.dxf.insert)[:2], outline))
            edges[match[2], int(match[1])] = hanging(outline[:len(outline) // 2],
                                                     level.dxf.rotation)
    return edges


def check(command, problem, flags, sheet, scale, wrong):
    with tempfile.TemporaryDirectory() as scratch:
        done = subprocess.run(
            [command, "solve", str(problem), "--json", "--track-dxf", scratch,
             "--sheet", f"{sheet[0]}x{sheet[1]}", "--scale", scale, *flags],
            capture_output=True, text=True, check=True)
        result = json.loads(done.stdout)
        edges = {}
        for path in sorted(pathlib.Path(scratch).glob("*.dxf")):
            edges.update(read(path, sheet, wrong))
    built, of = (float(number) for number in scale.split(":"))
    expected = 1e3 * built / of * result["rail_length"]
    for side in sorted({side for side, _ in edges}):
        lengths = [length(edges[key]) for key in sorted(edges) if key[0] == side]
        if abs(sum(lengths) - expected) > ALLOWED:
            wrong.append(f"{problem.name} {side}: {sum(lengths)} mm of {expected}")
        pieces = [edges[key] for key in sorted(edges) if key[0] == side]
        end = [sum(piece[-1][i] - piece[0][i] for piece in pieces) for i in (0, 1)]
        at_b = math.dist(end, [1e3 * built / of * result["scene"]["finish"]["L"],
                               -1e3 * built / of * result["scene"]["finish"]["H"]])
        if at_b > ALLOWED:
            wrong.append(f"{problem.name} {side}: it ends {at_b} mm from B")
        if min(lengths) < 0.5 * max(lengths):
            wrong.append(f"{problem.name} {side}: pieces of {lengths} mm")
        print(f"{problem.name} {scale} {side}: {len(lengths)} pieces, "
              f"{sum(lengths) - expected:+.4f} mm of {expected:.3f}, "
              f"{at_b:.4f} mm from B")
    if not edges:
        wrong.append(f"{problem.name}: no pieces")


def main():
    command, problems = sys.argv[1], pathlib.Path(sys.argv[2])
    wrong = []
    ball = problems / "build/ball_on_rails.yaml"
    of_ball = ["--strip", "30", "--hole", "4", "--rails"]
    check(command, ball, [*of_ball, "10"], (297, 210), "1:1", wrong)
    check(command, ball, [*of_ball, "5"], (297, 210), "1:2", wrong)
    for problem in sorted((problems / "build").glob("*.yaml")):
        if problem == ball:
            continue
        check(command, problem, [], (600, 400), "1:1", wrong)
        check(command, problem, ["--rails", "15", "--strip", "30", "--hole", "4"],
              (297, 210), "1:1", wrong)
        check(command, problem, ["--strip", "12", "--hole", "2"], (297, 210), "1:3", wrong)
    check(command, problems / "limits/coaster.yaml", [], (600, 400), "1:5", wrong)
    check(command, problems / "limits/coaster_with_a_push.yaml", [], (1200, 800), "1:1", wrong)
    for objection in wrong:
        print(objection)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
