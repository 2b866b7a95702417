# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Sweeps in the process, beside those of the command."""

import json
import tempfile
import unittest

import brachisto
import numpy as np
from command import PROBLEMS, run

CHOICES = """
scene: {body: {shape: cylinder, radius: 0.2, eta_m: 0.5, k: 0.5}, finish: {L: 0.5, H: 1}}
discretisation: {tolerance: 1e-6}
solver: {sensitivities: true}
sweep:
  scene.contact: [smooth, centre]
  scene.body.radius: [0.1, 0.2, 2]
"""


class Sweeps(unittest.TestCase):
    def test_has_the_rows_that_the_command_exports(self):
        with tempfile.TemporaryDirectory() as directory:
            choices = f"{directory}/choices.yaml"
            with open(choices, "w", encoding="utf-8") as file:
                file.write(CHOICES)
            for number, path in enumerate([PROBLEMS / "sweeps/small.yaml", choices]):
                store = f"{directory}/store{number}"
                run("sweep", path, "--out", store, "--quiet")
                rows = json.loads(run("export", store, "--json"))["rows"]

                table = brachisto.Sweep.from_file(path).table()

                self.assertEqual({len(column) for column in table.values()}, {len(rows)})
                for row in rows:
                    for key, value in row.items():
                        if key == "seconds.total":
                            continue
                        found = table[key][row["scene"]] if key in table else None
                        if value is None:
                            self.assertTrue(found is None or np.isnan(found), key)
                        else:
                            self.assertEqual(found, value, key)

    def test_columns_have_types_that_tables_like(self):
        table = brachisto.Sweep(CHOICES).table()

        kinds = {"scene": "i", "scene.contact": "O", "scene.body.radius": "f", "verified": "b",
                 "tau": "f", "feasible": "O", "nodes": "f"}
        self.assertEqual({key: table[key].dtype.kind for key in kinds}, kinds)
        self.assertFalse(table["verified"][2])  # larger than there is place for
        self.assertTrue(np.isnan(table["tau"][2]))
        self.assertIsNone(table["feasible"][2])

    def test_yields_rows_one_by_one(self):
        sweep = brachisto.Sweep(CHOICES)
        self.assertEqual(len(sweep), 6)
        rows = iter(sweep)
        row = next(rows)
        self.assertEqual(row.scene, 0)
        self.assertEqual(row.values, {"scene.contact": "smooth", "scene.body.radius": 0.1})
        self.assertEqual(next(rows).result.tau, brachisto.solve(sweep[1]).tau)
        with self.assertRaises(IndexError):
            sweep[6]

    def test_tells_what_is_wrong(self):
        with self.assertRaises(brachisto.InputError) as caught:
            brachisto.Sweep(CHOICES.replace("body.radius: [", "body.radius: [-1, "), "choices.yaml")
        self.assertEqual(caught.exception.diagnostics[0].line, 7)
        self.assertTrue(str(caught.exception).startswith("choices.yaml:7:"))


if __name__ == "__main__":
    unittest.main()
