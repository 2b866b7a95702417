# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The input of compare.py."""

import dataclasses
import math
import pathlib
import random

PROBLEMS = pathlib.Path(__file__).resolve().parents[2] / "problems"
TOO_LONG = {"million_nodes.yaml", "million_pieces.yaml", "L_200.yaml", "r_0.0002.yaml"}


@dataclasses.dataclass
class Case:
    name: str
    arguments: list
    files: dict = dataclasses.field(default_factory=dict)
    then: list = dataclasses.field(default_factory=list)  # further commands


def solve(name, text, *flags):
    return Case(name, ["solve", "case.yaml", "--json", *flags], {"case.yaml": text.encode()})


def of_problems():
    for path in sorted(PROBLEMS.rglob("*.yaml")):
        if path.name in TOO_LONG:
            continue
        name = "problems/" + path.relative_to(PROBLEMS).as_posix()
        files = {"case.yaml": path.read_bytes()}
        yield Case(name + " validate", ["validate", "case.yaml", "--json"], files)
        if "sweeps" in path.parts:
            if path.name == "small.yaml":
                yield Case(name, ["sweep", "case.yaml", "--out", "out", "--quiet"], files)
            continue
        yield Case(name, ["solve", "case.yaml", "--json", "--out", "out"], files)
        yield Case(name + " summary", ["solve", "case.yaml"], files)


def of_memory():
    """More than any machine has."""
    yield solve("memory/turns", "scene: {body: {shape: cylinder, radius: 1e-9, eta_m: 0.5, k: 0.5}, "
                                "finish: {L: 3, H: 1}}\n")


def number(value):
    return repr(value)


def random_case(index, seed):
    """A scene that is a function of its index alone."""
    draw = random.Random(f"{seed}/{index}")
    uniform = draw.uniform
    contact = "centre" if draw.random() < 0.1 else "smooth"
    kind = draw.random()
    if kind < 0.08:
        body = "{shape: bead}"
        r = 0.0
    else:
        r = math.exp(uniform(math.log(0.08), math.log(0.8)))
        k = uniform(0.0, 1.0) if kind < 0.9 else draw.choice([0.0, 0.5, 1.0])
        eta = 0.0 if kind < 0.18 else uniform(0.0, 0.98 * math.sqrt(1.0 - k))
        theta_m = uniform(-math.pi, math.pi) if draw.random() < 0.7 else 0.0
        body = (f"{{shape: cylinder, radius: {number(r)}, eta_m: {number(eta)}, "
                f"theta_m: {number(theta_m)}, k: {number(k)}}}")
    L = math.exp(uniform(math.log(0.6), math.log(12.0)))
    H = 1.0 if draw.random() < 0.6 else math.exp(uniform(math.log(0.3), math.log(4.0)))
    lines = ["scene:", f"  body: {body}", f"  finish: {{L: {number(L)}, H: {number(H)}}}",
             f"  contact: {contact}"]
    if draw.random() < 0.2:
        lines.append(f"  gravity: {number(uniform(1.0, 25.0))}")
    way = draw.random()
    if way < 0.5:
        pass
    elif way < 0.58:
        shape = draw.choice(["straight", "parabola", "circular_arc", "cycloid"])
        curve = draw.choice(["centre", "track"])
        lines.append(f"  path: {{curve: {curve}, shape: {shape}}}")
    elif way < 0.68:
        lines.append(f"discretisation: {{tolerance: 1e-{draw.randint(4, 12)}}}")
    elif way < 0.76:
        lines.append(f"discretisation: {{degree: {draw.randint(1, 8)}, "
                     f"elements: {draw.randint(2, 60)}}}")
    elif way < 0.82:
        lines.append("discretisation: {formulation: arc_length, "
                     f"elements: {draw.randint(20, 800)}}}")
    elif way < 0.85:
        lines.append("solver: {method: newton_kkt}")
    elif way < 0.9:
        lines.append("solver: {method: extremal}")
    elif way < 0.95:
        lines.append("solver: {certify: extremal}")
    elif way < 0.97:
        lines.append("solver: {linear_solver: mumps, polish: false}")
    elif way < 0.99:
        lines.append(f"solver: {{guess: random, seed: {draw.randint(1, 9)}}}")
    else:
        lines.append(f"discretisation: {{nodes: {draw.randint(10, 60)}}}")
        lines.append("solver: {method: fsolve, fsolve: {variant: "
                     f"{draw.choice(['hybrid', 'newton', 'lifted'])}, datum: rest}}}}")
    # Some extremals are left to their tables.
    flags = ["--out", "out"] if draw.random() < 0.25 else []
    return solve(f"random/{index}", "\n".join(lines) + "\n", *flags)


GOOD = """version: 1
scene:
  body: {shape: cylinder, radius: 1/3, eta_m: 2/3, theta_m: -30 deg, k: 1/2}
  finish: {L: 3, H: 1}
  gravity: 9.81
  contact: smooth
discretisation:
  formulation: rolling_time
  degree: 5
  elements: 40
solver:
  method: ipopt
  limits: {iterations: 500, seconds: 60}
"""

REPLACED = [
    ("k: 1/2", "k: 3/5"), ("k: 1/2", "k: -1"), ("k: 1/2", "k: nan"), ("k: 1/2", "k: 1/0"),
    ("k: 1/2", "k: [1]"), ("k: 1/2", "k: {a: 1}"), ("k: 1/2", "k:"), ("k: 1/2", "k: 2,3"),
    ("k: 1/2", "k: 1/2, k: 1/3"), ("k: 1/2", "kk: 1/2"), (", k: 1/2", ""),
    ("radius: 1/3", "radius: 0"), ("radius: 1/3", "radius: 1/3 m"), ("radius", "raduis"),
    ("shape: cylinder", "shape: cilinder"), ("shape: cylinder", "shape: bead"),
    ("shape: cylinder, ", ""), ("theta_m: -30 deg", "theta_m: -30 degrees"),
    ("theta_m: -30 deg", "theta_m: 90-60 deg"), ("eta_m: 2/3", "eta_m: 1"),
    ("eta_m: 2/3", "eta_m: sqrt(2)"), ("eta_m: 2/3", "eta_m: foo(2)"), ("L: 3", "L: 0"),
    ("L: 3", "L: inf"), ("L: 3", "L: -3"), ("H: 1", "H: 0"), ("H: 1}", "H: 1, W: 2}"),
    ("finish: {L: 3, H: 1}", "finish: 3"), ("  finish: {L: 3, H: 1}\n", ""),
    ("finish", "finsh"), ("gravity: 9.81", "gravity: 0"), ("gravity: 9.81", "mass: 2"),
    ("contact: smooth", "contact: rough"), ("contact: smooth", "contact: [smooth]"),
    ("version: 1", "version: 2"), ("version: 1", "version: one"), ("scene:", "szene:"),
    ("degree: 5", "degree: 9"), ("degree: 5", "degree: 2.5"), ("degree: 5", "degree: 0"),
    ("elements: 40", "elements: 40\n  nodes: 201"), ("elements: 40", "nodes: 200"),
    ("elements: 40", "elements: 0"), ("elements: 40", "elements: 1e99"),
    ("formulation: rolling_time", "formulation: arc_length"),
    ("formulation: rolling_time", "formulation: rolling"),
    ("degree: 5\n  elements: 40", "tolerance: 1e-16"), ("method: ipopt", "method: ipot"),
    ("method: ipopt", "method: extremal"), ("method: ipopt", "method: fsolve"),
    ("method: ipopt", "method: newton_kkt\n  guess: straight"),
    ("method: ipopt", "search: global\n  certify: extremal\n  guess: random"),
    ("method: ipopt", "fsolve: {epsilon: 0.01}"), ("method: ipopt", "linear_solver: ma57"),
    ("iterations: 500", "iterations: -1"), ("seconds: 60", "seconds: 0"),
    ("seconds: 60", "seconds: 1e400"), ("limits", "limit"), ("solver:", "solver: 1 #"),
    ("solver:", "discretisation:"), ("gravity: 9.81", "path: {shape: spiral}"),
    ("gravity: 9.81", "path: {shape: points}"), ("gravity: 9.81", "path: {curve: track}"),
    ("gravity: 9.81", "path: {shape: straight, start_angle: 1}"),
    ("scene:", "scene: &a"), ("gravity: 9.81", "gravity: *a"), ("gravity: 9.81", "gravity: !x 1"),
    ("solver:", "---\nsolver:"), ("solver:", "sweep: {scene.gravity: [1, 2]}\nsolver:"),
    ("solver:", "constraints: {}\nsolver:"), ("solver:", "\tsolver:"), ("solver:", "solver: {"),
]

SWEEPS = [
    "sweep: {}", "sweep: 1", "sweep: {scene.body.eta_m: {from: 0, to: 1}}",
    "sweep: {scene.body.eta_m: {from: 0, to: 1/2, count: 0}}",
    "sweep: {scene.body.eta: [0, 1/2]}", "sweep: {scene.body.eta_m: [0, x]}",
    "sweep: {scene.body.eta_m: {from: 0, to: sqrt(1-k), count: 3, spacing: lin}}",
    "sweep: {scene.body.eta_m: [0, 2]}", "sweep: {scene.body: [1]}",
    "sweep: {random: {count: 2, ranges: {scene.finish.L: [1, 2]}}}",
    "sweep: {random: {seed: 1, count: 2, ranges: {scene.finish.L: [2]}}}",
    "sweep: {zip: [scene.finish.L, scene.finish.H]}",
    "sweep: {zip: {scene.finish.L: [1, 2], scene.finish.H: [1]}}",
    "sweep: {scene.body.k: {from: 0, to: eta_m, count: 2}, scene.body.eta_m: {from: k, to: 1}}",
]


def refused():
    for i, (old, new) in enumerate(REPLACED):
        text = GOOD.replace(old, new, 1).encode()
        yield Case(f"refused/{i} {new[:24]!r}", ["validate", "case.yaml"], {"case.yaml": text})
        if i % 4 == 0:
            yield Case(f"refused/{i} json", ["solve", "case.yaml", "--json"], {"case.yaml": text})
    for i, section in enumerate(SWEEPS):
        text = (GOOD + section + "\n").encode()
        yield Case(f"refused/sweep {i}", ["validate", "case.yaml"], {"case.yaml": text})
    draw = random.Random("bytes")
    for i in range(150):
        text = bytearray(GOOD.encode())
        for _ in range(draw.randint(1, 3)):
            at = draw.randrange(len(text))
            if draw.random() < 0.5:
                del text[at:at + draw.randint(1, 6)]
            else:
                text[at:at] = bytes(draw.choice(b"{}[]:,#&*!|>'\"%@`- \n\t\0x1\xff")
                                    for _ in range(draw.randint(1, 3)))
        yield Case(f"refused/bytes {i}", ["validate", "case.yaml"], {"case.yaml": bytes(text)})
    good = {"case.yaml": GOOD.encode()}
    for i, setting in enumerate(["scene.body.k=2", "scene.body.q=1", "scene=1", "k", "=", "",
                                 "scene.finish.L=1/3", "solver.method=fsolve"]):
        yield Case(f"refused/set {i}", ["validate", "case.yaml", "--set", setting], good)


def verbs():
    good = {"case.yaml": GOOD.encode()}
    yield Case("verbs/validate", ["validate", "case.yaml"], good)
    yield Case("verbs/body", ["body", "ring:m=2", "point:m=1,at=1@-30deg"])
    yield Case("verbs/body json", ["body", "--json", "disc:m=2,hole=1/2", "rod:from=0@0,to=1@1"])
    yield Case("verbs/body wrong", ["body", "rings:m=2"])
    # The principal extremal is a saddle: refused, with advice.
    saddle = ("scene: {body: {shape: cylinder, radius: 0.38522, eta_m: 0.63445, theta_m: -1.2318, "
              "k: 0.50532}, finish: {L: 2.9236, H: 1}}\n")
    yield Case("verbs/saddle", ["solve", "case.yaml"], {"case.yaml": saddle.encode()})
    yield solve("verbs/saddle json", saddle)
    points = "x,z\n" + "".join(f"{3 * i / 40},{(i / 40) ** 0.5}\n" for i in range(41))
    yield Case("verbs/points", ["solve", "case.yaml", "--json", "--out", "out"], {
        "p.csv": points.encode(),
        "case.yaml": b"scene: {body: {shape: bead}, finish: {L: 3, H: 1}, "
                     b"path: {curve: track, shape: points, file: p.csv}}\n"})
    small = (PROBLEMS / "sweeps" / "small.yaml").read_bytes()
    yield Case("verbs/sweep", ["sweep", "case.yaml", "--out", "out"], {"case.yaml": small},
               [["export", "out", "--csv"], ["export", "out", "--json"], ["report", "out"],
                ["sweep", "case.yaml", "--out", "out"],
                ["sweep", "case.yaml", "--out", "out", "--resume"]])
    yield Case("verbs/compare", ["compare", "case.yaml", "--nodes", "25", "--json"],
               {"case.yaml": GOOD.replace("  degree: 5\n  elements: 40\n", "").encode()})
    base = (PROBLEMS / "work_precision" / "bead.yaml").read_bytes()
    yield Case("verbs/paper", ["paper", "--out", "out", "--quiet"])
    yield Case("verbs/validate work_precision", ["validate", "case.yaml", "--json"],
               {"case.yaml": base})


def all_cases(seed, count):
    return [*of_problems(), *of_memory(), *refused(), *verbs(),
            *(random_case(i, seed) for i in range(count))]
