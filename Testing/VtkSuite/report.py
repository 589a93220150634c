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
        return "no picture | | | "
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


HEAD = """# VTK's own tests as judge

The procedural volume tests of VTK 9.1, as they come in the distribution's source package, run
unmodified: once with VTK's mapper, which makes the baselines, and once through the plugin
(`VTK_AUTOLOAD_PATH`, see `Documentation/Plugin.md`). Made by
```
Testing/VtkSuite/run.sh build/release
```
on Mesa's llvmpipe, in windows of Xvfb, at commit COMMIT. Where a strict one is
not 0, the last section says why.

*Drawn by*: "ours", "VTK's" where the plugin left the picture to VTK's mapper (reasons below), "names its
class" where the test asks for VTK's mapper by its own name and the factory has no part in it.
*VTK's measure* is that of vtkTesting in VTK 9.1, which passes up to 0.15: it forgives 35 levels in each
channel and a shift by one pixel. The strict ones are differences of a channel in units of 1/255: RMSE, the
99.9th percentile and the largest. *To the limit*: RMSE to VTK's own mapper with a tenth of its steps, which is
nearer to what both tend to: the smaller of the two numbers tells which mapper is off, unless VTK's is off at
any number of steps. Times include the start of the program and are no measurement.

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
