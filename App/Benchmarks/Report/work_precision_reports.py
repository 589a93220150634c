"""Reports of error against run time: work-precision, and the published scenes."""

import base64
import html
import math

from columns import Column, Curve, Plot, Report, Table, load_text

# Colours that are distinct for every kind of colour vision: M. Okabe, K. Ito, "Color universal design",
# 2008. Brown and gray, darker and lighter than all others, are for third-party methods.
BLACK, BLUE, SKY, GREEN = "#000000", "#0072b2", "#56b4e9", "#009e73"
VERMILION, PURPLE, ORANGE, BROWN, GRAY = "#d55e00", "#cc79a7", "#e69f00", "#663300", "#8c8c8c"
STYLES = {
    "tolerance": (BLUE, "s", "--"), "optical": (BLUE, "o", "-"), "off": (SKY, "D", "--"),
    "cells-1": (GREEN, "o", "-"), "cells-4": (GREEN, "D", "--"), "cells-10": (GREEN, "s", ":"),
    "pre-integrated": (PURPLE, "o", "-"), "simpson": (PURPLE, "s", "--"), "published": (ORANGE, "D", "-"),
    "vtk-gpu": (VERMILION, "s", "-"), "vtk-cpu": (BLACK, "D", "--"), "whole-rays": (SKY, "o", ":"),
    "back-to-front": (SKY, "s", "-"), "stored-gradients": (BLUE, "D", ":"), "slices-object": (BROWN, "o", "-"),
    "slices-object-2d": (BROWN, "s", ":"), "slices-view": (BROWN, "D", "--"), "shells": (GRAY, "o", "-"),
    "passes": (GRAY, "s", "--"), "corrected-table": (GRAY, "o", "--"), "half-angle": (GRAY, "D", ":"),
    "light-volume": (BROWN, "D", ":"), "bits-8": (GREEN, "s", "-"), "bits-8-rgba": (GREEN, "D", ":"),
    "bits-6": (PURPLE, "D", "-"), "bits-4-rgba": (ORANGE, "o", "--"), "bits-1": (VERMILION, "D", ":"),
    "slices-side-by-side": (BLACK, "o", ":"),
}
OURS = ["tolerance", "optical", "pre-integrated"]  # the methods that use our mapper as intended
BY_HAND = ["optical", "pre-integrated", "simpson"]
SLOWEST_RATIO = 2.0  # our promise for the time of an error tolerance, relative to the best setting by hand


def curve_of(scene, method):
    return next((curve for curve in scene["methods"] if curve["method"] == method), None)


def rmse(point):
    return point["error255"]["rmse"]


def errors_of(curve):
    """The smallest and the largest RMSE of a curve."""
    errors = [rmse(point) for point in curve["points"]]
    return min(errors), max(errors)


def milliseconds_at_error(curve, error, measure="rmse"):
    """The time of a method at an error, interpolated along straight lines of the log-log plot.

    If even its coarsest setting has a smaller error, that setting's time; None if no setting has so small
    an error.
    """
    best = math.inf
    points = curve["points"]
    for i, point in enumerate(points):
        right = point["error255"][measure]
        left = points[i - 1]["error255"][measure] if i else right
        if right <= error:
            best = min(best, point["medianMs"])
        if left > error > right:
            part = math.log(left / error) / math.log(left / right) if right > 0 else 0.0
            left_ms = points[i - 1]["medianMs"]
            best = min(best, left_ms * (point["medianMs"] / left_ms) ** part)
    return None if math.isinf(best) else best


def fastest_at_error(scene, methods, error, measure="rmse"):
    """The time of the fastest of the methods at an error, and its name."""
    times = [(milliseconds_at_error(curve_of(scene, method), error, measure), method)
             for method in methods if curve_of(scene, method)]
    return min(((time, method) for time, method in times if time is not None), key=lambda pair: pair[0],
               default=(None, None))


def worst_against_vtk(scene, methods):
    """The smallest speed-up over VTK's GPU mapper at any RMSE that it has, and this RMSE.

    The speed-up is None if no setting has so small an error. None if VTK's mapper or all of the methods were
    not measured.
    """
    errors = 200  # number of errors, evenly spaced in the plot
    vtk = curve_of(scene, "vtk-gpu")
    if not vtk or not any(curve_of(scene, method) for method in methods):
        return None
    smallest, largest = errors_of(vtk)
    worst = (math.inf, largest)
    for i in range(errors + 1):
        error = max(largest * (smallest / largest) ** (i / errors), smallest)
        ours, _ = fastest_at_error(scene, methods, error)
        if ours is None:
            return None, error
        ratio = milliseconds_at_error(vtk, error) / ours
        worst = min(worst, (ratio, error), key=lambda pair: pair[0])
    return worst


def equal_error_rows(scene):
    """VTK's settings, each with our time at the same error."""
    vtk, ours = curve_of(scene, "vtk-gpu"), curve_of(scene, "optical")
    return [(point, milliseconds_at_error(ours, rmse(point))) for point in vtk["points"]] if vtk and ours else []


EQUAL_ERROR = [
    Column("VTK's sample distance", lambda row: row[0]["voxels"], 3, "voxels"),
    Column("RMSE", lambda row: rmse(row[0]), 3, "1/255"),
    Column("VTK", lambda row: row[0]["medianMs"], 1, "ms"),
    Column("ours", lambda row: row[1], 1, "ms", "never as precise"),
    Column("times as fast", lambda row: row[1] and row[0]["medianMs"] / row[1], 2, missing=""),
]


def tolerance_rows(scene):
    """Error and time of our defaults at each tolerance, and our fastest setting by hand of the same error."""
    rows = []
    for point in (curve_of(scene, "tolerance") or {"points": []})["points"]:
        tolerance, error = point["errorTolerance"], point["error255"]
        hand_ms, hand = fastest_at_error(scene, BY_HAND, error["percentile99.9"], "percentile99.9")
        row = {
            "scene": scene["name"], "setting": point["setting"], "errorTolerance": tolerance,
            "percentile99.9OfTolerance": error["percentile99.9"] / 255 / tolerance,
            "largestOfTolerance": error["largest"] / 255 / tolerance,
            "estimateOfTolerance": point["estimatedError"] / tolerance, "medianMs": point["medianMs"],
            "handTuned": hand, "handTunedMs": hand_ms, "timesHandTuned": hand_ms and point["medianMs"] / hand_ms,
        }
        missed = [name for name, is_missed in (
            ("99.9 %", row["percentile99.9OfTolerance"] > 1), ("largest", row["largestOfTolerance"] > 2),
            ("time", (row["timesHandTuned"] or 0) > SLOWEST_RATIO)) if is_missed]
        rows.append({**row, "missed": " ".join(missed)})
    return rows


TOLERANCES = [
    Column("scene", lambda row: row["scene"]),
    Column("setting", lambda row: row["setting"]),
    Column("99.9th percentile / tolerance", lambda row: row["percentile99.9OfTolerance"], 2),
    Column("largest error / tolerance", lambda row: row["largestOfTolerance"], 2),
    Column("estimate / tolerance", lambda row: row["estimateOfTolerance"], 2),
    Column("ms", lambda row: row["medianMs"], 1),
    Column("fastest by hand", lambda row: row["handTuned"] or "none so precise", 0),
    Column("its ms", lambda row: row["handTunedMs"], 1),
    Column("ratio", lambda row: row["timesHandTuned"], 2),
    Column("missed", lambda row: f"**{row['missed']}**" if row["missed"] else "", 0),
]

TOLERANCES_TEXT = (
    "The promise is at most 1 for 99.9 % of the pixels, and at most 2 for the largest error. By hand: the fastest of "
    "optical, pre-integrated and simpson at the same measured 99.9th percentile; the promise is at most twice its time. "
    "Missed: the promises that are not kept. Times are those of a still view, without the tolerance search of a new "
    "view.")


def near_one_voxel(scene):
    """VTK's setting that is nearest to one sample per voxel."""
    return min(curve_of(scene, "vtk-gpu")["points"], key=lambda point: max(point["voxels"], 1 / point["voxels"]))


def finest(scene):
    return curve_of(scene, "vtk-gpu")["points"][-1]


def gain(setting, method):
    """The speed-up of a method at the error of one of VTK's settings."""

    def value(scene):
        curve, vtk = curve_of(scene, method), setting(scene)
        if not curve:
            return "-"
        milliseconds = milliseconds_at_error(curve, rmse(vtk))
        return vtk["medianMs"] / milliseconds if milliseconds else "never"

    return value


def smallest_error(method):
    return lambda scene: errors_of(curve_of(scene, method))[0] if curve_of(scene, method) else "-"


AT_VTK_ERROR = [
    Column("scene", lambda scene: scene["name"]),
    Column("VTK RMSE at 1 voxel", lambda scene: rmse(near_one_voxel(scene)), 2, "1/255"),
    Column("VTK ms at 1 voxel", lambda scene: near_one_voxel(scene)["medianMs"], 0),
    Column("error tolerances", gain(near_one_voxel, "tolerance"), 1),
    Column("optical field", gain(near_one_voxel, "optical"), 1),
    Column("pre-integrated", gain(near_one_voxel, "pre-integrated"), 1),
    Column("no field", gain(near_one_voxel, "off"), 1),
    Column("cell field E 4/255", gain(near_one_voxel, "cells-4"), 1),
    Column("published method", gain(near_one_voxel, "published"), 1),
    Column("VTK RMSE at its finest", lambda scene: rmse(finest(scene)), 2, "1/255"),
    Column("VTK ms at its finest", lambda scene: finest(scene)["medianMs"], 0),
    Column("finest: error tolerances", gain(finest, "tolerance"), 1),
    Column("finest: optical field", gain(finest, "optical"), 1),
    Column("finest: pre-integrated", gain(finest, "pre-integrated"), 1),
    Column("VTK CPU smallest RMSE", smallest_error("vtk-cpu"), 2, "1/255"),
]


def worst_cell(methods):
    def value(scene):
        worst = worst_against_vtk(scene, methods)
        if not worst:
            return "-"
        times, error = worst
        return f"{times:.2f} at {error:.2f}" if times else f"never {error:.2f}"

    return value


def is_left_of_vtk(scene):
    return (worst_against_vtk(scene, OURS)[0] or 0) > 1


def vtk_errors(scene):
    smallest, largest = errors_of(curve_of(scene, "vtk-gpu"))
    return f"{largest:.2f} to {smallest:.2f}"


LEAST_GAIN = [
    Column("scene", lambda scene: scene["name"]),
    Column("ours is left of and below", lambda scene: "yes" if is_left_of_vtk(scene) else "**no**"),
    Column("VTK RMSE", vtk_errors, 0, "1/255"),
    Column("ours", worst_cell(OURS), 0),
    Column("error tolerances", worst_cell(["tolerance"]), 0),
    Column("optical field", worst_cell(["optical"]), 0),
    Column("pre-integrated", worst_cell(["pre-integrated"]), 0),
    Column("published method", worst_cell(["published"]), 0),
]


def shown(row):
    """The point that the picture of a curve shows."""
    return row[1]["points"][row[1]["shown"]]


def orbit(key):
    return lambda row: row[1].get("orbit", {}).get(key)


# A row is a scene and a curve.
METHODS = [
    Column("scene", lambda row: row[0]["name"]),
    Column("method", lambda row: row[1]["title"]),
    Column("setting", lambda row: shown(row)["setting"]),
    Column("RMSE", lambda row: rmse(shown(row)), 2),
    Column("ms", lambda row: shown(row)["medianMs"], 1),
    Column("fetches per pixel", lambda row: shown(row).get("fetchesPerPixel"), 1),
    Column("MB", lambda row: shown(row)["graphicsBytes"] / 1e6 if "graphicsBytes" in shown(row) else None, 1),
    Column("median change", orbit("medianChange255"), 3),
    Column("largest change", orbit("largestChange255"), 3),
    Column("at", orbit("largestAtDegrees"), 0, "degrees"),
]

# A row is a scene, a curve and a point.
SETTINGS = [
    Column("scene", lambda row: row[0]["name"]),
    Column("method", lambda row: row[1]["method"]),
    Column("renderer", lambda row: row[1]["renderer"]),
    Column("setting", lambda row: row[2]["setting"]),
    Column("error_tolerance", lambda row: row[2].get("errorTolerance"), 5, missing=""),
    Column("voxels", lambda row: row[2]["voxels"], "9g"),
    Column("sample_distance_mm", lambda row: row[2]["sampleDistanceMm"], "9g"),
    Column("rmse_255", lambda row: rmse(row[2]), "9g"),
    Column("percentile_99_9_255", lambda row: row[2]["error255"]["percentile99.9"], "9g"),
    Column("largest_255", lambda row: row[2]["error255"]["largest"], "9g"),
    Column("ssim", lambda row: row[2]["ssim"], "9g"),
    Column("ciede2000_mean", lambda row: row[2]["ciede2000"]["mean"], "9g"),
    Column("ciede2000_99", lambda row: row[2]["ciede2000"]["percentile99"], "9g"),
    Column("fetches_per_pixel", lambda row: row[2].get("fetchesPerPixel"), 5, missing=""),
    Column("graphics_bytes", lambda row: row[2].get("graphicsBytes"), 5, missing=""),
    Column("median_ms", lambda row: row[2]["medianMs"], "9g"),
]


def settings_of(scene):
    return [(scene, curve, point) for curve in scene["methods"] for point in curve["points"]]


def error_plot(scene, suffix, x_title, work):
    """Plots the error over `work` of each point. Points for which it is not known are left out."""
    curves, eight_bits = [], False
    for curve in scene["methods"]:
        points = [(work(point), rmse(point)) for point in curve["points"]
                  if (work(point) or 0) > 0 and 0 < rmse(point) < math.inf]
        if points:
            curves.append(Curve(curve["title"], STYLES[curve["method"]], points))
            eight_bits = eight_bits or curve["eightBits"]
    floor = [("floor of 8 bit images", scene["eightBitRmse255"])] if eight_bits and scene["eightBitRmse255"] > 0 else []
    return Plot(f"{scene['name']}-{suffix}", scene["name"], x_title, "RMSE of premultiplied RGBA [1/255]", curves, floor)


def plots_of(scene):
    return [error_plot(scene, "time", "median time of an image [ms]", lambda point: point["medianMs"]),
            error_plot(scene, "readings", "mean fetches per pixel", lambda point: point.get("fetchesPerPixel"))]


def introduction_of(results):
    machine = results["machine"]
    scenes = results.get("scenes", [])
    return (f"{machine['processor']}, {machine['cores']} cores, OpenGL renderer "
            f"\"{scenes[0]['openglRenderer'] if scenes else ''}\", VTK {machine['vtkVersion']}, {machine['date']}"
            f"{load_text(machine)}")


def work_precision(results):
    scenes = results.get("scenes", [])
    with_vtk = [scene for scene in scenes if curve_of(scene, "vtk-gpu")]
    judged = [scene for scene in with_vtk if worst_against_vtk(scene, OURS)]
    tolerances = [row for scene in scenes for row in tolerance_rows(scene)]
    skipped = "".join(f"\n{scene['name']}: {curve['title']} was not run at {curve['skipped']}.\n"
                      for scene in scenes for curve in scene["methods"] if curve["skipped"])
    plots = [plot for scene in scenes for plot in plots_of(scene)]
    links = "\nPlots: " + ", ".join(f"[{plot.stem}]({plot.stem}.svg)" for plot in plots if plot.curves) + ".\n"
    introduction = (
        f"{introduction_of(results)}. Made by\n\n    {results['command']}\n\nErrors are the RMSE of float images in 1/255 "
        "of premultiplied RGBA without background, against an adaptive integral of each ray in double precision. Times "
        "are medians of alternating rounds: compare the ratios.\n")
    return Report("Work and precision", introduction, [
        Table("at-vtk-error", AT_VTK_ERROR, with_vtk, "\n## Speed at VTK's error\n\nSpeed-up over VTK's GPU mapper at equal "
              "RMSE, interpolated along straight lines between settings in the plot; *never*: no setting has so small an "
              "error. Optical field: midpoints; pre-integrated: linear between samples; no field and fields at the sample "
              "distances that give this error. VTK CPU: the smallest RMSE of the fixed-point mapper.\n\n"),
        Table("least-gain", LEAST_GAIN, judged, "\n## Left of and below VTK's curve?\n\nThe smallest speed-up at any RMSE "
              "from VTK's largest to its smallest, and the RMSE at which it occurs; *yes*: above 1 everywhere. Ours: the "
              "best of error tolerances, optical field and pre-integrated at each error.\n\n",
              f"\nYes on {sum(map(is_left_of_vtk, judged))} of {len(judged)} scenes.\n"),
        Table("tolerances", TOLERANCES, tolerances, f"\n## Error tolerances\n\n{TOLERANCES_TEXT}\n\n",
              f"\nNothing missed in {sum(not row['missed'] for row in tolerances)} of {len(tolerances)} rows.\n"),
        Table("methods", METHODS, ((scene, curve) for scene in scenes for curve in scene["methods"]),
              "\n## All methods near one sample per voxel\n\nChange: RMSE of the change of the error between neighbouring "
              "frames of an orbit of 90 degrees, against our mapper at eight samples per voxel; a largest change far "
              "above the median is a pop. MB: textures of the method, in 10^6 bytes.\n\n"),
        Table("work-precision", SETTINGS, (row for scene in scenes for row in settings_of(scene)), only_csv=True),
    ], skipped + links, plots)


STYLE = """
body { font: 16px/1.5 sans-serif; color: #222; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px; }
th, td { padding: 2px 10px; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child { text-align: left; }
.pictures { display: flex; flex-wrap: wrap; gap: 12px; }
figure { margin: 0; width: 256px; }
figcaption { font-size: 13px; }
img { max-width: 100%; }
code { background: #f2f2f2; padding: 1px 4px; overflow-wrap: anywhere; }
"""


def embedded(folders, name, words):
    """An image in the text of the page, from the first folder that has it; nothing if none has."""
    path = next((folder / name for folder in folders if (folder / name).exists()), None)
    if not path:
        return ""
    kind = {".png": "image/png", ".svg": "image/svg+xml"}[path.suffix]
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img src="data:{kind};base64,{data}" alt="{html.escape(words)}">'


def figure(folders, name, words):
    return f"<figure>{embedded(folders, name, words)}<figcaption>{html.escape(words)}</figcaption></figure>\n"


def pictures_of(scene, folders):
    text = figure(folders, f"{scene['name']}-truth.png", "the truth")
    for curve in scene["methods"]:
        point, stem = shown((scene, curve)), f"{scene['name']}-{curve['method']}"
        text += figure(folders, f"{stem}.png", f"{curve['title']}, {point['setting']}, every "
                       f"{point['sampleDistanceMm']:.3f} mm: {point['medianMs']:.1f} ms")
        text += figure(folders, f"{stem}-difference.png", f"its difference from the truth: RMSE {rmse(point):.2f}, largest "
                       f"{point['error255']['largest']:.1f} of 255")
    scale = embedded(folders, "difference-scale.png", "scale of the differences")
    return ("<h3>Images, with about one sample per voxel if possible</h3>\n"
            f'<div class="pictures">\n{text}</div>\n<p>{scale}</p>\n')


def section_of(scene, folders):
    size = " x ".join(map(str, scene["volume"]["dimensions"]))
    facts = (f"{size} voxels of type {scene['volume']['type']}; image of {scene['size'][0]} x {scene['size'][1]} pixels; "
             f"look \"{scene['look']}\", {'shaded' if scene['shaded'] else 'not shaded'}. Truth: "
             f"{scene['reference']['text']}.")
    text = f"<h2>{html.escape(scene['name'])}</h2>\n<p>{html.escape(facts)}</p>\n"
    for plot in plots_of(scene):
        text += f"<p>{embedded(folders, f'{plot.stem}.svg', 'error over work of all methods')}</p>\n"
    equal, tolerances = Table("", EQUAL_ERROR, equal_error_rows(scene)), Table("", TOLERANCES, tolerance_rows(scene))
    if equal.rows:
        text += "<h3>Our optical field at the error of VTK's GPU mapper</h3>\n" + equal.html()
    if tolerances.rows:
        text += ("<h3>How our defaults keep an error tolerance</h3>\n" + tolerances.html().replace("**", "")
                 + f"<p>{html.escape(TOLERANCES_TEXT)}</p>\n")
    text += pictures_of(scene, folders) + "<h3>All settings</h3>\n" + Table("", SETTINGS[1:], settings_of(scene)).html()
    return text + "".join(f"<p>{html.escape(curve['title'])} was not run at {html.escape(curve['skipped'])}.</p>\n"
                          for curve in scene["methods"] if curve["skipped"])


def work_precision_html(results, folders):
    """A page with all images in it, which lie in these folders: images of the benchmark, and plots."""
    sections = "".join(section_of(scene, folders) for scene in results.get("scenes", []))
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Work and precision</title>'
        f"<style>{STYLE}</style></head><body>\n<h1>Work and precision</h1>\n<p>{html.escape(introduction_of(results))}.</p>\n"
        f"<p>Made by <code>{html.escape(results['command'])}</code></p>\n<p>Errors are those of float images in "
        "premultiplied RGBA without background; SSIM and CIEDE2000 are those of the image on its background. A time is the "
        "median of rounds that go through all methods and settings in turn; compare ratios, not milliseconds. Lower and "
        f"further left is better.</p>\n{sections}</body></html>\n")
