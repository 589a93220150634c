#!/usr/bin/env python3
"""Runs varimarch-bench work-precision as a user does and checks what it prints and writes.

Usage: test_work_precision.py VARIMARCH_BENCH CASE
"""

import csv
import html
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from bench_reports import made_report, tolerance_rows, worst_against_vtk
from test_command_line import VOLUME, png_size, run


def work_precision(folder):
    scene = folder / "two shells.json"
    scene.write_text('{"volume": {"procedural": "shells", "size": [16, 16, 16]},'
                     ' "look": "mr-head", "size": [48, 40]}')
    output = folder / "report"
    run("work-precision", scene, VOLUME, "-o", output, "--size", "48x40", "--rounds", "2", "--methods",
        "optical,off,vtk-gpu,vtk-cpu", "--no-shade", "--json", folder / "copy.json")
    table = made_report(output / "work-precision.json")
    results = json.loads((output / "work-precision.json").read_text())
    assert json.loads((folder / "copy.json").read_text()) == results
    assert results["machine"]["cores"] >= 1 and results["machine"]["processor"]
    names = ["two-shells", "procedural-torso-48x40x32"]
    assert [scene["name"] for scene in results["scenes"]] == names
    rows = list(csv.DictReader((output / "work-precision.csv").open()))
    for name in names:
        assert name in table
        assert png_size(output / f"{name}-truth.png") == png_size(output / f"{name}-optical.png") == (48, 40)
        curves = {method: [float(row["rmse_255"]) for row in rows
                           if row["scene"] == name and row["method"] == method]
                  for method in ("optical", "off", "vtk-gpu", "vtk-cpu")}
        lengths = {method: len(curve) for method, curve in curves.items()}
        assert lengths == {"optical": 8, "off": 6, "vtk-gpu": 6, "vtk-cpu": 6}, lengths
        reads = [float(row["fetches_per_pixel"] or 0) for row in rows if row["scene"] == name
                 and row["method"] == "off"]
        # Half the distance gives twice the samples, except on rays that end within a step or early.
        assert 1.5 < reads[5] / reads[4] < 2.1, reads
        # Finer sampling reduces the error, and the benchmark measures that.
        assert curves["off"][-1] < curves["off"][0] / 10, curves
    assert all(float(row["median_ms"]) > 0 for row in rows)
    assert all(bool(row["graphics_bytes"]) == (row["method"] in ("optical", "off")) for row in rows)
    assert all(method["orbit"]["frames"] == 31 for scene in results["scenes"]
               for method in scene["methods"])
    page = (output / "work-precision.html").read_text()
    assert "://" not in page and 'src="data:image/png;base64,' in page, "not self-contained"
    # The truth, each method and its difference, and the scale of the differences, of both scenes.
    assert page.count("<img") == 2 * (1 + 2 * 4 + 1)
    assert page.count("<figure>") == 2 * (1 + 2 * 4)
    assert results["command"] in html.unescape(page)


def work_precision_leaves_out_what_takes_long(folder):
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1",
        "--methods", "vtk-gpu", "--longest", "1e-9")
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    (method,) = scene["methods"]
    assert [point["setting"] for point in method["points"]] == ["4 voxels"]
    assert "2 voxels and finer" in method["skipped"]
    made_report(folder / "work-precision.json")
    assert html.escape(method["skipped"]) in (folder / "work-precision.html").read_text()


def work_precision_judges_error_tolerances(folder):
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1", "--methods",
        "tolerance,optical,vtk-gpu,vtk-cpu", "--no-shade")
    text = made_report(folder / "work-precision.json")
    rows = list(csv.DictReader((folder / "work-precision.csv").open()))
    swept = [row for row in rows if row["method"] == "tolerance"]
    tolerances = [4, 8, 16, 32, 64, 128, 255]
    assert [round(1 / float(row["error_tolerance"])) for row in swept] == tolerances
    distances = [float(row["sample_distance_mm"]) for row in swept]
    assert distances == sorted(distances, reverse=True) and distances[0] > distances[-1], distances
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    spacing = min(scene["volume"]["spacingMm"])
    for row in rows:
        if row["method"] != "tolerance":
            # Other methods get no tolerance, and exactly the sample distance of the sweep.
            assert row["error_tolerance"] == ""
            distance = float(row["setting"].removesuffix(" voxels")) * spacing
            assert abs(float(row["sample_distance_mm"]) / distance - 1) < 1e-6, row
    judged = tolerance_rows(scene)
    for row, measured in zip(judged, swept, strict=True):
        allowed = 255 * row["errorTolerance"]
        assert abs(row["percentile99.9OfTolerance"] * allowed
                   / float(measured["percentile_99_9_255"]) - 1) < 1e-5, (row, measured)
        assert row["percentile99.9OfTolerance"] <= 1 and row["largestOfTolerance"] <= 2, row
        assert not {"99.9", "largest"} & set(row["missed"].split()), row
        assert row["handTuned"] == "optical" and 0 < row["estimateOfTolerance"] < 1, row
        assert ("time" in row["missed"]) == (row["timesHandTuned"] > 2), row
    page = (folder / "work-precision.html").read_text()
    for number in tolerances:
        assert f"tolerance 1/{number}" in text and f"<td>tolerance 1/{number}</td>" in page
    tables = text
    judgement = tables[tables.index("## Left of"):tables.index("## Error tolerances")]
    errors = [float(row["rmse_255"]) for row in rows if row["method"] == "vtk-gpu"]
    times, error = worst_against_vtk(scene, ["tolerance", "optical", "pre-integrated"])
    assert min(errors) * 0.999 <= error <= max(errors) * 1.001, (error, errors)
    yes = (times or 0) > 1
    assert (f"| {'yes' if yes else '**no**'} |" in judgement) and f"Yes on {int(yes)} of 1" in judgement
    of_tolerances = tables[tables.index("## Error tolerances"):].partition("\n## ")[0]
    assert of_tolerances.count("| tolerance 1/") == len(tolerances)


def work_precision_draws_methods_of_others(folder):
    """Methods of others get the same columns as ours, and fewer samples give larger errors."""
    shadowed = ["half-angle", "light-volume"]  # shadows are not in the truth
    others = ["slices-object", "slices-object-2d", "slices-view", "shells", "passes",
              "corrected-table", *shadowed]
    orders = ["whole-rays", "back-to-front"]
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1", "--methods",
        ",".join(orders + others), "--no-shade", "--orbit", "4")
    table = made_report(folder / "work-precision.json")
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    curves = {method["method"]: method for method in scene["methods"]}
    assert list(curves) == orders + others, list(curves)
    for name, curve in curves.items():
        first, *_, last = curve["points"]
        assert curve["orbit"]["frames"] == 4 and curve["orbit"]["degreesPerFrame"] == 30, curve
        assert 0 < curve["orbit"]["medianChange255"] <= curve["orbit"]["largestChange255"], curve
        assert first["graphicsBytes"] > 2 * 48 * 40 * 32, (name, first)
        assert png_size(folder / f"{scene['name']}-{name}.png") == (48, 40)
        if name not in shadowed:
            assert last["error255"]["rmse"] < first["error255"]["rmse"] < 60, (name, curve)
    # Three stacks of slices, of which one view takes one, and the 3D texture of the others.
    bytes_of = {name: curve["points"][0]["graphicsBytes"] for name, curve in curves.items()}
    assert bytes_of["slices-object-2d"] == bytes_of["slices-object"] + 2 * 48 * 40 * 32, bytes_of
    one, other = (curves[name]["points"] for name in orders)
    assert all(abs(a["error255"]["rmse"] - b["error255"]["rmse"]) < 0.01 for a, b in zip(one, other, strict=True))
    assert "| back to front" not in table and "no field, back to front | 1 voxels |" in table


def work_precision_compares_storages(folder):
    """Fewer bits take less memory and err more; another arrangement of the same bits errs the same."""
    methods = ["passes", "bits-8", "bits-8-rgba", "bits-6", "bits-4-rgba", "bits-1",
               "slices-side-by-side"]
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1", "--methods",
        ",".join(methods), "--no-shade")
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    finest = {method["method"]: method["points"][-1] for method in scene["methods"]}
    assert list(finest) == methods, list(finest)
    errors = {name: point["error255"]["rmse"] for name, point in finest.items()}
    memory = {name: point["graphicsBytes"] for name, point in finest.items()}
    fewer = ["passes", "bits-8", "bits-6", "bits-4-rgba", "bits-1"]
    for more, less in zip(fewer, fewer[1:]):
        assert errors[less] > 1.5 * errors[more], errors
        assert memory[less] < memory[more] or "rgba" in less, memory  # a device may keep 4 in 8 bits
    for other, same in (("bits-8-rgba", "bits-8"), ("slices-side-by-side", "passes")):
        assert abs(errors[other] - errors[same]) < 0.01 * errors[same], errors
    assert memory["bits-8-rgba"] == memory["bits-8"], memory


def work_precision_keeps_what_it_has_when_stopped(folder):
    """A signal leaves complete results of all measured scenes, and a message that counts them."""
    process = subprocess.Popen(
        [sys.argv[1], "work-precision", VOLUME, "procedural:torso:192x192x192", "-o",
         str(folder), "--size", "48x40", "--methods", "off,vtk-cpu"],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while not (folder / "work-precision.json").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    time.sleep(0.2)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == -signal.SIGTERM, errors
    assert errors.splitlines()[-1] == f"varimarch-bench: stopped; {folder} holds 1 of 2 scenes", errors
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    made_report(folder / "work-precision.json")
    rows = list(csv.DictReader((folder / "work-precision.csv").open()))
    assert {row["scene"] for row in rows} == {scene["name"]}
    assert (folder / "work-precision.html").read_text().rstrip().endswith("</html>")
    assert not list(folder.glob("*.part*"))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[2]](pathlib.Path(name))
