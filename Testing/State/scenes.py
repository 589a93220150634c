"""Small scenes with everything that a picture may depend on, in kinds that use different caches.

Two scenes of the same kind are equal, and their pictures to the bit.
"""

import numpy
import varimarch
from beginning import Beginning
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkRectilinearGrid,
)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingVolume import vtkMultiVolume
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkVolume,
    vtkVolumeProperty,
)

SIZE = (18, 16, 14)  # voxels along x, y and z
SPACING = (1.0, 1.25, 1.5)
IMAGE_SIDE = 40  # pixels
MOST_PARTS = 100  # in which a picture is drawn, if its time is limited
ISOVALUES = (90, 150)
TABLE_SIZE = (7, 4, 1)  # of a function of two values


def values(seed=1, components=1):
    """A ball with noise, from 0 to 255."""
    z, y, x = numpy.mgrid[-1 : 1 : SIZE[2] * 1j, -1 : 1 : SIZE[1] * 1j, -1 : 1 : SIZE[0] * 1j]
    noise = numpy.random.default_rng(seed).uniform(-20, 20, (*x.shape, components))
    ball = 210 - 190 * numpy.sqrt(x * x + y * y + z * z)[..., None]
    shift = 30 * numpy.arange(components)
    array = numpy.clip(ball + noise + shift, 0, 255).astype(numpy.int16)
    return array[..., 0] if components == 1 else array


def image_of(array, name="values"):
    """An image of an array [z, y, x] or [z, y, x, component]."""
    made = vtkImageData()
    made.SetDimensions(*array.shape[2::-1])
    made.SetSpacing(*SPACING)
    components = array.shape[3] if array.ndim == 4 else 1
    scalars = numpy_to_vtk(array.reshape(-1, components), deep=True)
    scalars.SetName(name)
    made.GetPointData().SetScalars(scalars)
    return made


def image():
    """The volume, with a second array of the same kind and cell data."""
    made = image_of(values())
    other = image_of(values(seed=2)[:, ::-1], "other").GetPointData().GetScalars()
    made.GetPointData().AddArray(other)
    cells = image_of(values()[1:, 1:, 1:], "cells").GetPointData().GetScalars()
    made.GetCellData().SetScalars(cells)
    return made


def labels():
    array = numpy.zeros(SIZE[::-1], numpy.uint8)
    array[:, : SIZE[1] // 2] = 1
    array[: SIZE[2] // 2, :, : SIZE[0] // 3] = 2
    return array


def grid():
    """The volume as a rectilinear grid, with gaps that grow."""
    made = vtkRectilinearGrid()
    made.SetDimensions(*SIZE)
    for axis, count in enumerate(SIZE):
        coordinates = vtkFloatArray()
        for i in range(count):
            coordinates.InsertNextValue(SPACING[axis] * (i + 0.02 * i * i))
        (made.SetXCoordinates, made.SetYCoordinates, made.SetZCoordinates)[axis](coordinates)
    made.GetPointData().SetScalars(image().GetPointData().GetScalars())
    return made


def opacity(most=0.3):
    function = vtkPiecewiseFunction()
    for value, opaque in ((0, 0.0), (50, 0.0), (140, most), (255, most)):
        function.AddPoint(value, opaque)
    return function


def color(blue=0.1):
    function = vtkColorTransferFunction()
    function.AddRGBPoint(0, 0.9, 0.2, blue)
    function.AddRGBPoint(120, 0.9, 0.8, 0.3)
    function.AddRGBPoint(255, 1.0, 1.0, 0.9)
    return function


def gradient():
    function = vtkPiecewiseFunction()
    function.AddPoint(0, 0.1)
    function.AddPoint(30, 1.0)
    return function


def two_values(blue=0.3):
    """A transfer function of two values: colours and opacities."""
    y, x = numpy.mgrid[0 : 1 : TABLE_SIZE[1] * 1j, 0 : 1 : TABLE_SIZE[0] * 1j]
    entries = numpy.stack([x, y, numpy.full_like(x, blue), 0.1 * x * (1 - 0.5 * y)], axis=-1)
    return image_of(entries[None].astype(numpy.float32))


def ball():
    """Opaque geometry beside the volume."""
    sphere = vtkSphereSource()
    sphere.SetCenter(6, 20, 14)
    sphere.SetRadius(4)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def projection(camera, aspect):
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(camera.GetProjectionTransformMatrix(aspect, -1, 1))
    return matrix


class Scene:
    """A window with a volume. `objects` are what changes are made to, by their names."""

    def __init__(self, kind, window=None):
        self.kind = kind
        self.window = window or new_window()
        self.objects = {
            "mapper": varimarch.vtkVariationFieldVolumeMapper(),
            "property": vtkVolumeProperty(),
            "volume": vtkVolume(),
            "renderer": vtkRenderer(),
            "sun": vtkLight(),
            "lamp": vtkLight(),
            "plane": vtkPlane(),
            "slice": vtkPlane(),
            "image": image(),
            "mask": image_of(labels()),
            "opacity": opacity(),
            "color": color(),
            "gray": gradient(),
            "gradient": gradient(),
            "label opacity": opacity(0.02),
            "label color": color(0.9),
            "two values": two_values(),
            "matrix": vtkMatrix4x4(),
            "ball": ball(),
        }
        self.objects["camera"] = self["renderer"].GetActiveCamera()
        self.join()
        self.dress()
        self.light()
        self.aim()
        kind.arrange(self)
        self.window.AddRenderer(self["renderer"])
        self.began = Beginning(self)

    def __getitem__(self, name):
        return self.objects[name]

    def changed(self):
        """The names of the objects that changes are made to."""
        return [name for name in self.objects if name not in ("ball", "gray", "label color")]

    def join(self):
        self["mapper"].SetInputData(self["image"])
        self["volume"].SetMapper(self["mapper"])
        self["volume"].SetProperty(self["property"])
        self["volume"].SetUserMatrix(self["matrix"])
        self["renderer"].AddVolume(self["volume"])
        self["renderer"].AutomaticLightCreationOff()

    def dress(self):
        look = self["property"]
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        look.SetAmbient(0.4)
        look.SetDiffuse(0.9)
        look.SetSpecular(0.3)
        look.SetScalarOpacity(self["opacity"])
        look.SetColor(self["color"])
        look.SetSliceFunction(self["slice"])
        look.SetLabelScalarOpacity(1, self["label opacity"])
        look.SetLabelColor(2, self["label color"])
        for i, value in enumerate(ISOVALUES):
            look.GetIsoSurfaceValues().SetValue(i, value)

    def light(self):
        for name, position in (("sun", (60, 90, 40)), ("lamp", (-20, -10, 50))):
            light = self[name]
            light.SetLightTypeToSceneLight()
            light.SetPosition(*position)
            light.SetFocalPoint(*self["image"].GetCenter())
            self["renderer"].AddLight(light)
        self["lamp"].SetPositional(True)
        self["lamp"].SetColor(0.9, 0.7, 0.6)

    def aim(self):
        center = self["image"].GetCenter()
        for plane in ("plane", "slice"):
            self[plane].SetOrigin(*center)
            self[plane].SetNormal(0.8, 0.4, -0.4)
        camera = self["camera"]
        camera.SetFocalPoint(*center)
        camera.SetPosition(center[0] + 20, center[1] - 15, center[2] + 55)
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(21)
        self["renderer"].ResetCameraClippingRange()
        # Without a matrix, VTK fails when it is told to use one.
        camera.SetExplicitProjectionTransformMatrix(projection(camera, 1.2))

    def draw(self):
        """The picture, whose numbers are those of the screen."""
        for _ in range(self.kind.drawings):
            self.window.Render()
        for _ in range(MOST_PARTS if self["mapper"].GetLongestPartSeconds() > 0 else 0):
            if self["mapper"].GetDrawnPart() == 1:
                break
            self.window.Render()
        return varimarch.capture(self.window)

    def leave(self):
        """Takes the scene out of a window that others are drawn in."""
        for name in ("renderer", "other renderer"):
            if name in self.objects:
                self.window.RemoveRenderer(self[name])


def new_window():
    window = varimarch.vtkHeadlessRenderWindow()
    window.SetSize(IMAGE_SIDE, IMAGE_SIDE)
    return window


class Kind:
    """A kind of scene: how it is arranged, and how many drawings make its picture.

    Steps are searched for in some. `focus` has the objects and setters that a kind is for.
    """

    def __init__(self, arrange, focus=frozenset(), drawings=1, searches=False):
        self.arrange = arrange
        self.focus = focus
        self.drawings = drawings
        self.searches = searches


def with_fixed_steps(scene):
    scene["mapper"].AutoAdjustSampleDistancesOff()
    scene["mapper"].SetSampleDistance(0.7)


def with_tolerance(scene):
    scene["mapper"].SetErrorTolerance(1 / 32)
    scene["mapper"].SetIntegrationRule(1)  # a rule that is kept would be that of another view


def labelled(scene):
    with_fixed_steps(scene)
    scene["mapper"].SetMaskInput(scene["mask"])
    scene["property"].SetGradientOpacity(scene["gradient"])


def in_shadows(scene):
    with_tolerance(scene)
    scene["mapper"].ShadowsOn()
    scene["mapper"].SetVolumetricScatteringBlending(0.5)
    scene["mapper"].SetMaskInput(scene["mask"])
    scene["renderer"].AddActor(scene["ball"])


def occluded(scene):
    with_tolerance(scene)
    scene["mapper"].SetAmbientOcclusion(0.8)
    scene["mapper"].AddClippingPlane(scene["plane"])
    scene["property"].SetAmbient(0.6)


def by_shaders(scene):
    with_fixed_steps(scene)
    scene["mapper"].ProcessorMarchingOff()


def accumulated(scene):
    by_packets = scene["mapper"]
    with_fixed_steps(scene)
    by_packets.SetMaximumAccumulatedPictures(3)
    scene["renderer"].AddActor(scene["ball"])


def in_blocks(scene):
    by_shaders(scene)
    scene["mapper"].SetMaximumGraphicsMemory(200000)


def of_two_values(scene):
    with_fixed_steps(scene)
    scene["property"].SetTransferFunction2D(scene["two values"])


def of_components(scene):
    with_fixed_steps(scene)
    scene.objects["image"] = image_of(values(components=2))
    scene["mapper"].SetInputData(scene["image"])
    scene["property"].SetScalarOpacity(1, opacity(0.05))
    scene["property"].SetColor(1, color(0.8))


def uneven(scene):
    with_fixed_steps(scene)
    scene.objects["image"] = grid()
    scene["mapper"].SetInputData(scene["image"])


def overlapping(scene):
    """Two volumes that overlap, of which the second has changes of its own."""
    adapter = varimarch.vtkVariationFieldGPUVolumeRayCastMapper()
    adapter.SetAutoAdjustSampleDistances(False)
    adapter.SetSampleDistance(0.7)
    both, second = vtkMultiVolume(), vtkVolume()
    both.SetMapper(adapter)
    scene.objects["mapper"] = adapter.GetVariationFieldMapper()
    scene.objects["other volume"] = second
    scene.objects["other property"] = second.GetProperty()
    scene.objects["other opacity"] = opacity(0.2)
    second.GetProperty().SetScalarOpacity(scene["other opacity"])
    second.GetProperty().SetInterpolationTypeToLinear()
    second.SetPosition(4, 2, 3)
    for port, volume in enumerate((scene["volume"], second)):
        adapter.SetInputDataObject(port, scene["image"] if port == 0 else image_of(values(seed=3)))
        both.SetVolume(volume, port)
    scene["renderer"].RemoveVolume(scene["volume"])
    scene["renderer"].AddVolume(both)
    scene["mapper"].SetAmbientOcclusion(0.7)


def in_two_renderers(scene):
    """One mapper that is drawn in turn in two views."""
    with_fixed_steps(scene)
    other = vtkRenderer()
    scene.objects["other renderer"] = other
    scene.objects["other camera"] = other.GetActiveCamera()
    other.GetActiveCamera().DeepCopy(scene["camera"])
    other.GetActiveCamera().Azimuth(70)
    other.SetViewport(0.5, 0, 1, 1)
    other.AddVolume(scene["volume"])
    other.ResetCamera()
    scene["mapper"].SetMaximumAccumulatedPictures(2)
    scene.window.AddRenderer(other)


def blended(mode):
    def arrange(scene):
        with_fixed_steps(scene)
        scene["opacity"].AddPoint(200, 0.9)
        scene["mapper"].SetBlendMode(mode)
        scene["mapper"].SetAverageIPScalarRange(60, 200)

    return arrange
