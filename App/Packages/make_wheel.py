#!/usr/bin/env python3
"""Makes a wheel of an install tree, for the Python that runs this and the VTK of the tree.

Usage: make_wheel.py PREFIX FOLDER
PREFIX: where `cmake --install` installed Varimarch with the usual names of folders, best with --strip
FOLDER: gets varimarch-VERSION-TAGS.whl; its path is printed

pip puts the package into lib/pythonVERSION/site-packages of an environment, as deep below lib as it is
in the tree, and everything else where it is in the tree. So the libraries, the programs, the decoder
and the plugin find each other by the relative paths that the build gave them.
Needs Debian's python3-wheel.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile

PACKAGE = "lib/python3/dist-packages/varimarch"
BESIDE_IT = ("bin", "lib/varimarch", "share/man", "share/varimarch")
LICENSE = pathlib.Path(__file__).resolve().parents[2] / "LICENSE"

METADATA = """\
Metadata-Version: 2.1
Name: varimarch
Version: {version}
Summary: Volume rendering within an error tolerance, with or without a display
License-File: LICENSE
Requires-Python: =={python}.*
Requires-Dist: numpy

For the VTK of Debian 12 (python3-vtk9), in an environment made with --system-site-packages.
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: make_wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""


def version_of(prefix):
    text = (prefix / "lib/cmake/Varimarch/VarimarchConfigVersion.cmake").read_text()
    return re.search(r'PACKAGE_VERSION "([^"]+)"', text).group(1)


def require_package_for_this_python(prefix):
    module = prefix / PACKAGE / ("_scene" + sysconfig.get_config_var("EXT_SUFFIX"))
    if not module.exists():
        found = [path.name for path in (prefix / PACKAGE).glob("_scene.*")]
        sys.exit(
            f"{module}: expected the module for {sys.executable}, found {found or 'none'}; run this "
            "with the Python of the build, after cmake --install"
        )


def copy_tree(prefix, package, data):
    shutil.copytree(prefix / PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    for name in BESIDE_IT:
        if (prefix / name).is_dir():
            shutil.copytree(prefix / name, data / name)
    # A wheel holds no links, so the library gets the one name by which it is loaded.
    library = min((prefix / "lib").glob("libVarimarchVolume.so.*"), key=lambda path: len(path.name))
    shutil.copy(library, data / "lib")


def write_metadata(folder, version):
    """Returns the tag, by which pip knows the Pythons and systems that the wheel is for."""
    folder.mkdir()
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    interpreter = "cp" + python.replace(".", "")
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    tag = f"{interpreter}-{interpreter}-{platform}"
    (folder / "METADATA").write_text(METADATA.format(version=version, python=python))
    (folder / "WHEEL").write_text(WHEEL.format(tag=tag))
    shutil.copy(LICENSE, folder)
    return tag


def make_wheel(prefix, folder):
    require_package_for_this_python(prefix)
    version = version_of(prefix)
    with tempfile.TemporaryDirectory() as name:
        stage = pathlib.Path(name)
        copy_tree(prefix, stage / "varimarch", stage / f"varimarch-{version}.data" / "data")
        tag = write_metadata(stage / f"varimarch-{version}.dist-info", version)
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            [sys.executable, "-m", "wheel", "pack", "--dest-dir", folder, stage],
            check=True,
            stdout=subprocess.DEVNULL,
        )
    return folder / f"varimarch-{version}-{tag}.whl"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    print(make_wheel(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
