# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Scenes: what is asked."""

import json
import os
from collections.abc import Mapping

from brachisto import _core
from brachisto._errors import InputError


def as_json(value):
    """JSON is YAML; of NumPy's numbers and arrays it has the plain ones."""
    return json.dumps(value, default=lambda other: other.tolist())


def changes_of(keys, path=""):
    """Nested keys as the command has them after --set, "scene.body.k=0.1" each."""
    changes = []
    for key, value in keys.items():
        if isinstance(value, Mapping):
            changes += changes_of(value, f"{path}{key}.")
        else:
            changes.append(f"{path}{key}={as_json(value)}")
    return changes


def bytes_of(path):
    """Of a problem file, no more than show that they are too many."""
    with open(path, "rb") as file:
        return file.read(_core.MAX_FILE_SIZE + 1)


class Scene:
    """A body, A and B, and what else a problem file says, read and checked.

    The keywords are the keys of the section `scene` of problem files, values are those
    of Python: mappings, lists, numbers, booleans, and strings where a problem file has a
    word or an expression ("1/3", "-30 deg"). `from_file` and `from_text` read problem
    files, options of the solve included.

    A scene is a value: it cannot be changed, and can be pickled.

    Raises InputError for what a problem file could not say.
    """

    def __init__(self, **keys):
        self._read(as_json({"scene": keys}), _core.KEYWORDS, [])

    def _read(self, text, name, changes):
        self._source = (text, name, changes)
        self._problem = _core.Problem(*self._source)

    @classmethod
    def _from_source(cls, text, name, changes):
        scene = cls.__new__(cls)
        scene._read(text, name, changes)
        return scene

    @classmethod
    def _of_problem(cls, problem):
        """Without a text of its own, that of its input serves."""
        scene = cls.__new__(cls)
        scene._source, scene._problem = (problem.input, _core.KEYWORDS, []), problem
        return scene

    @classmethod
    def from_text(cls, text, name="<text>"):
        """The scene of a problem file's text, which messages call `name`.

        Names of other files in the text start from the directory of `name`.
        """
        return cls._from_source(text, name, [])

    @classmethod
    def from_file(cls, path):
        """The scene of a problem file. Raises OSError if it cannot be read."""
        return cls._from_source(bytes_of(path), os.fsencode(path), [])

    def changed(self, **keys):
        """The scene with other values of some keys: `scene.changed(body={"k": 0.1})`.

        A mapping changes the keys that it has and leaves the others.
        """
        return self._with(changes_of({"scene": keys}))

    def _with(self, changes):
        text, name, before = self._source
        return self._from_source(text, name, before + changes) if changes else self

    @property
    def input(self):
        """All that it says, defaults filled in, as `brachisto validate --json` does."""
        return json.loads(self._problem.input)

    @property
    def warnings(self):
        """A Diagnostic of each thing that it says but hardly means."""
        return self._problem.warnings

    def __reduce__(self):
        return (Scene._from_source, self._source)

    def __repr__(self):
        keys = {key: value for key, value in self.input["scene"].items() if value is not None}
        return f"Scene({', '.join(f'{key}={value!r}' for key, value in keys.items())})"


def validate(path):
    """What is wrong with a problem file or a sweep: a list of Diagnostic, empty if nothing.

    Raises OSError if it cannot be read.
    """
    try:
        _core.check(os.fsencode(path))
    except InputError as error:
        return list(error.diagnostics)
    return []
