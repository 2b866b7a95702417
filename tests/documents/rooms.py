#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Every room includes only from rooms that it sees, by the table in CONTRIBUTING.md.

A room is a folder of `src` with the folder of that name under `include/brachisto`. Its row
says which it sees: `nothing`, `all above`, or a list, whose rooms stand above as well. What
stands in `include/brachisto` itself is no room's: everyone sees the version, and the header of
all headers is for those who see `include/brachisto`.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BASES = (ROOT / "src", ROOT / "include" / "brachisto")
PUBLIC = "include/brachisto"
HEAD = "| folder | holds | sees |"
VERSION = "brachisto/version.hpp"
ALL_HEADERS = "brachisto/brachisto.hpp"
# Other libraries stand in angle brackets.
INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<(brachisto/[^>]+)>)', re.MULTILINE)


def seen_by_room(document):
    """The rooms of a table, each with the set of those that it sees."""
    lines = iter(document.splitlines())
    if HEAD not in lines:
        raise ValueError(f"there is no table {HEAD}")
    next(lines)
    seen = {}
    for line in lines:
        if not line.startswith("|"):
            break
        folder, _, sees = [cell.strip() for cell in line.strip("|").split("|")]
        room = folder.strip("`").removeprefix("src/")
        names = {"nothing": set(), "all above": set(seen)}.get(sees)
        if names is None:
            names = set(re.findall(r"`([^`]+)`", sees))
            if not names or names - set(seen) - {PUBLIC}:
                raise ValueError(f"{room} sees what does not stand above it: {sees}")
        seen[room] = names
    return seen


def fault(seen, room, public, included):
    """What is wrong with an include in a room, or nothing.

    public: the file that includes is one of the public headers.
    """
    own, *rest = included.split("/")
    if own == "brachisto":
        if included == VERSION:
            return None
        if PUBLIC in seen[room]:
            return None
        if included == ALL_HEADERS:
            return f"{room} does not see {PUBLIC}"
        own, *rest = rest
    elif public:
        return "a public header includes what is not public"
    if not rest or own not in seen:
        return "it names no room"
    if own != room and own not in seen[room]:
        return f"{room} does not see {own}"
    return None


def faults_of_self():
    """Whether the judgement sees what it should, and nothing else."""
    seen = seen_by_room(f"""\
{HEAD}
| --- | --- | --- |
| `low` | a | nothing |
| `side` | b | nothing |
| `middle` | c | `low` |
| `src/high` | d | all above |
| `src/outside` | e | `{PUBLIC}` |

| `later` | no row of it | nothing |""")
    good = [("low", False, "low/a.hpp"), ("low", False, "brachisto/low/a.hpp"),
            ("low", False, VERSION), ("middle", False, "low/deep/a.hpp"),
            ("middle", True, "brachisto/low/a.hpp"), ("high", False, "middle/a.hpp"),
            ("high", False, "brachisto/side/a.hpp"), ("outside", False, ALL_HEADERS)]
    bad = [("low", False, "middle/a.hpp"), ("low", True, "brachisto/high/a.hpp"),
           ("middle", False, "side/a.hpp"), ("middle", False, "brachisto/side/a.hpp"),
           ("high", False, "outside/a.hpp"), ("high", False, ALL_HEADERS),
           ("middle", True, "low/a.hpp"), ("outside", False, "low/a.hpp"),
           ("high", False, "later/a.hpp"), ("high", False, "a.hpp")]
    wrong = [f"refused: {case}" for case in good if fault(seen, *case)]
    wrong += [f"not refused: {case}" for case in bad if not fault(seen, *case)]
    for sees in ("`high`", "what it likes"):
        try:
            seen_by_room(f"{HEAD}\n| --- | --- | --- |\n| `low` | a | {sees} |")
            wrong.append(f"not refused: a row that sees {sees}")
        except ValueError:
            pass
    return wrong


def main():
    wrong = faults_of_self()
    seen = seen_by_room((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    judged, rooms = 0, set()
    for base in BASES:
        for path in sorted(base.rglob("*.[ch]pp")):
            room, *rest = path.relative_to(base).parts
            if not rest:  # the header of all headers
                continue
            rooms.add(room)
            if room not in seen:
                continue
            text = path.read_text(encoding="utf-8")
            for included in map("".join, INCLUDE.findall(text)):
                judged += 1
                why = fault(seen, room, base != BASES[0], included)
                if why:
                    wrong.append(f"{path.relative_to(ROOT)}: {included}: {why}")
    wrong += [f"{room}: no row in the table of rooms" for room in sorted(rooms - set(seen))]
    wrong += [f"{room}: a row without a folder" for room in sorted(set(seen) - rooms)]
    print("\n".join(wrong), file=sys.stderr)
    print(f"{judged} includes of {len(rooms)} rooms were judged, {len(wrong)} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
