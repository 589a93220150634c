"""How a scene began, and the ways back to it."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight


def to(target, method, *arguments):
    """A change that calls a method of one of a scene's objects."""
    return lambda s: getattr(s[target], method)(*arguments)


def numbers_of(image):
    """The numbers of an image as an array that shares its memory."""
    return vtk_to_numpy(image.GetPointData().GetScalars())


def nodes_of(function):
    size = 4 if function.IsA("vtkPiecewiseFunction") else 6
    nodes = [[0.0] * size for _ in range(function.GetSize())]
    for i, node in enumerate(nodes):
        function.GetNodeValue(i, node)
    return nodes


def set_nodes(function, nodes):
    add = function.AddPoint if function.IsA("vtkPiecewiseFunction") else function.AddRGBPoint
    function.RemoveAllPoints()
    for node in nodes:
        add(*node)


def copy_of(light):
    copy = vtkLight()
    copy.DeepCopy(light)
    return copy


VIEW = ("FocalPoint", "Position", "ViewUp", "ViewAngle", "ParallelScale", "ClippingRange")


class Beginning:
    """Copies of what changes replace in a scene."""

    functions = ("opacity", "color", "gradient", "label opacity")
    images = ("image", "mask", "two values")

    def __init__(self, scene):
        mapper, look = scene["mapper"], scene["property"]
        self.mask = mapper.GetMaskInput()
        planes = mapper.GetClippingPlanes()
        self.planes = [planes.GetItem(i) for i in range(planes.GetNumberOfItems() if planes else 0)]
        self.memory = mapper.GetMaximumGraphicsMemory()
        self.distance = mapper.GetSampleDistance()
        self.gradient = look.GetGradientOpacity() if look.HasGradientOpacity() else None
        self.two_values = look.GetTransferFunction2D()
        self.function_mode = look.GetTransferFunctionMode()
        self.has_ball = scene["renderer"].HasViewProp(scene["ball"])
        self.nodes = {name: nodes_of(scene[name]) for name in self.functions}
        self.lights = {name: copy_of(scene[name]) for name in ("sun", "lamp")}
        self.view = {name: getattr(scene["camera"], f"Get{name}")() for name in VIEW}
        self.numbers = {
            name: numbers_of(scene[name]).copy()
            for name in self.images
        }


def set_planes(s):
    s["mapper"].RemoveAllClippingPlanes()
    for plane in s.began.planes:
        s["mapper"].AddClippingPlane(plane)


def set_distance(s):
    s["mapper"].LockSampleDistanceToInputSpacingOff()
    s["mapper"].SetSampleDistance(s.began.distance)


def set_labels(s):
    look = s["property"]
    for label, color, opacity in (
        (1, None, s["label opacity"]),
        (2, s["label color"], None),
        (7, None, None),
    ):
        look.SetLabelColor(label, color)
        look.SetLabelScalarOpacity(label, opacity)
        look.SetLabelGradientOpacity(label, None)


def set_functions_of_values(s):
    if s.began.two_values:
        s["property"].SetTransferFunction2D(s.began.two_values)
    s["property"].SetTransferFunctionMode(s.began.function_mode)


def set_property(s):
    for name in ("color", "opacity"):
        set_nodes(s[name], s.began.nodes[name])
    s.dress()


def set_lights(s):
    s["renderer"].RemoveAllLights()
    for light in ("sun", "lamp"):
        s["renderer"].AddLight(s[light])


def set_ball(s):
    s["renderer"].RemoveActor(s["ball"])
    if s.began.has_ball:
        s["renderer"].AddActor(s["ball"])


def set_place(s):
    s["volume"].SetPosition(0, 0, 0)
    s["volume"].SetOrientation(0, 0, 0)


def set_shaders(s):
    shaders = s["volume"].GetShaderProperty()
    shaders.ClearAllFragmentShaderReplacements()
    shaders.GetFragmentCustomUniforms().RemoveAllUniforms()


def set_numbers(name):
    def make(s):
        numpy.copyto(numbers_of(s[name]), s.began.numbers[name])
        s[name].GetPointData().GetScalars().Modified()

    return make


def set_light(name):
    return lambda s: s[name].DeepCopy(s.began.lights[name])


def set_view(s):
    for name, value in s.began.view.items():
        getattr(s["camera"], f"Set{name}")(*(value if isinstance(value, tuple) else (value,)))


def set_camera(s):
    s["renderer"].SetActiveCamera(s["camera"])
    s["camera"].Modified()  # VTK's geometry would be that of the other camera


BEGINNINGS = {
    "input": lambda s: s["mapper"].SetInputData(s["image"]),
    "mask": lambda s: s["mapper"].SetMaskInput(s.began.mask),
    "planes": set_planes,
    "memory": lambda s: s["mapper"].SetMaximumGraphicsMemory(s.began.memory),
    "distance": set_distance,
    "color": lambda s: s["property"].SetColor(s["color"]),
    "opacity": lambda s: s["property"].SetScalarOpacity(s["opacity"]),
    "gradient": lambda s: s["property"].SetGradientOpacity(s.began.gradient),
    "labels": set_labels,
    "slice function": lambda s: s["property"].SetSliceFunction(s["slice"]),
    "two values": set_functions_of_values,
    "property": set_property,
    "volume's property": lambda s: s["volume"].SetProperty(s["property"]),
    "mapper": lambda s: s["volume"].SetMapper(s["mapper"]),
    "matrix": lambda s: s["volume"].SetUserMatrix(s["matrix"]),
    "shaders": set_shaders,
    "place": set_place,
    "lights": set_lights,
    "ball": set_ball,
    "viewport": to("renderer", "SetViewport", 0, 0, 1, 1),
    "camera": set_camera,
    "view": set_view,
    **{name: set_light(name) for name in ("sun", "lamp")},
    **{f"{name}'s numbers": set_numbers(name) for name in Beginning.images},
    **{
        f"{name}'s nodes": lambda s, name=name: set_nodes(s[name], s.began.nodes[name])
        for name in Beginning.functions
    },
}


def first(what):
    """The way back to how a scene began."""
    return BEGINNINGS[what]
