#!/usr/bin/env python3
"""Runs varimarch-bench as a user does and checks what it returns, prints and writes.

Usage: test_benchmarks.py VARIMARCH_BENCH CASE
"""

import csv
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

from bench_reports import made_report, speed_summaries
from test_command_line import VOLUME, png_size, run


def shaders(folder):
    run("shaders", VOLUME, "-o", folder / "out", "--size", "32x32", "--no-shade", "--json", folder / "copy.json")
    text = made_report(folder / "out" / "shaders.json")
    assert "| optical |" in text
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
    run("published", "--volumes", volumes, "-o", folder / "out", "--side", "32", "--rounds", "1")
    text = made_report(folder / "out" / "published.json")
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
    run("speed", "procedural:shells:16x16x16", "--volumes", volumes, "--only", "vismale,tooth-soft", "-o",
        folder / "out", "--sides", "32", "--shading", "off", "--rounds", "2", "--json", folder / "copy.json")
    text = made_report(folder / "out" / "speed.json")
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
    against = [summary["against"] for summary in speed_summaries(results)]
    assert len(against) == len(set(against)) >= 5, against
    assert all(("**missed**" in row) != ("| met" in row) for row in text.splitlines()
               if row.startswith("| VTK's GPU mapper"))
    with (folder / "out" / "32.csv").open() as file:
        assert [row["scene"] for row in csv.DictReader(file)] == scenes
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
    against = [summary["against"] for summary in speed_summaries(results)]
    assert against and against[::2] == against[1::2], "not each target at each size"
    for case in cases:
        assert case["shaded"] and all(len(point["rounds"]) == 1 for point in case["points"])
        assert "published" not in [point["method"] for point in case["points"]]


def shadows(folder):
    run("shadows", VOLUME, "-o", folder / "out", "--side", "32", "--rounds", "1", "--tolerances", "0.0625,0.015625",
        "--views", "2")
    text = made_report(folder / "out" / "shadows.json")
    scene, = json.loads((folder / "out" / "shadows.json").read_text())["scenes"]
    promises = scene["promises"]
    assert [(kept["view"], kept["errorTolerance"]) for kept in promises] == [
        (0, 0.0625), (0, 0.015625), (1, 0.0625), (1, 0.015625)]
    for kept in promises:
        assert kept["error"]["percentile99.9"] <= 255 * kept["errorTolerance"], kept
    assert promises[0]["error"] != promises[2]["error"], "one view, twice"
    worst = max(kept["error"]["percentile99.9"] for kept in promises[1::2])
    assert f"| {worst:.2f} |\n" in text.split("## Tolerances")[1], text


def shadows_beside(folder):
    run("shadows-beside", VOLUME, "-o", folder / "out", "--side", "32", "--rounds", "1")
    text = made_report(folder / "out" / "shadows-beside.json")
    scene, = json.loads((folder / "out" / "shadows-beside.json").read_text())["scenes"]
    names = [cost["name"] for cost in scene["costs"]]
    assert len(names) == 6 and all(name in text for name in names), names
    for cost in scene["costs"]:
        assert min(cost[key] for key in ("withoutMs", "withMs", "factor", "firstMs")) > 0.0, cost


def light_methods(folder):
    run("light-methods", VOLUME, "-o", folder / "out", "--side", "32", "--rounds", "1")
    assert "| half-angle, blurred |" in made_report(folder / "out" / "light-methods.json")
    with (folder / "out" / "light-methods.csv").open() as file:
        rows = {row["method"]: row for row in csv.DictReader(file)}
    assert list(rows) == ["ours", "ours, coarse", "no shadows", "second march", "light volume",
                          "half-angle", "half-angle, blurred", "VTK's rays"], list(rows)
    error = {name: float(row["percentile999"]) for name, row in rows.items()}
    assert error["ours"] <= 255 / 64, error
    assert error["no shadows"] > max(5.0, error["second march"]), error
    assert float(rows["no shadows"]["light_megabytes"]) == 0.0
    assert rows["half-angle"]["light_megabytes"] == "2.097", "two buffers of 256 x 256 pixels"
    json_scene, = json.loads((folder / "out" / "light-methods.json").read_text())["scenes"]
    assert set(json_scene["methods"]) == set(rows)


def scaling(folder):
    run("scaling", "-o", folder, "--sides", "16,32", "--size", "48x40", "--rounds", "2", "--no-shade")
    assert made_report(folder / "scaling.json").count("| torso | ours | ") == 2
    results = json.loads((folder / "scaling.json").read_text())
    assert results["size"] == [48, 40]
    assert [(curve["volume"], curve["renderer"]) for curve in results["curves"]] == [
        (volume, renderer) for volume in ("shells", "torso") for renderer in ("ours", "vtk-gpu")]
    for curve in results["curves"]:
        assert [point["side"] for point in curve["points"]] == [16, 32] and not curve["stopped"]
        assert all(len(point["rounds"]) == 2 for point in curve["points"])
    ours = results["curves"][0]["points"]
    assert all(point["graphicsBytes"] > 16 * 24 * 20 for point in ours)  # where the volume is


def extremes(folder):
    names = ["OpaqueAboveAStep", "NotANumberInADenseVolume", "OneVoxel", "StepOf1e-30"]
    run("extremes", "-o", folder, "--only", ",".join(names))
    assert all(f"| {name} |" in made_report(folder / "extremes.json") for name in names)
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
    run("order", "-o", folder, "--side", "16")
    text = made_report(folder / "order.json")
    results = json.loads((folder / "order.json").read_text())
    names = ["steps-ramp", "steps-checkerboard", "tolerance-ramp", "tolerance-checkerboard",
             "grid", "grid-inside", "pixels"]
    assert [experiment["name"] for experiment in results["experiments"]] == names
    rows = list(csv.DictReader((folder / "order.csv").open()))
    orders = {}
    for experiment in results["experiments"]:
        name = experiment["name"]
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
    run("soak", "procedural:shells:16x16x16", "-o", folder, "--size", "32x32", "--frames", "410")
    assert "The last tenth takes" in made_report(folder / "soak.json")
    parts = json.loads((folder / "soak.json").read_text())["parts"]
    assert [part["frames"] for part in parts] == list(range(41, 411, 41))
    assert all(part["medianMs"] > 0 for part in parts)
    # Nothing grows once all kinds of frames were rendered.
    assert parts[-1]["openFiles"] == parts[-2]["openFiles"]
    assert parts[-1]["residentMegabytes"] < parts[-2]["residentMegabytes"] + 20


def times(folder):
    run("times", "procedural:shells:16x16x16", "-o", folder, "--size", "32x32", "--times", "4", "--frames", "200")
    assert "| frames, each of another of 4 times | 200 |" in made_report(folder / "times.json")
    cost = json.loads((folder / "times.json").read_text())
    assert cost["frames"] == 200 and cost["newMs"] > 0 and cost["stillMs"] > 0, cost
    assert cost["residentMegabytesAtEnd"] < cost["residentMegabytesAtFirst"] + 20, cost


def features(folder):
    run("features", "procedural:shells:16x16x16", "-o", folder, "--size", "32x32", "--rounds", "1", "--only",
        "shading,dependent-4")
    text = made_report(folder / "features.json")
    assert "| shading | composite |" in text and "failed" not in text
    measured = json.loads((folder / "features.json").read_text())["features"]
    assert [feature["name"] for feature in measured] == ["shading", "dependent-4"]
    for feature in measured:
        assert not feature["failure"]
        assert all(feature[who][time] > 0 for who in ("ours", "vtk")
                   for time in ("beforeMs", "onMs", "afterMs"))
    assert not measured[0]["drawnByVtk"]


def promise(folder):
    """Results go to a folder, or to the standard output, from which the report is made alike."""
    arguments = ("promise", "--scenes", "3", "--size", "12")
    printed, _ = run(*arguments)
    run(*arguments, "-o", folder)
    results = json.loads((folder / "promise.json").read_text())
    assert len(results["pictures"]) >= 3 and {"seed", "answer", "alone"} <= set(results["pictures"][0])
    assert [picture["answer"] for picture in json.loads(printed)["pictures"]] == [
        picture["answer"] for picture in results["pictures"]]
    all_kinds, = (row for row in made_report(folder / "promise.json").splitlines() if row.startswith("| all |"))
    assert all_kinds.startswith(f"| all | {len(results['pictures'])} |"), all_kinds


def usage(folder):
    for arguments in ([], ["speed"], ["spead"], ["scaling", "-o", folder, "--rounds", "0"]):
        _, errors = run(*arguments, expect=2)
        assert errors.strip(), arguments
    text, _ = run("--help")
    for command in ("work-precision", "published", "speed", "shadows", "shadows-beside", "light-methods", "scaling",
                    "features", "shaders", "extremes", "order", "references", "soak", "times", "promise"):
        assert command in text.partition("Subcommands:")[2], text
        text_of_command, _ = run(command, "--help")
        assert f"  varimarch-bench {command} " in text_of_command, "help without examples"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[2]](pathlib.Path(name))
