# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Prints the type stubs of the package: a template, and the attributes of results.

    PYTHONPATH=PACKAGES python3 stubs.py TEMPLATE OUTPUT
"""

import keyword
import pathlib
import sys

import brachisto
from brachisto._result import SCHEMA

TYPES = {"boolean": "bool", "integer": "int", "number": "float", "string": "str"}


def lines_of(record, schema, indent):
    """The attributes of a class, with the classes of what is in it."""
    for key, part in schema["properties"].items():
        (kind,) = set(part["type"]) - {"null"}
        inner = record._made_of.get(key)
        if inner is not None:
            yield f"{indent}class {inner.__name__}(Record):"
            yield from lines_of(inner, part.get("items", part), indent + "    ")
        named = inner.__name__ if inner is not None else "Any"
        if kind == "array":
            kind = f"list[{named}]"
        elif kind == "object":
            kind = named if inner is not None else "dict[str, Any]"
        else:
            kind = TYPES[kind]
        if key.isidentifier() and not keyword.iskeyword(key):
            yield f"{indent}@property"
            yield f"{indent}def {key}(self) -> {kind} | None: ..."
        elif inner is None:
            yield f"{indent}# [{key!r}] is {kind} | None"


template, output = map(pathlib.Path, sys.argv[1:])
attributes = "\n".join(lines_of(brachisto.Result, SCHEMA, "    "))
output.write_text(template.read_text(encoding="utf-8") + attributes + "\n", encoding="utf-8")
