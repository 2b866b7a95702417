#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Random scenes under limits as a maker states them, bounds in numbers of their own.

    benchmarks/limits/makers.py BRACHISTO [--count 100] [--first 0] [--out FILE.csv] [--problems FOLDER]

Bodies have radii from L/50 to L/4, friction is 0.2 to 1, and a scene has one to three limits of all kinds,
every third one a world: a push, air, a sphere's field or rolling resistance. A bound need not bite,
and not every scene has a path. Exits non-zero if a process did not end in time.
"""
import argparse, csv, json, math, os, random, resource, signal, subprocess, sys, tempfile

KINDS = ["friction", "least load", "greatest load", "hump", "valley", "fold margin", "floor", "disc", "half-plane"]


def angle(radians):
    return f"{math.degrees(radians):.4g} deg"


def scene(seed, index):
    """Number `index` of a campaign: a problem, in the words of problem files."""
    draw = random.Random(f"{seed}/{index}")
    u = draw.uniform
    H = 1.0
    L = round(u(1.0, 5.0), 3)
    r = round(L * math.exp(u(math.log(1 / 50), math.log(1 / 4))), 4)
    k = round(u(0.1, 0.9), 3)
    eta = 0.0 if u(0, 1) < 0.2 else round(u(0.0, 0.9 * math.sqrt(1.0 - k)), 3)
    body = {"shape": "cylinder", "radius": r, "eta_m": eta, "k": k}
    if eta:
        body["theta_m"] = angle(u(-math.pi / 2, math.pi / 2))
    out = {"body": body, "finish": {"L": L, "H": H}}
    limits, bends = {}, {}
    kinds = draw.sample(KINDS, draw.choice([1, 1, 2, 2, 3]))
    for kind in kinds:
        if kind == "friction":
            limits["friction"] = round(u(0.2, 1.0), 3)
        elif kind == "least load":
            limits.setdefault("normal_force", {})["min"] = round(u(0.0, 0.5), 3)
        elif kind == "greatest load":
            limits.setdefault("normal_force", {})["max"] = round(u(1.5, 4.0), 3)
        elif kind == "hump":
            bends["hump"] = round(u(0.3, 3.0) / H * min(1.0, 0.9 * H / r / 3.0), 3)
        elif kind == "valley":
            bends["valley"] = round(u(0.5, 4.0) / H, 3)
        elif kind == "fold margin":
            limits["fold_margin"] = round(u(0.05, 0.6), 3)
        elif kind == "floor":
            limits["floor"] = round(H + u(0.02, 0.8), 3)
        elif kind == "disc":
            limits.setdefault("clear_of", []).append(
                {"disc": {"x": round(u(0.3, 0.8) * L, 3), "z": round(u(0.1, 1.3) * H, 3), "radius": round(u(0.05, 0.25), 3)}})
        else:  # what slopes by up to 20° under the path
            limits.setdefault("clear_of", []).append(
                {"half_plane": {"x": round(u(0.3, 0.9) * L, 3), "z": round(H + u(0.0, 0.6), 3), "normal": angle(math.radians(-90 + u(-20, 20)))}})
    if bends:
        limits["curvature"] = {**bends, "of": "centre"}
    out["limits"] = limits
    if index % 3 == 2:
        world = draw.choice(["push", "air", "sphere", "rolling", "push and air"])
        if "push" in world:
            out["start"] = {"speed": round(u(0.2, 2.0), 3)}
        if "air" in world:
            out["air"] = {"linear": round(u(0, 0.2), 3), "quadratic": round(u(0, 0.1), 3)}
        if world == "sphere":
            out["field"] = {"sphere": {"centre": {"x": round(u(-2, 4), 2), "z": round(u(10, 20), 2)}, "radius": 6, "surface_gravity": 9.81 * 6}}
        if world == "rolling":
            out["losses"] = {"rolling": round(u(0.002, 0.03), 4)}
            if "friction" not in limits or "normal_force" in limits:
                limits.setdefault("normal_force", {}).setdefault("min", 0.0)
    if "hump" in bends and bends["hump"] < 1 / r and ("valley" in bends or "max" in limits.get("normal_force", {})) and u(0, 1) < 0.5:
        out["contact"] = "optimal"
    return {"scene": out}


def fate(status, result):
    if status == -signal.SIGXCPU:
        return "out of time"
    if result is None:
        return "lost"
    if result.get("status") == "solved":
        return "verified" if result["verified"] else "not verified"
    if result["status"] in ("bad_input", "no_admissible_path", "no_fastest_track"):
        return "refused"
    return result["status"] + (", relaxed" if result.get("relaxed") else "")


def run(binary, problem, limit, path):
    with open(path, "w") as file:
        json.dump(problem, file)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([binary, "solve", path, "--json"], capture_output=True, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - used.ru_utime - used.ru_stime
    try:
        result = json.loads(done.stdout)
    except ValueError:
        result = None
    message = (result or {}).get("message") or done.stderr.strip().splitlines()[-1:] or ""
    relaxed = (result or {}).get("relaxed") or {}
    return {"fate": fate(done.returncode, result), "exit": done.returncode,
            "tau": (result or {}).get("tau"), "estimated_error": (result or {}).get("estimated_error"), "seconds": round(cpu, 2),
            "relaxed": json.dumps(relaxed.get("limits")) if relaxed else "", "message": message}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", help="numbers of scenes, with commas between")
    parser.add_argument("--seconds", type=float, default=60, help="of a processor, for one scene")
    parser.add_argument("--out", default="makers.csv")
    parser.add_argument("--problems", help="folder that keeps their files")
    options = parser.parse_args()
    folder = options.problems or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    numbers = [int(i) for i in options.only.split(",")] if options.only else range(options.first, options.first + options.count)
    fates = {}
    with open(options.out, "w", newline="") as file:
        table = None
        for i in numbers:
            problem = scene(options.seed, i)
            row = {"scene": i, **run(options.binary, problem, options.seconds, f"{folder}/{i}.yaml")}
            row["problem"] = json.dumps(problem["scene"])
            if table is None:
                table = csv.DictWriter(file, row.keys())
                table.writeheader()
            table.writerow(row)
            file.flush()
            fates[row["fate"]] = fates.get(row["fate"], 0) + 1
    for name, number in sorted(fates.items(), key=lambda item: -item[1]):
        print(f"{number:>5} {name}")
    return 1 if fates.get("lost") or fates.get("out of time") else 0


if __name__ == "__main__":
    sys.exit(main())
