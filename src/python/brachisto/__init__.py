# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Fastest tracks for off-centred rolling cylinders.

    import brachisto

    scene = brachisto.Scene(
        body={"shape": "cylinder", "radius": "1/3", "eta_m": "2/3", "k": "1/2"},
        finish={"L": 3, "H": 1},
    )
    result = brachisto.solve(scene)
    print(result.tau, result.trajectory["x_b"])
"""

from brachisto._core import __version__
from brachisto._compare import Comparison, compare
from brachisto._errors import Diagnostic, InputError, NotVerified
from brachisto._race import Race, race
from brachisto._result import Record, Result, design, sensitivities, solve
from brachisto._scene import Scene, validate
from brachisto._sweep import Row, Sweep, sweep

__all__ = [
    "Comparison",
    "Diagnostic",
    "InputError",
    "NotVerified",
    "Race",
    "Record",
    "Result",
    "Row",
    "Scene",
    "Sweep",
    "compare",
    "design",
    "race",
    "sensitivities",
    "solve",
    "sweep",
    "validate",
]
for _name in __all__:
    globals()[_name].__module__ = __name__
