#!/usr/bin/env python3
"""Runs varimarch-bench as a user does and checks what it returns, prints and writes.

Usage: test_benchmarks.py VARIMARCH_BENCH CASE
"""

import csv
import html
import json
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time

from test_command_line import VOLUME, png_size, run


def work_precision(folder):
    scene = folder / "two shells.json"
    scene.write_text('{"volume": {"procedural": "shells", "size": [16, 16, 16]},'
                     ' "look": "mr-head", "size": [48, 40]}')
    output = folder / "report"
    table, _ = run("work-precision", scene, VOLUME, "-o", output, "--size", "48x40",
                   "--rounds", "2", "--methods", "optical,off,vtk-gpu,vtk-cpu", "--no-shade",
                   "--json", folder / "copy.json")
    results = json.loads((output / "work-precision.json").read_text())
    assert json.loads((folder / "copy.json").read_text()) == results
    assert results["machine"]["cores"] >= 1 and results["machine"]["processor"]
    names = ["two-shells", "procedural-torso-48x40x32"]
    assert [scene["name"] for scene in results["scenes"]] == names
    rows = list(csv.DictReader((output / "work-precision.csv").open()))
    for name in names:
        assert name in table
        assert png_size(output / f"{name}-time.png")[0] > 1000
        assert (output / f"{name}-time.svg").read_text().rstrip().endswith("</svg>")
        curves = {method: [float(row["rmse_255"]) for row in rows
                           if row["scene"] == name and row["method"] == method]
                  for method in ("optical", "off", "vtk-gpu", "vtk-cpu")}
        lengths = {method: len(curve) for method, curve in curves.items()}
        assert lengths == {"optical": 8, "off": 6, "vtk-gpu": 6, "vtk-cpu": 6}, lengths
        reads = [float(row["fetches_per_pixel"] or 0) for row in rows if row["scene"] == name
                 and row["method"] == "off"]
        # Half the distance gives twice the samples, except on rays that end within a step or early.
        assert 1.5 < reads[5] / reads[4] < 2.1, reads
        assert png_size(output / f"{name}-readings.png")[0] > 1000
        # Finer sampling reduces the error, and the benchmark measures that.
        assert curves["off"][-1] < curves["off"][0] / 10, curves
    assert all(float(row["median_ms"]) > 0 for row in rows)
    assert all(bool(row["graphics_bytes"]) == (row["method"] in ("optical", "off")) for row in rows)
    assert all(method["orbit"]["frames"] == 31 for scene in results["scenes"]
               for method in scene["methods"])
    page = (output / "work-precision.html").read_text()
    assert "://" not in page and 'src="data:image/svg+xml;base64,' in page, "not self-contained"
    assert page.count("<figure>") == 2 * (1 + 2 * 4)
    assert results["command"] in html.unescape(page)


def work_precision_leaves_out_what_takes_long(folder):
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1",
        "--methods", "vtk-gpu", "--longest", "1e-9")
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    (method,) = scene["methods"]
    assert [point["setting"] for point in method["points"]] == ["4 voxels"]
    assert "2 voxels and finer" in method["skipped"]
    assert html.escape(method["skipped"]) in (folder / "work-precision.html").read_text()


def work_precision_judges_error_tolerances(folder):
    text, _ = run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds",
                  "1", "--methods", "tolerance,optical,vtk-gpu,vtk-cpu", "--no-shade")
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
    judged = scene["tolerances"]
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
    tables = (folder / "work-precision.md").read_text()
    judgement = tables[tables.index("## Left of"):tables.index("## Error tolerances")]
    errors = [float(row["rmse_255"]) for row in rows if row["method"] == "vtk-gpu"]
    worst = scene["worstAgainstVtkGpu"]
    assert min(errors) * 0.999 <= worst["rmse255"] <= max(errors) * 1.001, (worst, errors)
    yes = worst.get("timesAsFast", 0) > 1
    assert (f"| {'yes' if yes else '**no**'} |" in judgement) and f"Yes on {int(yes)} of 1" in judgement
    of_tolerances = tables[tables.index("## Error tolerances"):].partition("\n## ")[0]
    assert of_tolerances.count("| tolerance 1/") == len(tolerances)


def work_precision_draws_methods_of_others(folder):
    """Methods of others get the same columns as ours, and fewer samples give larger errors."""
    shadowed = ["half-angle", "light-volume"]  # shadows are not in the truth
    others = ["slices-object", "slices-object-2d", "slices-view", "shells", "passes", *shadowed]
    orders = ["whole-rays", "back-to-front"]
    run("work-precision", VOLUME, "-o", folder, "--size", "48x40", "--rounds", "1", "--methods",
        ",".join(orders + others), "--no-shade", "--orbit", "4")
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
    table = (folder / "work-precision.md").read_text()
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


def shaders(folder):
    text, _ = run("shaders", VOLUME, "-o", folder / "out", "--size", "32x32", "--no-shade",
                  "--json", folder / "copy.json")
    assert (folder / "out" / "shaders.md").read_text() == text
    results = json.loads((folder / "out" / "shaders.json").read_text())
    assert json.loads((folder / "copy.json").read_text()) == results
    costs = {cost["recipe"]: cost for cost in results["shaders"]}
    assert {"off", "optical", "back-to-front", "clipping", "maximum"} <= set(costs), list(costs)
    assert "lit" not in costs["simpson"] and "shells" not in costs
    for name in ("off", "optical", "clipping"):
        plain, lit = costs[name]["plain"], costs[name]["lit"]
        assert plain["textures"] >= 2 and plain["numbers"] > 100, (name, plain)
        if "llvmpipe" in results["openglRenderer"]:
            for cost in (plain, lit):  # which is larger depends on the rule of integration
                assert cost["instructions"] > 100 and cost["fetches"] >= 3, (name, plain, lit)
    assert costs["optical"]["plain"]["textures"] == costs["off"]["plain"]["textures"] + 1
    if "llvmpipe" in results["openglRenderer"]:  # features are measured on linear interpolation
        fetches = [costs[name]["plain"]["fetches"] for name in ("nearest", "clipping", "cubic")]
        assert fetches == sorted(set(fetches)), fetches


def write_ball(volumes):
    """Writes a small ball in place of the Visible Male in a folder of volumes."""
    (volumes / "vismale").mkdir(parents=True)
    name = "vismale_128x256x256_uint8"
    side = 16
    voxels = bytes(200 if (x - 8) ** 2 + (y - 8) ** 2 + (z - 8) ** 2 < 36 else 20
                   for z in range(side) for y in range(side) for x in range(side))
    (volumes / "vismale" / f"{name}.raw").write_bytes(voxels)
    (volumes / "vismale" / f"{name}.mhd").write_text(
        "ObjectType = Image\nNDims = 3\nDimSize = 16 16 16\nElementSpacing = 1 1 1\n"
        f"ElementType = MET_UCHAR\nElementDataFile = {name}.raw\n")


def published(folder):
    """A small ball replaces one of the papers' volumes; the missing others are named."""
    volumes = folder / "volumes"
    write_ball(volumes)
    text, _ = run("published", "--volumes", volumes, "-o", folder / "out", "--side", "32",
                  "--rounds", "1")
    assert (folder / "out" / "published.md").read_text() == text
    assert "Not in the folder: tooth/tooth_103x94x161_uint8.mhd." in text
    assert "| VIS MALE | 256 x 256 x 256 | 120 | 32.1 |" in text
    assert "| VIS MALE | 128 x 128 x 128 | 45 | > 60 | > 1.33 | 0.5 |" in text
    results = json.loads((folder / "out" / "published.json").read_text())
    sets = results["banquero"]
    assert [(row["dataSet"], row["side"]) for row in sets] == [("VIS MALE", 128), ("VIS MALE", 256)]
    methods = {method["method"]: method["points"] for method in sets[0]["measured"]["methods"]}
    assert list(methods) == ["steps", "rc", "df", "tolerance", "tolerance-shader"]
    for name in ("rc", "df"):
        assert [round(point["voxels"], 3) for point in methods[name]] == [1, 0.5], name
    fetches = {name: methods[name][0]["fetchesPerPixel"] for name in ("steps", "rc", "df")}
    assert 1 < fetches["steps"] < fetches["rc"] and fetches["df"] < fetches["rc"], fetches
    assert sets[0]["meanChebyshev"] <= sets[0]["meanEuclidean"] and 0 < sets[0]["longJumps"] <= 1
    for name in (f"figure-{figure}.png" for figure in (3, 5, 6, 9, 10)):
        assert png_size(folder / "out" / name)[0] >= 64 and name in text
    assert [(row["alpha255"], row["shaded"]) for row in results["volt"]] == [
        (alpha, shaded) for alpha in (15, 63, 255) for shaded in (False, True)]
    _, errors = run("published", "--volumes", folder / "out", "-o", folder, expect=1)
    assert "found none" in errors


def speed(folder):
    """A small ball replaces one of the volumes, with each look, beside a procedural scene."""
    volumes = folder / "volumes"
    write_ball(volumes)
    text, _ = run("speed", "procedural:shells:16x16x16", "--volumes", volumes, "--only",
                  "vismale,tooth-soft", "-o", folder / "out", "--sides", "32", "--shading",
                  "off", "--rounds", "2", "--json", folder / "copy.json")
    assert (folder / "out" / "speed.md").read_text() == text
    results = json.loads((folder / "out" / "speed.json").read_text())
    assert json.loads((folder / "copy.json").read_text()) == results
    assert results["missing"] == ["tooth/tooth_103x94x161_uint8.mhd"]
    scenes = ["vismale-soft", "vismale-dense", "vismale-thin-peak", "procedural:shells:16x16x16"]
    assert [case["scene"] for case in results["cases"]] == scenes
    rivals = {"vtk-gpu": 1, "vtk-cpu": 0.2, "off": 1, "off-shader": 1, "published": 1}
    kept = {}
    for case in results["cases"]:
        points = case["points"]
        assert [point["method"] for point in points[:7]] == [
            "ours", "off", "ours-shader", "off-shader", "published", "vtk-gpu", "vtk-cpu"]
        assert all(len(point["rounds"]) >= 2 for point in points)
        assert all(("fetchesPerPixel" in p) == p["renderer"].startswith("ours") for p in points)
        assert points[1]["median"]["firstFieldMs"] == 0 < points[0]["median"]["firstFieldMs"]
        error = {point["method"]: point["error255"]["rmse"] for point in points[:7]}
        for kept_error in case.get("keeping", []):
            ours, rival = points[kept_error["point"]], kept_error["rival"]
            kept[rival] = max(kept.get(rival, 0), len(kept_error["rounds"]))
            assert kept_error["timesAsFast"] == statistics.median(kept_error["rounds"])
            assert ours["error255"]["rmse"] <= rivals[rival] * error[rival] * 1.001, case
    assert set(kept) == set(rivals) and 6 in kept.values(), "one not compared, or short ones once"
    against = [target["against"] for target in results["targets"]]
    assert len(against) == len(set(against)) >= 5, against
    assert all(("**missed**" in row) != ("| met" in row) for row in text.splitlines()
               if row.startswith("| VTK's GPU mapper"))
    assert png_size(folder / "out" / "speed.png")[0] > 1000
    _, errors = run("speed", "-o", folder, expect=2)
    assert "SCENES or --volumes" in errors
    _, errors = run("speed", "--volumes", folder, "-o", folder, expect=1)
    assert "found none" in errors


def speed_draws_what_takes_long_in_one_round(folder):
    run("speed", "procedural:shells:16x16x16", "-o", folder, "--sides", "32,48", "--shading",
        "on", "--rounds", "2", "--longest", "1e-9")
    results = json.loads((folder / "speed.json").read_text())
    cases = results["cases"]
    assert [case["side"] for case in cases] == [32, 48]
    against = [target["against"] for target in results["targets"]]
    assert against and against[::2] == against[1::2], "not each target at each size"
    for case in cases:
        assert case["shaded"] and all(len(point["rounds"]) == 1 for point in case["points"])
        assert "published" not in [point["method"] for point in case["points"]]


def scaling(folder):
    text, _ = run("scaling", "-o", folder, "--sides", "16,32", "--size", "48x40",
                  "--rounds", "2", "--no-shade")
    assert (folder / "scaling.md").read_text() == text
    results = json.loads((folder / "scaling.json").read_text())
    assert results["size"] == [48, 40]
    assert [(curve["volume"], curve["renderer"]) for curve in results["curves"]] == [
        (volume, renderer) for volume in ("shells", "torso") for renderer in ("ours", "vtk-gpu")]
    for curve in results["curves"]:
        assert [point["side"] for point in curve["points"]] == [16, 32] and not curve["stopped"]
        assert all(len(point["rounds"]) == 2 for point in curve["points"])
    ours = results["curves"][0]["points"]
    assert all(point["graphicsBytes"] > 16 * 24 * 20 for point in ours)  # where the volume is
    assert png_size(folder / "scaling.png")[0] > 1000


def extremes(folder):
    names = ["OpaqueAboveAStep", "NotANumberInADenseVolume", "OneVoxel", "StepOf1e-30"]
    text, _ = run("extremes", "-o", folder, "--only", ",".join(names))
    assert (folder / "extremes.md").read_text() in text
    rows = list(csv.DictReader((folder / "extremes.csv").open()))
    drawn = {row["scene"] for row in rows}
    assert drawn == {*names, "OneVoxelThick", "OneVoxelThickFromItsFront", "OneVoxelThickInX",
                     "OneVoxelThickInY", "OneVoxelThickInTwoAxes", "OneVoxelOfNotANumber"}, drawn
    assert len(rows) == 4 * len(drawn)
    for row in rows:
        if row["mapper"].startswith("ours"):
            # Rays that graze a hard surface are right or wrong by all.
            right = float(row["percentile_99_9_255"]) <= 4 or row["scene"] == "OpaqueAboveAStep"
            assert row["finite"] == "yes" and (right or row["message"]), row
            assert row["empty"] == "no" and float(row["median_ms"]) > 0, row
        if row["scene"] == "StepOf1e-30":
            assert row["tried"] == ("yes" if row["mapper"].startswith("ours") else "no"), row


def order(folder):
    text, _ = run("order", "-o", folder, "--side", "16")
    results = json.loads((folder / "order.json").read_text())
    names = ["steps-ramp", "steps-checkerboard", "tolerance-ramp", "tolerance-checkerboard",
             "grid", "grid-inside", "pixels"]
    assert [experiment["name"] for experiment in results["experiments"]] == names
    rows = list(csv.DictReader((folder / "order.csv").open()))
    orders = {}
    for experiment in results["experiments"]:
        name = experiment["name"]
        assert png_size(folder / f"{name}.png")[0] > 1000
        assert (folder / f"{name}.svg").read_text().rstrip().endswith("</svg>")
        for method in experiment["methods"]:
            assert method["method"] in text
            assert len(method["points"]) == sum(
                row["experiment"] == name and row["method"] == method["method"] for row in rows)
            orders[name, method["method"]] = (method.get("order"), method.get("expectedOrder"))
    # The orders of our rules where theory has them: linear values along rays, and a smooth field.
    for name, method in [("steps-ramp", "Varimarch, midpoint"),
                         ("steps-ramp", "Varimarch, midpoint, packets"),
                         ("steps-ramp", "Varimarch, pre-integrated"),
                         ("steps-ramp", "published sum"), ("grid", "Varimarch, linear")]:
        observed, expected = orders[name, method]
        assert abs(observed - expected) < 0.35, (name, method, observed, expected)


def references(folder):
    committed = pathlib.Path(__file__).parents[2] / "Data" / "References"
    run("references", "-o", folder / "again")
    run("references", "-o", folder / "vtk", "--renderer", "vtk-gpu")
    names = sorted(path.name for path in committed.iterdir())
    written = sorted(path.name for path in (folder / "again").iterdir())
    assert written == [name for name in names if name not in ("README.md", "compare.py")], written

    def compared(pictures):
        script = [sys.executable, committed / "compare.py", pictures, "--json"]
        result = subprocess.run(script, capture_output=True, text=True, check=False)
        return result.returncode, result.stderr, json.loads(result.stdout or "[]")

    code, errors, rows = compared(folder / "again")
    assert code == 0, errors
    assert len(rows) == sum(name.endswith(".npy") for name in names)
    # Another compiler rounds otherwise, within the error that the reference states.
    assert all(row["largest"] <= max(2 * 255 * row["reference_error"], 1e-3) for row in rows), rows
    code, errors, rows = compared(folder / "vtk")
    assert code == 0, errors
    assert all(row["rmse"] > 0.01 for row in rows), rows
    (folder / "vtk" / "ramp.npy").unlink()
    code, errors, _ = compared(folder / "vtk")
    assert code == 1 and "ramp.npy" in errors, errors


def soak(folder):
    text, _ = run("soak", "procedural:shells:16x16x16", "-o", folder, "--size", "32x32",
                  "--frames", "410")
    assert (folder / "soak.md").read_text() == text
    parts = json.loads((folder / "soak.json").read_text())["parts"]
    assert [part["frames"] for part in parts] == list(range(41, 411, 41))
    assert all(part["medianMs"] > 0 for part in parts)
    # Nothing grows once all kinds of frames were rendered.
    assert parts[-1]["openFiles"] == parts[-2]["openFiles"]
    assert parts[-1]["residentMegabytes"] < parts[-2]["residentMegabytes"] + 20


def features(folder):
    text, _ = run("features", "procedural:shells:16x16x16", "-o", folder, "--size",
                  "32x32", "--rounds", "1", "--only", "shading,dependent-4")
    assert (folder / "features.md").read_text() == text
    measured = json.loads((folder / "features.json").read_text())["features"]
    assert [feature["name"] for feature in measured] == ["shading", "dependent-4"]
    for feature in measured:
        assert not feature["failure"]
        assert all(feature[who][time] > 0 for who in ("ours", "vtk")
                   for time in ("beforeMs", "onMs", "afterMs"))
    assert not measured[0]["drawnByVtk"]


def work_precision_keeps_what_it_has_when_stopped(folder):
    """A signal leaves complete reports of all measured scenes, and a message that counts them."""
    process = subprocess.Popen(
        [sys.argv[1], "work-precision", VOLUME, "procedural:torso:192x192x192", "-o",
         str(folder), "--size", "48x40", "--methods", "off,vtk-cpu"],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while not (folder / "work-precision.html").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    time.sleep(0.2)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == -signal.SIGTERM, errors
    assert errors.splitlines()[-1] == f"varimarch-bench: stopped; {folder} holds 1 of 2 scenes", errors
    (scene,) = json.loads((folder / "work-precision.json").read_text())["scenes"]
    rows = list(csv.DictReader((folder / "work-precision.csv").open()))
    assert {row["scene"] for row in rows} == {scene["name"]}
    assert (folder / "work-precision.html").read_text().rstrip().endswith("</html>")
    assert not list(folder.glob("*.part*"))


def usage(folder):
    for arguments in ([], ["speed"], ["spead"], ["scaling", "-o", folder, "--rounds", "0"]):
        _, errors = run(*arguments, expect=2)
        assert errors.strip(), arguments
    text, _ = run("--help")
    for command in ("work-precision", "published", "speed", "scaling", "features", "shaders",
                    "extremes", "order", "references", "soak"):
        assert command in text.partition("Subcommands:")[2], text
        text_of_command, _ = run(command, "--help")
        assert f"  varimarch-bench {command} " in text_of_command, "help without examples"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[2]](pathlib.Path(name))
