#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""What two builds of the command say of the same input, side by side.

    compare.py REFERENCE CANDIDATE          every digit and every word equal
    compare.py --arithmetic REFERENCE CANDIDATE
                                            outcomes equal, τ within the estimate

Run before and after a change of structure, with the executables of both states.
The input is every problem file, thousands of random scenes, input that is to be
refused, and the verbs that go through families of scenes. Times, versions and
machine do not count. What a change of the schema renamed stands in `schema.json`
beside this file and is applied to what the reference says; keys that it added there are
left out of what the candidate says, where the reference does not have them yet.
"""

import argparse
import concurrent.futures
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import cases

HERE = pathlib.Path(__file__).resolve().parent
SECONDS = 300

# Keys that differ from run to run, wherever they stand.
VOLATILE = re.compile(r"^seconds\.|^forecast\.seconds$|_seconds$|memory|^(sentence|quickest)$"
                      r"|^(provenance|machine|date|version)$")
# Progress, and times that messages tell.
PROGRESS = re.compile(r"^\[ *\d+ s\].*$|^\r.*$", re.MULTILINE)
TIMES = re.compile(r"\d+(\.\d+)? (s|ms|min|[kMGT]?B)\b")
# Of a result: equal in every arithmetic.
DISCRETE = {"status", "verified", "feasible", "nodes", "principal", "minimum",
            "schema_version", "solved"}


def run(binary, case):
    """Exit codes, output and files of the commands of a case."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in case.files.items():
            (pathlib.Path(folder) / name).write_bytes(text)
        result = {}
        for arguments in [case.arguments, *case.then]:
            try:
                done = subprocess.run([binary, *arguments], cwd=folder, timeout=SECONDS,
                                      stdin=subprocess.DEVNULL, capture_output=True)
            except subprocess.TimeoutExpired:
                return {"exit": "timeout"}
            which = f"{len(result) // 3} " if case.then else ""
            result[which + "exit"] = done.returncode
            out = done.stdout.decode("utf-8", "replace")
            result[which + "stdout"] = columns(out) if "--csv" in arguments else document(out)
            result[which + "stderr"] = words(done.stderr.decode("utf-8", "replace"))
        for path in sorted(pathlib.Path(folder).rglob("*")):
            name = path.relative_to(folder).as_posix()
            if path.is_dir() or name in case.files or path.suffix in (".sqlite", ".lock"):
                continue
            result["file " + name] = of_file(path)
        return result


def words(text):
    return TIMES.sub("… s", PROGRESS.sub("", text)).strip()


def document(text):
    """JSON with its numbers as they were printed; other text as words."""
    try:
        return without_times(json.loads(text, parse_float=str, parse_int=str))
    except ValueError:
        pass
    head, brace, tail = text.partition(":\n{")  # a document that words announce
    if brace:
        try:
            return {"(words)": words(head), **without_times(
                json.loads("{" + tail, parse_float=str, parse_int=str))}
        except ValueError:
            pass
    return words(text)


def without_times(value, parent=""):
    if isinstance(value, dict):
        return {key: without_times(v, key) for key, v in value.items()
                if not VOLATILE.search(key) and not VOLATILE.search(f"{parent}.{key}")
                and not (key == "seconds" and isinstance(v, dict))}
    if isinstance(value, list):
        return [without_times(v) for v in value]
    return words(value) if isinstance(value, str) and " " in value else value


def of_file(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix == ".json":
        return document(text)
    if path.suffix == ".csv":
        return columns(text)
    return path.suffix + " file"  # pictures and pages are looked at


def columns(text):
    rows = [line.split(",") for line in text.splitlines()]
    kept = [i for i, name in enumerate(rows[0]) if not VOLATILE.search(name)]
    return [",".join(row[i] for i in kept if i < len(row)) for row in rows]


def translate(value, renamed, path=""):
    """What the reference says, under the names of today's schema."""
    if isinstance(value, list):
        return [translate(v, renamed, path) for v in value]
    if not isinstance(value, dict):
        return value
    out = {}
    for key, inner in value.items():
        here = f"{path}.{key}" if path else key
        name = renamed.get(here, key)
        if name is not None:
            out[name] = translate(inner, renamed, here)
    return out


def without(value, added, reference, path=""):
    """What the candidate says, without the keys that are new and that the reference lacks."""
    if isinstance(value, list):
        old = reference if isinstance(reference, list) else []
        pairs = itertools.zip_longest(value, old[:len(value)])
        return [without(v, added, o, path) for v, o in pairs]
    if not isinstance(value, dict):
        return value
    old = reference if isinstance(reference, dict) else {}
    here = {key: f"{path}.{key}" if path else key for key in value}
    return {key: without(v, added, old.get(key), here[key]) for key, v in value.items()
            if here[key] not in added or key in old}


def as_number(value):
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


def differences(old, new, arithmetic, path=""):
    """Where two results differ, as lines of text."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(set(old) | set(new)):
            here = f"{path}/{key}"
            if key not in old or key not in new:
                yield f"{here}: only in the {'candidate' if key in new else 'reference'}"
            else:
                yield from differences(old[key], new[key], arithmetic, here)
    elif isinstance(old, list) and isinstance(new, list) and not arithmetic:
        if len(old) != len(new):
            yield f"{path}: {len(old)} against {len(new)} items"
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, arithmetic, f"{path}/{i}")
    elif old != new and not (arithmetic and close(old, new, path)):
        yield f"{path}: {shorten(old)} became {shorten(new)}"


def close(old, new, path):
    """Whether a value may differ if the arithmetic does."""
    key = path.rsplit("/", 1)[-1]
    if key in DISCRETE or path.endswith("exit"):
        return False
    a, b = as_number(old), as_number(new)
    if a is not None and b is not None and key in ("tau", "transit_time"):
        return abs(a - b) <= 1e-10 * abs(a)
    return True


def shorten(value):
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 160 else text[:157] + "…"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reference", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("candidate", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("--arithmetic", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=2000, help="random scenes")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="names that contain this")
    parser.add_argument("--until-different", action="store_true", help="stop at the first")
    parser.add_argument("--show", type=int, default=20, help="differences told in full")
    flags = parser.parse_args()
    schema = json.loads((HERE / "schema.json").read_text(encoding="utf-8"))
    chosen = [c for c in cases.all_cases(flags.seed, flags.count) if flags.only in c.name]

    def compare(case):
        old, new = run(flags.reference, case), run(flags.candidate, case)
        old = {key: translate(value, schema["renamed"]) if isinstance(value, dict) else value
               for key, value in old.items()}
        new = {key: without(value, schema["added"], old.get(key)) if isinstance(value, dict)
               else value for key, value in new.items()}
        return case, list(differences(old, new, flags.arithmetic))

    counts, told = {}, 0
    with concurrent.futures.ThreadPoolExecutor(flags.jobs) as pool:
        for case, found in pool.map(compare, chosen):
            kind = counts.setdefault(case.name.split("/")[0], [0, 0])
            kind[0] += 1
            kind[1] += bool(found)
            if found and told < flags.show:
                told += 1
                print(f"{case.name}: {len(found)} differences")
                for line in found[:8]:
                    print("   " + line)
            if found and flags.until_different:
                pool.shutdown(cancel_futures=True)
                break
    for kind, (number, different) in sorted(counts.items()):
        print(f"{kind:10} {number:6} cases, {different} differ")
    sys.exit(any(different for _, different in counts.values()))


if __name__ == "__main__":
    main()
