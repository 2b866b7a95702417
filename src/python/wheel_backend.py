# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Makes a wheel of the package and the command (PEP 517), by the build with cmake.

    pip wheel . --no-deps --no-index [--config-settings build-dir=DIR]

`build-dir` is a build tree, build/wheel if it is not given; one that is there is used as it
was configured. The wheel is for machines with the libraries that it was built with.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
METADATA = """\
Metadata-Version: 2.1
Name: brachisto
Version: {version}
Summary: Fastest tracks of rolling bodies
License: MIT
Requires-Python: =={python}.*
Requires-Dist: numpy
Provides-Extra: pandas
Requires-Dist: pandas; extra == "pandas"
Description-Content-Type: text/markdown

{description}"""


def run(*command):
    """With the Python packages of the system, which pip hides from what it builds."""
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    subprocess.run([os.fspath(part) for part in command], check=True, env=environment)


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^\s*VERSION ([\d.]+)$", text, re.MULTILINE)[1]


def build(directory):
    """Configures, if it is not, and builds the package and the command."""
    if not (directory / "CMakeCache.txt").exists():
        run("cmake", "-S", ROOT, "-B", directory, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            "-DBRACHISTO_BUILD_PYTHON=ON", "-DBRACHISTO_BUILD_TESTS=OFF",
            "-DCMAKE_UNITY_BUILD=ON", f"-DPython3_EXECUTABLE={os.path.realpath(sys.executable)}")
    cache = (directory / "CMakeCache.txt").read_text(encoding="utf-8")
    for setting, wanted in [("BRACHISTO_BUILD_PYTHON", "ON"), ("BUILD_SHARED_LIBS", "OFF")]:
        if not re.search(rf"^{setting}:BOOL={wanted}$", cache, re.MULTILINE):
            raise SystemExit(f"{directory}: a wheel needs a build tree with {setting}={wanted}")
    run("cmake", "--build", directory, "--target", "brachisto_python", "brachisto_python_stubs",
        "brachisto_app", "brachisto_chain", "documents")


def installed(directory, prefix):
    """What is installed: the files of the package, and the others below the prefix."""
    for component in "python", "command":
        run("cmake", "--install", directory, "--component", component, "--prefix", prefix)
    (package,) = prefix.rglob("brachisto/__init__.py")
    parts = {}
    for path in sorted(prefix.rglob("*")):
        if not path.is_file():
            continue
        if package.parent in path.parents:
            parts[path.relative_to(package.parents[1]).as_posix()] = path
        else:
            below = path.relative_to(prefix).as_posix()
            parts[f"brachisto-{version()}.data/data/{below}"] = path
    return parts


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def about():
    """The name of the folder, and the texts that stand in it by their names."""
    guide = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    python = ".".join(map(str, sys.version_info[:2]))
    return f"brachisto-{version()}.dist-info", {
        "METADATA": METADATA.format(version=version(), python=python, description=guide),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: brachisto\nRoot-Is-Purelib: false\nTag: {tag()}\n",
        "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8"),
    }


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder, texts = about()
    place = pathlib.Path(metadata_directory, folder)
    place.mkdir()
    for name, text in texts.items():
        (place / name).write_text(text, encoding="utf-8")
    return folder


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    directory = ROOT / (config_settings or {}).get("build-dir", "build/wheel")
    build(directory)
    folder, texts = about()
    name = f"brachisto-{version()}-{tag()}.whl"
    record = []
    with tempfile.TemporaryDirectory() as scratch, zipfile.ZipFile(
            pathlib.Path(wheel_directory, name), "w") as wheel:

        def add(place, content, mode=0o644):
            info = zipfile.ZipInfo(place)  # of no time
            info.external_attr = (0o100000 | mode) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(info, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=")
            record.append(f"{place},sha256={digest.decode()},{len(content)}\n")

        for place, path in installed(directory, pathlib.Path(scratch)).items():
            add(place, path.read_bytes(), path.stat().st_mode & 0o777)
        for text in texts:
            add(f"{folder}/{text}", texts[text].encode("utf-8"))
        record.append(f"{folder}/RECORD,,\n")
        wheel.writestr(f"{folder}/RECORD", "".join(record))
    return name


def get_requires_for_build_wheel(config_settings=None):
    """Nothing of Python; cmake, ninja and Debian's libraries have to be there."""
    return []
