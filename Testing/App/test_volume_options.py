#!/usr/bin/env python3
"""Options that choose a volume if the file or folder alone is ambiguous.

Usage: test_volume_options.py VARIMARCH CASE
"""

import json
import pathlib
import re
import struct
import sys
import tempfile

from nifti_files import nifti_of_times
from test_command_line import VOLUME, run


def dicom_slice(series, number, columns=4, rows=3, down="0\\1\\0", pixels=range(12)):
    """A DICOM image in explicit little endian (PS3.5, PS3.10). Its columns run down."""
    def element(group, tag, kind, value):
        value = value if isinstance(value, bytes) else str(value).encode()
        value += (b"\0" if kind == "UI" else b" ") * (len(value) % 2)
        head = struct.pack("<HH2s", group, tag, kind.encode())
        long = kind in ("OB", "OW")
        return head + struct.pack("<xxI" if long else "<H", len(value)) + value

    def numbers(*values):
        return struct.pack(f"<{len(values)}H", *values)

    image_class, image = "1.2.840.10008.5.1.4.1.1.2", f"{series}.9.{number}"
    meta = (element(2, 0x1, "OB", b"\0\1") + element(2, 0x2, "UI", image_class)
            + element(2, 0x3, "UI", image) + element(2, 0x10, "UI", "1.2.840.10008.1.2.1"))
    size = element(2, 0, "UL", struct.pack("<I", len(meta)))
    return b"\0" * 128 + b"DICM" + size + meta + b"".join(element(*row) for row in (
        (8, 0x16, "UI", image_class), (8, 0x18, "UI", image), (8, 0x60, "CS", "CT"),
        (8, 0x103E, "LO", f"Series of {series}"), (0x20, 0xD, "UI", "1.2.7"),
        (0x20, 0xE, "UI", series), (0x20, 0x13, "IS", number),
        (0x20, 0x32, "DS", f"0\\0\\{number}"), (0x20, 0x37, "DS", f"1\\0\\0\\{down}"),
        (0x28, 2, "US", numbers(1)), (0x28, 4, "CS", "MONOCHROME2"),
        (0x28, 0x10, "US", numbers(rows)), (0x28, 0x11, "US", numbers(columns)),
        (0x28, 0x30, "DS", "1\\1"), (0x28, 0x100, "US", numbers(16)),
        (0x28, 0x101, "US", numbers(16)), (0x28, 0x102, "US", numbers(15)),
        (0x28, 0x103, "US", numbers(1)), (0x7FE0, 0x10, "OW", numbers(*pixels))))


def series(folder):
    """Chooses one of several DICOM series by number, by UID, or by the beginning of a UID."""
    scan = folder / "scan"
    scan.mkdir()
    for uid, count in (("1.2.33", 2), ("1.2.44", 3)):
        for number in range(count):
            (scan / f"{uid}-{number}").write_bytes(dicom_slice(uid, number))

    def slices(*arguments):
        _, errors = run("info", scan, "--json", folder / "info.json", *arguments)
        return json.loads((folder / "info.json").read_text())["volume"]["dimensions"][2], errors

    both = "1 (CT, 3 images, Series of 1.2.44, 1.2.44), 2 (CT, 2 images, Series of 1.2.33, 1.2.33)"
    count, errors = slices()
    assert count == 3 and both in errors, errors
    for name in ("2", "1.2.33", "1.2.3"):
        assert slices("--series", name) == (2, ""), name
    run("render", scan, "--series", "2", "-o", folder / "a.png", "--size", "32x32")
    run("compare", scan, "--series", "2", "-o", folder / "c", "--size", "32x32", "--rounds", "1")
    for name in ("3", "1.2."):
        _, errors = run("info", scan, "--series", name, expect=1)
        assert f'"{name}", found {both}.' in errors, errors
    _, errors = run("info", VOLUME, "--series", "1", expect=2)
    assert f"--series: expected a folder of DICOM files, found the procedural volume {VOLUME}" in errors
    _, errors = run("info", scan / "1.2.33-0", "--series", "1", expect=2)
    assert "expected a folder of DICOM files, found the file" in errors, errors


def raw(folder):
    """Reads a raw file as the options describe it, header included."""
    voxels = folder / "voxels.raw"
    voxels.write_bytes(b"header!" + struct.pack(">24H", *range(100, 124)))
    layout = ["--raw-dimensions", "4x3x2", "--raw-type", "uint16", "--raw-byte-order", "big",
              "--raw-spacing", "1,2,3", "--json", folder / "info.json"]
    run("info", voxels, *layout, "--raw-header-bytes", "7")
    volume = json.loads((folder / "info.json").read_text())["volume"]
    assert volume["range"] == [100, 123] and volume["spacingMm"] == [1, 2, 3], volume
    _, errors = run("info", voxels, *layout)
    assert "7 bytes longer" in errors, errors
    _, errors = run("info", voxels, expect=2)
    assert f"--raw-dimensions: needed for the raw voxels of {voxels}\n" in errors, errors
    guessed = folder / "voxels_4x3x2.raw"
    guessed.write_bytes(voxels.read_bytes()[7:])
    _, errors = run("info", guessed, expect=2)
    assert "; its size fits --raw-dimensions 4x3x2 --raw-type int16" in errors, errors
    _, errors = run("info", voxels, *layout, "--raw-header-bytes", "-1", expect=2)
    assert "--raw-header-bytes" in errors, errors


def nrrd(path, values, size, pairs=""):
    """Writes bytes as an NRRD file with voxels of 1 x 2 x 3 mm."""
    header = ("NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
              f"sizes: {' '.join(map(str, size))}\nspace origin: (0,0,0)\nencoding: raw\n"
              f"space directions: (1,0,0) (0,2,0) (0,0,3)\n{pairs}\n")
    path.write_bytes(header.encode() + bytes(values))


def overlays(folder):
    """Draws volumes together by options and by a scene, and warns of an unknown space."""
    first, second, picture = folder / "first.nrrd", folder / "second.nrrd", folder / "a.png"
    nrrd(first, [100 if i % 8 < 4 else 0 for i in range(512)], (8, 8, 8))
    nrrd(second, [100 if i % 8 >= 4 else 0 for i in range(512)], (8, 8, 8))
    options = ["-o", picture, "--size", "48x48"]
    run("render", first, *options)
    alone = picture.read_bytes()
    _, errors = run("render", first, "--overlay", second, *options)
    assert "second.nrrd: the files do not say whether it is in the same space" in errors, errors
    both = picture.read_bytes()
    assert both != alone
    (folder / "scene.json").write_text(json.dumps(
        {"volume": {"file": "first.nrrd"}, "look": "mr-head",
         "overlays": [{"volume": {"file": "second.nrrd"}, "look": "mr-head"}]}))
    run("render", folder / "scene.json", *options)
    assert picture.read_bytes() == both, "the scene differs from the options"
    _, errors = run("render", first, "--overlay", second, "--renderer", "vtk-cpu", *options)
    assert "only the first volume is drawn" in errors, errors
    _, errors = run("render", first, *["--overlay", second] * 4, *options, expect=2)
    assert "expected at most 4 volumes together with the first, found 5" in errors, errors


def labels_of_overlays(folder):
    """Draws the segments of each volume, and warns of those for which no place is left."""
    nrrd(folder / "scan.nrrd", [0] * 512, (8, 8, 8))
    nrrd(folder / "half.nrrd", [i % 8 // 4 for i in range(512)], (8, 8, 8))
    bare = {"volume": {"file": "scan.nrrd"}, "look": "mr-head"}
    labelled = {**bare, "labels": {"file": "half.nrrd"}}

    def draw(scene, *options):
        (folder / "scene.json").write_text(json.dumps(scene))
        _, errors = run("render", folder / "scene.json", "-o", folder / "a.png", "--size", "48x48",
                        *options)
        return (folder / "a.png").read_bytes(), errors

    without, errors = draw({**bare, "overlays": [bare]})
    assert "scan.nrrd: the files do not say whether it is in the same space" in errors, errors
    of_overlay, _ = draw({**bare, "overlays": [labelled]})
    of_first, _ = draw({**labelled, "overlays": [bare]})
    assert of_overlay != without != of_first
    _, errors = draw({**labelled, "overlays": [labelled]}, "--blend", "maximum")
    assert "labels are" not in errors, errors
    _, errors = draw({**labelled, "overlays": [labelled, bare]})
    assert "not all labels are drawn: expected at most 4 volumes" in errors, errors


def labels(folder):
    """Draws segments over their scan, lists them, and says how a segmentation gets its scan."""
    scan, segments = folder / "scan.nrrd", folder / "organs.seg.nrrd"
    nrrd(scan, [100] * 512, (8, 8, 8))
    in_ball = [i % 8 in range(2, 6) and i // 8 % 8 in range(2, 6) and i // 64 in range(2, 6)
               for i in range(512)]
    nrrd(segments, [5 if inside else 0 for inside in in_ball], (8, 8, 8),
         "Segment0_Name:=left kidney\nSegment0_Color:=1 0.5 0\nSegment0_LabelValue:=5\n"
         "Segment1_Name:=nothing\nSegment1_LabelValue:=6\n")
    results, picture = folder / "results.json", folder / "a.png"
    text, _ = run("info", segments, "--json", results)
    # 64 voxels of 6 mm3
    assert "5          64        0.38  #ff8000  left kidney\n" in text, text
    listed = json.loads(results.read_text())["segments"]
    assert [row["value"] for row in listed] == [5, 6] and listed[0]["voxels"] == 64, listed
    assert abs(listed[0]["volumeMl"] - 0.384) < 1e-9 and listed[1]["voxels"] == 0, listed

    options = ["-o", picture, "--size", "48x48", "--json", results]
    run("render", scan, *options)
    plain = picture.read_bytes()
    _, errors = run("render", scan, "--labels", segments, *options)
    assert errors == "" and picture.read_bytes() != plain, errors
    drawn = picture.read_bytes()
    (folder / "scene.json").write_text(json.dumps(
        {"volume": {"file": "scan.nrrd"}, "look": "mr-head",
         "labels": {"file": "organs.seg.nrrd"}}))
    run("render", folder / "scene.json", *options)
    assert picture.read_bytes() == drawn, "the scene differs from the options"
    table = folder / "table.ctbl"
    table.write_text("5 kidney 0 0 255 255\n")
    text, _ = run("info", scan, "--labels", segments, "--label-colors", table)
    assert "#0000ff  kidney\n" in text, text
    run("render", scan, "--labels", segments, "--label-colors", table, *options)
    assert picture.read_bytes() not in (plain, drawn)

    _, errors = run("render", segments, *options)
    assert f"to draw it over the scan: render SCAN --labels {segments}" in errors, errors
    assert json.loads(results.read_text())["look"] == "labels"
    _, errors = run("render", scan, "--labels", segments, "--blend", "maximum", *options)
    assert "the labels are not drawn: expected the blend mode composite" in errors, errors
    _, errors = run("render", scan, "--label-colors", table, *options, expect=2)
    assert "--label-colors: expected --labels FILE" in errors, errors


def rectify(folder):
    """Resamples slices of a tilted gantry upright if an option or a scene asks for it."""
    (folder / "scan").mkdir()
    pixels = [1500 if abs(i - 7.5) < 5 and abs(j - 7.5) < 5 else 0
              for j in range(16) for i in range(16)]
    for number in range(12):
        (folder / "scan" / str(number)).write_bytes(
            dicom_slice("1.2.33", number, 16, 16, "0\\0.96\\-0.28", pixels))
    text, warnings = run("info", folder / "scan", "--json", folder / "scanned.json")
    assert "--rectify resamples them" in text, text
    assert "tilted by 16.26 degrees; each slice is drawn at its true position" in warnings, warnings
    text, warnings = run("info", folder / "scan", "--rectify", "--json", folder / "rectified.json")
    assert "resampled on an even grid; --as-scanned keeps them\n" in text, text
    assert "resampled on an even grid" in warnings, warnings
    scanned, rectified = (json.loads((folder / f"{name}.json").read_text())["volume"]
                          for name in ("scanned", "rectified"))
    assert scanned["irregularSlices"] and rectified["irregularSlices"]
    assert rectified["rectified"] and not scanned["rectified"]
    # Neighbouring slices are shifted by 0.28 rows.
    assert scanned["dimensions"] == [16, 16, 12] and rectified["dimensions"] == [16, 16 + 4, 12]
    options = ["--preset", "ct-bone", "--size", "64x64", "--sample-distance", "0.5"]
    pictures = []
    for volume, more in (({"rectified": True}, []), ({}, ["--rectify"]), ({}, [])):
        (folder / "scene.json").write_text(
            json.dumps({"volume": {"file": "scan", **volume}, "look": "ct-bone"}))
        run("render", folder / "scene.json", "-o", folder / "a.png", *options, *more)
        pictures.append((folder / "a.png").read_bytes())
    run("render", folder / "scan", "--rectify", "-o", folder / "a.png", *options)
    pictures.append((folder / "a.png").read_bytes())
    assert pictures[0] == pictures[1] == pictures[3] != pictures[2]
    for command in (["info"], ["render", "-o", folder / "a.png"]):
        for option in ("--rectify", "--as-scanned"):
            _, errors = run(*command, VOLUME, option, expect=2)
            assert f"{option}: expected a scan, found a procedural volume" in errors, errors

    # A missing slice is made up unless the user refuses; a conversion keeps the values.
    (folder / "scan" / "5").unlink()
    for options, count in ([], 12), (["--as-scanned"], 11):
        run("info", folder / "scan", *options, "--json", folder / "gap.json")
        volume = json.loads((folder / "gap.json").read_text())["volume"]
        assert volume["dimensions"][2] == count and volume["rectified"] == (count == 12), volume
    for options, count in ([], 11), (["--rectify"], 12):
        run("convert", folder / "scan", folder / "gap.nrrd", "--overwrite", *options)
        header = (folder / "gap.nrrd").read_bytes().split(b"\n\n")[0].decode() + "\n"
        assert re.search(rf"sizes: \d+ \d+ {count}\n", header), header


def on_disk(folder):
    volume = folder / "torso.nrrd"
    run("convert", VOLUME, volume)
    pictures = {}
    for options in ((), ("--memory", "0.2"), ("--memory", "0.2", "--detail", "coarse")):
        run("info", volume, *options[:2], "--json", folder / "info.json")
        written = json.loads((folder / "info.json").read_text())["volume"]
        assert written["fromDisk"] == bool(options), written
        pictures[options] = written["percentiles"], written["histogram"]
        run("render", volume, *options, "-o", folder / "a.png", "--size", "64x64",
            "--json", folder / "render.json")
        pictures[options] += ((folder / "a.png").read_bytes(),)
        bound = json.loads((folder / "render.json").read_text())["levelErrorBound"]
        assert (bound > 0.0) == ("coarse" in options), bound
    memory, disk, coarse = pictures.values()
    assert memory == disk != coarse
    _, notes = run("render", volume, "--memory", "0.2", "--detail", "refined", "--size", "64x64",
                   "-o", folder / "a.png", "--json", folder / "render.json")
    results = json.loads((folder / "render.json").read_text())
    assert results["levelErrorBound"] <= 1 / 128, results
    assert 0 < results["refinedBlocks"] <= results["visibleBlocks"], results
    assert f"voxels of {results['refinedBlocks']} of {results['visibleBlocks']} visible" in notes, notes
    scene = {"volume": {"file": "torso.nrrd", "memory": 0.2}, "look": "mr-head"}
    (folder / "scene.json").write_text(json.dumps(scene))
    run("render", folder / "scene.json", "-o", folder / "b.png", "--json", folder / "render.json")
    assert (folder / "torso.nrrd.varimarch-ranges").exists()
    _, errors = run("info", volume, "--memory", "0.00002", expect=1)
    assert "for the bricks of 48 x 40 x 32" in errors, errors


def coarse_copy(folder):
    """Draws a coarse copy of a volume that was not read before, without a promise."""
    volume = folder / "ramp.raw"
    volume.write_bytes(bytes(range(256)) * 2 * 512 * 80)
    options = "--raw-dimensions", "512x512x80", "--memory", "60"

    def draw():
        _, notes = run("render", volume, *options, "--detail", "coarse", "-o", folder / "a.png",
                       "--size", "64x64", "--json", folder / "a.json")
        written = json.loads((folder / "a.json").read_text())
        return written["volume"]["dimensions"], written["levelErrorBound"], notes

    ranges = folder / "ramp.raw.varimarch-ranges"
    size, bound, notes = draw()
    assert size == [256, 256, 40] and bound == 1.0 and not ranges.exists(), (size, bound)
    assert "warning: A coarse copy" in notes and "no error" in notes, notes
    run("info", volume, *options)
    size, bound, notes = draw()
    assert size == [512, 512, 80] and ranges.exists() and "warning" not in notes, (size, notes)


def times(folder):
    """Chooses a time by its number or by its seconds, of one file or of several."""
    nifti_of_times(folder / "t.nii", range(10, 14), 1.5)

    def brightness(path, *options):
        _, notes = run("info", path, "--json", folder / "info.json", *options)
        volume = json.loads((folder / "info.json").read_text())["volume"]
        assert volume["range"][0] == volume["range"][1], volume
        return volume["range"][0], volume, notes

    value, volume, notes = brightness(folder / "t.nii")
    assert value == 10 and volume["times"] == [0, 1.5, 3, 4.5] and volume["timesInSeconds"], volume
    assert "holds 4 times; the first was read, and --time chooses another" in notes, notes
    for option, expected in (("2", 12), ("3s", 12), ("4.4s", 13), ("-2s", 10)):
        value, volume, notes = brightness(folder / "t.nii", f"--time={option}")
        assert value == expected and volume["time"] == expected - 10, volume
        assert "--time" not in notes, notes
    text, _ = run("info", folder / "t.nii", "--time", "2")
    assert "times        4, from 0 s to 4.5 s; this is time 2 (3 s)\n" in text, text

    run("convert", folder / "t.nii", folder / "second.nii", "--time", "1")
    assert (folder / "second.nii").read_bytes()[352:] == bytes([11]) * 60
    for number in (9, 10, 11):
        nifti_of_times(folder / f"v_{number}.nii", [number])
    for number in (0, 2):
        value, volume, _ = brightness(
            folder / "v_10.nii", "--files-are-times", "--time", str(number))
        assert value == 9 + number and volume["times"] == [0, 1, 2], volume
        assert not volume["timesInSeconds"], volume

    _, errors = run("info", folder / "t.nii", "--time", "4", expect=1)
    assert "expected a time from 0 to 3, found the time 4" in errors, errors
    _, errors = run("info", folder / "v_10.nii", "--time", "1s", expect=1)
    assert "states its times in seconds, found a single volume" in errors, errors
    for volume, words in (
            ({"file": "t.nii", "time": 3}, None), ({"file": "t.nii", "timeSeconds": 1.4}, None),
            ({"file": "t.nii", "time": 4}, "expected a time from 0 to 3, found the time 4"),
            ({"file": "v_10.nii", "timeSeconds": 1.4}, "found a single volume"),
            ({"file": "v_10.nii", "filesAreTimes": True, "time": 3}, "expected a time from 0 to 2")):
        (folder / "scene.json").write_text(json.dumps({"volume": volume, "look": "ct-bone"}))
        _, errors = run("render", folder / "scene.json", "-o", folder / "a.png", "--size", "16x16",
                        expect=1 if words else 0)
        assert not words or words in errors, errors
    for wrong in ("1.5", "-1", "s", "soon", "nans"):
        _, errors = run("info", folder / "t.nii", f"--time={wrong}", expect=2)
        assert f'expected the number of a time, counted from 0, or its seconds' in errors, errors
    _, errors = run("info", VOLUME, "--time", "1", expect=2)
    assert "--time: expected a file, found a procedural volume" in errors, errors


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        {"series": series, "raw": raw, "labels": labels, "overlays": overlays,
         "labels_of_overlays": labels_of_overlays, "rectify": rectify, "on_disk": on_disk,
         "coarse_copy": coarse_copy, "times": times}[sys.argv[2]](pathlib.Path(name))
