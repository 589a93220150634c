#!/usr/bin/env python3
"""Runs programs that use only VTK with the plugin, and checks which mapper renders, and the image.

Usage: test_plugin.py CASE PROGRAM PLUGIN_FOLDER REJECTED_PLUGINS_FOLDER
Needs an X display and, for scripts, a Python with VTK.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

CASE, PROGRAM, PLUGIN, REJECTED = (*sys.argv[1:4], pathlib.Path(sys.argv[4]))
SCRIPT = pathlib.Path(__file__).with_name("draw.py")
OURS = "vtkVariationFieldGPUVolumeRayCastMapper"
VTKS = "vtkOpenGLGPUVolumeRayCastMapper"
WE_DRAW = "Varimarch: The variation field mapper draws."

# Tolerances in 1/255. At a twentieth of a voxel, the mappers differ by rounding and by VTK's tables
# and first samples, twice for two volumes. At half a voxel, its default, VTK's error is larger.
FINE = {"rmse": 0.3, "largest": 2}
FINE_OF_TWO = {"rmse": 0.6, "largest": 2}
COARSE = {"rmse": 0.5, "largest": 4}


def draw(*command, plugin=None, **environment):
    """Standard output, standard error and the bytes of the image of a program."""
    environment = {**os.environ, "VARIMARCH_VERBOSE": "1", **environment}
    if plugin:
        environment["VTK_AUTOLOAD_PATH"] = str(plugin)
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.ppm"
        command = [str(part).replace("PICTURE", str(picture)) for part in command]
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, env=environment
        )
        assert done.returncode == 0, f"exit code {done.returncode}: {done.stdout}{done.stderr}"
        assert "ERROR" not in done.stderr, done.stderr
        head, size, largest, pixels = picture.read_bytes().split(b"\n", 3)[:4]
    assert head == b"P6", head
    return done.stdout.strip(), done.stderr, pixels


def assert_agree(first, second, rmse, largest):
    assert len(first) == len(second) > 0 and len(set(first)) > 50, "nothing is drawn"
    differences = [abs(a - b) for a, b in zip(first, second)]
    root = (sum(d * d for d in differences) / len(differences)) ** 0.5
    print(f"RMSE {root:.3f}, largest {max(differences)} of 255")
    assert root <= rmse and max(differences) <= largest


def programs_draw_with_it():
    for kind, tolerated in (
        ("gpu", FINE),
        ("several", FINE_OF_TWO),
        ("smart", COARSE),
        ("blocks", COARSE),
    ):
        vtk_class, said, vtk_picture = draw(PROGRAM, kind, "PICTURE")
        assert WE_DRAW not in said
        our_class, said, our_picture = draw(PROGRAM, kind, "PICTURE", plugin=PLUGIN)
        assert WE_DRAW in said, said
        if kind in ("gpu", "several"):
            assert (vtk_class, our_class) == (VTKS, OURS)
        assert our_picture != vtk_picture, "the same mapper drew both"
        assert_agree(our_picture, vtk_picture, **tolerated)


def vectors_are_drawn_by_component_and_by_magnitude():
    """The program derives the scalars of the plain image from both kinds of vectors."""
    plain = draw(PROGRAM, "smart", "PICTURE", plugin=PLUGIN)[2]
    for kind in ("component", "magnitude"):
        _, said, picture = draw(PROGRAM, kind, "PICTURE", plugin=PLUGIN)
        assert WE_DRAW in said, said
        assert_agree(picture, plain, **COARSE)


def scripts_draw_with_it():
    vtk_class, _, vtk_picture = draw(sys.executable, SCRIPT, "PICTURE")
    our_class, said, our_picture = draw(sys.executable, SCRIPT, "PICTURE", plugin=PLUGIN)
    assert (vtk_class, our_class) == (VTKS, OURS)
    assert WE_DRAW in said, said
    assert_agree(our_picture, vtk_picture, **FINE)


def assert_vtk_draws(drawn):
    printed, said, picture = drawn
    assert printed == VTKS, printed
    assert WE_DRAW not in said, said
    assert picture == draw(PROGRAM, "gpu", "PICTURE")[2]


def environment_switches_it_off():
    assert_vtk_draws(draw(PROGRAM, "gpu", "PICTURE", plugin=PLUGIN, VARIMARCH_DISABLE="1"))
    assert draw(PROGRAM, "gpu", "PICTURE", plugin=PLUGIN, VARIMARCH_DISABLE="0")[0] == OURS


def object_factory_switches_it_off():
    assert_vtk_draws(draw(sys.executable, SCRIPT, "PICTURE", OURS, plugin=PLUGIN))


def assert_rejected(plugin, *words):
    drawn = draw(PROGRAM, "gpu", "PICTURE", plugin=REJECTED / plugin)
    assert "Incompatible factory rejected" in drawn[1], drawn[1]
    for word in words:
        assert word in drawn[1], drawn[1]
    assert_vtk_draws(drawn)


def other_version_is_rejected():
    assert_rejected("version", "Running VTK version: vtk version 9", "vtk version 8.9.7")


def other_package_is_rejected():
    assert_rejected("package", "libvtk-from-elsewhere.so", "this program does not use")


def missing_factory_is_rejected():
    assert_rejected("factory", "Varimarch cannot be loaded: not-installed.so")


def missing_module_is_reported():
    drawn = draw(PROGRAM, "gpu", "PICTURE", plugin=REJECTED / "module")
    assert "Varimarch cannot be loaded: libVarimarchVolume-not-installed.so" in drawn[1], drawn[1]
    assert_vtk_draws(drawn)


globals()[CASE]()
