# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Tables of the documents that take seconds: a function of the program for each."""

import pathlib
import re

SUPPORT = pathlib.Path(__file__).resolve().parents[1] / "support"
LIMITS_IN_WORLDS = SUPPORT.parents[1] / "problems/limits_in_worlds"
LOSSES = SUPPORT.parents[1] / "problems/losses"


def minus(text):
    """With a real minus sign, and none before a zero."""
    zero = text.startswith("-") and not text.strip("-0.")
    return text.replace("-", "" if zero else "−")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def scene(L=3, *, bead=False, eta_m=2 / 3, theta_m=0, k=0.5, r=1 / 3, **more):
    body = ({"shape": "bead"} if bead else
            {"shape": "cylinder", "radius": r, "eta_m": eta_m, "theta_m": theta_m, "k": k})
    return {"scene": {"body": body, "finish": {"L": L, "H": 1}, **more}}


def small(number, digits=0):
    """An error or a difference by its first digit."""
    if number == 0:
        return "0"
    mantissa, exponent = f"{number:.{digits}e}".split("e")
    return f"{minus(mantissa)}e{int(exponent)}"


# --- docs/validation.md, values computed outside this project ---------------

def reference_rows():
    """The values of tests/support/reference_values.hpp, by name."""
    text = (SUPPORT / "reference_values.hpp").read_text(encoding="utf-8")
    pattern = r'ReferenceValue\{\s*"([^"]+)",\s*Shape::(\w+),([^}]*?)Source::(\w+)\}'
    for name, shape, numbers, source in re.findall(pattern, text):
        L, r, eta, theta, k, *values = [part.strip() for part in numbers.split(",")][:10]
        problem = scene(float(L), bead=shape == "Bead", r=float(r), eta_m=float(eta),
                        theta_m=float(theta), k=float(k))
        yield name, problem, values, source


def reference_values(program):
    rows, names = [], list(reference_rows())
    answers = program.solve_all([problem for _, problem, _, _ in names])
    for (name, _, values, source), answer in zip(names, answers):
        tau, centre, track, first, last = values
        keys = ("tau", "centre_path_length", "rail_length", "start_angle", "end_angle")
        # What the tests demand of the program: 1e-9 of τ, 1e-7 of the others.
        for key, reference in zip(keys, values):
            if abs(answer[key] - float(reference)) > (1e-9 if key == "tau" else 1e-7):
                raise RuntimeError(f"{name}: {key} is {answer[key]}, not {reference}")
        rows.append([name, tau] + [f"{float(x):.10f}" for x in (centre, track, first, last)])
    return table(["case", "τ", "centre path", "track", "β₀", "β_end"], rows)


# --- docs/validation.md and docs/theory.md, limits --------------------------

def curvature(**bounds):
    return {"curvature": {**bounds, "of": "centre"}}


# name in tests/support/limited_scenes.hpp, body, contact, limit in words, limits,
# source: (b) marks what a third method confirmed on a coarser mesh only
LIMITED = [
    ("friction_3", "reference", "smooth", "μ = 3", {"friction": 3}, ""),
    ("friction_1", "reference", "smooth", "μ = 1", {"friction": 1}, ""),
    ("friction_0.6", "reference", "smooth", "μ = 0.6", {"friction": 0.6}, ""),
    ("friction_0.5", "reference", "smooth", "μ = 0.5", {"friction": 0.5}, ""),
    ("friction_0.3", "reference", "smooth", "μ = 0.3", {"friction": 0.3}, ""),
    ("normal_min_0.1", "reference", "smooth", "R_n ≥ 0.1", {"normal_force": {"min": 0.1}}, ""),
    ("valley_4", "reference", "smooth", "K_v = 4", curvature(valley=4), ""),
    ("valley_2", "reference", "smooth", "K_v = 2", curvature(valley=2), " (b)"),
    ("floor_0.9", "reference", "smooth", "z_c ≤ 0.9", {"floor": 0.9 + 1 / 3}, ""),
    ("floor_0.8", "reference", "smooth", "z_c ≤ 0.8", {"floor": 0.8 + 1 / 3}, " (b)"),
    ("optimal_K2", "reference", "optimal", "K_h = 2, K_v = 2", curvature(hump=2, valley=2), ""),
    ("optimal_K4", "reference", "optimal", "K_h = 2.9, K_v = 4",
     curvature(hump=2.9, valley=4), ""),
    ("optimal_uniform_K2", "uniform", "optimal", "K_h = 2, K_v = 2",
     curvature(hump=2, valley=2), ""),
    ("uniform_friction_1", "uniform", "smooth", "μ = 1", {"friction": 1}, None),
    ("uniform_friction_0.5", "uniform", "smooth", "μ = 0.5", {"friction": 0.5}, None),
    ("uniform_friction_0.3", "uniform", "smooth", "μ = 0.3", {"friction": 0.3}, None),
    ("uniform_normal_min_0.1", "uniform", "smooth", "R_n ≥ 0.1",
     {"normal_force": {"min": 0.1}}, None),
    ("uniform_floor_1.1", "uniform", "smooth", "floor 1.1", {"floor": 1.1}, None),
    ("bead_floor_1.0", "bead", "–", "floor 1.0", {"floor": 1}, None),
    ("bead_floor_1.1", "bead", "–", "floor 1.1", {"floor": 1.1}, None),
    ("bead_normal_min_0.1", "bead", "–", "R_n ≥ 0.1", {"normal_force": {"min": 0.1}}, None),
]
ARC_NAMES = {"friction": "μ", "normal_force.min": "R_n", "normal_force.max": "load",
             "curvature.hump": "hump", "curvature.valley": "valley", "fold_margin": "fold",
             "floor": "floor", "clear_of.disc": "disc", "clear_of.half_plane": "board"}


def limited_scene(body, contact, limits, **changes):
    kind = {"reference": {}, "uniform": {"eta_m": 0}, "bead": {"bead": True}}[body]
    more = {"contact": contact} if contact == "optimal" else {}
    return scene(**kind, limits=limits, **more, **changes)


def arcs_in_words(answer):
    """μ–free–…: two arcs of one limit that touch are counted as one."""
    spans = sorted((span["t"]["from"], span["t"]["to"], limit["name"])
                   for limit in answer["limits"] for span in limit["active"])
    touching = 1e-9  # seconds
    words, at = [], 0.0
    for begin, end, name in spans:
        if begin - at > touching:
            words.append("free")
        short = ARC_NAMES[name]
        if not words or words[-1] != short:
            words.append(short)
        at = end
    if answer["transit_time"] - at > touching:
        words.append("free")
    return "–".join(words)


def limited_tracks(program):
    text = (SUPPORT / "limited_scenes.hpp").read_text(encoding="utf-8")
    problems = [limited_scene(body, contact, limits)
                for _, body, contact, _, limits, _ in LIMITED]
    answers = program.solve_all(problems, "--certify", "extremal")
    rows = []
    for (name, body, contact, words, _, mark), answer in zip(LIMITED, answers):
        digits = re.search(rf'"{re.escape(name)}",.*?(\d\.\d{{12}})', text, re.S).group(1)
        tau = answer["tau"]
        difference = tau - float(digits)
        # Half a unit of the last digit of the reference is no difference.
        difference = 0 if abs(difference) <= 0.5e-12 else difference
        rows.append([body, contact, words, digits, f"{tau:.12f}", small(difference),
                     small(tau - answer["extremal"]["tau"]), minus(f"{answer['end_angle']:.9f}"),
                     arcs_in_words(answer),
                     "closed form" if mark is None else "indirect, over arcs" + mark])
    return table(["body", "contact", "limit", "τ, reference", "τ, here", "difference",
                  "τ − indirect", "φ", "arcs", "source"], rows)


def tau_over_friction(program):
    bounds = [3, 1, 0.6, 0.5, 0.3]
    problems = [scene()] + [scene(limits={"friction": mu}) for mu in bounds]
    answers = program.solve_all(problems)
    return table([r"$\mu$", r"$\infty$"] + [str(mu) for mu in bounds],
                 [[r"$\tau$, smooth contact"] + [f"{one['tau']:.4f}" for one in answers]])


# scene, bound, limits of a bound, the bound, digits of the two prices
PRICES = [
    ("reference", r"$\mu=1$", lambda b: {"friction": b}, 1.0, 4, 6),
    ("", r"$\mu=0.6$", lambda b: {"friction": b}, 0.6, 4, 5),
    ("", r"$\mu=0.5$", lambda b: {"friction": b}, 0.5, 3, 5),
    ("", r"$\mu=0.3$", lambda b: {"friction": b}, 0.3, 3, 5),
    ("", r"$R_n\ge0.1$", lambda b: {"normal_force": {"min": b}}, 0.1, 4, 5),
    ("", r"valley, $K_v=4$", lambda b: curvature(valley=b), 4.0, 6, 6),
    ("", r"$z_c\le0.9$", lambda b: {"floor": b}, 0.9 + 1 / 3, 4, 4),
    ("uniform cylinder", r"$\mu=0.5$", lambda b: {"friction": b}, 0.5, 3, 5),
    ("", r"$R_n\ge0.1$", lambda b: {"normal_force": {"min": b}}, 0.1, 4, 5),
]
# Central differences of fourth order, of τ known to 1e-13.
STENCIL = ((-2, 1 / 12), (-1, -8 / 12), (1, 8 / 12), (2, -1 / 12))


def prices(program):
    problems, body = [], "reference"
    step = 0.004
    for kind, _, limits, bound, *_ in PRICES:
        body = {"reference": "reference", "uniform cylinder": "uniform", "": body}[kind]
        places = [bound] + [bound * (1 + step * i) for i, _ in STENCIL]
        problems += [limited_scene(body, "smooth", limits(place)) for place in places]
    answers = program.solve_all(problems)
    rows = []
    for i, (kind, words, _, bound, held, moving) in enumerate(PRICES):
        here, *beside = answers[5 * i:5 * i + 5]
        limit = here["limits"][0]
        slope = sum(c * one["tau"] for (_, c), one in zip(STENCIL, beside)) / (step * bound)
        rows.append([kind, words, minus(f"{limit['price_at_fixed_contacts']:.{held}f}"),
                     minus(f"{limit['price']:.{moving}f}"), minus(f"{slope:.{moving}f}")])
    return table(["scene, smooth contact", "bound", "contacts held", "all moving",
                  r"difference of $\tau$"], rows)


# --- docs/validation.md, derivatives ----------------------------------------

QUANTITIES = ("eta_m", "theta_m", "k", "radius", "L", "H")
HEAD = ["", "dτ/dη_m", "dτ/dθ_m", "dτ/dk", "dτ/dr", "dτ/dL", "dτ/dH"]


def rate_rows(answer, name, held):
    """Total derivatives, and at fixed contacts with so many decimals."""
    rates = answer["sensitivities"]

    def row(key, digits):
        return [minus(f"{rates[q][key]:.{digits}f}") for q in QUANTITIES]
    return [[name + ", total"] + row("tau", 8),
            ["at fixed contacts"] + row("tau_at_fixed_contacts", held)]


def sensitivities(program):
    rows = []
    # Under a limit that holds at rest the share of the slope at A depends on the mesh.
    for file, name, held in (("paper/fig04_reference_case.yaml", "reference", 8),
                             ("limits/friction_1.yaml", "μ = 1", 4),
                             ("worlds/cylinder_with_a_push.yaml",
                              "`cylinder_with_a_push`", 8)):
        rows += rate_rows(program.solve(file, "--set", "solver.sensitivities=true"), name,
                          held)
    return table(HEAD, rows)


# --- docs/validation.md, straight pieces ------------------------------------

PIECE_CASES = ("bead_L3", "uniform_L3", "reference_case", "theta_-30", "theta_60", "fast")
PIECES = (50, 100, 200, 400, 800, 1600, 3200)


def straight_pieces(program):
    known = {name: (problem, float(values[0])) for name, problem, values, _ in reference_rows()}
    problems = [{**known[name][0],
                 "discretisation": {"formulation": "arc_length", "elements": N}}
                for N in PIECES for name in PIECE_CASES]
    # Pieces have forces that are those of chords: some are judged infeasible.
    answers = iter(program.solve_all(problems, may_fail=True))
    rows = []
    for N in PIECES:
        row = [str(N)]
        for name in PIECE_CASES:
            answer = next(answers)
            error = answer["tau"] / known[name][1] - 1
            row.append(f"{small(error, 2)} ({answer['estimated_error'] / abs(error):.1f})")
        rows.append(row)
    return table(["N", *PIECE_CASES], rows)


# --- docs/validation.md, other worlds ---------------------------------------

WORLDS = ("bead_with_a_push", "cylinder_with_a_push", "gravity_train", "into_the_planet",
          "small_planet", "with_drag")


def worlds(program):
    files = [f"worlds/{name}.yaml" for name in WORLDS]
    by_program = program.solve_all(files)
    by_shooting = program.solve_all(files, "--set", "solver.method=extremal")
    rows = [[f"`{name}`", f"{shot['tau']:.12f}", small(abs(one["tau"] / shot["tau"] - 1), 1)]
            for name, one, shot in zip(WORLDS, by_program, by_shooting)]
    return table(["scene", "τ", "difference"], rows)


def limits_in_worlds(program):
    return with_witness(program, LIMITS_IN_WORLDS)


def losses(program):
    return with_witness(program, LOSSES)


def with_witness(program, folder):
    """A folder of limited scenes by the program, with its witness."""
    names = sorted(path.stem for path in folder.glob("*.yaml"))
    answers = program.solve_all([f"{folder.name}/{name}.yaml" for name in names],
                                "--certify", "extremal", may_fail=True)
    rows = []
    for name, answer in zip(names, answers):
        checks = answer["certificate"]["checks"]
        value = {check["name"]: check["value"] for check in checks}
        # Of the reasons the words, not the numbers.
        reasons = [reason.split(":")[0] for reason in answer["infeasible_because"]]
        rows.append([f"`{name}`", arcs_in_words(answer), f"{answer['tau']:.12f}",
                     small(value["extremal"]), small(value["kkt_residual"]),
                     small(value["reintegration_error"]),
                     f"{sum(check['passed'] for check in checks)} of {len(checks)}",
                     ", ".join(reasons) or "yes"])
    return table(["scene", "arcs", "τ", "indirect", "residual", "integrated again", "checks",
                  "can be rolled on"], rows)


BLOCKS = {maker.__name__: maker for maker in (
    reference_values, limited_tracks, tau_over_friction, prices, sensitivities,
    straight_pieces, worlds, limits_in_worlds, losses)}
