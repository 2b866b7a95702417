#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Whether sources are compiled with the flags of their own that they need.

    compile_flags.py BUILD CONFIG   BUILD has a compile_commands.json

Some sources want other floating-point flags than the rest: a file that is moved
loses them without a word. `compile_flags.json` beside this file says which. Where CONFIG
is Debug, levels of optimisation do not count.
"""

import collections
import json
import pathlib
import re
import shlex
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent.parent / "src"
# What decides how numbers come out.
COUNTS = re.compile(r"-(O|march|mtune|mfpmath|ffast-math|ffp-contract|f(no-)?math-errno|"
                    r"f(no-)?(unsafe|finite|associative|reciprocal)-)")


# Rooms that read, write, draw or call others, a library among them, where -O1 is as good.
QUICK = {"app", "comparison", "design", "fit", "io", "plot", "process", "program_files", "proof",
         "python", "report", "reproduction", "search", "study", "sweep"}


def sources_of(file):
    """The file, or those that it joins to be compiled together."""
    if "Unity" not in file.parts:
        return [file]
    return [pathlib.Path(path) for path in re.findall(r'#include "(.+)"', file.read_text())]


def main(build, config):
    with open(pathlib.Path(build) / "compile_commands.json", encoding="utf-8") as file:
        commands = json.load(file)

    def counting(words):
        return [w for w in words
                if COUNTS.match(w) and not (config == "Debug" and w.startswith("-O"))]

    flags = {}
    for command in commands:
        words = counting(shlex.split(command["command"]))
        for source in sources_of(pathlib.Path(command["file"])):
            if source.is_relative_to(SOURCES):
                flags[source.relative_to(SOURCES).as_posix()] = words
    computing = [tuple(words) for name, words in flags.items() if name.split("/")[0] not in QUICK]
    common = collections.Counter(computing).most_common(1)[0][0]
    wanted = json.loads((HERE / "compile_flags.json").read_text(encoding="utf-8"))
    wrong = 0
    for source in sorted(flags.keys() | wanted.keys()):
        own = flags[source][len(common):] if source in flags else None
        if own and source.split("/")[0] in QUICK:
            own = [word for word in own if word != "-O1"]
        expected = counting(wanted.get(source, []))
        if own != expected:
            wrong += 1
            found = "is not compiled" if own is None else f"has {own}"
            print(f"src/{source}: {found}, expected {expected}")
    print(f"{len(flags)} sources, {len(wanted)} with flags of their own, {wrong} wrong")
    return 1 if wrong or not flags else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
