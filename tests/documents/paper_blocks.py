# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Tables of docs/validation.md from the output of brachisto paper --json."""

import json

from blocks import minus, table

NAMES = ("paper_numbers", "paper_statements")


def spelled(text):
    """Rich text as Markdown has it; a bar would end the cell."""
    return text.replace("|", "\\|")


def numbers(document):
    rows = []
    for one in document["comparisons"]:
        printed = float(one["paper"].replace("−", "-"))
        # As many digits as are known, at most ten.
        digits = 12 if one["error"] < 5e-13 else 10 if one["error"] < 5e-11 else 6
        unit = f" {one['unit']}" if one["unit"] else ""
        off = "agrees" if one["agrees"] else minus(f"{100 * (one['ours'] / printed - 1):+.1f} %")
        if not one["agrees"] and abs(one["ours"] / printed - 1) < 5e-4:
            off = minus(f"{100 * (one['ours'] / printed - 1):+.2f} %")
        rows.append([one["quantity"], one["paper"] + unit,
                     minus(f"{one['ours']:.{digits}f}") + unit, off])
    return table(["quantity", "paper", "here", "here − paper"], rows)


def statements(document):
    rows = [[spelled(one["statement"]), one["verdict"], spelled(one["evidence"])]
            for one in document["claims"]]
    return table(["the paper says", "verdict", "evidence"], rows)


def blocks_of(file):
    document = json.loads(file.read_text(encoding="utf-8"))
    return {"paper_numbers": lambda _: numbers(document),
            "paper_statements": lambda _: statements(document)}
