# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Results: attributes as the table of result keys has them."""

import json
import re
import unittest

import brachisto
import numpy as np
from command import PROBLEMS, ROOT

CASE = brachisto.Scene.from_file(PROBLEMS / "paper/fig04_reference_case.yaml")


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = brachisto.solve(CASE)

    def test_attributes_are_the_keys_of_the_document(self):
        def compare(record, document):
            self.assertEqual(list(record), list(document))
            for key, value in document.items():
                found = record[key]
                if key.isidentifier():
                    self.assertIs(type(getattr(record, key)), type(found), key)
                if isinstance(found, brachisto.Record):
                    compare(found, value)
                elif isinstance(found, list) and found and isinstance(found[0], brachisto.Record):
                    for item, values in zip(found, value, strict=True):
                        compare(item, values)
                else:
                    self.assertEqual(found, value)

        compare(self.result, json.loads(self.result.to_json()))

    def test_every_row_of_the_reference_is_documented(self):
        page = (ROOT / "docs/results.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| `([^`]+)` \| (\w+) \| ([^|]*) \| (.*) \|$", page, re.MULTILINE)
        self.assertGreater(len(rows), 100)
        for name, _, unit, meaning in rows:
            if re.search(r"\.\d", name):
                continue  # "share_above_0.3": no name for Python
            path = name.replace("[]", "").split(".")
            record = brachisto.Result
            for key in path[:-1]:
                record = record._made_of[key]
            told = getattr(record, path[-1]).__doc__
            self.assertEqual(told, f"{meaning} [{unit.strip()}]" if unit.strip() else meaning)

    def test_what_is_not_asked_for_is_none(self):
        self.assertIsNone(self.result.sensitivities)
        self.assertIsNone(self.result.limits)
        self.assertNotIn("limits", self.result)
        with self.assertRaises(AttributeError):
            self.result.transit
        with self.assertRaises(KeyError):
            self.result["transit"]

    def test_keys_that_are_no_names_are_items(self):
        self.assertEqual(list(self.result.friction),
                         ["share_above_0.3", "share_above_0.5", "share_above_1"])
        self.assertGreater(self.result.friction["share_above_0.3"], 0)

    def test_certificate_has_all_checks(self):
        checks = self.result.certificate.checks
        self.assertTrue(all(check.passed and check.value <= check.threshold for check in checks))
        self.assertIn("kkt_residual", [check.name for check in checks])
        for check in checks:
            self.assertEqual(getattr(self.result.certificate, check.name), check.value)

    def test_trajectory_leads_from_a_to_b_in_the_transit_time(self):
        path = self.result.trajectory
        self.assertEqual(len(path["t"]), self.result.nodes)
        self.assertEqual((path["x_b"][0], path["t"][0], path["v_c"][0]), (0, 0, 0))
        self.assertAlmostEqual(path["x_b"][-1], 3, delta=1e-11)
        self.assertAlmostEqual(path["z_b"][-1], 1, delta=1e-11)
        self.assertAlmostEqual(path["t"][-1], self.result.transit_time, delta=1e-12)
        # No slip: the speed of the centre is r ω.
        np.testing.assert_allclose(path["v_c"], path["omega"] / 3, rtol=1e-14)
        self.assertIs(self.result.trajectory, path)

    def test_of_a_failed_solve_tells_why(self):
        result = brachisto.solve(CASE, solver={"limits": {"seconds": 1e-6}})
        self.assertEqual(result.status, "time_limit")
        self.assertFalse(result.verified)
        self.assertTrue(result.message)
        self.assertIsNone(result.tau)
        self.assertIsNone(result.trajectory)
        self.assertEqual(repr(result), "<Result: time_limit, not verified>")

    def test_a_neighbour_gives_the_same_track(self):
        nearby = CASE.changed(body={"k": 0.49})
        alone = brachisto.solve(nearby)
        beside = brachisto.solve(nearby, near=self.result)
        self.assertTrue(beside.verified)
        self.assertAlmostEqual(beside.tau / alone.tau, 1, delta=2e-10)
        self.assertLess(len(beside.continuation), len(alone.continuation) + 1)
        failed = brachisto.solve(CASE, solver={"limits": {"seconds": 1e-6}})
        self.assertEqual(brachisto.solve(nearby, near=failed).tau, alone.tau)

    def test_documents_are_problem_files(self):
        again = brachisto.solve(brachisto.Scene.from_text(self.result.to_json()))
        self.assertEqual(again.tau, self.result.tau)

    def test_summary_is_that_of_the_command(self):
        self.assertIn("5.0934", self.result.summary())


class Sensitivities(unittest.TestCase):
    def test_are_the_slopes_of_whole_solves(self):
        slopes = brachisto.sensitivities(brachisto.solve(CASE))

        for step, key, slope in [(1e-4, "k", slopes.k.tau), (1e-4, "eta_m", slopes.eta_m.tau),
                                 (1e-4, "radius", slopes.radius.tau)]:
            value = CASE.input["scene"]["body"][key]
            high, low = (brachisto.solve(CASE.changed(body={key: value + sign * step})).tau
                         for sign in (1, -1))
            # The third derivative times step²/6, and 1e-10 τ / step: 1e-6 is more than both.
            self.assertAlmostEqual((high - low) / (2 * step), slope, delta=1e-5)

    def test_are_those_of_the_option(self):
        for option, second in [(True, False), ("second", True)]:
            asked = brachisto.solve(CASE, solver={"sensitivities": option}).sensitivities
            later = brachisto.sensitivities(brachisto.solve(CASE), second)
            self.assertEqual(asked, later)
            self.assertEqual("second" in later, second)

    def test_are_none_of_another_method(self):
        result = brachisto.solve(CASE, solver={"method": "extremal"})
        self.assertTrue(result.verified)
        self.assertIsNone(brachisto.sensitivities(result))


if __name__ == "__main__":
    unittest.main()
