# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""All methods on one scene."""

import html
import json
import pathlib
import tempfile

from brachisto import _command
from brachisto._pages import write_page

_NOT_SOLVED = 4


class Comparison:
    """What each method came to on one scene: its time, its memory and its true error."""

    def __init__(self, document, summary, page):
        self._document, self._summary, self._page = document, summary, page

    def to_dict(self):
        """The document that `brachisto compare --json` prints."""
        return self._document

    def summary(self):
        """The text that `brachisto compare` prints."""
        return self._summary

    def table(self):
        """A row for each method: a dict of lists, which pandas.DataFrame takes.

        `method`, `verdict` in words, `tau`, `error`, relative to the best answer,
        `cpu_seconds`, the median [s], and `peak_memory_bytes`; None where there is none.
        """
        rows = self._document["methods"]
        columns = {key: [row.get(key) for row in rows]
                   for key in ["method", "verdict", "tau", "error"]}
        times = [row.get("cpu_seconds") or {} for row in rows]
        columns["cpu_seconds"] = [time.get("median") for time in times]
        columns["peak_memory_bytes"] = [row.get("peak_memory_bytes") for row in rows]
        return columns

    def write_page(self, path, *, force=False):
        """Writes the page of the comparison, the index.html of `brachisto compare --out`.

        Raises OSError if it cannot be written, or if it is there and `force` is not given.
        """
        write_page(path, force, lambda: self._page)

    def _repr_html_(self):
        """The text of `summary`, for notebooks."""
        table, *words = self._summary.split("\n\n")
        style = "overflow-x:auto;white-space:pre;line-height:1.3"
        return f'<div><pre style="{style}">{html.escape(table)}</pre>' + "".join(
            f"<p>{html.escape(text)}</p>" for text in words) + "</div>"

    def __repr__(self):
        return self._summary.rstrip("\n")


def compare(scene, *, nodes=101, repetitions=5, seconds=60, residual=None):
    """Solves a scene by every method, as `brachisto compare` does: a Comparison.

    Each method runs in a process of its own, which the command `brachisto` starts, so that
    the memory of this one is no part of what is measured; it has to be installed.
    `nodes` is n of the methods on a fixed mesh, `repetitions` the timed solves of each,
    `seconds` its limit on the wall, `residual` where the iterations of all stop.

    Raises InputError for a scene that states its path, FileNotFoundError without the command.
    """
    flags = ["--nodes", nodes, "--repetitions", repetitions, "--seconds", seconds]
    if residual is not None:
        flags += ["--residual", residual]
    with tempfile.TemporaryDirectory(prefix="brachisto-") as directory:
        # Methods read the problem again, each in its own process.
        problem = pathlib.Path(directory, "problem.yaml")
        problem.write_text(json.dumps(scene.input), encoding="utf-8")
        out = pathlib.Path(directory, "out")
        document = _command.run("compare", "problem.yaml", "--json", "--quiet", "--out", out,
                                *flags, directory=directory, codes=(0, _NOT_SOLVED))
        names = "compare.txt", "index.html"
        summary, page = [(out / name).read_text(encoding="utf-8") for name in names]
    return Comparison(json.loads(document), summary, page)
