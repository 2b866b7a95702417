#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Theorems of all reference rows, each proven and shown again by the command.

    proof_table.py BRACHISTO                the table, on stdout
    proof_table.py BRACHISTO --write        into docs/proofs.md, and all figures into
                                            benchmarks/results/proofs.json
    proof_table.py BRACHISTO --only NAME    rows whose names contain NAME
    proof_table.py BRACHISTO --set limits   of other scenes: worlds, limits or reference

A row is tried with more bits until all statements hold. Its printed digits, those of the
reference and `estimated_error` of `solve` are compared with the bounds of the proof.
Exits with 1 if a statement does not hold or a number does not agree.
"""

import argparse
import decimal
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/documents"))

from blocks import minus, reference_rows, small, table  # noqa: E402
from generated_numbers import stamp  # noqa: E402

PAGE = ROOT / "docs/proofs.md"
RECORD = ROOT / "benchmarks/results/proofs.json"
BEGIN, END = "<!-- measured: proof_table -->\n", "<!-- end -->\n"
BITS = (160, 224, 320, 448)
# tests/paper: the references give 12 digits, closed forms 1e-15.
REFERENCE_DIGITS = {"Indirect": decimal.Decimal("1e-12"), "ClosedForm": decimal.Decimal("4e-15")}
PHYSICS = ("normal_force_positive", "no_fold", "no_loop")
Dec = decimal.Decimal
decimal.getcontext().prec = 60


# Other scenes, of which there are no references; of what is missing docs/proofs.md tells why.
WORLDS = ["worlds/bead_with_a_push", "worlds/cylinder_with_a_push", "worlds/small_planet",
          "worlds/with_drag", "worlds/inside_a_planet", "worlds/into_the_planet"]
LIMITS = ["limits/bead_with_floor", "limits/table_in_the_way"] + [
    f"limits_in_worlds/{name}" for name in (
        "drag_disc", "drag_load_bead", "drag_squared_bends", "drag_squared_floor",
        "drag_squared_half_plane_bead", "inside_fold_margin", "inside_half_plane",
        "inside_valley_bead", "planet_floor_bead", "planet_load",
        "planet_push_air_half_plane", "push_disc_bead", "push_friction", "push_hump")]
INSIDE = {"scene": {"body": {"shape": "cylinder", "radius": 0.25, "k": 0.5},
                    "finish": {"L": 3, "H": 1},
                    "field": {"sphere": {"centre": {"x": 1, "z": 6}, "radius": 9,
                                         "surface_gravity": 12}}}}


def other_rows(names):
    for name in names:
        problem = INSIDE if name == "worlds/inside_a_planet" else str(
            ROOT / f"problems/{name}.yaml")
        yield name.replace("limits_in_worlds/", "").replace("limits/", "").replace(
            "worlds/", ""), problem, None, None


def rows():
    """Name, problem, the reference's τ and its source: all references, and what the paper
    draws besides."""
    for name, problem, values, source in reference_rows():
        yield name, problem, Dec(values[0]), source
    for r in ("0.2", "0.25", "1/3", "0.4", "0.5"):
        name = f"fig11_r_{r.replace('/', '_')}_eta_m_1_3"
        yield name, str(ROOT / f"problems/paper/{name}.yaml"), None, None


def seconds_of_children():
    use = resource.getrusage(resource.RUSAGE_CHILDREN)
    return use.ru_utime + use.ru_stime


class Command:
    def __init__(self, executable, folder):
        self.executable, self.folder = str(pathlib.Path(executable).resolve()), folder

    def file(self, name, problem):
        if isinstance(problem, str):
            return problem
        path = pathlib.Path(self.folder) / f"{name}.yaml"
        path.write_text(json.dumps(problem), encoding="utf-8")  # JSON is YAML
        return str(path)

    def __call__(self, *words):
        """Exit code, JSON and seconds of processor time."""
        before = seconds_of_children()
        done = subprocess.run([self.executable, *words, "--json"], capture_output=True,
                              text=True, check=False)
        return done.returncode, json.loads(done.stdout), seconds_of_children() - before


def prove(command, name, file):
    """The first precision at which all holds, or else the best."""
    best = {"proven": False}
    for bits in BITS:
        out = pathlib.Path(command.folder) / f"{name}_{bits}"
        code, said, seconds = command("prove", file, "--bits", str(bits), "--out", str(out))
        if code != 0:
            best.setdefault("why_not", said["message"])
            continue
        holds = {key: value["holds"] for key, value in said["theorems"].items()}
        worth = sum(holds.values()), len(said["least_friction"])
        if not best["proven"] or worth > (sum(best["holds"].values()),
                                          len(best["least_friction"])):
            again, _, check_seconds = command("check-proof", str(out / "proof.json"),
                                              "--problem", file)
            tau = said["enclosures"]["tau"]
            best = {"proven": True, "bits": bits, "seconds": round(seconds, 2),
                    "check_seconds": round(check_seconds, 2), "shown_again": again == 0,
                    "tau": [tau["lower"], tau["upper"]], "holds": holds,
                    "bead": said["scene"]["shape"] == "bead",
                    "arcs": [arc.get("holds", "free") for arc in said.get("arcs", [])],
                    "refuted": [key for key, value in said["theorems"].items()
                                if value.get("refuted")],
                    "steps": said["accuracy"]["steps"],
                    "least_friction": [[each["share_of_time"], each["mu"]["lower"],
                                        each["mu"]["upper"]] for each in said["least_friction"]],
                    "why_not": {key: value["why_not"] for key, value in said["theorems"].items()
                                if "why_not" in value}}
        # A bead needs no friction; of others there are two enclosures.
        # What is refuted is known.
        open_ones = [key for key, value in said["theorems"].items()
                     if "why_not" in value and not value.get("refuted")]
        if not open_ones and (best["least_friction"] or best["bead"] or len(best["arcs"]) > 1):
            break
    return best


def distance(number, bounds):
    lower, upper = bounds
    return max(lower - number, number - upper, Dec(0))


def compare(command, file, found, reference, source):
    """How far the numbers in floating point are from the bounds."""
    bounds = [Dec(end) for end in found["tau"]]
    code, solved, _ = command("solve", file)
    off = distance(Dec(solved["tau"]), bounds)
    estimated = Dec(solved["estimated_error"]) * Dec(solved["tau"])
    out = {"width": float(bounds[1] - bounds[0]), "solve": solved["tau"],
           "solve_exit": code, "off": float(off), "estimated": float(estimated),
           "within_estimate": off <= estimated}
    told = {each["share_of_time"]: each["mu"] for each in (solved["grip"] or {}).get("least_after", [])}
    out["friction_off"] = [float(distance(Dec(told[share]), [Dec(lower), Dec(upper)]))
                           for share, lower, upper in found["least_friction"]]
    if reference is not None:
        out["reference_off"] = float(distance(reference, bounds))
        out["reference_agrees"] = out["reference_off"] <= REFERENCE_DIGITS[source]
    return out


SETS = {"reference": rows, "worlds": lambda: other_rows(WORLDS),
        "limits": lambda: other_rows(LIMITS)}


def run(command, only, of):
    record = {}
    for name, problem, reference, source in SETS[of]():
        if only not in name:
            continue
        print(name, file=sys.stderr, flush=True)
        file = command.file(name, problem)
        found = prove(command, name, file)
        if found["proven"]:
            found.update(compare(command, file, found, reference, source))
        record[name] = found
    return record


def good(row):
    return (row["proven"] and row["shown_again"] and all(row["holds"].values())
            and row["within_estimate"] and row.get("reference_agrees", True))


def said(row, names):
    missing = [name for name in names if not row["holds"].get(name)]
    return "proven" if not missing else "not: " + ", ".join(f"`{name}`" for name in missing)


def friction(row):
    """From 5 % of T on, to the digits that both ends share."""
    for share, lower, upper in row["least_friction"]:
        if share == 0.05:
            same = 0
            while same < len(lower) and lower[same] == upper[same]:
                same += 1
            return lower[:min(same, 10)]
    return "–"


def cost(row):
    """What `solve` errs by, and what the proof took."""
    sign = "≤" if row["within_estimate"] else ">"
    return [f"{small(row['off'])} {sign} {small(row['estimated'])}",
            f"{row['bits']}, {row['seconds']:.1f} s, {row['check_seconds']:.1f} s"]


def other_markdown(record):
    """Of scenes without references, in whose theorems minima may not be asked for."""
    lines = []
    for name, row in record.items():
        if not row["proven"]:
            lines.append([name, f"not proven: {row['why_not']}"] + [""] * 6)
            continue
        asked = [key for key in ("strict_minimum", "strong_minimum", "keeps_limits",
                                 "multipliers", "legendre") if key in row["holds"]]
        lines.append([
            name, ", ".join(row["arcs"]), f"[{minus(row['tau'][0])}, {minus(row['tau'][1])}]",
            small(row["width"]), said(row, asked), said(row, PHYSICS), *cost(row)])
    return table(["scene", "arcs", "τ", "width", "minimum, or limits and multipliers", "physics",
                  "`solve` against its estimate", "bits, proof, check"], lines)


def markdown(record):
    lines = []
    for name, row in record.items():
        if not row["proven"]:
            lines.append([name, f"not proven: {row['why_not']}"] + [""] * 8)
            continue
        reference = row.get("reference_off")
        lines.append([
            name, f"[{minus(row['tau'][0])}, {minus(row['tau'][1])}]", small(row["width"]),
            said(row, ["exists_once_in_box"]), said(row, ["strict_minimum", "strong_minimum"]),
            said(row, PHYSICS), friction(row),
            "–" if reference is None else small(reference), *cost(row)])
    return table(["row", "τ", "width", "exists once", "strict and strong minimum",
                  "physics", "least μ from 5 % of T on", "reference", "`solve` against its estimate", "bits, proof, check"], lines)


def write(record, of):
    begin = BEGIN if of == "reference" else f"<!-- measured: proof_table --set {of} -->\n"
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(begin)
    _, after = rest.split(END, 1)
    shown = markdown(record) if of == "reference" else other_markdown(record)
    PAGE.write_text(f"{before}{begin}{stamp()}\n\n{shown}{END}{after}", encoding="utf-8")
    recorded = RECORD if of == "reference" else RECORD.with_name(f"proofs_{of}.json")
    recorded.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--only", default="", metavar="NAME")
    parser.add_argument("--set", default="reference", choices=SETS, dest="of")
    options = parser.parse_args()
    if options.write and options.only:
        parser.error("--write wants all rows")
    with tempfile.TemporaryDirectory() as folder:
        record = run(Command(options.program, folder), options.only, options.of)
    if options.write:
        write(record, options.of)
    else:
        print((markdown if options.of == "reference" else other_markdown)(record), end="")
    if options.of != "reference":
        return 0 if record and all(row["shown_again"] and row["within_estimate"]
                                   for row in record.values() if row["proven"]) else 1
    return 0 if record and all(good(row) for row in record.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
