# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""What notebooks show, and pages: those that the command writes."""

import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ET

import brachisto
from command import PROBLEMS, run

CASE = brachisto.Scene.from_file(PROBLEMS / "paper/fig04_reference_case.yaml")
BEAD = brachisto.Scene(body={"shape": "bead"}, finish={"L": 3, "H": 1})
TOO_LARGE = CASE.changed(body={"radius": 2}, finish={"L": 0.5})
SVG = "{http://www.w3.org/2000/svg}"


def words(element):
    return " ".join("".join(element.itertext()).split())


def texts_of_x(card):
    return [text for text in card.iter(f"{SVG}text") if text.get("text-anchor") == "middle"]


class Cards(unittest.TestCase):
    def test_has_the_figures_of_the_result_with_their_units(self):
        result = brachisto.solve(CASE)
        card = ET.fromstring(result._repr_html_())
        rows = {words(row.find("th")): words(row.find("td")) for row in card.iter("tr")}

        self.assertEqual(list(rows)[:3], ["transit time T", "τ = T √(2g/H)", "length of the track"])
        told = re.fullmatch(r"([\d.]+)\(\d+\) s", rows["transit time T"])
        self.assertAlmostEqual(float(told[1]), result.transit_time, delta=1e-9)
        self.assertRegex(rows["length of the track"], r"^[\d.]+ m$")
        self.assertRegex(rows["normal force Rn"], r"^[\d.]+ to [\d.]+ m g$")
        self.assertEqual(rows["verdict"], "verified, feasible")

    def test_the_track_is_drawn_in_equal_scales_with_axes_in_metres(self):
        result = brachisto.solve(CASE)
        card = ET.fromstring(result._repr_html_())
        texts = {words(text): text for text in card.iter(f"{SVG}text")}
        (line,) = card.iter(f"{SVG}polyline")
        points = [tuple(map(float, point.split(","))) for point in line.get("points").split()]

        self.assertLessEqual({"x [m]", "z, down [m]", "A", "B"}, set(texts))
        # Pixels of a metre, from the ticks below.
        ticks = {words(text): float(text.get("x")) for text in texts_of_x(card)}
        across = ticks["2"] - ticks["1"]
        (x_a, z_a), (x_b, z_b) = points[0], points[-1]
        # A pixel is rounded to a tenth.
        self.assertAlmostEqual(x_b - x_a, 3 * across, delta=0.5)
        self.assertAlmostEqual(z_b - z_a, across, delta=0.5)
        deepest = (max(z for _, z in points) - z_a) / across
        self.assertAlmostEqual(deepest, result.trajectory["z_b"].max(), delta=0.3 / across)
        # The body, and where it touches the track, at six equal times.
        radii = [float(circle.get("r")) for circle in card.iter(f"{SVG}circle")]
        self.assertEqual(sum(abs(r - across / 3) < 0.06 for r in radii), 6)

    def test_words_take_their_colour_from_around(self):
        for result in [brachisto.solve(CASE), brachisto.solve(BEAD), brachisto.solve(TOO_LARGE)]:
            card = result._repr_html_()
            self.assertNotRegex(card, r"black|white|background|<script|(?:src|href)=")
            for text in re.findall(r"<text[^>]*>", card):
                self.assertNotIn("fill", text)

    def test_colours_are_seen_on_light_and_on_dark(self):
        def luminance(colour):  # of sRGB, as WCAG has it
            parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
            linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
            return sum(w * p for w, p in zip((0.2126, 0.7152, 0.0722), linear))

        race = brachisto.race({str(i): CASE.changed(body={"k": 0.5 - i / 100}) for i in range(7)})
        colours = set(re.findall(r'stroke="(#\w{6})"', race._repr_html_()))

        self.assertEqual(len(colours), 6)
        for colour in colours:
            for ground in "#ffffff", "#111111":  # of notebooks
                pair = sorted([luminance(colour) + 0.05, luminance(ground) + 0.05])
                self.assertGreaterEqual(pair[1] / pair[0], 3, (colour, ground))

    def test_a_failure_is_told_and_not_drawn(self):
        result = brachisto.solve(TOO_LARGE)
        card = ET.fromstring(result._repr_html_())

        self.assertIn(result.status, words(card))
        self.assertIsNone(card.find(f".//{SVG}svg"))


class Pages(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def read(self, name):
        with open(f"{self.directory}/{name}", encoding="utf-8") as file:
            return file.read()

    def test_of_an_answer_is_that_of_the_command(self):
        path = PROBLEMS / "limits/coaster.yaml"
        run("solve", path, "--out", self.directory, "--quiet")

        brachisto.solve(brachisto.Scene.from_file(path)).write_page(f"{self.directory}/own.html")

        data = [re.search(r'id="data">(.*?)</script>', self.read(name), re.DOTALL)[1]
                for name in ("index.html", "own.html")]
        self.assertEqual(data[0], data[1])
        own, other = self.read("own.html"), self.read("index.html")
        self.assertLess(abs(len(own) - len(other)), 200)  # digits of times

    def test_of_a_race_is_that_of_the_command(self):
        names = ["bead", "uniform_cylinder", "cylinder_off_centre"]
        files = [PROBLEMS / f"race/{name}.yaml" for name in names]
        run("race", *files, "--out", f"{self.directory}/race.html", "--quiet")

        race = brachisto.race({name.replace("_", " "): brachisto.Scene.from_file(file)
                               for name, file in zip(names, files)})
        race.write_page(f"{self.directory}/own.html")

        self.assertEqual(self.read("own.html"), self.read("race.html"))

    def test_of_a_race_on_one_track_is_that_of_the_command(self):
        names = ["uniform_cylinder", "cylinder_off_centre"]
        files = [PROBLEMS / f"race/{name}.yaml" for name in names]
        run("race", *files, "--same-track", "--out", f"{self.directory}/race.html", "--quiet")
        scenes = {name.replace("_", " "): brachisto.Scene.from_file(file)
                  for name, file in zip(names, files)}

        brachisto.race(scenes, same_track=True).write_page(f"{self.directory}/own.html")

        self.assertEqual(self.read("own.html"), self.read("race.html"))
        with self.assertRaisesRegex(TypeError, "give its Scene"):
            second = brachisto.solve(scenes["cylinder off centre"])
            brachisto.race(scenes | {"cylinder off centre": second}, same_track=True)

    def test_is_not_replaced_unless_it_is_said(self):
        result = brachisto.solve(BEAD)
        path = f"{self.directory}/new/page.html"
        result.write_page(path)

        with self.assertRaisesRegex(OSError, "page.html: exists; force=True replaces it"):
            result.write_page(path)
        result.write_page(path, force=True)
        with self.assertRaises(OSError):
            result.write_page(f"{path}/below.html")

    def test_without_a_motion_there_is_none(self):
        result = brachisto.solve(TOO_LARGE)

        with self.assertRaisesRegex(brachisto.NotVerified, "no motion to show: B lies") as caught:
            result.write_page(f"{self.directory}/page.html")
        self.assertIs(caught.exception.result, result)
        self.assertEqual(os.listdir(self.directory), [])


class Races(unittest.TestCase):
    def test_the_order_is_that_of_the_times(self):
        solved = brachisto.solve(CASE)
        race = brachisto.race({"off": solved, "uniform": CASE.changed(body={"eta_m": 0}),
                               "bead": BEAD})
        table = race.table()

        self.assertEqual(table["body"], ["bead", "off", "uniform"])
        # The closed forms of the two that have one, L = 3 and H = 1.
        for name, tau in [("bead", 4.510563136747), ("uniform", 5.115100653580)]:
            time_of = tau / math.sqrt(2 * 9.81)
            self.assertAlmostEqual(race.results[name].transit_time, time_of, delta=1e-9)
        self.assertIs(race.results["off"], solved)
        for behind, time_of in zip(table["behind"], table["transit_time"]):
            self.assertAlmostEqual(float(behind), 1e3 * (time_of - table["transit_time"][0]),
                                   delta=1e-3)
        card = ET.fromstring(race._repr_html_())
        self.assertEqual([words(row)[:1] for row in card.iter("tr")][1:], ["1", "2", "3"])
        self.assertEqual(len(list(card.iter(f"{SVG}polyline"))), 3)

    def test_no_track_hides_another(self):
        # Of a uniform cylinder the track is the same whatever k is.
        uniform = CASE.changed(body={"eta_m": 0})
        race = brachisto.race({"disc": uniform, "hoop": uniform.changed(body={"k": 1}),
                               "off": CASE})
        card = ET.fromstring(race._repr_html_())
        dashes = [line.get("stroke-dasharray") for line in card.iter(f"{SVG}polyline")]

        order = race.table()["body"]
        self.assertEqual({order[i] for i in range(3) if dashes[i]}, {"hoop"})

    def test_what_cannot_race_is_refused(self):
        with self.assertRaisesRegex(ValueError, "2 to 24 bodies can race, not 1"):
            brachisto.race({"alone": BEAD})
        with self.assertRaisesRegex(TypeError, "b: expected a Scene or a Result, read one of type"):
            brachisto.race({"a": BEAD, "b": 3})
        with self.assertRaisesRegex(brachisto.NotVerified, "large: B lies inside"):
            brachisto.race({"bead": BEAD, "large": TOO_LARGE})
        with self.assertRaises(brachisto.InputError) as caught:
            brachisto.race({"a": BEAD, "b": BEAD.changed(finish={"L": 4})})
        (found,) = caught.exception.diagnostics
        self.assertEqual(found.key, "scene.finish")
        self.assertRegex(found.message, '^"b": the track runs .* to .4, 1., that of "a" ')


class Designs(unittest.TestCase):
    def test_has_the_numbers_of_the_command(self):
        path = PROBLEMS / "design/quickest.yaml"
        flags = ["--set=design.starts=2"]
        expected = brachisto.design(brachisto.Scene.from_file(path), starts=2).to_dict()
        found = run("design", path, "--json", *flags)

        document = json.loads(found)
        for each in expected, document:
            del each["seconds"], each["design"]["cpu_seconds"]
            (each.get("forecast") or {}).pop("seconds", None)
        self.assertEqual(expected, document)

    def test_what_is_free_is_asked_for_by_its_key(self):
        with self.assertRaisesRegex(brachisto.InputError, "design.free: missing; expected"):
            brachisto.design(CASE)
        with self.assertRaisesRegex(brachisto.InputError, 'design.free: "eta" was read'):
            brachisto.design(CASE, free=["eta"])

    def test_ctrl_c_ends_it(self):
        script = """if True:
            import brachisto
            from test_pages import CASE
            try:
                print("begin", flush=True)
                brachisto.design(CASE, free=["eta_m", "theta_m", "k"], starts=1000)
            except KeyboardInterrupt:
                print("stopped")"""
        program = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE,
                                   cwd=sys.path[0], encoding="utf-8")
        with program:
            self.assertEqual(program.stdout.readline(), "begin\n")
            time.sleep(0.5)
            program.send_signal(signal.SIGINT)
            self.assertEqual(program.stdout.read(), "stopped\n")
        self.assertEqual(program.returncode, 0)

    def test_the_limit_of_time_is_that_of_all_searches(self):
        since = time.monotonic()
        result = brachisto.design(CASE, free=["eta_m", "theta_m", "k"], starts=1000,
                                  solver={"limits": {"seconds": 1}})

        self.assertLess(time.monotonic() - since, 60)
        self.assertIn("the limit of 1 s was reached", " ".join(result.warnings))
        self.assertLess(result.tau, brachisto.solve(CASE).tau)


class Comparisons(unittest.TestCase):
    def test_has_all_methods_and_their_true_errors(self):
        made = brachisto.compare(CASE, nodes=21, repetitions=1)
        table = made.table()

        self.assertIn("rolling_time", table["method"])
        self.assertEqual(len({len(column) for column in table.values()}), 1)
        # Of the closed-loop reference value; rows beside it have errors of their own.
        best = table["tau"][table["method"].index("extremal")]
        self.assertAlmostEqual(best / brachisto.solve(CASE).tau, 1, delta=2e-10)
        for tau, error in zip(table["tau"], table["error"]):
            if tau is not None:
                self.assertAlmostEqual(error, abs(tau / best - 1), delta=1e-14)
        self.assertIn("<pre", made._repr_html_())
        with tempfile.TemporaryDirectory() as directory:
            made.write_page(f"{directory}/compare.html")
            ET.parse(f"{directory}/compare.html")

    def test_what_is_refused_has_its_key(self):
        with self.assertRaisesRegex(ValueError, "nodes: Value 3 not in range"):
            brachisto.compare(CASE, nodes=3)
        given = brachisto.Scene.from_file(PROBLEMS / "race/straight_track.yaml")
        with self.assertRaises(brachisto.InputError) as caught:
            brachisto.compare(given)
        self.assertEqual(caught.exception.diagnostics[0].key, "scene.path")

    def test_without_the_command_it_says_where_it_looked(self):
        script = """if True:
            import brachisto
            from test_pages import BEAD
            try:
                brachisto.compare(BEAD)
            except FileNotFoundError as error:
                print(error)"""
        told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                              cwd=sys.path[0], check=True,
                              env={**os.environ, "BRACHISTO_APP": "/nowhere/brachisto"}).stdout
        self.assertRegex(told, r"the command `brachisto` of version [\d.]+ is needed as /nowhere")


if __name__ == "__main__":
    unittest.main()
