#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""From a signal, and from the limit of time, to the end of a large solve.

Runs the command once undisturbed, then sends SIGTERM at moments spread over
that time, and then solves with limits spread over it. Prints each latency and
exits with 1 if one is more than a second or leaves no JSON document. Python 3.8
or later, nothing else.

    latency.py problems/large/million_nodes.yaml --set solver.method=ipopt
"""

import argparse
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

MOST_SECONDS = 1.0


class Solve:
    """A solve that writes its results, too."""

    def __init__(self, program, arguments, limit=None):
        self.folder = tempfile.TemporaryDirectory()
        command = [str(program), "solve", *arguments, "--json", "--quiet",
                   "--out", self.folder.name + "/out"]
        if limit is not None:
            command += ["--set", f"solver.limits.seconds={limit}"]
        self.out = open(self.folder.name + "/stdout", "w+b")
        self.begin = time.monotonic()
        self.process = subprocess.Popen(command, stdout=self.out,
                                        stderr=subprocess.DEVNULL)

    def end(self):
        """Exit code, status in the document, and seconds since the start."""
        code = self.process.wait()
        seconds = time.monotonic() - self.begin
        self.out.seek(0)
        try:
            status = json.load(self.out)["status"]
        except (ValueError, KeyError):
            status = None
        self.out.close()
        self.folder.cleanup()
        return code, status, seconds


def report(title, latencies, faults):
    if not latencies:
        print(f"{title}: the solve was always done before")
        return
    ordered = sorted(latencies)
    print(f"{title}: median {ordered[len(ordered) // 2]:.2f} s, longest "
          f"{ordered[-1]:.2f} s of {len(ordered)}, {faults} faults\n")


def main():
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, metavar="FILE",
                        default=root / "build/release/src/app/brachisto",
                        help="the command (%(default)s)")
    parser.add_argument("--moments", type=int, default=20, metavar="N",
                        help="of signals, and of limits (%(default)s)")
    options, arguments = parser.parse_known_args()

    code, status, whole = Solve(options.program, arguments).end()
    print(f"undisturbed: {whole:.1f} s, exit code {code}, {status}\n")
    moments = [whole * (i + 0.5) / options.moments
               for i in range(options.moments)]
    all_faults = 0

    latencies, faults = [], 0
    for moment in moments:
        solve = Solve(options.program, arguments)
        time.sleep(moment)
        if solve.process.poll() is not None:
            solve.end()
            continue
        solve.process.send_signal(signal.SIGTERM)
        sent = time.monotonic() - solve.begin
        code, status, seconds = solve.end()
        latencies.append(seconds - sent)
        fault = (latencies[-1] > MOST_SECONDS or status is None or
                 code not in (0, 143))
        faults += fault
        print(f"signal after {moment:6.2f} s: {latencies[-1]:.2f} s, exit code "
              f"{code}, {status}{'  FAULT' if fault else ''}", flush=True)
    report("signals", latencies, faults)
    all_faults += faults

    latencies, faults = [], 0
    for moment in moments:
        code, status, seconds = Solve(options.program, arguments,
                                      round(moment, 3)).end()
        # The limit is for the solve; what follows is the writing of results.
        if code != 7:
            continue
        latencies.append(max(0.0, seconds - moment))
        fault = latencies[-1] > MOST_SECONDS or status is None
        faults += fault
        print(f"limit of {moment:6.2f} s: exceeded by {latencies[-1]:.2f} s, "
              f"{status}{'  FAULT' if fault else ''}", flush=True)
    report("limits", latencies, faults)
    all_faults += faults
    return 1 if all_faults else 0


if __name__ == "__main__":
    sys.exit(main())
