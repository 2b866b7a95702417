# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The module says what the command says, to the last digit."""

import json
import tempfile
import unittest

import brachisto
import numpy as np
from command import PROBLEMS, reference_rows, run, without_times


class Digits(unittest.TestCase):
    maxDiff = None

    def assert_same(self, result, document):
        self.assertEqual(without_times(result.to_json()), without_times(document))

    def test_of_all_reference_values(self):
        rows = list(reference_rows())
        self.assertEqual(len(rows), 27)
        for name, keys, tau in rows:
            with self.subTest(name):
                result = brachisto.solve(brachisto.Scene(**keys))

                text = json.dumps({"scene": keys})
                self.assert_same(result, run("solve", "-", "--json", text=text))
                self.assertTrue(result.verified)
                # Twice the relative error that is asked for by default.
                self.assertLessEqual(abs(result.tau / tau - 1), 2e-10)

    def test_of_problem_files(self):
        files = [*sorted(PROBLEMS.glob("paper/*.yaml")), *sorted(PROBLEMS.glob("limits/*.yaml")),
                 *sorted(PROBLEMS.glob("worlds/*.yaml"))]
        self.assertGreater(len(files), 40)
        for path in files:
            with self.subTest(path.name):
                result = brachisto.solve(brachisto.Scene.from_file(path))

                self.assert_same(result, run("solve", path, "--json"))

    def test_of_options(self):
        path = PROBLEMS / "case.yaml"
        scene = brachisto.Scene.from_file(path).changed(finish={"L": 2.5})
        for keys, flags in [
            ({"method": "newton_kkt", "polish": False},
             ["solver.method=newton_kkt", "solver.polish=false"]),
            ({"method": "extremal"}, ["solver.method=extremal"]),
            ({"method": "fsolve", "fsolve": {"slopes": "smooth"}},
             ["solver.method=fsolve", "solver.fsolve.slopes=smooth"]),
            ({"linear_solver": "mumps", "certify": "extremal"},
             ["solver.linear_solver=mumps", "solver.certify=extremal"]),
            ({"sensitivities": "second"}, ["solver.sensitivities=second"]),
        ]:
            with self.subTest(keys=keys):
                result = brachisto.solve(scene, solver=keys)

                flags = [f"--set={flag}" for flag in ["scene.finish.L=2.5", *flags]]
                self.assert_same(result, run("solve", path, "--json", *flags))

    def test_of_trajectories(self):
        for name in ["paper/fig04_reference_case", "paper/fig06_bead", "limits/coaster"]:
            with self.subTest(name), tempfile.TemporaryDirectory() as directory:
                path = PROBLEMS / f"{name}.yaml"
                run("solve", path, "--out", directory, "--quiet", "--force")
                with open(f"{directory}/trajectory.csv", encoding="utf-8") as file:
                    head, *rows = [line.rstrip("\n").split(",") for line in file]

                trajectory = brachisto.solve(brachisto.Scene.from_file(path)).trajectory

                self.assertEqual(list(trajectory), head)
                for name, cells in zip(head, zip(*rows)):
                    if name == "active":
                        self.assertEqual(trajectory[name].tolist(), list(cells))
                    else:
                        numbers = np.array([float(cell or "nan") for cell in cells])
                        np.testing.assert_array_equal(trajectory[name], numbers, name)


if __name__ == "__main__":
    unittest.main()
