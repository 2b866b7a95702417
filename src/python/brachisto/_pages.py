# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Pages: files that need no other one and no network."""

import os

from brachisto import _core


def write_page(path, force, page):
    """Writes what `page()` makes, unless it is known beforehand that it cannot be written."""
    path = os.fsencode(path)
    try:
        _core.check_page(path, force)
        _core.write_page(path, page(), force)
    except OSError as error:
        # The command has a flag for it, a function a keyword.
        raise OSError(str(error).replace("--force", "force=True")) from None
