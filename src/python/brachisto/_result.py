# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Results: classes made of the library's table of result keys."""

import functools
import json

from brachisto import _core
from brachisto._errors import NotVerified
from brachisto._pages import write_page
from brachisto._scene import changes_of


class Record:
    """A part of a result: its keys are attributes, and items where they are no names."""

    _made_of = {}  # The class of each key that has keys itself, or whose items have.

    def __init__(self, values):
        self._values = values

    def __getitem__(self, key):
        value = self._values[key]
        made_of = self._made_of.get(key)
        if made_of is None or value is None:
            return value
        if isinstance(value, list):
            return [made_of(item) for item in value]
        return made_of(value)

    def __getattr__(self, name):
        # Keys that the table leaves open, such as further checks of a certificate.
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"{type(self).__name__} has no {name!r}")
        return self[name]

    def __iter__(self):
        return iter(self._values)

    def __len__(self):
        return len(self._values)

    def __contains__(self, key):
        return key in self._values

    def __eq__(self, other):
        return type(self) is type(other) and self._values == other._values

    def __dir__(self):
        return [*super().__dir__(), *self._values]

    def __repr__(self):
        return f"{type(self).__name__}({self._values!r})"

    def to_dict(self):
        """Plain values, as in the document."""
        return self._values


def _attribute(key, schema):
    def value_of(record):
        return record[key] if key in record else None

    return property(value_of, doc=schema["description"])


def _record_class(name, schema, base=Record, within=""):
    """The class of what a JSON Schema tells of an object, with those of its parts."""
    path = within + name
    members, made_of = {}, {}
    for key, part in schema["properties"].items():
        members[key] = _attribute(key, part)
        inner = part.get("items", part)
        if "properties" in inner:
            words = "".join(word.capitalize() for word in key.split("_")) + "Part"
            inner = {**inner, "description": part["description"]}
            made_of[key] = members[words] = _record_class(words, inner, within=path + ".")
    members |= {
        "__module__": "brachisto",
        "__qualname__": path,
        "__doc__": schema["description"],
        "_made_of": made_of,
    }
    return type(name, (base,), members)


class _Solved(Record):
    def __init__(self, core):
        self._core = core
        super().__init__(json.loads(self.to_json()))

    def to_json(self):
        """The document that `brachisto solve --json` prints."""
        return self._core.json()

    def summary(self):
        """The text that `brachisto solve` prints."""
        return self._core.summary()

    def write_page(self, path, *, force=False):
        """Writes the page of the answer, the index.html of `brachisto solve --out`.

        Raises NotVerified if there is no motion to show, OSError if the page cannot be
        written, or if it is there and `force` is not given.
        """
        if not self.verified:
            raise NotVerified(f"there is no motion to show: {self._complaint()}", self)
        write_page(path, force, self._core.page)

    def _complaint(self):
        return self.message or "; ".join(self.not_verified_because or [])

    def _repr_html_(self):
        """A small drawing of the track, and the figures that one looks for first."""
        return self._core.card()

    @functools.cached_property
    def trajectory(self):
        return self._core.trajectory()

    def __reduce__(self):
        raise TypeError("a Result stays in its process; to_json() is what others can read")

    def __repr__(self):
        verdict = "verified" if self.verified else "not verified"
        tau = f", tau = {self.tau:.10g}" if self.verified else ""
        return f"<Result: {self.status}, {verdict}{tau}>"


_Solved.trajectory.__doc__ = """The motion at the nodes, None unless it is verified.

A dict of NumPy arrays, the columns of trajectory.csv. What a bead does not have is NaN:

{}

Under limits there are further columns: `active`, names of the bounds that hold as
equations, joined by +, and for each bound `slack_` and its name, the distance from it.
""".format(
    "\n".join(
        f"    {name:8} {meaning} [{unit}]" for name, unit, meaning in _core.trajectory_texts()
    )
)

SCHEMA = json.loads(_core.result_schema())

Result = _record_class(
    "Result",
    {
        **SCHEMA,
        "description": "What came of a scene; the keys of docs/results.md are its attributes.\n\n"
        "Numbers of the path are None unless the result is `verified`; a solve that failed\n"
        "tells why by `status` and `message`.",
    },
    _Solved,
)


def solve(scene, *, discretisation=None, solver=None, near=None):
    """Finds the track of a scene, by default its smooth-contact extremal.

    `discretisation` and `solver` are mappings with keys of these sections of problem
    files, before which those of the scene's file stand back. `near`, the result of a scene
    not far away, spares the way from the cycloid where its track can be followed.

    A solve that fails is a Result with its `status`, no exception. InputError is raised
    for options that a problem file could not have, and what the handler of a signal
    raises, such as KeyboardInterrupt, ends the solve. Other threads run meanwhile; solves
    in several threads take turns in Ipopt, which is not made for more than one.
    """
    options = {"discretisation": discretisation or {}, "solver": solver or {}}
    return solved(scene._with(changes_of(options)), near)


def solved(scene, near):
    return Result(_core.solve(scene._problem, near._core if near is not None else None))


def design(scene, *, discretisation=None, solver=None, **keys):
    """Finds the body that is the quickest on its own extremal: the Result of its track.

    `keys` are those of the section `design` of problem files, before which those of the
    scene's file stand back: `design(scene, free=["eta_m", "theta_m"])`. What was found on
    the way is the attribute `design` of the result.

    The searches run one after the other in this process and have the numbers of
    `brachisto design`, which uses more processes; the limit `solver.limits.seconds` is that of
    all of them together. Errors and signals are those of `solve`.
    """
    options = {"discretisation": discretisation or {}, "solver": solver or {}, "design": keys}
    return Result(_core.design(scene._with(changes_of(options))._problem))


def sensitivities(result, second=False):
    """How the time of a verified result changes with its scene.

    The same as its attribute `sensitivities`, which is there if they were asked for
    beforehand (`solver={"sensitivities": True}`); `second` adds the second derivatives of
    τ. None where they do not exist: the conditions of the answer are singular, its arcs
    are not known, or it was not found by collocation in the rolling time.
    """
    found = Result(result._core.differentiated(second)).sensitivities
    return found if found else None
