# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Answers of the command, each asked for once."""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import tempfile

SECONDS = 300


class Program:
    def __init__(self, executable, root):
        self.executable = str(pathlib.Path(executable).resolve())
        self.root = root
        self.answers = {}

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def solve(self, problem, *flags, may_fail=False):
        """The JSON of a problem, a file below problems/ or the document itself.

        may_fail: an answer that is not verified or not feasible is one too.
        """
        key = json.dumps([problem, flags])
        if key not in self.answers:
            self.answers[key] = self._run(problem, flags, may_fail)
        return self.answers[key]

    def _run(self, problem, flags, may_fail):
        if isinstance(problem, str):
            file = self.root / "problems" / problem
        else:
            handle, name = tempfile.mkstemp(suffix=".yaml", dir=self.folder.name)
            # JSON is YAML.
            with os.fdopen(handle, "w", encoding="utf-8") as out:
                json.dump(problem, out)
            file = name
        done = subprocess.run([self.executable, "solve", str(file), "--json", *flags],
                              capture_output=True, text=True, timeout=SECONDS, check=False)
        if done.returncode != 0 and not may_fail:
            raise RuntimeError(f"{problem}: exit {done.returncode}: {done.stderr}")
        return json.loads(done.stdout)

    def solve_all(self, problems, *flags, may_fail=False):
        """The answers of several problems, by all cores."""
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(lambda one: self.solve(one, *flags, may_fail=may_fail),
                                 problems))
