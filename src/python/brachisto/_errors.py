# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""What is wrong with an input, and where."""

from typing import NamedTuple


class Diagnostic(NamedTuple):
    """One mistake of an input, or one thing that it says but hardly means."""

    file: str
    """Name of the file; "<keywords>" for what is not from a text."""
    line: int
    """From 1; 0 of keywords."""
    column: int
    """From 1, in characters; 0 of keywords."""
    key: str
    """Dotted, "scene.body.k"; empty for the whole file."""
    message: str
    """What was read, what is allowed, the nearest match."""


class InputError(ValueError):
    """The content of a problem is refused, for all that `diagnostics` lists.

    As a string it is what the command `brachisto` says: one line for each mistake.
    """

    def __str__(self):
        return self.args[0]

    @property
    def diagnostics(self):
        """A Diagnostic of each mistake."""
        return self.args[1]


class NotVerified(ValueError):
    """A result was to be shown or to race that is not verified: it has no motion.

    As a string it says why.
    """

    def __init__(self, message, result=None):
        super().__init__(message)
        self._result = result

    @property
    def result(self):
        """The Result that was to be shown."""
        return self._result
