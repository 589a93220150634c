"""Changes that no signature tells: objects that are set, nodes of functions, data in place.

Each is a setter's name, what makes the change in a scene, and what takes it back.
"""

import numpy
import scenes
import varimarch
from beginning import first, numbers_of, to
from scenes import image_of, values
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkCommonMath import vtkMatrix3x3, vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkVolumeProperty


def turned(degrees=15):
    transform = vtkTransform()
    transform.RotateWXYZ(degrees, 0.3, 1, 0.2)
    return transform


def matrix(degrees):
    made = vtkMatrix4x4()
    made.DeepCopy(turned(degrees).GetMatrix())
    return made


def directions(quarters):
    """Axes that are turned about z by right angles."""
    made = vtkMatrix3x3()
    cosine, sine = ((1, 0), (0, 1))[quarters]
    for i, row in enumerate(((cosine, sine, 0), (-sine, cosine, 0), (0, 0, 1))):
        for j, number in enumerate(row):
            made.SetElement(i, j, number)
    return made


def input_changes():
    def from_pipeline(s):
        source = vtkTrivialProducer()
        source.SetOutput(image_of(values(seed=6)))
        s["mapper"].SetInputConnection(source.GetOutputPort())

    def other_array(s):
        s["mapper"].SetScalarModeToUsePointFieldData()
        s["mapper"].SelectScalarArray("other")

    inputs = {
        "voxels": values(seed=5),
        "floats": values().astype(numpy.float32) + 0.5,
        "components": values(components=2),
        "part": values()[2:, 1:],
    }
    for array in inputs.values():
        yield "SetInputData", to("mapper", "SetInputData", image_of(array)), first("input")
    yield "SetInputData", to("mapper", "SetInputData", scenes.grid()), first("input")
    yield "SetInputDataObject", to("mapper", "SetInputDataObject", scenes.image()), first("input")
    yield "SetInputConnection", from_pipeline, first("input")
    yield "SelectScalarArray", other_array, to("mapper", "SetScalarModeToDefault")


def mapper_changes():
    def second_plane(s):
        plane = vtkPlane()
        plane.SetOrigin(s["image"].GetCenter())
        plane.SetNormal(-0.2, -0.9, 0.3)
        s["mapper"].AddClippingPlane(plane)

    def two_planes(s):
        planes = vtkPlaneCollection()
        planes.AddItem(s["plane"])
        planes.AddItem(s["slice"])
        s["mapper"].SetClippingPlanes(planes)

    def crop(s):
        bounds = s["image"].GetBounds()
        ends = [(0.7 * a + 0.3 * b, 0.3 * a + 0.7 * b) for a, b in zip(bounds[::2], bounds[1::2])]
        s["mapper"].SetCroppingRegionPlanes(*numpy.ravel(ends))
        s["mapper"].CroppingOn()

    def second_values(s):
        s["property"].SetTransferFunctionMode(1)
        s["mapper"].SetTransfer2DYAxisArray("other")

    def no_second_values(s):
        s["property"].SetTransferFunctionMode(s.began.function_mode)
        s["mapper"].SetTransfer2DYAxisArray(None)

    yield from input_changes()
    for labels in (None, scenes.labels(), scenes.labels()[:, ::-1], scenes.labels()[:, :, :9]):
        mask = None if labels is None else image_of(labels)
        yield "SetMaskInput", to("mapper", "SetMaskInput", mask), first("mask")
    yield "AddClippingPlane", second_plane, first("planes")
    yield "AddClippingPlane", lambda s: s["mapper"].AddClippingPlane(s["plane"]), first("planes")
    yield "RemoveClippingPlane", lambda s: s["mapper"].RemoveClippingPlane(s["plane"]), first("planes")
    yield "RemoveAllClippingPlanes", to("mapper", "RemoveAllClippingPlanes"), first("planes")
    yield "SetClippingPlanes", two_planes, first("planes")
    yield "SetCroppingRegionPlanes", crop, to("mapper", "CroppingOff")
    yield "SetTransfer2DYAxisArray", second_values, no_second_values
    memory = to("mapper", "SetMaximumGraphicsMemory", 150000)
    yield "SetMaximumGraphicsMemory", memory, first("memory")
    # The lock sets the distance itself, as in VTK.
    for lock in (1, 0):
        setter = "SetLockSampleDistanceToInputSpacing"
        yield setter, to("mapper", setter, lock), first("distance")
    for switch in ("LockSampleDistanceToInputSpacingOn", "LockSampleDistanceToInputSpacingOff"):
        yield switch, to("mapper", switch), first("distance")


def property_changes():
    def other():
        look = vtkVolumeProperty()
        look.SetColor(scenes.color(0.7))
        look.SetScalarOpacity(scenes.opacity(0.06))
        look.SetInterpolationTypeToLinear()
        return look

    colors = to("property", "SetColor", scenes.color(0.9))
    yield "SetColor", colors, first("color")
    yield "SetColor", lambda s: s["property"].SetColor(s["gray"]), first("color")
    opacities = to("property", "SetScalarOpacity", scenes.opacity(0.05))
    yield "SetScalarOpacity", opacities, first("opacity")
    gradients = to("property", "SetGradientOpacity", scenes.gradient())
    yield "SetGradientOpacity", gradients, first("gradient")
    for setter, made in (
        ("SetLabelColor", scenes.color(0.6)),
        ("SetLabelScalarOpacity", scenes.opacity(0.08)),
        ("SetLabelGradientOpacity", scenes.gradient()),
    ):
        for label in (1, 7):
            yield setter, to("property", setter, label, made), first("labels")
    sphere = vtkPlane()
    sphere.SetOrigin(8, 9, 8)
    sphere.SetNormal(0, 1, 1)
    yield "SetSliceFunction", to("property", "SetSliceFunction", sphere), first("slice function")
    table = to("property", "SetTransferFunction2D", scenes.two_values(0.9))
    yield "SetTransferFunction2D", table, first("two values")
    yield "DeepCopy", lambda s: s["property"].DeepCopy(other()), first("property")


def isovalue_changes():
    def isovalue(value):
        return lambda s: s["property"].GetIsoSurfaceValues().SetValue(0, value)

    yield "GetIsoSurfaceValues().SetValue", isovalue(110), isovalue(scenes.ISOVALUES[0])


def volume_changes():
    def other_property(s):
        look = vtkVolumeProperty()
        look.DeepCopy(s["property"])
        look.SetAmbient(0.5)
        s["volume"].SetProperty(look)

    def other_mapper(s):
        mapper = varimarch.vtkVariationFieldVolumeMapper()
        mapper.SetInputData(s["image"])
        scenes.with_fixed_steps({"mapper": mapper})
        s["volume"].SetMapper(mapper)

    def bgra(s):
        code = "vec4 Windowed(vec4 picture) { return picture.bgra; }"
        shaders = s["volume"].GetShaderProperty()
        shaders.AddFragmentShaderReplacement("//Varimarch::Window", True, code, False)

    def uniform(s):
        shaders = s["volume"].GetShaderProperty()
        code = "vec4 Windowed(vec4 picture) { return picture * dim; }"
        shaders.AddFragmentShaderReplacement("//Varimarch::Window", True, code, False)
        shaders.GetFragmentCustomUniforms().SetUniformf("dim", 0.5)

    yield "SetProperty", other_property, first("volume's property")
    yield "SetMapper", other_mapper, first("mapper")
    yield "SetUserMatrix", to("volume", "SetUserMatrix", matrix(12)), first("matrix")
    yield "SetUserTransform", to("volume", "SetUserTransform", turned()), first("matrix")
    yield "SetShaderProperty", bgra, first("shaders")
    yield "SetShaderProperty", uniform, first("shaders")
    for method, there in (
        ("RotateX", (10,)),
        ("RotateY", (10,)),
        ("RotateZ", (10,)),
        ("RotateWXYZ", (10, 1, 1, 0)),
        ("AddPosition", (1, 2, 3)),
        ("AddOrientation", (5, 6, 7)),
    ):
        yield method, to("volume", method, *there), first("place")


def matrix_changes():
    yield "SetElement", to("matrix", "SetElement", 0, 1, 0.3), to("matrix", "Identity")
    yield "SetElement", to("matrix", "SetElement", 2, 2, 1.5), to("matrix", "Identity")
    yield "DeepCopy", to("matrix", "DeepCopy", matrix(20)), to("matrix", "Identity")


def renderer_changes():
    def extra_light(s):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(0, -80, 20)
        s["renderer"].AddLight(light)

    def other_camera(s):
        camera = vtkCamera()
        camera.DeepCopy(s["camera"])
        camera.Azimuth(20)
        s["renderer"].SetActiveCamera(camera)

    def with_ball(s):
        s["renderer"].AddActor(s["ball"])

    yield "AddLight", extra_light, first("lights")
    yield "RemoveLight", lambda s: s["renderer"].RemoveLight(s["lamp"]), first("lights")
    yield "RemoveAllLights", to("renderer", "RemoveAllLights"), first("lights")
    yield "SetActiveCamera", other_camera, first("camera")
    yield "AddActor", with_ball, first("ball")
    yield "RemoveActor", lambda s: s["renderer"].RemoveActor(s["ball"]), first("ball")
    yield "SetViewport", to("renderer", "SetViewport", 0, 0, 0.9, 1), first("viewport")


def camera_changes():
    for method, amount in (
        ("Azimuth", 3),
        ("Elevation", -4),
        ("Roll", 5),
        ("Yaw", 2),
        ("Pitch", 1),
        ("Dolly", 1.1),
        ("Zoom", 1.2),
    ):
        yield method, to("camera", method, amount), first("view")
    yield "SetClippingRange", lambda s: s["camera"].SetClippingRange(50, 65), first("view")
    yield "ApplyTransform", to("camera", "ApplyTransform", turned(5)), first("view")
    for setter in ("SetUserTransform", "SetUserViewTransform"):
        yield setter, to("camera", setter, turned(4)), to("camera", setter, None)
    setter = "SetModelTransformMatrix"
    yield setter, to("camera", setter, matrix(5)), to("camera", setter, matrix(0))

    def explicit(s):
        matrix = scenes.projection(s["camera"], 0.9)
        s["camera"].SetExplicitProjectionTransformMatrix(matrix)
        s["camera"].UseExplicitProjectionTransformMatrixOn()

    setter = "SetExplicitProjectionTransformMatrix"
    yield setter, explicit, to("camera", "UseExplicitProjectionTransformMatrixOff")
    oblique = to("camera", "SetObliqueAngles", 60, 70)
    yield "SetObliqueAngles", oblique, to("camera", "SetViewShear", 0, 0, 1)


def light_changes(light):
    key = varimarch.vtkVariationFieldVolumeMapper.LIGHT_SOFTNESS()

    def soft(s):
        s[light].GetInformation().Set(key, 4.0)

    def sharp(s):
        s[light].GetInformation().Remove(key)

    yield "GetInformation().Set", soft, sharp
    # Renderers move lights that are at the camera.
    for kind in ("Headlight", "CameraLight", "SceneLight"):
        yield f"SetLightTypeTo{kind}", to(light, f"SetLightTypeTo{kind}"), first(light)
    yield "SetLightType", to(light, "SetLightType", 2), first(light)
    yield "SetColor", to(light, "SetColor", 0.2, 0.9, 0.4), first(light)
    yield "SetDirectionAngle", to(light, "SetDirectionAngle", 20, 40), first(light)
    yield "SetTransformMatrix", to(light, "SetTransformMatrix", matrix(30)), first(light)
    yield "DeepCopy", lambda s: s[light].DeepCopy(s["lamp" if light == "sun" else "sun"]), first(light)


def plane_changes(plane):
    yield "Push", to(plane, "Push", 1.5), to(plane, "Push", -1.5)
    yield "SetTransform", to(plane, "SetTransform", turned()), to(plane, "SetTransform", None)


def array_changes(name, size=scenes.SIZE):
    """Numbers of an image in place, and its shape."""

    def mirror(s):
        numbers = numbers_of(s[name])
        numbers[...] = numbers[::-1].copy()
        s[name].GetPointData().GetScalars().Modified()

    yield "GetPointData().Modified", mirror, mirror
    def one_number(setter):
        def make(s):
            getattr(s[name], setter)(*(i // 2 for i in size), 0, 2)
            s[name].Modified()  # the method does not say so itself

        return make

    for setter in ("SetScalarComponentFromDouble", "SetScalarComponentFromFloat"):
        yield setter, one_number(setter), first(f"{name}'s numbers")
    yield "SetDimensions", to(name, "SetDimensions", *size[1::-1], size[2]), to(name, "SetDimensions", *size)
    turn = to(name, "SetDirectionMatrix", directions(1))
    yield "SetDirectionMatrix", turn, to(name, "SetDirectionMatrix", directions(0))


def ghost_changes():
    def hollow(s):
        s["image"].AllocatePointGhostArray()
        flags = s["image"].GetPointGhostArray()
        for point in range(1500, 2500):
            flags.SetValue(point, 2)  # vtkDataSetAttributes::HIDDENPOINT
        flags.Modified()

    def whole(s):
        s["image"].GetPointData().RemoveArray("vtkGhostType")

    yield "AllocatePointGhostArray", hollow, whole


def coordinate_changes():
    """Places of a rectilinear grid, in place."""

    def stretch(factor):
        def make(s):
            coordinates = s["image"].GetXCoordinates()
            for i in range(coordinates.GetNumberOfTuples()):
                coordinates.SetValue(i, coordinates.GetValue(i) * factor)
            coordinates.Modified()

        return make

    def with_coordinates(axis, shift):
        def make(s):
            coordinates = vtkFloatArray()
            for i in range(scenes.SIZE["XYZ".index(axis)]):
                coordinates.InsertNextValue(i + shift * i * i)
            getattr(s["image"], f"Set{axis}Coordinates")(coordinates)

        return make

    yield "GetXCoordinates().Modified", stretch(2.0), stretch(0.5)
    for axis in "XYZ":
        yield f"Set{axis}Coordinates", with_coordinates(axis, 0.05), with_coordinates(axis, 0.02)


def function_changes(name, add):
    """The methods of a transfer function, all taken back by its first nodes."""
    back = first(f"{name}'s nodes")
    for method, arguments in add:
        yield method, to(name, method, *arguments), back
    yield "AdjustRange", to(name, "AdjustRange", (20.0, 200.0)), back
    yield "RemoveAllPoints", to(name, "RemoveAllPoints"), back


def opacity_changes(name):
    table = (0, 255, 4, [0.0, 0.02, 0.1, 0.05], 1)
    add = (
        ("AddPoint", (90, 0.08)),
        ("AddSegment", (80, 0.02, 200, 0.1)),
        ("SetNodeValue", (1, [40.0, 0.05, 0.5, 0.0])),
        ("RemovePointByIndex", (1,)),
        ("RemovePoint", (255.0,)),
        ("BuildFunctionFromTable", table),
        ("DeepCopy", (scenes.opacity(0.03),)),
        ("ShallowCopy", (scenes.opacity(0.04),)),
    )
    return function_changes(name, add)


def color_changes(name):
    table = (0, 255, 2, [0.2, 0.4, 0.9, 0.9, 0.1, 0.1])
    add = (
        ("AddRGBPoint", (170, 0.1, 0.9, 0.2)),
        ("AddHSVPoint", (170, 0.6, 0.9, 0.8)),
        ("AddRGBSegment", (100, 0, 0, 1, 200, 0, 1, 0)),
        ("AddHSVSegment", (100, 0.1, 1, 1, 200, 0.6, 1, 1)),
        ("SetNodeValue", (1, [120.0, 0.2, 0.4, 0.9, 0.3, 0.2])),
        ("RemovePoint", (120.0,)),
        ("BuildFunctionFromTable", table),
        ("DeepCopy", (scenes.color(0.5),)),
        ("ShallowCopy", (scenes.color(0.4),)),
    )
    return function_changes(name, add)


OWN = {
    "mapper": [*mapper_changes()],
    "property": [*property_changes(), *isovalue_changes()],
    "volume": [*volume_changes()],
    "matrix": [*matrix_changes()],
    "renderer": [*renderer_changes()],
    "camera": [*camera_changes()],
    "sun": [*light_changes("sun")],
    "lamp": [*light_changes("lamp")],
    "plane": [*plane_changes("plane")],
    "slice": [*plane_changes("slice")],
    "image": [*array_changes("image"), *ghost_changes(), *coordinate_changes()],
    "mask": [*array_changes("mask")],
    "two values": [*array_changes("two values", scenes.TABLE_SIZE)],
    "opacity": [*opacity_changes("opacity")],
    "gradient": [*opacity_changes("gradient")],
    "label opacity": [*opacity_changes("label opacity")],
    "color": [*color_changes("color")],
}
