#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The comparison of documents notices what it should, and nothing else."""

import sys

from comparison import differences, is_stamp

SAME = [
    ("| a | 5.0934 |", "| a | 5.0934 |"),
    ("| a | 5.0934 |", "| a | 5.0935 |"),        # rounded otherwise
    ("| a | −0.1079 (1.5) |", "| a | −0.1078 (1.5) |"),
    ("| a | 4e-13 |", "| a | −7e-16 |"),          # below the accuracy of the solves
    ("| a | 4e-13 |", "| a | 0 |"),
    ("| a | 5.0e-11 |", "| a | 7.3e-11 |"),       # the magnitude of an error
    ("| a | 7.59e-5 (1.9) |", "| a | 7.60e-5 (1.8) |"),
]
OTHER = [
    ("| a | 4.7720 |", "| a | 5.0444 |"),
    ("| a | 5.0934 |", "| a | 5.0936 |"),
    ("| a | 2e-9 |", "| a | 2e-8 |"),
    ("| a | 2e-9 |", "| a | −2e-9 |"),
    ("| a | 4e-13 |", "| a | 5e-9 |"),
    ("| a | μ–free |", "| a | μ–free–μ |"),
    ("| a | 1.0 |", "| a | 1.0 | 2.0 |"),
    ("| a | 1.0 |", "| a | 1.0 |\n| b | 1.0 |"),
    ("| a | −1.25 |", "| a | 1.25 |"),
    ("| a | 7.59e-5 |", "| a | 7.54e-5 |"),
    ("| a | 79 of 79 |", "| a | 78 of 79 |"),
]
STAMPS = {"*Measured 2026-11-23, commit 2091539, 2 cores of an AMD EPYC.*": True,
          "*Measured 2026-11-23, 2 cores of an AMD EPYC.*": False,
          "*Measured lately, commit 2091539, some machine.*": False}


def main():
    wrong = [f"a difference is seen: {a} {b}" for a, b in SAME if differences(a, b)]
    wrong += [f"no difference is seen: {a} {b}" for a, b in OTHER if not differences(a, b)]
    wrong += [f"stamp: {line}" for line, good in STAMPS.items() if is_stamp(line) != good]
    print("\n".join(wrong), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
