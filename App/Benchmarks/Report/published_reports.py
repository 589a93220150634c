"""The report of the scenes of two papers, beside their published figures."""

from columns import Column, Report, Table, load_text
from work_precision_reports import curve_of, rmse

BANQUERO = """## Banquero, Ortiz, Rossi 2016
Their setup: NVIDIA GeForce GTX 660 Ti, Intel Core Duo 2.40 GHz. The paper does not state the
image size, the transfer function, the step and the first distance; 60 frames per second are
probably the display's limit. Here the transfer function is a grey ramp, clear at its lower
end, rays begin where they enter the volume, and nothing ends them early, as in the printed
loop. All volumes are resampled to the sizes of the paper, in bytes. The loop runs in a
shader, line by line (`VolumeModule/Shaders/March/PublishedSum.glsl`). *Readings* are fetches
from the volume per pixel; with the field, each has one from the field beside it. RMSE is in
1/255 of premultiplied RGBA, against an adaptive integral of each whole ray.
"""

TABLE_1 = """
### Table 1: the number of steps
The paper calls 120 steps almost half of a volume of 256 voxels, so a step is one voxel, the
smallest spacing. Rays that short do not reach the far side, which is most of the error.

"""

TABLE_2 = """
### Table 2: ray casting (RC) and distance field (DF)
E = 4/255 of the range. The paper does not state its steps, so rays are whole.

"""

TOLERANCES = """
### Ours, at the error of their field
The coarsest error tolerance whose RMSE is not above that of DF, by packets of rays on the CPU
and by shaders.

"""

PROMISE = """
### The field, and how often it is wrong
S promises that voxels closer than S(p) differ from voxel p by less than E = 4/255. A ray
meets interpolated values, at places between voxels. 200000 jumps from random places in random
directions: the part that goes two voxels or more, the part of these that meets a value which
differs by E or more from the first, and the largest such difference in 1/255.

"""

VOLT = """
## Volt 2009
Their setup: an NVIDIA GPU of 2009 with CUDA. The text that we have gives registers (32
shaded, 14 unshaded), but no frame rates. VIS MALE, values up to 40 clear, from 41 at one
opacity per voxel edge, a sample every 0.49 of the shortest edge, early termination at 95 %
(VTK's own limit cannot be set). Shaded light is damped where the gradient is below 10/255 per
voxel, which VTK's mapper does not have. Errors are measured against the image without early
termination.

"""


def fps(point):
    return 1000 / point["medianMs"] if point else None


def fetches(point):
    return point.get("fetchesPerPixel") if point else None


def error(point):
    return rmse(point) if point else None


# A row of any of these tables is a dictionary that has at least the data set.
SET = [
    Column("data set", lambda row: row["set"]["dataSet"]),
    Column("size", lambda row: " x ".join(3 * [str(row["set"]["side"])])),
]

STEPS = SET + [
    Column("steps", lambda row: row["theirs"]["steps"], 0),
    Column("FPS, theirs", lambda row: row["theirs"]["fps"], 1),
    Column("FPS, ours", lambda row: fps(row["point"]), 1),
    Column("readings", lambda row: fetches(row["point"]), 1, missing=""),
    Column("RMSE", lambda row: error(row["point"]), 2),
]

RATES = SET + [
    Column("FPS RC, theirs", lambda row: row["theirs"]["plainFps"], 0),
    Column("FPS DF, theirs", lambda row: row["theirs"]["fieldFps"], 0),
    Column("DF / RC, theirs", lambda row: row["theirs"]["ratio"], 0),
    Column("step", lambda row: row["step"], 1, "voxels"),
    Column("FPS RC", lambda row: fps(row["plain"]), 1),
    Column("FPS DF", lambda row: fps(row["field"]), 1),
    Column("DF / RC", lambda row: row["plain"]["medianMs"] / row["field"]["medianMs"], 2),
    Column("readings RC", lambda row: fetches(row["plain"]), 1, missing=""),
    Column("readings DF", lambda row: fetches(row["field"]), 1, missing=""),
    Column("RMSE RC", lambda row: error(row["plain"]), 2),
    Column("RMSE DF", lambda row: error(row["field"]), 2),
]

OURS = SET + [
    Column("step of DF", lambda row: row["step"], 1),
    Column("RMSE DF", lambda row: error(row["field"]), 2),
    Column("FPS DF", lambda row: fps(row["field"]), 1),
    Column("readings DF", lambda row: fetches(row["field"]), 1, missing=""),
    Column("tolerance", lambda row: row["ours"]["setting"] if row["ours"] else "none", 0),
    Column("RMSE", lambda row: error(row["ours"]), 2, missing=""),
    Column("FPS", lambda row: fps(row["ours"]), 1, missing=""),
    Column("FPS, shaders", lambda row: fps(row["shader"]), 1, missing=""),
    Column("readings, shaders", lambda row: fetches(row["shader"]), 1, missing=""),
]

JUMPS = SET + [
    Column("built in", lambda row: row["set"]["buildSeconds"], 1, "s"),
    Column("mean S, ball", lambda row: row["set"]["meanEuclidean"], 2),
    Column("mean S, cube", lambda row: row["set"]["meanChebyshev"], 2),
    Column("jumps of two voxels or more", lambda row: f"{100 * row['set']['longJumps']:.1f} %", 0),
    Column("broken", lambda row: f"{100 * row['set']['brokenJumps']:.2f} %", 0),
    Column("by up to", lambda row: row["set"]["largestDifference"], 0),
]


def volt_point(row, index):
    methods = row["measured"]["methods"]
    return methods[index]["points"][0] if index < len(methods) else None


def volt_columns(index, name):
    return [Column(name, lambda row: fps(volt_point(row, index)), 1, "FPS", ""),
            Column("RMSE", lambda row: error(volt_point(row, index)), 2, missing="")]


VOLT_COLUMNS = [
    Column("alpha", lambda row: row["alpha255"], 0, "1/255"),
    Column("shaded", lambda row: "yes" if row["shaded"] else "no"),
    *volt_columns(0, "ours"), *volt_columns(1, "no field"), *volt_columns(2, "VTK GPU"),
]


def points(data_set, method):
    return curve_of(data_set["measured"], method)["points"]


def step_rows(data_set):
    return [{"set": data_set, "theirs": theirs, "point": point} for theirs, point in
            zip(data_set["theirSteps"], points(data_set, "steps"))] if "theirSteps" in data_set else []


def rate_rows(data_set, steps):
    if "theirRates" not in data_set:
        return []
    rows = []
    for step, plain, field in zip(steps, points(data_set, "rc"), points(data_set, "df")):
        ours, shader = next(((ours, shader) for ours, shader in zip(
            points(data_set, "tolerance"), points(data_set, "tolerance-shader")) if rmse(ours) <= rmse(field)),
            (None, None))
        rows.append({"set": data_set, "theirs": data_set["theirRates"], "step": step, "plain": plain, "field": field,
                     "ours": ours, "shader": shader})
    return rows


def remarks_of(results):
    remarks = dict.fromkeys(f"{data_set['dataSet']}: {data_set['remark']}." for data_set in results.get("banquero", []))
    missing = [f"Not in the folder: {file}." for file in results.get("missing", [])]
    return "\nOur volumes before they were resampled: " + " ".join([*remarks, *missing]) + "\n"


def published(results):
    sets = results.get("banquero", [])
    first = sets[0]["measured"] if sets else {"openglRenderer": "", "size": [0, 0]}
    machine = results["machine"]
    introduction = (
        f"Ours: {machine['processor']}, {machine['cores']} cores, OpenGL renderer \"{first['openglRenderer']}\", images of "
        f"{first['size'][0]} x {first['size'][1]}, {machine['date']}{load_text(machine)}. "
        f"Made by `{results['command']}`.\nIf ours is a CPU, frame rates are not comparable with theirs: compare the "
        f"ratios.\n\n{BANQUERO}{remarks_of(results)}")
    figures = "".join(f"\n{figure['text']}\n\n![]({figure['file']})\n" for figure in results.get("figures", []))
    rates = [row for data_set in sets for row in rate_rows(data_set, results["stepVoxels"])]
    return Report("Published scenes", introduction, [
        Table("steps", STEPS, (row for data_set in sets for row in step_rows(data_set)), TABLE_1),
        Table("rates", RATES, rates, TABLE_2),
        Table("ours", OURS, rates, TOLERANCES),
        Table("jumps", JUMPS, ({"set": data_set} for data_set in sets if "longJumps" in data_set), PROMISE),
        Table("volt", VOLT_COLUMNS, results.get("volt", []), figures + VOLT),
    ], "" if results.get("volt") else figures)
