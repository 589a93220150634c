"""Reports of benchmarks of error: orders of convergence, extreme scenes, published scenes, the promise."""

from columns import Column, Curve, Plot, Report, Table, machine_text

# Colours of M. Okabe, K. Ito, "Color universal design", 2008; marker and line of matplotlib.
ORDER_STYLES = {
    "Varimarch, midpoint": ("#0072b2", "o", "-"), "Varimarch, midpoint, packets": ("#56b4e9", "x", "--"),
    "Varimarch, pre-integrated": ("#cc79a7", "s", "-"), "Varimarch, Simpson": ("#009e73", "D", "-"),
    "published sum": ("#e69f00", "+", "--"), "VTK GPU mapper": ("#d55e00", "s", "--"),
    "VTK fixed-point mapper": ("#000000", "D", "--"), "Varimarch": ("#0072b2", "o", "-"),
    "Varimarch, by shaders": ("#cc79a7", "s", "-"), "Varimarch, linear": ("#0072b2", "o", "-"),
    "Varimarch, cubic spline": ("#009e73", "D", "-"),
}


def fitted_order(curve):
    return f"{curve['order']:.2f} ± {curve['orderHalfWidth95']:.2f}" if "order" in curve else None


ORDER = [
    Column("method", lambda row: row["method"]),
    Column("expected", lambda row: row.get("expectedOrder"), 0),
    Column("observed order", fitted_order, 0),
    Column("fitted to", lambda row: f"{row.get('fittedPoints', 0)} of {len(row['points'])}", 0),
    Column("error, coarsest", lambda row: row["points"][0]["rmse255"], 3),
    Column("error, finest", lambda row: row["points"][-1]["rmse255"], 4),
]

# A row is an experiment, a method and a point.
ORDER_CSV = [
    Column("experiment", lambda row: row[0]["name"]),
    Column("method", lambda row: row[1]["method"], quoted=True),
    Column("width", lambda row: row[2]["width"], "6g"),
    Column("rmse_255", lambda row: row[2]["rmse255"], "6g"),
    Column("largest_255", lambda row: row[2]["largest255"], "6g"),
]


def order_heading(experiment):
    fitted = (f"Fitted from {experiment['width']} {experiment['widestFitted']:.0f} on.\n\n"
              if "widestFitted" in experiment else "")
    return (f"\n## {experiment['title']}\n\n![Error over {experiment['width']}]({experiment['name']}.svg)\n\n{fitted}")


def order_plot(experiment):
    curves = []
    for curve in experiment["methods"]:
        points = [(point["width"], point["rmse255"]) for point in curve["points"] if point["rmse255"] > 0]
        if points:
            curves.append(Curve(f"{curve['method']}, order {fitted_order(curve) or '-'}",
                                ORDER_STYLES[curve["method"]], points))
    return Plot(experiment["name"], experiment["title"], experiment["width"], "RMSE [1/255]", curves)


def order(results):
    experiments = results["experiments"]
    machine = results["machine"]
    introduction = (
        f"{machine['processor']}, VTK {machine['vtkVersion']}, {machine['date']}, images of {results['side']} x "
        f"{results['side']} pixels. Made by `{results['command']}`.\n\nErrors are RMSE in 1/255. Orders are slopes fitted "
        f"to all errors above {results['floor']:.4f}, with their 95 % confidence.\n")
    rows = ((experiment, curve, point) for experiment in experiments for curve in experiment["methods"]
            for point in curve["points"])
    tables = [Table(experiment["name"], ORDER, experiment["methods"], order_heading(experiment))
              for experiment in experiments]
    return Report("Observed orders of convergence", introduction, [*tables, Table("order", ORDER_CSV, rows, only_csv=True)],
                  plots=list(map(order_plot, experiments)))


DEFAULT_TOLERANCE_255 = 255 / 64


def extreme_error(result):
    """The RMSE and the error that 99.9 % of the pixels keep, or a word that says more."""
    if not result["tried"]:
        text = "not tried"
    elif not result["finite"]:
        text = "**not finite**"
    elif result["empty"]:
        text = "**empty**"
    else:
        text = f"{result['error255']['rmse']:.2f} / {result['error255']['percentile99.9']:.2f}"
    return text + (" \\*" if result["message"] else "")


def is_kept(result):
    return result["tried"] and result["finite"] and result["error255"]["percentile99.9"] <= DEFAULT_TOLERANCE_255


def count(condition):
    return lambda row: sum(bool(condition(result)) for result in row[1])


# A row is a mapper and its results in all scenes.
EXTREMES_SUMMARY = [
    Column("mapper", lambda row: row[0]),
    Column("scenes", count(lambda result: result["tried"]), 0),
    Column("within 4 of 255", count(is_kept), 0),
    Column("further off", count(lambda result: result["tried"] and not is_kept(result)), 0),
    Column("of these with a message", count(
        lambda result: result["tried"] and not is_kept(result) and result["message"]), 0),
    Column("empty", count(lambda result: result["tried"] and result["empty"]), 0),
    Column("not finite", count(lambda result: result["tried"] and not result["finite"]), 0),
]

MAPPERS = ["ours", "ours-shader", "vtk-gpu", "vtk-cpu"]
EXTREMES = [
    Column("scene", lambda row: row["name"]),
    *(Column(mapper, lambda row, i=i: extreme_error(row["results"][i]), 0) for i, mapper in enumerate(MAPPERS)),
    *(Column(mapper, lambda row, i=i: row["results"][i]["medianMs"] if row["results"][i]["tried"] else None, 1, "ms")
      for i, mapper in enumerate(MAPPERS)),
]

# A row is a scene and a result.
EXTREMES_CSV = [
    Column("group", lambda row: row[0]["group"]),
    Column("scene", lambda row: row[0]["name"]),
    Column("mapper", lambda row: row[1]["mapper"]),
    Column("tried", lambda row: "yes" if row[1]["tried"] else "no"),
    Column("rmse_255", lambda row: row[1]["error255"]["rmse"], "6g", missing="nan"),
    Column("percentile_99_9_255", lambda row: row[1]["error255"]["percentile99.9"], "6g", missing="nan"),
    Column("largest_255", lambda row: row[1]["error255"]["largest"], "6g", missing="nan"),
    Column("finite", lambda row: "yes" if row[1]["finite"] else "no"),
    Column("empty", lambda row: "yes" if row[1]["empty"] else "no"),
    Column("median_ms", lambda row: row[1]["medianMs"], "6g"),
    Column("message", lambda row: row[1]["message"], quoted=True),
]


def extremes(results):
    scenes = results.get("scenes", [])
    side = results.get("side")
    introduction = f"{machine_text(results)}. Made by `{results['command']}`.\n\n"
    below = (f"\nBelow: the RMSE / the error that 99.9 % of the pixels keep [1/255], of images of {side} x {side} pixels, "
             "and the time of a frame. \\*: with a warning or an error. All mappers have their\ndefaults, except that "
             "VTK's fixed-point mapper samples as finely as its GPU mapper does.\n")
    groups = dict.fromkeys([*(scene["group"] for scene in scenes),
                            *(key for key in results.get("tables", {}) if key != "summary")])
    return Report("Extreme scenes", introduction, [
        Table("summary", EXTREMES_SUMMARY, ((mapper, [scene["results"][i] for scene in scenes])
                                            for i, mapper in enumerate(MAPPERS) if scenes), after=below),
        *(Table(group, EXTREMES, (scene for scene in scenes if scene["group"] == group), f"\n## {group}\n\n")
          for group in groups),
        Table("extremes", EXTREMES_CSV, ((scene, result) for scene in scenes for result in scene["results"]),
              only_csv=True),
    ])


# Counts of the pictures of a kind, or of all; a row is a name and the pictures.
PROMISE = [
    Column("kind", lambda row: row[0]),
    Column("pictures", lambda row: len(row[1]), 0),
    Column("kept", lambda row: sum(picture["answer"] == "kept" for picture in row[1]), 0),
    Column("silent misses", lambda row: sum(map(is_silent_miss, row[1])), 0),
    Column("false alarms", lambda row: sum(map(is_false_alarm, row[1])), 0),
    Column("unsettled", lambda row: sum(picture["answer"] == "unsettled" for picture in row[1]), 0),
    Column("messages", lambda row: sum(bool(picture["message"]) for picture in row[1]), 0),
    Column("worst factor", lambda row: worst_factor(row[1]), 2, missing="inf"),
    Column("drawing", lambda row: sum(picture["drawSeconds"] for picture in row[1]), 1, "s"),
    Column("judging", lambda row: sum(picture["judgeSeconds"] for picture in row[1]), 1, "s"),
]


def is_silent_miss(picture):
    return picture["saysKept"] and picture["answer"] == "beyond"


def is_false_alarm(picture):
    return not picture["saysKept"] and picture["answer"] == "kept"


def worst_factor(pictures):
    """The largest factor where the mapper says that it kept the tolerance; None if one is infinite."""
    factors = [picture["factor"] for picture in pictures if picture["saysKept"]]
    return None if None in factors else max(factors, default=0.0)


def times_tolerance(factor):
    return "inf" if factor is None else f"{factor:.2f}"


def promise_line(picture):
    x, y = picture["worst"]
    message = "; " + picture["message"] if picture["message"] else ""
    return (f"- {picture['kind']}, picture {picture['picture']} of seed {picture['seed']}: {picture['answer']}, 99.9 % off "
            f"by up to {times_tolerance(picture['factor'])} x, largest {times_tolerance(picture['largest'])} x at pixel "
            f"{x}, {y}, {picture['beyond']} of {picture['pixels']} pixels beyond for certain, {picture['doubtful']} "
            f"doubtful; tolerance {picture['errorTolerance']:g}, estimated {picture['estimatedError']:g}, kept "
            f"{int(picture['saysKept'])}: `{picture['alone']}`{message}\n")


def promise(results):
    pictures = results["pictures"]
    rows = [(kind["name"], [picture for picture in pictures if picture["kind"] == kind["name"]])
            for kind in results["kinds"]]
    lit = {kind["name"] for kind in results["kinds"] if kind["isLit"]}
    rows = [row for row in rows if row[1]]
    rows += [("with light", [picture for picture in pictures if picture["kind"] in lit]), ("all", pictures)]
    text = ""
    for title, condition in (
            ("Silent misses:", is_silent_miss), ("False alarms:", is_false_alarm),
            ("Unsettled:", lambda picture: picture["answer"] == "unsettled"),
            ("Beyond the tolerance, and said so:",
             lambda picture: not picture["saysKept"] and picture["answer"] == "beyond")):
        lines = [promise_line(picture) for picture in pictures if condition(picture)]
        text += f"\n{title}\n\n" + "".join(lines) if lines else ""
    return Report("The promise, judged", f"`{results['command']}`\n\n", [Table("kinds", PROMISE, rows)], text)
