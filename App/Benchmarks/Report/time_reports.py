"""Reports of benchmarks of time: speed, scaling, features, shaders, soak and times."""

from columns import Column, Curve, Plot, Report, Table, geometric_mean, load_text, machine_text

# Colours of M. Okabe, K. Ito, "Color universal design", 2008; marker and line of matplotlib.
SPEED_STYLES = [("#d55e00", "s", "-"), ("#000000", "D", "--"), ("#56b4e9", "o", "-"), ("#56b4e9", "o", ":"),
                ("#e69f00", "D", "-"), ("#e69f00", "D", ":")]


def yes(value):
    return "yes" if value else "no"


def is_ours(renderer):
    return renderer.startswith("ours")


def mebibytes(number):
    return None if number is None else number / 2**20


def tolerance_text(point):
    return f"1/{1 / point['errorTolerance']:.0f}" if is_ours(point["renderer"]) and "errorTolerance" in point else None


def cost_columns(point_of, renderer_of):
    """Columns of the times of frames, of a row from which these functions take point and renderer."""

    def ours(time):
        return lambda row: point_of(row)["median"][time] if is_ours(renderer_of(row)) else None

    return [
        Column("still frame", lambda row: point_of(row)["median"]["stillMs"], 1, "ms"),
        Column("first frame", lambda row: point_of(row)["median"]["firstMs"], 1, "ms"),
        Column("rebuild", lambda row: point_of(row)["median"]["rebuildMs"], 1, "ms"),
        Column("field", ours("firstFieldMs"), 2, "ms"),
        Column("field again", ours("changeFieldMs"), 2, "ms"),
        Column("graphics memory", lambda row: mebibytes(point_of(row).get("graphicsBytes")), 1, "MiB"),
        Column("samples per pixel", lambda row: point_of(row).get("fetchesPerPixel"), 1),
    ]


def comparison(case, target):
    """The comparison of a case with a target's rival; None if no tolerance kept its error."""
    return next((kept for kept in case.get("keeping", []) if kept["target"] == target), None)


def rival(case, target):
    return next((point for point in case["points"] if point["method"] == target["rival"]), None)


def speed_summaries(results):
    """The result of each target over all scenes of one size, shaded or not."""
    cases = results.get("cases", [])
    summaries = []
    for index, target in enumerate(results["targets"]):
        for shaded, side in sorted({(case["shaded"], case["side"]) for case in cases}):
            judged = [case for case in cases if (case["shaded"], case["side"]) == (shaded, side)
                      and rival(case, target)]
            kept = sorted((comparison(case, index)["timesAsFast"], case["scene"])
                          for case in judged if comparison(case, index))
            failing = [case["scene"] for case in judged if not comparison(case, index)]
            mean = geometric_mean([times for times, _ in kept])
            met = (not failing and mean >= target["timesWanted"] and kept[0][0] >= target["timesAtLeast"])
            if judged:
                summaries.append({"target": index, **target, "shaded": shaded, "side": side, "scenes": len(judged),
                                  "mean": mean, "kept": kept, "failing": failing, "met": met})
    return summaries


def verdict(summary):
    if not summary["failing"]:
        return "met" if summary["met"] else "**missed**"
    return "**missed**; no tolerance keeps the error on " + ", ".join(summary["failing"])


TARGETS = [
    Column("against", lambda row: row["against"]),
    Column("shaded", lambda row: yes(row["shaded"])),
    Column("image side", lambda row: row["side"], 0, "pixels"),
    Column("scenes", lambda row: row["scenes"], 0),
    Column("times as fast, mean", lambda row: row["mean"], 2),
    Column("target mean", lambda row: row["timesWanted"], 0),
    Column("least", lambda row: row["kept"][0][0] if row["kept"] else None, 2),
    Column("target least", lambda row: row["timesAtLeast"] or None, 0),
    Column("least on", lambda row: row["kept"][0][1] if row["kept"] else ""),
    Column("verdict", verdict),
]

CASE = [
    Column("scene", lambda row: row[0]["scene"]),
    Column("shaded", lambda row: yes(row[0]["shaded"])),
    Column("size", lambda row: row[0]["side"], 0),
]

# A row is a case, its rival, the target, and our point that keeps the error with its factor, or None.
KEEPING = CASE + [
    Column("rival", lambda row: row[1]["method"]),
    Column("rival", lambda row: row[1]["median"]["stillMs"], 1, "ms"),
    Column("rival RMSE", lambda row: row[1]["error255"]["rmse"], 2),
    Column("ours", lambda row: row[2]["ours"]),
    Column("our tolerance", lambda row: tolerance_text(row[3]) if row[3] else "none", 0),
    Column("ours", lambda row: row[3] and row[3]["median"]["stillMs"], 1, "ms"),
    Column("our RMSE", lambda row: row[3] and row[3]["error255"]["rmse"], 2),
    Column("times as fast", lambda row: row[4], 2),
]

# A row is a case and a point.
SETTINGS = CASE + [
    Column("method", lambda row: row[1]["method"]),
    Column("tolerance", lambda row: tolerance_text(row[1]), 0),
    Column("RMSE", lambda row: row[1]["error255"]["rmse"], 2),
    Column("99.9 %", lambda row: row[1]["error255"]["percentile99.9"], 1),
    *cost_columns(lambda row: row[1], lambda row: row[1]["renderer"]),
    Column("rounds", lambda row: len(row[1]["rounds"]), 0),
]


def factor(target):
    return lambda case: (comparison(case, target) or {}).get("timesAsFast")


def kept_point(case):
    """Our point that keeps the error of VTK's GPU mapper."""
    kept = comparison(case, 0)
    return case["points"][kept["point"]] if kept else None


def vtk_gpu(case):
    return next(point for point in case["points"] if point["method"] == "vtk-gpu")


SCENE = Column("scene", lambda case: case["scene"])
FACTORS = [
    Column("times as fast as VTK GPU mapper", factor(0), 2),
    Column("as VTK CPU mapper at 5 times our RMSE", factor(1), 2),
    Column("as no field", factor(2), 2),
    Column("as no field, both by shaders", factor(3), 2),
]
VTK_MS = Column("VTK GPU mapper", lambda case: vtk_gpu(case)["median"]["stillMs"], 1, "ms")
OUR_MS = Column("ours", lambda case: kept_point(case) and kept_point(case)["median"]["stillMs"], 1, "ms")
SCENES = [
    SCENE, VTK_MS,
    Column("VTK GPU mapper RMSE", lambda case: vtk_gpu(case)["error255"]["rmse"], 2, "1/255"),
    Column("our error tolerance", lambda case: kept_point(case) and tolerance_text(kept_point(case)), 0),
    OUR_MS,
    Column("our RMSE", lambda case: kept_point(case) and kept_point(case)["error255"]["rmse"], 2, "1/255"),
    *FACTORS,
]


def of_part(column, part, prefix):
    """The column of a row of several cases."""
    return column._replace(name=prefix + column.name, value=lambda row: column.value(row[part]))


SCENES_BOTH = [of_part(SCENE, 0, "")] + [
    of_part(column, part, prefix) for part, prefix in ((0, ""), (1, "shaded: "))
    for column in (VTK_MS, OUR_MS, *FACTORS)]


def speed_by_scene(results):
    """For each size a table of all scenes not shaded, one shaded, and one of both."""
    cases = results.get("cases", [])
    tables = []
    for side in sorted({case["side"] for case in cases}) or [256, 512, 1024]:
        plain, shaded = ([case for case in cases if case["side"] == side and case["shaded"] == wanted]
                         for wanted in (False, True))
        both = zip(plain, shaded) if len(plain) == len(shaded) else []
        tables += [Table(f"{side}", SCENES, plain, only_csv=True),
                   Table(f"{side}-shaded", SCENES, shaded, only_csv=True),
                   Table(f"{side}-both", SCENES_BOTH, both, only_csv=True)]
    return tables


def speed_plot(results):
    curves = []
    for index, target in enumerate(results["targets"]):
        times = sorted(factor(index)(case) for case in results.get("cases", []) if factor(index)(case))
        if times:
            curves.append(Curve(f"{target['ours']} against {target['rival']}", SPEED_STYLES[index],
                                list(enumerate(times, 1))))
    return Plot("speed", "Times as fast at the same error", "rank of scene and size, slowest first",
                "times as fast as the rival", curves, [("equal", 1.0)])


def speed(results):
    results = {"targets": [], "missing": [], **results}
    cases = results.get("cases", [])
    keeping = []
    for case in cases:
        for index, target in enumerate(results["targets"]):
            kept = comparison(case, index)
            if rival(case, target):
                keeping.append((case, rival(case, target), target, kept and case["points"][kept["point"]],
                                kept and kept["timesAsFast"]))
    machine = results["machine"]
    introduction = (
        f"{machine['processor']}, {machine['cores']} cores, OpenGL renderer "
        f"\"{cases[0]['openglRenderer'] if cases else ''}\", VTK {machine['vtkVersion']}, {machine['date']}"
        f"{load_text(machine)}. Medians of up to {results.get('rounds')} rounds;\n"
        f"an image that takes more than {results.get('longestSeconds', 0):.1f} s is drawn in only one. Made by "
        f"`{results['command']}`.\n")
    if results["missing"]:
        introduction += "Not in the folder: " + ", ".join(results["missing"]) + ".\n"
    return Report("Speed", introduction, [
        Table("targets", TARGETS, speed_summaries(results), "\n## Targets\n"
              "Our speed-up over another method, at the largest error tolerance at which our RMSE meets the\n"
              "target. VTK's mappers and the published method, with E = 4/255, take one sample\n"
              "per voxel; our march without a field keeps a tolerance of 1/64. Means are geometric.\n\n"),
        Table("keeping", KEEPING, keeping, "\n## Scene by scene\n"
              "Times are medians of still images: of five, or as many as take 50 ms. *Times as fast* is the\n"
              "median of the rounds, in each of which both were drawn one right after the other. RMSE in\n"
              "1/255 of premultiplied RGBA, against an adaptive integral in double precision. *Our tolerance*\n"
              "is an error in [0, 1].\n\n"),
        Table("settings", SETTINGS, ((case, point) for case in cases for point in case["points"]),
              "\n## Every setting\n"
              "*First frame*: first image of a new window and mapper, with the volume in memory. *Rebuild*: extra\n"
              "time of the image after a change of transfer function, compared with the next one; it includes the\n"
              "tolerance search. *Field*: time to build the field for the first image; *field again*: time to\n"
              "rebuild it after the change. *Graphics memory* is that of the mapper. *Samples* are fetches from\n"
              "the volume by a shader, mean of all pixels. VTK's mappers do not report the last four.\n\n"),
        *speed_by_scene(results),
    ], plots=[speed_plot(results)])


SCALING_TIMES = [
    ("ours, still", True, "stillMs", ("#0072b2", "o")), ("ours, first", True, "firstMs", ("#56b4e9", "D")),
    ("ours, field", True, "firstFieldMs", ("#009e73", "x")), ("VTK GPU, still", False, "stillMs", ("#d55e00", "s")),
    ("VTK GPU, first", False, "firstMs", ("#e69f00", "+")),
]

# A row is a curve and a point.
SCALING = [
    Column("volume", lambda row: row[0]["volume"]),
    Column("renderer", lambda row: row[0]["renderer"]),
    Column("side", lambda row: row[1]["side"], 0, "voxels"),
    *cost_columns(lambda row: row[1], lambda row: row[0]["renderer"]),
]


def scaling_plot(curves):
    lines = []
    for curve in curves:
        line = "-" if curve["volume"] == curves[0]["volume"] else "--"
        for title, ours, time, style in SCALING_TIMES:
            points = [(point["side"], point["median"][time]) for point in curve.get("points", [])
                      if point["median"][time] > 0 and ours == is_ours(curve["renderer"])]
            if points:
                lines.append(Curve(f"{curve['volume']}: {title}", (*style, line), points))
    return Plot("scaling", "Time over the size of the volume", "side of the volume [voxels]", "median time [ms]", lines)


def scaling(results):
    curves = results.get("curves", [])
    width, height = results.get("size", (0, 0))
    introduction = (
        f"{machine_text(results)}, images of {width} x {height}, medians of {results.get('rounds')} alternating "
        f"rounds. Made by `{results['command']}`.\n\nOurs uses its error tolerance, VTK's GPU mapper its own choice of "
        "samples; errors are not measured.\n\n")
    stopped = [f"\n{curve['volume']}, {curve['renderer']}: no larger volume ({curve['stopped']})\n"
               for curve in curves if curve["stopped"]]
    rows = ((curve, point) for curve in curves for point in curve.get("points", []))
    return Report("Time over the size of the volume", introduction, [Table("volume-size", SCALING, rows)],
                  "".join(stopped), [scaling_plot(curves)])


def feature_time(who, time):
    return lambda row: None if row["failure"] or (who == "vtk" and not row["isVtks"]) else row[who][time]


def feature_ratio(over, under, unless=()):
    """A ratio of two of feature_time, unless one of these keys is true."""

    def ratio(row):
        times = feature_time(*over)(row), feature_time(*under)(row)
        return None if None in times or any(row[key] for key in unless) else times[0] / times[1]

    return ratio


FEATURES = [
    Column("feature", lambda row: row["name"]),
    Column("over", lambda row: row["over"]),
    Column("ours without", feature_time("ours", "beforeMs"), 1, "ms"),
    Column("ours with", feature_time("ours", "onMs"), 1, "ms"),
    Column("our cost", feature_ratio(("ours", "onMs"), ("ours", "beforeMs")), 2),
    Column("off again", feature_ratio(("ours", "afterMs"), ("ours", "beforeMs")), 2),
    Column("VTK with", feature_time("vtk", "onMs"), 1, "ms"),
    Column("VTK cost", feature_ratio(("vtk", "onMs"), ("vtk", "beforeMs")), 2),
    Column("VTK / ours", feature_ratio(("vtk", "onMs"), ("ours", "onMs"), ["vtkShowsNothing"]), 2),
]


def feature_notes(features):
    """Footnotes about features that our mapper or VTK's does not draw."""
    notes = []
    for row in features:
        if row["failure"]:
            notes.append(f"{row['name']} failed: {row['failure']}")
        elif row["drawnByVtk"]:
            notes.append(f"{row['name']} is left to VTK's mapper by the plugin: {row['drawnByVtk']}")
        if not row["isVtks"]:
            notes.append(f"{row['name']}: VTK's mapper does not have this feature")
        elif row["vtkShowsNothing"]:
            notes.append(f"{row['name']}: VTK's mapper shows nothing")
    return "".join(f"- {note}\n" for note in notes)


def features(results):
    rows = results.get("features", [])
    width, height = results.get("size", (0, 0))
    introduction = (
        f"{results.get('volume')}, {machine_text(results)}, images of {width} x {height} of a moving camera, medians of "
        f"{results.get('rounds')} alternating rounds. Made by `{results['command']}`.\n\nOurs is the plugin's mapper at "
        "its error tolerance; VTK's takes one sample per voxel. With: time with the feature. Cost: ratio of the times "
        "with and without it. Off again: ratio of the times after the feature is switched off and before it was "
        "switched on.\n\n")
    notes = feature_notes(rows)
    return Report("What features cost", introduction, [Table("costs", FEATURES, rows)], notes and "\n" + notes)


def shader_columns(light):
    """The cost of a shader with light or without."""

    def number(key):
        return lambda row: row.get(light, {}).get(key)

    return [
        Column(f"{light}: instructions", number("instructions"), 0),
        Column("fetches", number("fetches"), 0),
        Column("inputs", number("inputs"), 0),
        Column("textures", number("textures"), 0),
        Column("binary", number("binaryBytes"), 0),
    ]


def lit_over_plain(row):
    lit, plain = (row.get(light, {}).get("instructions") for light in ("lit", "plain"))
    return lit / plain if lit and plain else None


SHADERS = [Column("recipe", lambda row: row["recipe"]), *shader_columns("plain"), *shader_columns("lit"),
           Column("lit / plain", lit_over_plain, 2)]


def shaders(results):
    introduction = (
        f"OpenGL renderer \"{results['openglRenderer']}\", {results['machine']['date']}. Made by\n\n    "
        f"{results['command']}\n\nWhat the driver says of the program that marches rays, without light and with it: "
        "instructions of the fragment shader as Mesa hands it to the driver, without constants and addresses; those of "
        "them that read a texture; vectors of four numbers that the vertex shader hands on; textures; and the length of "
        "the program's binary [bytes], 0 if the driver has none. \"-\": not known.\n\n")
    return Report("Cost of each shader", introduction, [Table("shaders", SHADERS, results.get("shaders", []))])


SOAK = [
    Column("frames", lambda row: row["frames"], 0),
    Column("median time of a frame", lambda row: row["medianMs"], 1, "ms"),
    Column("memory", lambda row: row["residentMegabytes"], 0, "MB"),
    Column("open files", lambda row: row["openFiles"], 0),
    Column("threads", lambda row: row["threads"], 0),
]


def soak(results):
    parts = results["parts"]
    machine = results["machine"]
    after = ""
    if len(parts) == 10:
        ratio = parts[-1]["medianMs"] / parts[0]["medianMs"]
        after = f"\nThe last tenth takes {ratio:.2f} times as long as the first.\n"
    return Report("A long run", f"`{results['command']}`, {machine['processor']}, {machine['date']}.\n\n",
                  [Table("parts", SOAK, parts)], after)


# A row is a name and a number.
TIMES = [Column("", lambda row: row[0]), Column("", lambda row: row[1], 1)]


def times(results):
    def per_second(milliseconds):
        return f"{1000 / milliseconds:.1f}" if milliseconds > 0 else "-"

    rows = [
        (f"frames, each of another of {results['times']} times", str(results["frames"])),
        ("frames a second, each time drawn first", per_second(results["newMs"])),
        ("median time of such a frame [ms]", results["newMs"]),
        ("frames a second, each time drawn again", per_second(results["againMs"])),
        ("median time of such a frame [ms]", results["againMs"]),
        ("of it for the field [ms]", results["fieldMs"]),
        ("median time of a frame of the same voxels [ms]", results["stillMs"]),
        ("median time of a frame while somebody plays, 15 a second wanted [ms]", results["movingMs"]),
        ("median distance between its rays [pixels]", f"{results['movingRaysApart']:.2f}"),
        ("memory when each time was drawn once [MB]", f"{results['residentMegabytesAtFirst']:.0f}"),
        ("memory at the end [MB]", f"{results['residentMegabytesAtEnd']:.0f}"),
    ]
    return Report("Times played", f"`{results['command']}`, {machine_text(results)}.\n\n",
                  [Table("times", TIMES, rows)])
