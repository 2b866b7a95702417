# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Sweeps: families of scenes."""

import json
import os
import pathlib
import tempfile
import warnings
from typing import NamedTuple

import numpy as np

from brachisto import _command, _core
from brachisto._result import SCHEMA, Result, solved
from brachisto._scene import Scene, bytes_of


class Row(NamedTuple):
    """A scene of a sweep, solved."""

    scene: int
    """Its number, from 0."""
    values: dict
    """Of the keys of the sweep, in SI units and radians, or words."""
    result: Result


def _scalars(schema, path=()):
    """Paths of all plain values in a document, those of lists left out."""
    for key, part in schema["properties"].items():
        if "properties" in part:
            yield from _scalars(part, (*path, key))
        elif not {"array", "object"} & set(part["type"]):
            yield (*path, key)


def _at(document, path):
    for key in path:
        document = document.get(key) if document is not None else None
    return document


def _column(values):
    """Numbers with NaN for what is not there; words and truth values with None."""
    if all(value is None or type(value) in (int, float) for value in values):
        if values and all(type(value) is int for value in values):
            return np.array(values)
        return np.array([np.nan if value is None else value for value in values], float)
    truths = all(type(value) is bool for value in values)
    return np.array(values, dtype=bool if truths else object)


class Sweep:
    """The scenes of a problem file with a section `sweep`, all of them checked.

    Iterating solves them, one after the other, and yields a Row of each: all begin with
    the cycloid and have the numbers of `brachisto sweep`. Only with `warm_start: true` each
    begins with its neighbour before it along the last axis, where the command cuts long
    rows of neighbours into pieces. For more processes than one, and to go on after a
    stop, use the command.
    """

    def __init__(self, text, name="<text>"):
        self._source = (text, name)
        self._core = _core.Sweep(text, name, [])

    @classmethod
    def from_file(cls, path):
        """The sweep of a problem file. Raises OSError if it cannot be read."""
        return cls(bytes_of(path), os.fsencode(path))

    def __len__(self):
        return len(self._core)

    def values(self, scene):
        """Those of the sweep's keys in the scene of that number: a dict."""
        return self._core.values(scene)

    def __getitem__(self, scene):
        """The Scene of that number."""
        return Scene._of_problem(self._core.problem(scene))

    def __iter__(self):
        near = None
        for scene in range(len(self)):
            follows = self._core.warm_start and scene % self._core.row > 0
            near = solved(self[scene], near if follows else None)
            yield Row(scene, self.values(scene), near)

    def table(self):
        """Solves all scenes. A dict of NumPy arrays, which pandas.DataFrame takes as it is.

        A column for the number of the scene, for each key of the sweep, and for each single
        value of results that any of the scenes has, such as "normal_force.min".
        """
        of_all_alike = "schema_version", "provenance"
        paths = [path for path in _scalars(SCHEMA) if path[0] not in of_all_alike]
        columns = {}
        for row in self:
            document = row.result.to_dict()
            figures = {".".join(path): _at(document, path) for path in paths}
            # A list, whose items are told apart by a value.
            least = {grip["share_of_time"]: grip["mu"]
                     for grip in (document.get("grip") or {}).get("least_after", [])}
            for percent in 1, 5:
                figures[f"grip.mu_after_{percent}_percent"] = least.get(percent / 100)
            for key, value in {"scene": row.scene, **row.values, **figures}.items():
                columns.setdefault(key, []).append(value)
        return {
            key: _column(values)
            for key, values in columns.items()
            if any(value is not None for value in values)
        }


_SOME_FAILED = 4  # the code with which the command then exits


def _table_of_processes(found, jobs):
    """What `brachisto export` has of a sweep by the command."""
    text, name = found._source
    text = text.encode("utf-8") if isinstance(text, str) else text
    beside = pathlib.Path(os.fsdecode(name)).parent
    with tempfile.TemporaryDirectory(prefix="brachisto-") as directory:
        _command.run("sweep", "-", "--out", directory, "--jobs", jobs, "--quiet", "--force",
                     text=text, directory=beside, codes=(0, _SOME_FAILED))
        rows = json.loads(_command.run("export", directory, "--json"))["rows"]
    columns = {key: [row[key] for row in rows] for key in rows[0]}
    return {
        key: _column(values)
        for key, values in columns.items()
        if any(value is not None for value in values)
    }


def sweep(what, *, jobs=None):
    """Solves all scenes of a sweep: a pandas.DataFrame with a row for each.

    `what` is a Sweep or the name of a problem file with a section `sweep`. Its columns are
    those of `Sweep.table`. With `jobs` so many processes share the scenes, which the command
    `brachisto` starts, and the columns are those of `brachisto export`; without it they are
    solved in this one. Either way the numbers are the same.

    Without pandas it says so in a warning and returns the dict of NumPy arrays.

    Raises InputError for a file that is no sweep, OSError if it cannot be read.
    """
    found = what if isinstance(what, Sweep) else Sweep.from_file(what)
    table = found.table() if jobs is None else _table_of_processes(found, jobs)
    try:
        import pandas
    except ImportError:
        warnings.warn(
            "pandas is not installed: the table is a dict of NumPy arrays, one for each column",
            stacklevel=2,
        )
        return table
    return pandas.DataFrame(table)
