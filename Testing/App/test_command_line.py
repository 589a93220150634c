#!/usr/bin/env python3
"""Runs varimarch as a user does and checks what it returns, prints and writes.

Usage: test_command_line.py VARIMARCH CASE
"""

import csv
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

VOLUME = "procedural:torso:48x40x32"
RENDERERS = ["ours", "ours-shader", "vtk-gpu", "vtk-cpu"]


def run(*arguments, expect=0):
    """Standard output and error of varimarch, which must end with the expected exit code."""
    done = subprocess.run(
        [sys.argv[1], *map(str, arguments)], capture_output=True, text=True, check=False
    )
    assert done.returncode == expect, f"exit code {done.returncode}: {done.stdout}{done.stderr}"
    assert "\x1b" not in done.stderr and "\r" not in done.stderr, "control codes in a log"
    return done.stdout, done.stderr


def png_size(path):
    head = path.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n", path
    return int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")


def render(folder):
    for renderer in RENDERERS:
        picture, results = folder / f"{renderer}.png", folder / f"{renderer}.json"
        run("render", VOLUME, "-o", picture, "--size", "90x60", "--renderer", renderer,
            "--json", results, "--view", "left", "--preset", "ct-vessels")
        assert png_size(picture) == (90, 60)
        written = json.loads(results.read_text())
        assert written["volume"]["dimensions"] == [48, 40, 32]
        assert written["look"] == "ct-vessels" and written["renderer"] == renderer
        assert "--view left" in written["command"]
    assert not list(folder.glob("*.part*")), "an unfinished file is left"
    for acceleration in ("off", "cells", "variation", "optical"):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64",
            "--acceleration", acceleration)
    run("render", VOLUME, "-o", folder / "a.png", "--size", "32x32", "--error-tolerance", "0",
        "--graphics-memory", "0.1", "--repeat", "1", "--json", folder / "blocks.json")
    blocks = json.loads((folder / "blocks.json").read_text())
    assert blocks["blockUploads"] > 1 and blocks["graphicsMemoryBytes"] <= 1e5, blocks
    rules = set()
    for rule in ("midpoint", "pre-integrated", "simpson", "published-sum", "first-hit"):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64", "--no-shade",
            "--integration", rule, "--sample-distance", "4")
        rules.add((folder / "a.png").read_bytes())
    assert len(rules) == 5, "two rules draw the same picture"
    for rule, name in (("published-sum", "PublishedSum"), ("first-hit", "FirstHit")):
        _, message = run("render", VOLUME, "-o", folder / "lit.png", "--size", "32x32", "--shade",
                         "--integration", rule, expect=1)
        assert f"The integration rule {name} is defined only for" in message, message
        assert message.count("\n") == 1 and not (folder / "lit.png").exists(), message
    pictures = {}
    for option in (None, "--shade", "--no-shade"):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64", *filter(None, [option]))
        pictures[option] = (folder / "a.png").read_bytes()
    assert pictures[None] == pictures["--shade"] != pictures["--no-shade"]
    seen = {pictures["--shade"]}
    for options in (["--light", "70,20"], ["--light", "70,20", "--light", "-50,0"],
                    ["--light", "70,20", "--shadows"], ["--occlusion", "0.5"],
                    ["--light", "70,20", "--shadow-strength", "0.5"],
                    ["--light", "70,20", "--shadows", "--softness", "25"], ["--preset-light"],
                    ["--scattering", "0.5"], ["--scattering", "0.5", "--anisotropy", "0.4"],
                    ["--light", "70,20", "--scattering", "1", "--scattering-reach", "0.5"],
                    ["--occlusion", "0.5", "--occlusion-reach", "5"], ["--damping", "500"], ["--interpolation", "nearest"],
                    ["--interpolation", "cubic"], ["--clipping-range", "1,2"],
                    ["--error-tolerance", "0", "--early-termination", "0.5"],
                    ["--error-tolerance", "0", "--early-termination", "0.5", "--jitter"]):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64", *options)
        seen.add((folder / "a.png").read_bytes())
    assert len(seen) == 18, "an option changes nothing"
    _, message = run("render", VOLUME, "-o", folder / "a.png", "--clipping-range", "9,3", expect=2)
    assert "--clipping-range: expected the nearer distance first" in message, message
    _, message = run("render", "procedural:marschner-lobb:16x16x16", "-o", folder / "a.png", "--body-only",
                     expect=1)
    assert "from CT only" in message and "unknown modality" in message, message
    scene = folder / "scene.json"
    scene.write_text('{"volume": {"procedural": "shells", "size": [16, 16, 16]},'
                     ' "look": "mr-head", "size": [40, 30]}')
    run("render", scene, "-o", folder / "scene.png")
    assert png_size(folder / "scene.png") == (40, 30)


def render_dicom(folder):
    picture = folder / "a.dcm"
    run("render", VOLUME, "-o", picture, "--size", "33x21", "--error-tolerance", "0.125")
    first = picture.read_bytes()
    assert first[128:132] == b"DICM" and b"colour channel: 0.125 of full" in first
    description, _ = run("info", picture)
    assert "33 x 21 x 1" in description, description
    _, message = run("render", VOLUME, "-o", picture, "--size", "33x21", expect=1)
    assert "--overwrite" in message and picture.read_bytes() == first
    run("render", VOLUME, "-o", picture, "--size", "33x21", "--overwrite", "--sample-distance", "2")
    assert b"error is not bounded" in picture.read_bytes()
    _, message = run("render", VOLUME, "-o", folder / "a.jpg", expect=2)
    assert ".png or .dcm" in message and not (folder / "a.jpg").exists()


def compare(folder):
    output = folder / "new" / "comparison"
    table, _ = run("compare", VOLUME, "-o", output, "--size", "80x60", "--rounds", "2",
                   "--json", folder / "copy.json")
    results = json.loads((output / "compare.json").read_text())
    assert json.loads((folder / "copy.json").read_text()) == results
    rows = list(csv.DictReader((output / "compare.csv").open()))
    assert [row["renderer"] for row in rows] == RENDERERS
    assert [row["renderer"] for row in results["renderers"]] == RENDERERS
    for row in results["renderers"]:
        assert len(row["roundsMs"]) == 2 and row["medianMs"] > 0
        # The same picture within what coarse sampling costs: nothing is turned, moved or missing.
        # VTK's CPU mapper is off by half a pixel, which is much in so small a picture.
        assert row["error255"]["rmse"] < (25 if row["renderer"] == "vtk-cpu" else 12), row
        assert row["error255"]["rmse"] <= row["error255"]["largest"]
        assert row["class"] in table
        # What differs less looks more alike.
        assert 0.5 < row["ssim"] < 1 and 0 < row["ciede2000"]["mean"] < 10, row
        assert row["ciede2000"]["mean"] <= row["ciede2000"]["percentile99"], row
    assert float(rows[0]["ssim"]) > float(rows[3]["ssim"])
    assert results["renderers"][2]["timesAsFastAsVtkGpu"] == 1
    assert results["openglRenderer"] and results["command"] in (output / "compare.md").read_text()
    for name in RENDERERS:
        assert png_size(output / f"{name}.png") == (80, 60)
        assert png_size(output / f"difference-{name}.png")[1] > 60
    assert png_size(output / "side-by-side.png")[0] > 4 * 80


def compare_with_paths(folder):
    run("compare", "procedural:marschner-lobb:12x12x12", "-o", folder, "--size", "20x16",
        "--rounds", "1", "--paths", "40", "--scatterings", "3")
    results = json.loads((folder / "compare.json").read_text())
    assert results["reference"]["paths"] == 40 and results["reference"]["largestError255"] > 0.1
    assert "40 random paths" in (folder / "compare.md").read_text()
    _, message = run("compare", VOLUME, "-o", folder, "--scatterings", "3", expect=2)
    assert "--paths" in message, message
    _, message = run("compare", VOLUME, "-o", folder, "--paths", "9", "--blend", "maximum", expect=1)
    assert "expected a composite with shading" in message, message


def compare_with_every_blend(folder):
    (look := folder / "look.json").write_text('{"colors": [{"value": 0, "rgb": [1, 1, 1]}],'
        '"opacities": [{"value": 0, "opacity": 1}], "isosurfaces": [{"value": 0.5, "rgb": [1, 1, 1]}]}')
    for blend in ("maximum", "minimum", "average", "additive", "isosurface"):
        function = ["--transfer-function", look] if blend == "isosurface" else ()
        run("compare", "procedural:marschner-lobb:24x24x24", "-o", folder, "--size", "40x30",
            "--rounds", "1", "--blend", blend, *function)
        renderers = json.loads((folder / "compare.json").read_text())["renderers"]
        count = 3 if blend in ("average", "isosurface") else 4  # not with VTK's fixed-point mapper
        assert [row["renderer"] for row in renderers] == RENDERERS[:count]
        assert 0 < renderers[0]["error255"]["rmse"] < 1, (blend, renderers)


def info(folder):
    text, _ = run("info", VOLUME, "--json", folder / "info.json", "--bins", "8")
    assert "48 x 40 x 32" in text and "L P S" in text and "short" in text
    volume = json.loads((folder / "info.json").read_text())["volume"]
    assert sum(volume["histogram"]) == 48 * 40 * 32 and len(volume["histogram"]) == 8
    assert volume["bytes"] == 2 * 48 * 40 * 32
    assert volume["percentiles"][0]["value"] >= volume["range"][0]


def convert(folder):
    for name in ("a.nrrd", "b.nii.gz", "c.mha", "d.vti", "e.tif"):
        _, messages = run("convert", VOLUME, folder / name)
        assert ("only the spacing" in messages) == name.endswith(".tif"), messages
        description, _ = run("info", folder / name)
        assert "48 x 40 x 32" in description, description
    assert not list(folder.glob("*.part*")), "an unfinished file is left"
    first = (folder / "a.nrrd").read_bytes()
    _, message = run("convert", folder / "b.nii.gz", folder / "a.nrrd", expect=1)
    assert "--overwrite" in message and (folder / "a.nrrd").read_bytes() == first
    run("convert", folder / "c.mha", folder / "a.nrrd", "--overwrite")
    _, message = run("convert", VOLUME, folder / "a.dcm", expect=2)
    assert ".nrrd" in message and not (folder / "a.dcm").exists()
    _, message = run("convert", VOLUME, folder / "nowhere" / "a.nrrd", expect=1)
    assert "cannot be written" in message, message


def limited_rays(folder):
    pictures = set()
    for options in ((), ("--steps", "9"), ("--first-distance", "900")):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64", "--no-shade",
            "--sample-distance-voxels", "1", *options)
        pictures.add((folder / "a.png").read_bytes())
    assert len(pictures) == 3, "an option has no effect"
    _, message = run("render", VOLUME, "-o", folder / "a.png", "--sample-distance", "1",
                     "--sample-distance-voxels", "1", expect=2)
    assert "excludes" in message, message


def regions(folder):
    """Regions of a file draw what the same regions of a look draw, in place of its curves."""
    tissue = [{"shape": "ellipse", "values": [-100, 300], "gradients": [0, 60], "rgb": [1, 0.6, 0.4],
               "opacity": 0.02},
              {"shape": "rectangle", "values": [100, 1200], "gradients": [20, 4000],
               "rgb": [1, 1, 0.9], "opacity": 0.4, "softness": 0.2}]
    (alone := folder / "regions.json").write_text(json.dumps(tissue))
    look = {"colors": [{"value": 0, "rgb": [0, 0, 1]}], "opacities": [{"value": 0, "opacity": 1}]}
    (curves := folder / "curves.json").write_text(json.dumps(look))
    (whole := folder / "look.json").write_text(json.dumps({**look, "regions": tissue}))
    pictures = []
    for options in (["--transfer-function", curves], ["--transfer-function", whole],
                    ["--transfer-function", curves, "--regions", alone]):
        run("render", VOLUME, "-o", folder / "a.png", "--size", "64x64", *options)
        pictures.append((folder / "a.png").read_bytes())
    assert pictures[0] != pictures[1] == pictures[2]
    alone.write_text('[{"shape": "ellipse", "values": [300, 100]}]')
    _, message = run("render", VOLUME, "-o", folder / "a.png", "--regions", alone, expect=1)
    assert "regions.json: [0].values: expected the smaller end first" in message, message


def field(folder):
    def voxels_of(name):
        header, _, voxels = (folder / name).read_bytes().partition(b"ElementDataFile = LOCAL\n")
        assert b"MET_UCHAR" in header and b"CompressedData = False" in header, header
        return voxels

    # A row of values whose nearest differences can be counted.
    values = [0, 0, 0, 0, 9, 9, 5, 5]
    (folder / "row.raw").write_bytes(bytes(2 * values + 2 * values))
    raw = (folder / "row.raw", "--raw-dimensions", "8x2x2", "--raw-type", "uint8")
    for distance in ("euclidean", "chebyshev"):
        run("field", *raw, "-o", folder / f"{distance}.mha", "--tolerance", "5",
            "--distance", distance)
        assert list(voxels_of(f"{distance}.mha")[:8]) == [4, 3, 2, 1, 1, 2, 3, 4], distance
    run("field", *raw, "-o", folder / "six.mha", "--tolerance", "6")
    assert list(voxels_of("six.mha")[:8]) == [4, 3, 2, 1, 1, 2, 255, 255]
    _, message = run("field", *raw, "-o", folder / "six.mha", "--tolerance", "6", expect=1)
    assert "--overwrite" in message, message
    run("field", *raw, "-o", folder / "six.mha", "--tolerance", "10", "--overwrite")
    assert set(voxels_of("six.mha")) == {255}, "no two values differ by 10"
    description, _ = run("info", VOLUME)
    run("field", VOLUME, "-o", folder / "torso.nii.gz", "--tolerance", "50")
    place = [line for line in description.splitlines() if "mm" in line]
    written, _ = run("info", folder / "torso.nii.gz")
    assert all(line in written for line in place), (place, written)
    for arguments, message in ((["-o", folder / "a.nrrd"], "--tolerance"),
                               (["-o", folder / "a.png", "--tolerance", "1"], ".nrrd"),
                               (["-o", folder / "a.nrrd", "--tolerance", "-1"], "--tolerance")):
        _, errors = run("field", *raw, *arguments, expect=2)
        assert message in errors, errors


def look(folder):
    """A preset in the format of each program that can be written."""
    written = folder / "bone.paraview.json"
    run("look", VOLUME, written, "--preset", "ct-bone")
    (color_map,) = json.loads(written.read_text())
    assert color_map["RGBPoints"][:4] == [150, 0.6, 0.36, 0.24], color_map
    assert color_map["Points"][4:8] == [300, 0.35, 0.5, 0.0], color_map
    before = written.read_bytes()
    _, message = run("look", VOLUME, written, "--preset", "ct-lung", expect=1)
    assert "--overwrite" in message and written.read_bytes() == before, message
    run("look", VOLUME, written, "--preset", "ct-lung", "--overwrite")
    assert written.read_bytes() != before
    _, errors = run("look", VOLUME, folder / "bone.png", expect=2)
    assert "expected a name that ends with .json" in errors, errors
    draw = ["render", VOLUME, "--size", "48x48", "-o"]
    run("look", VOLUME, folder / "own.json", "--preset", "ct-bone")
    run(*draw, folder / "preset.png", "--preset", "ct-bone")
    run(*draw, folder / "own.png", "--transfer-function", folder / "own.json")
    assert (folder / "own.png").read_bytes() == (folder / "preset.png").read_bytes()
    # 3D Slicer's formats hold less than a preset does.
    for name in ("slicer.vp.json", "slicer.vp"):
        run("look", VOLUME, folder / name, "--preset", "ct-bone")
        assert "0.35" in (folder / name).read_text(), name
        run(*draw, folder / "slicer.png", "--transfer-function", folder / name)


def usage(folder):
    for arguments in ([], ["render"], ["rendr"], ["render", VOLUME], ["info", VOLUME, "--bins", "0"],
                      ["compare", VOLUME, "-o", folder, "--rounds", "none"]):
        _, errors = run(*arguments, expect=2)
        assert errors.strip(), arguments
    for arguments, message in (
        (["--preset", "ct-bones"], 'did you mean "ct-bone"?'),
        (["--size", "12y3"], "such as 800x600"),
        (["--sample-distance", "0"], "expected a number > 0"),
        (["--acceleration", "none"], "known: off, cells, variation, optical"),
    ):
        _, errors = run("render", VOLUME, "-o", folder / "a.png", *arguments, expect=2)
        assert message in errors, errors
    for volume, kind in ((VOLUME, "procedural volume"), (folder / "scene.json", "scene file")):
        _, errors = run("render", volume, "-o", folder / "a.png", "--raw-dimensions", "4x4x4",
                        expect=2)
        assert f"--raw-dimensions: expected a raw file, found the {kind} {volume}" in errors, errors
    for command in ("render", "compare", "info", "convert", "field", "look"):
        text, _ = run(command, "--help")
        assert f"  varimarch {command} " in text, "help without examples"


def errors(folder):
    broken = folder / "broken.json"
    broken.write_text('{"volume": {"procedural": "shells"}, "look": "mr-head", "sise": [1, 1]}')
    nowhere = folder / "none" / "a.png"
    for arguments, message in (
        (["render", folder / "none.nii", "-o", folder / "a.png"], "none.nii"),
        (["render", broken, "-o", folder / "a.png"], 'unknown key "sise"; did you mean "size"?'),
        (["render", VOLUME, "-o", nowhere, "--size", "64x64"], f"{nowhere}: cannot be written: No such file"),
        (["compare", VOLUME, "-o", broken], f"{broken}: expected a folder"),
        (["render", VOLUME, "-o", folder / "a.png", "--transfer-function", "none.json"], "none.json"),
    ):
        _, text = run(*arguments, expect=1)
        assert message in text, text
        complaint = text.splitlines()[-1]
        assert complaint.startswith("varimarch: "), text
        assert text.count("varimarch: ") == 1, text
    assert not (folder / "a.png").exists()


def interrupt(folder):
    """Ctrl-C ends the program by the signal and leaves no unfinished file."""
    output = folder / "comparison"
    process = subprocess.Popen(
        [sys.argv[1], "compare", "procedural:torso:64x64x64", "-o", str(output), "--rounds", "9999"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=20) == -signal.SIGINT
    assert not list(folder.rglob("*.part*"))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        cases = (render, render_dicom, compare, compare_with_every_blend,
                 compare_with_paths, info, convert, field, look,
                 limited_rays, regions, usage, errors, interrupt)
        {case.__name__: case for case in cases}[sys.argv[2]](pathlib.Path(name))
