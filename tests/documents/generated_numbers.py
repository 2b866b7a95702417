#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Numbers in the documents, made from what the program prints.

    generated_numbers.py BRACHISTO                 writes every block that takes seconds anew
    generated_numbers.py BRACHISTO --paper FILE    those of the paper too, from the output of
                                                   brachisto paper --json
    generated_numbers.py BRACHISTO --check         compares instead; exits with 1 if one differs
    generated_numbers.py --stamp                   the line for a table that was measured now

A block stands in a page between

    <!-- generated: NAME -->
    <!-- end -->

and NAME is a function of blocks.py or paper_blocks.py. A sentence with numbers is a template in
sentences.py. Every other table with numbers of several digits stands below a line that tells
when, with which commit and on which machine it was measured.
"""

import argparse
import datetime
import pathlib
import re
import subprocess
import sys

import blocks
import paper_blocks
import sentences
from comparison import differences, is_stamp
from program import Program

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", "docs/validation.md", "docs/theory.md", "docs/numerics.md",
         "docs/robustness.md", "docs/benchmarks.md", "docs/paper-system.md", "docs/proofs.md"]

BLOCK = re.compile(r"(<!-- generated: (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
# What was counted or measured, as against years, names and sizes.
SEVERAL_DIGITS = re.compile(r"\d\.\d{2,}|\d\.?\d*e-?\d|\d s\b")


def makers(paper):
    known = dict(blocks.BLOCKS)
    if paper:
        known |= paper_blocks.blocks_of(paper)
    return known


def renew(page, program, known, check):
    """What differs in a page; its blocks are written anew unless they are only checked."""
    path = ROOT / page
    text, findings = path.read_text(encoding="utf-8"), []

    def new(match):
        head, name, shown, end = match.groups()
        if name in paper_blocks.NAMES and name not in known:
            return match.group(0)
        if name not in known:
            findings.append(f"{page}: nothing makes the block {name}")
            return match.group(0)
        now = known[name](program).rstrip("\n") + "\n"
        wrong = differences(shown, now)
        findings.extend(f"{page}: {name}: {line}" for line in wrong)
        # What agrees is left as it is: the last digits of errors are no news.
        return head + (now if wrong else shown) + end

    renewed = BLOCK.sub(new, text)
    for template in sentences.SENTENCES.get(page, []):
        now = sentences.filled(template, program)
        if any(not differences(said, now) for said in sentences.places(template, text)):
            continue
        findings.append(f"{page}: does not say {now!r}")
    if not check and renewed != text:
        path.write_text(renewed, encoding="utf-8")
    return findings


def unmarked_tables(page):
    """Tables of numbers that neither are generated nor say when they were measured."""
    text = BLOCK.sub(lambda m: "\n" * m.group(0).count("\n"),
                     (ROOT / page).read_text(encoding="utf-8"))
    lines = text.split("\n")
    found, stamped = [], False
    at = 0
    while at < len(lines):
        line = lines[at]
        if line.startswith("|"):
            start = at
            while at < len(lines) and lines[at].startswith("|"):
                at += 1
            body = "\n".join(lines[start + 2:at])
            if SEVERAL_DIGITS.search(body) and not stamped:
                found.append(f"{page}:{start + 1}: a table of numbers that is neither "
                             "generated nor has a line *Measured DATE, commit …, MACHINE.*")
            stamped = False
            continue
        if line.strip():
            stamped = is_stamp(line)
        at += 1
    return found


def stamp():
    """The line for a table that was measured on this machine, with this commit."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.strip()
    models = re.findall(r"^model name\s*: (.*)$",
                        pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return (f"*Measured {datetime.date.today()}, commit {commit}, "
            f"{len(models)} cores of {models[0] if models else 'an unknown processor'}.*")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program", nargs="?")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--paper", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--stamp", action="store_true")
    options = parser.parse_args()
    if options.stamp:
        print(stamp())
        return 0
    if not options.program:
        parser.error("the executable of brachisto is missing")
    known = makers(options.paper)
    with Program(options.program, ROOT) as program:
        findings = [line for page in PAGES
                    for line in renew(page, program, known, options.check)]
    if not options.check:
        print("\n".join(findings), file=sys.stderr)
        return 0
    findings += [line for page in PAGES for line in unmarked_tables(page)]
    print("\n".join(findings), file=sys.stderr)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
