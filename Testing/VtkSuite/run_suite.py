#!/usr/bin/env python3
"""Runs VTK's tests with VTK's mapper and through the plugin, and writes the report. See run.sh.

Usage: run_suite.py BUILD_FOLDER [TEST...]
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import time

import pictures
import report

SUITE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(sys.argv[1])
WORK = BUILD / "vtk-suite"
SCRIPTS = WORK / "source/Rendering/Volume/Testing/Python"
(PLUGIN,) = BUILD.glob("lib*/**/varimarch/plugins/vtk-*")
LONGEST_SECONDS = 900


# Environment for each renderer: VTK's mapper, ours, and VTK's with a tenth of its step size.
SETTINGS = {
    "vtk": {},
    "ours": {"VTK_AUTOLOAD_PATH": str(PLUGIN), "VARIMARCH_VERBOSE": "1"},
    "refined": {"REFINED_VTK": "1"},
}


def run(command, who):
    """Runs one test and returns its output, its exit status and its duration."""
    start = time.monotonic()
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=LONGEST_SECONDS,
            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **SETTINGS[who]},
            check=False,
        )
        output, code = done.stdout + done.stderr, done.returncode
    except subprocess.TimeoutExpired:
        output, code = "", "timeout"
    return {
        "output": output,
        "ended": code in (0, 1),
        "errors": sorted(set(re.findall(r"ERROR: .*?\n(.*)", output))),
        "seconds": time.monotonic() - start,
    }


def drawers(output):
    """Renderer of each image in order, and the reason if it was VTK's mapper."""
    told = re.findall(r"Varimarch: (.*?) draws\. ?(.*)", output)
    names = {"The variation field mapper": "ours", "VTK's mapper": "VTK's"}
    return (
        list(dict.fromkeys(names[name] for name, _ in told)),
        list(dict.fromkeys(reason.strip() for _, reason in told if reason.strip())),
    )


def draw(name, who, command):
    folder = WORK / "pictures" / who
    folder.mkdir(parents=True, exist_ok=True)
    picture = folder / f"{name}.png"
    picture.unlink(missing_ok=True)
    result = run(command(folder), who)
    (folder / f"{name}.log").write_text(result["output"])
    return picture, result


def judge(name, command):
    """Compares the renderers; command(folder) makes the test write NAME.png into the folder."""
    vtk, vtk_result = draw(name, "vtk", command)
    ours, our_result = draw(name, "ours", command)
    drawn_by, reasons = drawers(our_result["output"])
    difference = pictures.compare_files(ours, vtk)
    result = {"name": name, "drawnBy": drawn_by, "reasons": reasons, "difference": difference}
    if difference and difference["largest"] > 0:
        refined, _ = draw(name, "refined", command)
        result["oursFromRefined"] = pictures.compare_files(ours, refined)
        result["vtkFromRefined"] = pictures.compare_files(vtk, refined)
    for who, outcome in (("vtk", vtk_result), ("ours", our_result)):
        outcome.pop("output")
        result[who] = outcome
    return result


def cxx_test(name):
    program = WORK / "build/VtkVolumeTests"
    # The baseline image is missing, so the test writes its own.
    return judge(
        name,
        lambda folder: [program, name, "-D", WORK / "data", "-T", folder, "-V", f"/missing/{name}.png"],
    )


def python_test(name):
    return judge(
        name,
        lambda folder: [sys.executable, SUITE / "python_matrix.py", SCRIPTS, name, folder],
    )


def commit():
    command = ["git", "-C", str(SUITE), "rev-parse", "--short", "HEAD"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def main():
    names = [line.split()[1] for line in (SUITE / "tests.txt").read_text().splitlines()]
    scripts = [f"TestFixedPointRayCaster{kind}" for kind in
               ("Nearest", "Linear", "NearestCropped", "LinearCropped")]
    kept = WORK / "results.json"
    results = json.loads(kept.read_text()) if sys.argv[2:] and kept.exists() else {}
    for name in sys.argv[2:] or names + scripts:
        results[name] = cxx_test(name) if name in names else python_test(name)
        print(report.row(results[name]), flush=True)
        kept.write_text(json.dumps(results, indent=1))
    (SUITE.parents[1] / "Documentation/Reports/VtkTests.md").write_text(
        report.page([results[name] for name in names if name in results],
                    [results[name] for name in scripts if name in results],
                    [name for name in names + scripts if name not in results],
                    commit())
    )


main()
