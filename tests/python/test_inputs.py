# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""What a program states is read as a problem file is, and refused with the same words."""

import json
import pathlib
import pickle
import tempfile
import unittest

import brachisto
import numpy as np
from command import PROBLEMS, run

MISTAKES = """\
scene:
  body: {shape: cylinder, radius: 0, eta_m: 2/3, k: 1/2, colour: red}
  finish: {L: 3, H: -1}
solver: {method: guess}
"""
BODY = {"shape": "cylinder", "radius": "1/3", "eta_m": "2/3", "theta_m": "-30 deg", "k": 0.5}
FINISH = {"L": 3, "H": 1}


class Scenes(unittest.TestCase):
    def test_keywords_say_what_a_file_says(self):
        text = """
scene:
  body: {shape: cylinder, radius: 1/3, eta_m: 2/3, theta_m: -30 deg, k: 0.5}
  finish: {L: 3, H: 1}
  contact: {end_slope: -10 deg}
  limits: {curvature: {hump: 2, valley: 2}, clear_of: [{disc: {x: 1, z: 1.3, radius: 0.2}}]}
"""
        scene = brachisto.Scene(
            body=BODY, finish=FINISH, contact={"end_slope": "-10 deg"},
            limits={"curvature": {"hump": 2, "valley": 2},
                    "clear_of": [{"disc": {"x": 1, "z": 1.3, "radius": 0.2}}]},
        )

        self.assertEqual(scene.input, brachisto.Scene.from_text(text).input)

    def test_numbers_of_numpy_are_numbers(self):
        finish = {"L": np.float64(3), "H": np.int64(1)}
        points = np.array([[0, 0], [1, 0.7], [3, 1]])

        scene = brachisto.Scene(body={"shape": "bead"}, finish=finish, contact="centre",
                                path={"shape": "points", "points": points})

        self.assertEqual(scene.input["scene"]["path"]["points"], points.tolist())
        self.assertEqual(scene.input["scene"]["finish"], {"L": 3, "H": 1})

    def test_input_is_that_of_validate_and_a_problem_again(self):
        for path in sorted(PROBLEMS.glob("*/*.yaml")):
            if path.parent.name in ("sweeps", "work_precision", "design"):
                continue
            with self.subTest(path.name):
                told = json.loads(run("validate", path, "--json"))
                if "errors" in told:  # of bodies that are none
                    self.assertEqual([list(error.values()) for error in told["errors"]],
                                     [list(error) for error in brachisto.validate(path)])
                    continue
                scene = brachisto.Scene.from_file(path)

                told.pop("forecast", None)  # no part of the input
                self.assertEqual(scene.input, told)
                again = brachisto.Scene.from_text(json.dumps(scene.input))
                self.assertEqual(again.input, scene.input)

    def test_a_change_leaves_the_other_keys(self):
        scene = brachisto.Scene(body=BODY, finish=FINISH)

        changed = scene.changed(body={"k": "1/4"}, finish={"L": 4}).changed(gravity=1.62)

        expected = scene.input
        expected["scene"]["body"]["k"] = 0.25
        expected["scene"]["finish"]["L"] = 4
        expected["scene"]["gravity"] = 1.62
        self.assertEqual(changed.input, expected)
        self.assertEqual(scene.input["scene"]["body"]["k"], 0.5)

    def test_can_be_pickled_and_shown(self):
        for scene in [brachisto.Scene(body=BODY, finish=FINISH).changed(gravity=2),
                      brachisto.Sweep.from_file(PROBLEMS / "sweeps/small.yaml")[1]]:
            copy = pickle.loads(pickle.dumps(scene))
            self.assertEqual(copy.input, scene.input)
            shown = eval(repr(scene), {"Scene": brachisto.Scene})
            self.assertEqual(shown.input["scene"], scene.input["scene"])

    def test_warnings_tell_what_is_hardly_meant(self):
        scene = brachisto.Scene(body={**BODY, "theta_m": "400 deg"}, finish=FINISH)

        (warning,) = scene.warnings
        self.assertEqual((warning.file, warning.line, warning.key),
                         ("<keywords>", 0, "scene.body.theta_m"))
        self.assertIn("more than a turn", warning.message)


class Mistakes(unittest.TestCase):
    def refusal(self, function, *arguments, **keys):
        with self.assertRaises(brachisto.InputError) as caught:
            function(*arguments, **keys)
        return caught.exception

    def test_are_told_as_the_command_tells_them(self):
        for text in [MISTAKES, "scene: [", "", "scene: {body: {shape: bead}}", "a: 1\na: 2\n",
                     "scene: &x {body: *x}\n", "\u03b8: 1\n", "x" * 2_000_000]:
            with self.subTest(text[:20]):
                error = self.refusal(brachisto.Scene.from_text, text, "-")

                told = json.loads(run("validate", "-", "--json", text=text))["errors"]
                self.assertEqual([d._asdict() for d in error.diagnostics], told)
                lines = [f"{d.file}:{d.line}:{d.column}: {d.key}{': ' if d.key else ''}{d.message}"
                         for d in error.diagnostics]
                if all(d.line for d in error.diagnostics):
                    self.assertEqual(str(error).splitlines(), lines)

    def test_all_of_them_are_told_with_their_places(self):
        error = self.refusal(brachisto.Scene.from_text, MISTAKES, "case.yaml")

        places = [(d.line, d.column, d.key) for d in error.diagnostics]
        keys = ["scene.body.radius", "scene.body.colour", "scene.finish.H", "solver.method"]
        self.assertEqual([key for _, _, key in places], keys)
        self.assertEqual([line for line, _, _ in places], [2, 2, 3, 4])
        self.assertEqual({d.file for d in error.diagnostics}, {"case.yaml"})
        self.assertIn("case.yaml:4:", str(error))
        self.assertIsInstance(error, ValueError)

    def test_of_keywords_have_no_lines(self):
        scene = brachisto.Scene(body=BODY, finish=FINISH)
        for error in [
            self.refusal(brachisto.Scene, body={**BODY, "k": 2}, finish=FINISH),
            self.refusal(scene.changed, body={"k": 2}),
            self.refusal(brachisto.Scene, body={**BODY, "k": float("nan")}, finish=FINISH),
            self.refusal(scene.changed, body={"k": "1/"}),
        ]:
            (mistake,) = error.diagnostics
            self.assertEqual(mistake[:4], ("<keywords>", 0, 0, "scene.body.k"))
        error = self.refusal(brachisto.solve, scene, solver={"limits": {"second": 1}})
        self.assertEqual(error.diagnostics[0].key, "solver.limits.second")
        self.assertIn("seconds", str(error))

    def test_survive_pickling(self):
        error = self.refusal(brachisto.Scene.from_text, MISTAKES)

        copy = pickle.loads(pickle.dumps(error))

        self.assertEqual((str(copy), copy.diagnostics), (str(error), error.diagnostics))

    def test_validate_lists_them(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "fälle.yaml"
            path.write_text(MISTAKES, encoding="utf-8")

            mistakes = brachisto.validate(path)

            self.assertEqual(len(mistakes), 4)
            self.assertEqual({mistake.file for mistake in mistakes}, {str(path)})
        self.assertEqual(brachisto.validate(PROBLEMS / "case.yaml"), [])
        self.assertEqual(brachisto.validate(PROBLEMS / "sweeps/small.yaml"), [])

    def test_a_file_that_cannot_be_read_is_an_os_error(self):
        for read in [brachisto.Scene.from_file, brachisto.Sweep.from_file, brachisto.validate]:
            for path in ["no/such.yaml", str(PROBLEMS)]:
                with self.assertRaises(OSError):
                    read(path)
        with self.assertRaises(OSError):  # that of the points
            brachisto.Scene(body={"shape": "bead"}, finish=FINISH,
                            path={"shape": "points", "file": "no/such.csv"})


if __name__ == "__main__":
    unittest.main()
