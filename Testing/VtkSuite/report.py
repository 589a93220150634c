"""Results of VTK's tests as a Markdown table."""

import json
import pathlib

EXPLANATIONS = pathlib.Path(__file__).with_name("explanations.json")


def drawer(result):
    if not result["drawnBy"]:
        return "names its class"
    return " then ".join(result["drawnBy"]) if len(result["drawnBy"]) > 1 else result["drawnBy"][0]


def numbers(difference):
    if not difference:
        return "no image | | | "
    return "{vtk:.3f} | {rmse:.2f} | {most:.0f} | {largest:.0f}".format(**difference)


def rmse(result, key):
    return "{rmse:.2f}".format(**result[key]) if result.get(key) else ""


def row(result):
    times = f"{result['vtk']['seconds']:.0f} | {result['ours']['seconds']:.0f}"
    failed = "" if result["ours"]["ended"] else " **ended early**"
    failed += " **errors**" if result["ours"]["errors"] else ""
    return f"| {result['name']}{failed} | {drawer(result)} | {numbers(result['difference'])} | {rmse(result, 'oursFromRefined')} | {rmse(result, 'vtkFromRefined')} | {times} |"


def explanation(result):
    return json.loads(EXPLANATIONS.read_text()).get(result["name"], "")


HEAD = """# VTK's own tests through the plugin

This page shows what a user of VTK sees who loads the plugin. The procedural volume tests of VTK
9.1, from the distribution's source package, run unmodified: once with VTK's mapper, which makes the
baselines, and once through the plugin (`VTK_AUTOLOAD_PATH`, see `Documentation/Plugin.md`). The
report is made by
```
Testing/VtkSuite/run.sh build/release
```
on Mesa's llvmpipe, in windows of Xvfb, at commit COMMIT. The last section explains each difference
that a strict measure finds.

| column | meaning |
|---|---|
| drawn by | "ours"; "VTK's" if the plugin left the image to VTK's mapper, for a reason below; "names its class" if the test makes VTK's mapper by its own class name, so that no factory is asked |
| VTK's measure | the measure of vtkTesting in VTK 9.1. A test passes up to 0.15; the measure forgives 35 levels in each channel and a shift by one pixel |
| RMSE, 99.9 %, largest | strict differences of a channel, in units of 1/255: root mean square, 99.9th percentile and maximum |
| ours to the limit, VTK's to the limit | RMSE to VTK's own mapper at a tenth of its sample distance, which is nearer to the exact image. The smaller number tells which mapper is more accurate, unless VTK's mapper is wrong at every sample distance |
| VTK's [s], ours [s] | time of the test with the start of its program; it is not a measurement of speed |

| test | drawn by | VTK's measure | RMSE | 99.9 % | largest | ours to the limit | VTK's to the limit | VTK's [s] | ours [s] |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|
"""


def paragraphs(title, results, text):
    lines = [f"- `{result['name']}`: {text(result)}" for result in results if text(result)]
    return f"\n## {title}\n" + "\n".join(lines) + "\n" if lines else ""


def page(tests, scripts, missing, commit):
    """The whole report; missing: names of the tests that did not run."""
    left_out = ", ".join(f"`{name}`" for name in missing)
    table = "\n".join(row(result) for result in tests)
    matrix = "\n".join(row(result) for result in scripts)
    return (
        f"{HEAD.replace('COMMIT', commit)}{table}\n"
        + paragraphs("Left to VTK's mapper", tests + scripts, lambda r: "; or: ".join(r["reasons"]))
        + "\n## VTK's Python matrix\nFive kinds of data by five looks each; VTK's CPU mapper is "
        "replaced by `vtkGPUVolumeRayCastMapper`.\n\n"
        + "".join(HEAD.splitlines(keepends=True)[-2:])
        + f"{matrix}\n"
        + (f"\nNot run this time: {left_out}.\n" if missing else "")
        + paragraphs("Differences explained", tests + scripts, explanation)
    )
