# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Numbers that a page shows against those that the program prints.

Two numbers with a point agree if they differ by no more than one unit of the last digit
that the page shows: half a unit by rounding, and half for what another machine
rounds differently. Whole numbers are equal. Numbers such as 4e-13 are errors or
differences, of which the magnitude counts: they agree within a factor of 3, if
two decimals are shown, 4.12e-5, within two units of the last, and below 2e-12, the
accuracy of the solves, always.
"""

import re

NUMBER = re.compile(r"[−-]?\d+(?:\.\d+)?(?:e[−-]?\d+)?")
SMALL = 2e-12
FACTOR = 3.0
STAMP = re.compile(r"^\*Measured \d{4}-\d\d-\d\d, commit [0-9a-f]{7,}, [^*]+\.\*$")


def value(text):
    return float(text.replace("−", "-"))


def same_number(shown, now):
    if shown == now:
        return True
    a, b = value(shown), value(now)
    if "e" in shown or "e" in now:
        if abs(a) < SMALL and abs(b) < SMALL:
            return True
        mantissa, _, exponent = shown.partition("e")
        decimals = len(mantissa.partition(".")[2])
        if exponent and decimals >= 2:
            return abs(a - b) <= 2.001 * 10.0 ** (value(exponent) - decimals)
        return a * b > 0 and 1 / FACTOR <= a / b <= FACTOR
    decimals = len(shown.partition(".")[2])
    return decimals > 0 and abs(a - b) <= 1.001 * 10.0 ** -decimals


def cells(text):
    """Rows of cells without the blanks that only align."""
    return [re.split(r"(?<!\\)\|", line) if line.startswith("|") else [line]
            for line in text.strip().splitlines()]


def differences(shown, now):
    """What differs between two texts, number by number."""
    old, new = cells(shown), cells(now)
    if [len(row) for row in old] != [len(row) for row in new]:
        return [f"other rows or columns: {len(old)} lines are shown, {len(new)} are written"]
    found = []
    for row, (ours, theirs) in enumerate(zip(old, new)):
        for a, b in zip(ours, theirs):
            a, b = a.strip(), b.strip()
            # A difference that vanishes has no sign and no exponent.
            tiny = [NUMBER.fullmatch(x) and ("e" in x or x == "0") and abs(value(x)) < SMALL
                    for x in (a, b)]
            if a == b or all(tiny):
                continue
            numbers = NUMBER.findall(a), NUMBER.findall(b)
            if (NUMBER.sub("#", a) != NUMBER.sub("#", b)
                    or not all(map(same_number, *numbers))):
                found.append(f"line {row + 1}: shown {a!r}, written {b!r}")
    return found


def is_stamp(line):
    """Whether a line says when, with which commit and where a table was measured."""
    return bool(STAMP.match(line))
