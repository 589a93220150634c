"""Reports of benchmarks of light: the cost of each feature, methods of others, shadows beside a volume."""

import statistics

from columns import Column, Report, Table, geometric_mean, machine_text

MOTIONS = ["still", "turning", "dragged"]


def conditions(results, rounds):
    side = results.get("side")
    tolerance = 255 * results.get("errorTolerance", 0)
    return (f"{machine_text(results)}. Images of {side} x {side}, error tolerance {tolerance:.2f} of 255, {rounds}. "
            f"Made by\n\n    {results['command']}\n\n")


def motion_columns(index, motion):
    return [
        Column(motion, lambda row: row["withoutMs"][index], 1),
        Column("with", lambda row: row["withMs"][index], 1),
        Column("factor", lambda row: row["factor"][index], 2),
    ]


SCENE = Column("scene", lambda row: row["scene"])

COST = [
    SCENE,
    *(column for index, motion in enumerate(MOTIONS) for column in motion_columns(index, motion)),
    Column("first", lambda row: row["firstMs"], 0),
    Column("RMSE", lambda row: row["error"]["rmse"], 2),
    Column("99.9 %", lambda row: row["error"]["percentile99.9"], 2),
    Column("largest", lambda row: row["error"]["largest"], 1),
]


def parts_of_tolerance(promises, error):
    return [promise["error"][error] / (255 * promise["errorTolerance"]) for promise in promises]


def kept(promises, error, limit):
    parts = parts_of_tolerance(promises, error)
    return f"{sum(part <= limit for part in parts)} of {len(parts)}"


# A row is a tolerance and the errors of all views of all scenes with it.
TOLERANCES = [
    Column("tolerance", lambda row: f"1/{1 / row[0]:.0f}"),
    Column("99.9 % kept", lambda row: kept(row[1], "percentile99.9", 1), 0),
    Column("worst", lambda row: max(parts_of_tolerance(row[1], "percentile99.9")), 2),
    Column("largest within twice", lambda row: kept(row[1], "largest", 2), 0),
    Column("worst", lambda row: max(parts_of_tolerance(row[1], "largest")), 1),
]


def worst_view_column(tolerance):
    return Column(f"1/{1 / tolerance:.0f}: {255 * tolerance:.2f}", lambda row: max(
        promise["error"]["percentile99.9"] for promise in row["promises"] if promise["errorTolerance"] == tolerance), 2)


def light_cost(results):
    scenes = results.get("scenes", [])
    feature = results.get("feature")
    tolerances = results.get("tolerances", [])
    promises = [promise for scene in scenes for promise in scene["promises"]]
    introduction = conditions(
        results, f"one light fixed in the world, medians of {results.get('rounds')} alternating rounds") + (
        f"Times without and with {feature} [ms] and their factor, still, while the camera turns, and while the "
        f"{results.get('dragged')} is dragged; the first frame with it [ms]; and its errors [1/255] against rays with "
        f"samples {results.get('fineVoxels', 0):.3f} of a voxel apart.\n\n")
    means = ", ".join(f"{motion} {geometric_mean([scene['factor'][index] for scene in scenes]):.2f}"
                      for index, motion in enumerate(MOTIONS))
    kept_rows = [(tolerance, [promise for promise in promises if promise["errorTolerance"] == tolerance])
                 for tolerance in tolerances]
    return Report(f"Cost of {feature}", introduction, [
        Table("costs", COST, scenes, after=f"\nGeometric means of the factors: {means}.\n"),
        Table("tolerances", TOLERANCES, kept_rows, f"\n## Tolerances\n{results.get('views')} views of each scene in the "
              f"same light, of half the side, against rays with samples {results.get('fineVoxelsOfViews', 0):.3f} of a "
              "voxel apart. Kept: 99.9 % of the pixels are within the tolerance, and the largest error is within twice "
              "of it. Errors are parts of the tolerance.\n\n"),
        Table("worst-views", [SCENE, *map(worst_view_column, tolerances)], scenes,
              "\nThe error of 99.9 % of the pixels in the worst view [1/255].\n\n"),
    ])


# A row is a scene and a cost.
BESIDE = [
    Column("scene", lambda row: row[0]["scene"]),
    Column("", lambda row: row[1]["name"]),
    Column("without", lambda row: row[1]["withoutMs"], 1),
    Column("with", lambda row: row[1]["withMs"], 1),
    Column("factor", lambda row: row[1]["factor"], 2),
    Column("first", lambda row: row[1]["firstMs"], 0),
]


def shadows_beside(results):
    introduction = conditions(
        results, "one light fixed in the world, whose shadows on the volume itself all images have, except the first of "
        "two volumes that overlap. Medians over images drawn in turn with and without it, rounds: "
        f"{results.get('rounds')}") + (
        "Times of a still image without what the first column says, of one with it, their factor, and the first image "
        "with it [ms]. Where geometry moves, the image without it is that of geometry at rest.\n\n")
    rows = ((scene, cost) for scene in results.get("scenes", []) for cost in scene["costs"])
    return Report("Cost of shadows beside a volume", introduction, [Table("costs", BESIDE, rows)])


def all_scenes(method, *keys):
    """A number of a method in all scenes."""
    numbers = []
    for scene in method["scenes"]:
        value = scene["methods"][method["name"]]
        for key in keys:
            value = value[key]
        numbers.append(value)
    return numbers


def times_ours(method, time):
    """The geometric mean, over all scenes, of a time relative to ours, which is the first method."""
    return geometric_mean([scene["methods"][method["name"]][time] / next(iter(scene["methods"].values()))[time]
                           for scene in method["scenes"]])


METHODS = [
    Column("method", lambda row: row["name"]),
    Column("what it is", lambda row: row["title"]),
    Column("RMSE", lambda row: statistics.median(all_scenes(row, "error", "rmse")), 2),
    Column("99.9 %", lambda row: statistics.median(all_scenes(row, "error", "percentile99.9")), 1),
    Column("largest 99.9 %", lambda row: max(all_scenes(row, "error", "percentile99.9")), 1),
    Column("still", lambda row: times_ours(row, "stillMs"), 2),
    Column("light dragged", lambda row: times_ours(row, "draggedMs"), 2),
    Column("MB", lambda row: max(all_scenes(row, "lightMegabytes")), 2),
]


def method_columns(name):
    return [Column(name, lambda row: row["methods"][name]["error"]["percentile99.9"], 1),
            Column("ms", lambda row: row["methods"][name]["stillMs"], 0)]


# A row is a scene, the name of a method, and its costs.
METHODS_CSV = [
    Column("scene", lambda row: row[0]),
    Column("method", lambda row: row[1], quoted=True),
    Column("first_ms", lambda row: row[2]["firstMs"], 3),
    Column("still_ms", lambda row: row[2]["stillMs"], 3),
    Column("dragged_ms", lambda row: row[2]["draggedMs"], 3),
    Column("rmse", lambda row: row[2]["error"]["rmse"], 3),
    Column("percentile999", lambda row: row[2]["error"]["percentile99.9"], 3),
    Column("largest", lambda row: row[2]["error"]["largest"], 3),
    Column("light_megabytes", lambda row: row[2]["lightMegabytes"], 3),
]


def light_methods(results):
    scenes = results.get("scenes", [])
    methods = results.get("methods", [])
    side = results.get("side")
    introduction = (
        f"{machine_text(results)}. {len(scenes)} scenes, images of {side} x {side}, one light fixed in the world, medians "
        f"of {results.get('rounds')} alternating rounds. Ours has an error tolerance of "
        f"{255 * results.get('errorTolerance', 0):.2f} of 255; the samples and slices of all others are a voxel apart. "
        f"Errors [1/255] are against our own rays with samples {results.get('fineVoxels', 0):.3f} of a voxel apart. Made "
        f"by\n\n    {results['command']}\n")
    per_scene = [SCENE, *(column for method in methods for column in method_columns(method["name"]))]
    return Report("Methods of light", introduction, [
        Table("methods", METHODS, ({**method, "scenes": scenes} for method in methods if scenes),
              "\n## All scenes together\nMedians of the errors and the largest of 99.9 % of the pixels; geometric means "
              "of the times, relative to ours; the most memory for light.\n\n"),
        Table("scenes", per_scene, scenes, "\n## Each scene\nThe error of 99.9 % of the pixels [1/255], and the time of a "
              "frame of a still camera [ms].\n\n"),
        Table("light-methods", METHODS_CSV, ((scene["scene"], name, cost) for scene in scenes
                                             for name, cost in scene["methods"].items()), only_csv=True),
    ])
