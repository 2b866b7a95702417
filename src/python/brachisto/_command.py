# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The command `brachisto`, for work that is done by processes of their own."""

import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys

from brachisto import _core
from brachisto._errors import Diagnostic, InputError

_BAD_USE, _BAD_INPUT = 2, 3
# "problem.yaml:3:12: scene.body.k: …", without the parts that are not there.
_MISTAKE = re.compile(r"[^:]+(?::\d+:\d+)?: (?:([\w.\[\]]+): )?(.*)")
_FLAG = re.compile(r"brachisto \w+: --([\w-]+): (.*)")


def _candidates():
    """Where the command of this package may be, the nearest place first."""
    package = pathlib.Path(__file__).resolve().parent
    named = os.environ.get("BRACHISTO_APP")
    yield from [named] if named else [
        pathlib.Path(sys.prefix, "bin", "brachisto"),  # of a wheel
        package.parents[1] / "app" / "brachisto",  # of a build
        *(above / "bin" / "brachisto" for above in package.parents),  # of a prefix
        shutil.which("brachisto"),
    ]


@functools.cache
def _program(named):
    tried = []
    for program in _candidates():
        if program is None or not os.access(program, os.X_OK) or os.path.isdir(program):
            continue
        told = subprocess.run([program, "--version"], capture_output=True, text=True,
                              check=False).stdout.split()
        version = told[1] if len(told) > 1 else "no version"
        if version == _core.__version__:
            return str(program)
        tried.append(f"{program} is {version}")
    found = "; ".join(tried) if tried else "there is no such program"
    where = f"as {named}" if named else "beside the package or in the PATH"
    raise FileNotFoundError(
        f"the command `brachisto` of version {_core.__version__} is needed {where}; {found}. "
        "The environment variable BRACHISTO_APP can name it"
    )


def run(verb, *arguments, text=None, directory=None, codes=(0,)):
    """Runs the command and returns what it prints; a signal that raises here ends it.

    `text` is its problem file, and names of other files in it start from `directory`.

    Raises InputError for a problem that it refuses, ValueError for a number that it does,
    RuntimeError for any other exit code than `codes`.
    """
    program = _program(os.environ.get("BRACHISTO_APP"))
    told = subprocess.run([program, verb, *map(str, arguments)], input=text,
                          capture_output=True, cwd=directory, check=False)
    output, errors = (each.decode("utf-8", "replace") for each in (told.stdout, told.stderr))
    if told.returncode == _BAD_INPUT:
        found = [_MISTAKE.fullmatch(line) for line in errors.splitlines()]
        if found and all(found):
            raise InputError(errors.rstrip("\n"), tuple(
                Diagnostic(_core.KEYWORDS, 0, 0, one[1] or "", one[2]) for one in found))
    if told.returncode == _BAD_USE and (flag := _FLAG.match(errors)):
        raise ValueError(f"{flag[1]}: {flag[2]}")
    if told.returncode not in codes:
        raise RuntimeError(errors.strip() or f"brachisto {verb} ended with {told.returncode}")
    return output
