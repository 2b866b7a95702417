# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""What type checkers are told is what there is."""

import ast
import inspect
import pathlib
import unittest

import brachisto

PACKAGE = pathlib.Path(brachisto.__file__).parent


def names_of(definition):
    """Of a function's arguments."""
    arguments = definition.args
    named = [argument.arg for argument in arguments.args + arguments.kwonlyargs]
    return named + ([arguments.kwarg.arg] if arguments.kwarg else [])


class Stubs(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))

    def compare(self, stub, found):
        for node in stub.body:
            if isinstance(node, ast.ClassDef):
                self.compare(node, getattr(found, node.name))
            elif isinstance(node, ast.AnnAssign):
                self.assertTrue(hasattr(found, node.target.id), node.target.id)
            elif isinstance(node, ast.FunctionDef):
                value = inspect.getattr_static(found, node.name)
                if isinstance(value, classmethod):
                    value = value.__func__
                if inspect.isfunction(value):
                    parameters = list(inspect.signature(value).parameters)
                    self.assertEqual(len(names_of(node)), len(parameters), node.name)
                    self.assertTrue(node.name.startswith("__") or names_of(node) == parameters)
                    self.assertTrue(node.name.startswith("__") or value.__doc__, node.name)
                else:
                    self.assertTrue(value.__doc__, node.name)

    def test_names_and_arguments_are_there(self):
        self.compare(self.tree, brachisto)

    def test_every_public_name_is_in_them(self):
        def public(value):
            return {name for name in vars(value) if not name.startswith("_")}

        stubs = {node.name: node for node in self.tree.body if hasattr(node, "name")}
        self.assertEqual(set(stubs), set(brachisto.__all__))
        for name in ["Scene", "Sweep", "Record", "Result"]:
            told = {getattr(node, "name", None) for node in stubs[name].body}
            self.assertLessEqual(public(getattr(brachisto, name)), told, name)

    def test_the_package_is_marked_as_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
