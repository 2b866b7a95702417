# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Sweeps in the process, beside those of the command."""

import json
import tempfile
import unittest
import unittest.mock
import warnings

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

    def test_is_a_data_frame_where_pandas_is(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        expected = brachisto.Sweep(CHOICES).table()

        frame = brachisto.sweep(brachisto.Sweep(CHOICES))

        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(list(frame), list(expected))
        np.testing.assert_array_equal(frame["tau"], expected["tau"])

    def test_without_pandas_it_is_a_dict_and_says_so(self):
        with unittest.mock.patch.dict("sys.modules", {"pandas": None}):
            with self.assertWarnsRegex(UserWarning, "pandas is not installed: the table is"):
                table = brachisto.sweep(brachisto.Sweep(CHOICES))

        self.assertIsInstance(table["tau"], np.ndarray)

    def test_processes_share_the_scenes_and_find_the_same(self):
        path = PROBLEMS / "sweeps/small.yaml"
        with unittest.mock.patch.dict("sys.modules", {"pandas": None}), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            alone, shared = brachisto.sweep(path), brachisto.sweep(path, jobs=2)

        self.assertLessEqual(set(shared), set(alone))
        for key in set(shared) - {"seconds.total"}:
            np.testing.assert_array_equal(shared[key], alone[key], key)

    def test_what_is_no_sweep_is_refused_by_its_key(self):
        with self.assertRaises(brachisto.InputError) as caught:
            brachisto.sweep(PROBLEMS / "case.yaml")
        self.assertEqual(caught.exception.diagnostics[0].key, "sweep")
        with self.assertRaises(OSError):
            brachisto.sweep("nowhere.yaml")
        with self.assertRaisesRegex(ValueError, "^jobs: "):
            brachisto.sweep(brachisto.Sweep(CHOICES), jobs=0)


if __name__ == "__main__":
    unittest.main()
