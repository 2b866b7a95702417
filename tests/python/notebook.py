# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""The cells of docs/notebook.ipynb do what they say.

    python3 notebook.py [PAGE]

runs them one after the other, as a notebook does, and compares what they show; with PAGE it
writes that as a page to be looked at. Where jupyter-nbconvert and a kernel are installed it
has them run the notebook too.
"""

import ast
import contextlib
import html
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTEBOOK = ROOT / "docs/notebook.ipynb"
CELLS = 12


def run_cell(source, names):
    """What a cell prints, and the value of its last line if that is one."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, NOTEBOOK.name, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), NOTEBOOK.name, "eval"), names)
    return printed.getvalue(), value


def shown(value):
    """As a notebook shows it, in HTML."""
    if value is None:
        return ""
    if hasattr(value, "_repr_html_"):
        return value._repr_html_()
    return f"<pre>{html.escape(repr(value))}</pre>"


def run_all(cells):
    """Of each code cell its source, what it prints and what it shows."""
    names, out = {"__name__": "__main__"}, []
    for cell in cells:
        if cell["cell_type"] != "code":
            continue
        source = "".join(cell["source"])
        printed, value = run_cell(source, names)
        out.append((source, printed, shown(value)))
    return out


def check(ran):
    """What the text of the cells promises."""
    text = [printed + display for _, printed, display in ran]
    assert "1.149905 s" in text[2], text[2]
    # A whole drawing each: the answer, the race and the design.
    assert [number for number, told in enumerate(text, 1) if "<svg" in told] == [2, 6, 7]
    order = [text[5].index(f"> {name}</th>") for name in ["bead", "off centre", "uniform", "hoop"]]
    assert order == sorted(order), text[5]
    assert "% less time" in text[8] and "ms" in text[8], text[8]
    assert "rolling_time" in text[9], text[9]
    assert "scene.body.radios: unknown key" in text[10] and "not verified" in text[10], text[10]


def run_by_jupyter():
    """What nbconvert makes of the notebook, or nothing where it is not installed."""
    with tempfile.TemporaryDirectory() as directory:
        command = [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute",
                   "--output-dir", directory, str(NOTEBOOK)]
        probe = subprocess.run([sys.executable, "-c", "import nbconvert, ipykernel"], check=False,
                               stderr=subprocess.DEVNULL)
        if probe.returncode:
            return None
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL,
                       env={**os.environ, "JUPYTER_PLATFORM_DIRS": "1"})
        told = json.loads(pathlib.Path(directory, NOTEBOOK.name).read_text(encoding="utf-8"))
    return [cell["outputs"] for cell in told["cells"] if cell["cell_type"] == "code"]


def main(page=None):
    document = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    cells = document["cells"]
    assert len(cells) == CELLS, len(cells)
    assert not any(cell.get("outputs") for cell in cells), "the notebook is kept without outputs"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that there is no pandas
        ran = run_all(cells)
    if page:
        body = "".join(f"<pre class='in'>{html.escape(source)}</pre>"
                       f"<pre>{html.escape(printed)}</pre>{display}\n"
                       for source, printed, display in ran)
        pathlib.Path(page).write_text(
            "<!doctype html><meta charset='utf-8'><meta name='color-scheme' content='light dark'>"
            "<style>body{font:14px sans-serif}.in{border-left:3px solid;padding-left:1em}</style>"
            f"{body}", encoding="utf-8")
    check(ran)
    outputs = run_by_jupyter()
    if outputs is None:
        print("run; not by jupyter, which is not installed")
        return
    drawn = [number for number, output in enumerate(outputs, 1) if "<svg" in json.dumps(output)]
    assert drawn == [2, 6, 7], drawn
    print("run, by jupyter too")


if __name__ == "__main__":
    main(*sys.argv[1:])
