#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""No source is longer than CONTRIBUTING.md says, but for the tables that it names.

The sentence that it reads: "No source has more than 450 lines but what is one table:
`src/io/key_table.cpp`."
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
RULE = re.compile(r"No source has\s+more than (\d+) lines but what is one\s+table:\s+"
                  r"((?:`[^`]+`,?\s*)+)\.")


def rule(document):
    """The most lines of a source, and the tables that may have more."""
    found = RULE.search(document)
    if not found:
        raise ValueError("no sentence says how long a source may be")
    return int(found[1]), set(re.findall(r"`([^`]+)`", found[2]))


def faults(most, tables, lengths):
    """What is too long, and tables that are named and need not be."""
    wrong = [f"{name}: {lines} lines, {most} are the most"
             for name, lines in lengths.items() if lines > most and name not in tables]
    return wrong + [f"{name}: named as a table of more than {most} lines, which it is not"
                    for name in sorted(tables) if lengths.get(name, 0) <= most]


def faults_of_self():
    """Whether the judgement sees what it should, and nothing else."""
    most, tables = rule(
        "No source has more than 9 lines but what is one\ntable: `a.cpp`,\n`b.cpp`. More.")
    cases = {(10, 10, 9): 0, (10, 10, 10): 1, (9, 10, 9): 1, (9, 9, 10): 3}
    wrong = [] if (most, tables) == (9, {"a.cpp", "b.cpp"}) else [f"read: {most}, {tables}"]
    for lines, number in cases.items():
        found = faults(most, tables, dict(zip(("a.cpp", "b.cpp", "c.cpp"), lines)))
        if len(found) != number:
            wrong.append(f"{lines}: {len(found)} faults, not {number}")
    return wrong


def main():
    most, tables = rule((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    lengths = {path.relative_to(ROOT).as_posix():
               len(path.read_text(encoding="utf-8").splitlines())
               for base in ("src", "include") for path in sorted((ROOT / base).rglob("*.[ch]pp"))}
    wrong = faults_of_self() + faults(most, tables, lengths)
    print("\n".join(wrong), file=sys.stderr)
    print(f"{len(lengths)} sources, {sum(lengths.values())} lines, {len(wrong)} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
