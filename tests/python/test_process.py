# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The module as part of a process: signals, threads, memory."""

import concurrent.futures
import signal
import subprocess
import sys
import threading
import time
import unittest

import brachisto
from command import reference_rows, without_times

QUICK = brachisto.Scene(body={"shape": "bead"}, finish={"L": 3, "H": 1})
# A search that takes minutes.
LONG = brachisto.Scene(
    body={"shape": "cylinder", "radius": 0.02, "eta_m": "2/3", "k": 0.5}, finish={"L": 3, "H": 1}
)
SEARCH = {"search": "global"}
# What takes longer hangs: from a signal to the end of a solve takes milliseconds.
PATIENCE = 300.0


class Signals(unittest.TestCase):
    def test_ctrl_c_ends_a_solve(self):
        script = """if True:
            import brachisto
            from test_process import LONG, QUICK, SEARCH
            try:
                print("begin", flush=True)
                brachisto.solve(LONG, solver=SEARCH)
            except KeyboardInterrupt:
                print(brachisto.solve(QUICK).status)"""
        program = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE,
                                   cwd=sys.path[0], encoding="utf-8")
        with program:
            self.assertEqual(program.stdout.readline(), "begin\n")
            time.sleep(0.5)
            self.assertIsNone(program.poll())
            program.send_signal(signal.SIGINT)
            since = time.monotonic()
            self.assertEqual(program.stdout.read(), "solved\n")
            self.assertLess(time.monotonic() - since, PATIENCE)
        self.assertEqual(program.returncode, 0)

    def in_a_while(self, handler):
        before = signal.signal(signal.SIGALRM, handler)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.2)

    def test_what_any_handler_raises_comes_out_of_a_solve(self):
        class Enough(Exception):
            pass

        def handler(*_):
            raise Enough

        self.in_a_while(handler)
        with self.assertRaises(Enough):
            brachisto.solve(LONG, solver=SEARCH)
        self.assertTrue(brachisto.solve(QUICK).verified)

    def test_a_handler_that_returns_leaves_the_solve_alone(self):
        handled = []
        self.in_a_while(lambda number, frame: handled.append(number))

        result = brachisto.solve(LONG, solver={**SEARCH, "limits": {"seconds": 1}})

        self.assertEqual(handled, [signal.SIGALRM])
        self.assertEqual(result.status, "time_limit")


class Threads(unittest.TestCase):
    def test_two_at_a_time_find_what_one_finds(self):
        def solved(keys):
            return without_times(brachisto.solve(brachisto.Scene(**keys)).to_json())

        scenes = [keys for _, keys, _ in reference_rows()]
        expected = list(map(solved, scenes))

        with concurrent.futures.ThreadPoolExecutor(2) as threads:
            found = list(threads.map(solved, [*scenes, *reversed(scenes)]))

        self.assertEqual(found, [*expected, *reversed(expected)])

    def test_others_run_during_a_solve(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.01):
                ticks.append(time.monotonic())

        other = threading.Thread(target=tick)
        other.start()
        brachisto.solve(LONG, solver={**SEARCH, "limits": {"seconds": 1}})
        done.set()
        other.join()
        # One before the solve and one after it are all that a solve that keeps others from
        # running leaves; there are some hundred, most of which a busy machine may leave out.
        self.assertGreater(len(ticks), 2)


class Memory(unittest.TestCase):
    def test_does_not_grow_with_the_number_of_solves(self):
        # A process of its own, in which nothing else comes and goes.
        script = """if True:
            import resource
            import brachisto
            from test_process import QUICK

            def resident():
                with open("/proc/self/statm") as file:
                    return int(file.read().split()[1]) * resource.getpagesize()

            refused = 0
            for count in range(1, 1001):
                mesh = {"degree": 4, "elements": 6 + count % 4}
                result = brachisto.solve(QUICK, discretisation=mesh)
                assert result.to_json() and result.summary() and result.status == "solved"
                brachisto.sensitivities(result)
                len(result.trajectory["x_b"]) if result.verified else None
                try:
                    QUICK.changed(body={"k": 2})
                except brachisto.InputError:
                    refused += 1
                if count == 200:
                    before = resident()
            assert refused == 1000
            print(resident() - before)"""
        grown = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE,
                               cwd=sys.path[0], check=True).stdout
        # 800 results: were they or a part of them kept, a document alone has 8 kB, this
        # would be 6 MB and more.
        self.assertLess(int(grown), 1 << 20)


if __name__ == "__main__":
    unittest.main()
