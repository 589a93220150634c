"""Draws cases in ParaView, by pvpython or by pvbatch on any number of processes.

Usage: pvbatch draw.py PLUGIN REPRESENTATION FOLDER [SERVER] CASE...

Each case is a function of this file, or the name of a scene in Data/References. Its picture is
FOLDER/CASE.png; of our volumes FOLDER/CASE.floats has it before it is rounded to 8 bits. SERVER, such
as localhost:11111, is the pvserver that draws. Without a case, the names of all cases are printed. The
least depth of each picture is printed. With the environment variable VARIMARCH_FRAMES the camera of each
case then turns for this number of frames, and the median time of one is printed [ms]. With
VARIMARCH_BYTES our volumes are drawn and composited in 8 bits, as ParaView's are, and
VARIMARCH_TOLERANCE is their error tolerance.
"""

import json
import os
import pathlib
import statistics
import sys
import time

from paraview import simple
from vtkmodules.vtkCommonCore import vtkFloatArray

REFERENCES = pathlib.Path(__file__).resolve().parents[2] / "Data" / "References"
SIZE = 256
LIT = {"Ambient": 0.2, "Diffuse": 0.8, "Specular": 0.2, "SpecularPower": 16.0}
CASES = {}
# The script of a filter that makes a rectilinear grid of an image, or of a piece of it.
UNEVEN = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
image, grid = self.GetInputDataObject(0, 0), self.GetOutputDataObject(0)
extent = image.GetExtent()
grid.SetExtent(extent)
for axis, name in enumerate("XYZ"):
    places = vtkDoubleArray()
    for i in range(extent[2 * axis], extent[2 * axis + 1] + 1):
        places.InsertNextValue(i + 0.004 * i * abs(i))
    getattr(grid, f"Set{name}Coordinates")(places)
grid.GetPointData().ShallowCopy(image.GetPointData())
"""
# The script of a filter that cuts an image at the middle of each axis.
BLOCKS = """
import itertools
from vtkmodules.vtkCommonDataModel import vtkImageData
image, blocks = self.GetInputDataObject(0, 0), self.GetOutputDataObject(0)
extent = image.GetExtent()
halves = [((lower, (lower + upper) // 2), ((lower + upper) // 2, upper))
          for lower, upper in zip(extent[::2], extent[1::2])]
for i, (x, y, z) in enumerate(itertools.product(*halves)):
    block = vtkImageData()
    block.ShallowCopy(image)
    block.Crop((*x, *y, *z))
    blocks.SetBlock(i, block)
"""


def case(function):
    CASES[function.__name__] = function
    return function


class Stage:
    """A view of one kind of volumes."""

    def __init__(self, representation, floats):
        self.representation = representation
        self.floats = floats  # the file of a picture in floats
        self.is_ours = representation != "Volume"
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [SIZE, SIZE]
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [0.0, 0.0, 0.0]
        self.view.OrientationAxesVisibility = 0
        self.view.UseLight = 0
        # It smooths edges of a picture, or with several processes of their parts of it.
        self.view.UseFXAA = 0
        simple.AddLight(view=self.view).Coords = "Headlight"

    def show(self, source, array, colors, opacities, unit_distance=1.0):
        """Shows a source as a volume with nodes (value, red, green, blue) and (value, opacity)."""
        display = simple.Show(source, self.view)
        display.ColorArrayName = ["POINTS", array]
        look = simple.GetColorTransferFunction(array, display, separate=True)
        look.AutomaticRescaleRangeMode = "Never"
        look.RGBPoints = [number for node in colors for number in node]
        look.ColorSpace = "RGB"
        opacity = simple.GetOpacityTransferFunction(array, display, separate=True)
        opacity.Points = [
            number for value, alpha in opacities for number in (value, alpha, 0.5, 0.0)
        ]
        display.LookupTable = look
        display.ScalarOpacityFunction = opacity
        self.set(display, "ScalarOpacityUnitDistance", unit_distance)
        if self.is_ours:
            display.FloatImageFile = self.floats
            display.FloatCompositing = int(not os.environ.get("VARIMARCH_BYTES"))
            display.ErrorTolerance = float(os.environ.get("VARIMARCH_TOLERANCE", 1 / 64))
        display.SetRepresentationType(self.representation)
        return display

    def set(self, display, name, value):
        """Sets a property of ParaView's volumes, which ours may have under a name of its own."""
        own = {
            "Shade": "VarimarchShade",
            "BlendMode": "VarimarchBlendMode",
            "ScalarOpacityUnitDistance": "VarimarchUnitDistance",
        }
        setattr(display, own.get(name, name) if self.is_ours else name, value)

    def look(self, position, focal_point, view_up=(0.0, 0.0, 1.0), angle=30.0):
        self.view.CameraPosition = position
        self.view.CameraFocalPoint = focal_point
        self.view.CameraViewUp = view_up
        self.view.CameraViewAngle = angle


def wavelet(stage, shade=False, opacity=0.2):
    """ParaView's own test volume, of 81 voxels along each axis, from -40 to 40."""
    source = simple.Wavelet(WholeExtent=[-40, 40, -40, 40, -40, 40])
    source.XFreq, source.YFreq, source.ZFreq = 30.0, 20.0, 25.0
    colors = [(0.0, 0.1, 0.2, 0.9), (130.0, 0.9, 0.8, 0.3), (280.0, 1.0, 0.2, 0.1)]
    display = stage.show(source, "RTData", colors, [(0.0, 0.0), (120.0, 0.0), (280.0, opacity)])
    stage.look([120.0, -170.0, 80.0], [0.0, 0.0, 0.0])
    if shade:
        stage.set(display, "Shade", 1)
        for name, value in LIT.items():
            setattr(display, name, value)
    return source, display


@case
def composite(stage):
    wavelet(stage)


@case
def behind(stage):
    wavelet(stage)
    stage.look([-120.0, 170.0, -80.0], [0.0, 0.0, 0.0])


@case
def lit(stage):
    wavelet(stage, shade=True)


@case
def opaque(stage):
    wavelet(stage, shade=True, opacity=0.95)


@case
def turned(stage):
    wavelet(stage)[1].Orientation = [180.0, 0.0, 0.0]


@case
def oblique(stage):
    wavelet(stage)[1].Orientation = [20.0, 30.0, 40.0]


@case
def cropped(stage):
    display = wavelet(stage)[1]
    display.UseCropping = 1
    display.CroppingOrigin = [0.0, 0.0, 12.0]
    display.CroppingScale = [1.0, 0.7, 0.8]


@case
def geometry(stage):
    wavelet(stage)
    sphere = simple.Sphere(Radius=22.0, Center=[6.0, -8.0, 4.0])
    sphere.ThetaResolution = sphere.PhiResolution = 64
    simple.Show(sphere, stage.view)


@case
def toned(stage):
    """An image that a pass processes."""
    geometry(stage)
    stage.view.UseToneMapping = 1


@case
def closed(stage):
    """The image of composite() after another view was closed, with which views share programs."""
    composite(stage)
    simple.Render(stage.view)
    other = Stage(stage.representation, stage.floats)
    composite(other)
    simple.Render(other.view)
    simple.Delete(other.view)
    del other


@case
def inside(stage):
    wavelet(stage, opacity=0.05)
    stage.look([5.0, 3.0, 2.0], [40.0, 30.0, 5.0], angle=60.0)


@case
def two(stage):
    wavelet(stage)
    other = simple.Wavelet(WholeExtent=[-40, 40, -40, 40, -40, 40])
    display = stage.show(other, "RTData", [(0.0, 0.0, 0.6, 0.1), (280.0, 0.7, 1.0, 0.7)],
                         [(0.0, 0.0), (200.0, 0.0), (280.0, 0.3)])
    display.Position = [90.0, 0.0, 0.0]
    stage.look([120.0, -300.0, 80.0], [45.0, 0.0, 0.0])


@case
def cells(stage):
    source, _ = wavelet(stage)
    simple.Hide(source, stage.view)
    moved = simple.PointDatatoCellData(Input=source)
    display = stage.show(moved, "RTData", [(0.0, 0.1, 0.2, 0.9), (280.0, 1.0, 0.2, 0.1)],
                         [(0.0, 0.0), (120.0, 0.0), (280.0, 0.2)])
    display.ColorArrayName = ["CELLS", "RTData"]


def of_wavelet(stage, filtered):
    """The volume of wavelet() behind a filter."""
    source, _ = wavelet(stage)
    simple.Hide(source, stage.view)
    return stage.show(filtered(source), "RTData", [(0.0, 0.1, 0.2, 0.9), (280.0, 1.0, 0.2, 0.1)],
                      [(0.0, 0.0), (120.0, 0.0), (280.0, 0.2)])


@case
def uneven(stage):
    """A rectilinear grid."""
    of_wavelet(stage, lambda source: simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkRectilinearGrid", Script=UNEVEN))
    stage.look([150.0, -210.0, 100.0], [0.0, 0.0, 0.0])


@case
def block(stage):
    """An image in a multi-block data set."""
    of_wavelet(stage, lambda source: simple.GroupDatasets(Input=[source]))


@case
def partition(stage):
    """An image in a partitioned data set, of which each process has a part."""
    return of_wavelet(stage, lambda source: simple.GroupDatasets(
        Input=[source], OutputType="vtkPartitionedDataSet"))


@case
def cropped_partition(stage):
    partition(stage).UseCropping = 1


@case
def blocks(stage):
    """A multi-block data set of the eight images into which each process cuts its own."""
    of_wavelet(stage, lambda source: simple.ProgrammableFilter(
        Input=source, OutputDataSetType="vtkMultiblockDataSet", Script=BLOCKS))


@case
def overlapping(stage):
    """Two images at the same place in a multi-block data set."""
    of_wavelet(stage, lambda source: simple.GroupDatasets(Input=[source, simple.Wavelet()]))


@case
def cell(stage):
    """One cell, so that all processes but one have no data."""
    source, display = wavelet(stage, opacity=0.9)
    source.WholeExtent = [0, 1, 0, 1, 0, 1]
    stage.set(display, "ScalarOpacityUnitDistance", 0.1)
    stage.look([1.7, -3.0, 1.5], [0.5, 0.5, 0.5])


@case
def maximum(stage):
    stage.set(wavelet(stage)[1], "BlendMode", 1)


@case
def shadows(stage):
    display = wavelet(stage, shade=True)[1]
    stage.view.AdditionalLights = []
    light = simple.AddLight(view=stage.view)
    light.Coords, light.Type = "Scene", "Directional"
    light.Position, light.FocalPoint = [100.0, 0.0, 200.0], [0.0, 0.0, 0.0]
    if stage.is_ours:
        display.Shadows = 1


def reference(stage, name):
    """A scene of Data/References, whose exact picture is there too."""
    description = json.loads((REFERENCES / f"{name}.json").read_text())
    scene, camera = description["scene"], description["camera"]
    source = simple.NrrdReader(FileName=str(REFERENCES / description["volume"]["file"]))
    source.UpdatePipeline()
    array = source.PointData.GetArray(0).Name
    colors = [(node["value"], *node["rgb"]) for node in scene["look"]["colors"]]
    opacities = [(node["value"], node["opacity"]) for node in scene["look"]["opacities"]]
    display = stage.show(source, array, colors, opacities, scene["look"]["opacityUnitDistance"])
    light = scene["look"]["shading"]
    stage.set(display, "Shade", int(light["enabled"]))
    for name, key in zip(LIT, ("ambient", "diffuse", "specular", "specularPower")):
        setattr(display, name, light[key])
    angle = camera["viewAngleDegrees"]
    stage.look(camera["position"], camera["focalPoint"], camera["viewUp"], angle)
    stage.view.CameraParallelProjection = int(camera["isParallel"])
    stage.view.CameraParallelScale = camera["parallelScale"]
    stage.view.ViewSize = scene["size"]


def frame_seconds(view):
    """The median time of a frame while the camera turns, with the number of frames that
    VARIMARCH_FRAMES says, drawn and composited as a still image."""
    times = []
    for _ in range(int(os.environ["VARIMARCH_FRAMES"])):
        view.GetActiveCamera().Azimuth(7.0)
        start = time.perf_counter()
        simple.Render(view)
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def least_depth(view):
    depths = vtkFloatArray()
    width, height = view.ViewSize
    view.GetRenderWindow().GetZbufferData(0, 0, width - 1, height - 1, depths)
    return depths.GetRange()[0]


def main():
    plugin, representation, folder, *cases = sys.argv[1:]
    is_remote = bool(cases) and ":" in cases[0]
    if is_remote:
        host, port = cases.pop(0).split(":")
        simple.Connect(host, int(port))
        simple.LoadPlugin(plugin, remote=False, ns=globals())
    simple.LoadPlugin(plugin, remote=True, ns=globals())
    simple._DisableFirstRenderCameraReset()
    if not cases:
        print(*CASES)
    for name in cases:
        stage = Stage(representation, f"{folder}/{name}.floats")
        if name in CASES:
            CASES[name](stage)
        else:
            reference(stage, name)
        simple.Render(stage.view)
        if not is_remote:
            print(name, "least depth", f"{least_depth(stage.view):.6f}", flush=True)
        if os.environ.get("VARIMARCH_FRAMES"):
            print(name, f"{1000 * frame_seconds(stage.view):.0f}", flush=True)
        simple.SaveScreenshot(f"{folder}/{name}.png", stage.view)
        if not is_remote:
            simple.ResetSession()


main()
