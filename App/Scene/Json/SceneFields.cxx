#include "Scene/Json/SceneFields.h"

#include "Scene/Looks/Presets.h"

namespace varimarch
{

namespace
{

// Far more than anybody draws by hand.
constexpr std::size_t MostCuts = 1000;
constexpr std::size_t MostOutlinePoints = 100000;

constexpr double MostTurnDegrees = 180.0;

// All relevant OpenGL versions guarantee 2D textures of at least this size.
constexpr int LargestPictureSide = 16384;

const NameTable<bool>& KeptNames()
{
  static const NameTable<bool> table = { { "outside", false }, { "inside", true } };
  return table;
}

const Fields<CameraPose>& PoseFields()
{
  static const Fields<CameraPose> fields("pose",
    [](Fields<CameraPose>& list)
    {
      list.Require("position", &CameraPose::positionMm, NumbersForm<3>(), { "the eye", "mm, LPS" });
      list.Require("focalPoint", &CameraPose::focalPointMm, NumbersForm<3>(),
        { "the point that it looks at", "mm, LPS" });
      list.Require("viewUp", &CameraPose::viewUp, NumbersForm<3>(),
        { "the direction that is up in the image, LPS" });
      list.Require("parallelScale", &CameraPose::parallelScaleMm, NumberForm(Positive),
        { "half the height of a parallel image", "mm" });
    });
  return fields;
}

const Fields<CutPlane>& PlaneFields()
{
  static const Fields<CutPlane> fields("plane",
    [](Fields<CutPlane>& list)
    {
      list.Require(
        "point", &CutPlane::pointMm, NumbersForm<3>(), { "a point of the plane", "mm, LPS" });
      list.Require("normal", &CutPlane::normal,
        Checked(NumbersForm<3>(), &HasLength, "expected a direction, found 0, 0, 0"),
        { "a vector of any length to the side that stays" });
    });
  return fields;
}

const Fields<ScissorsCut>& ScissorsFields()
{
  static const Fields<ScissorsCut> fields("scissors",
    [](Fields<ScissorsCut>& list)
    {
      list.Require("camera", &ScissorsCut::camera,
        Checked<Camera>(
          ObjectForm(&CameraFields), [](const Camera& camera) { return bool(camera.pose); },
          "expected the key \"pose\", found none"),
        { "the camera of the image that the outline was drawn on, with a `pose`" });
      list.Require("outline", &ScissorsCut::outline,
        ListForm(NumbersForm<2>(), 3, MostOutlinePoints),
        { "a polygon over that image, whose points are measured from the middle of the image, to "
          "the right and upwards, in halves of its height" });
      list.Add("keep", &ScissorsCut::keepsInside, ChoiceForm(KeptNames()),
        { "the part that stays: `outside` or `inside`" });
    });
  return fields;
}

const Fields<KeyImage>& KeyImageFields()
{
  static const Fields<KeyImage> fields("keyImage",
    [](Fields<KeyImage>& list)
    {
      list.Require("view", &KeyImage::view, ChoiceForm(KeyViewNames()),
        { "`volume`, `axial`, `coronal` or `sagittal`" });
      list.Require("name", &KeyImage::name, TextForm(), { "for people" });
      list.Require("slices", &KeyImage::slices, ObjectForm(&SlicesFields), { "as they were" });
      list.Require("camera", &KeyImage::camera, ObjectForm(&CameraFields), { "as it was" });
      list.Add("time", &KeyImage::time, IntegerForm(0),
        { "of a volume with several times: the one that was shown, counted from 0" });
    });
  return fields;
}

void AddSampling(Fields<RenderOptions>& fields)
{
  using Options = RenderOptions;
  fields
    .Add("sampleDistance", &Options::sampleDistanceMm, NumberOrAutoForm(Positive),
      { "the distance between the samples of a ray", "mm", nullptr, ", or `\"auto\"`" })
    .Option("--sample-distance", "MM");
  fields
    .Add("errorTolerance", &Options::errorTolerance, NumberForm(UnitInterval),
      { "the largest accepted error of a premultiplied colour channel, 0 to 1", "",
        "the look's; else 1/64",
        ", with an automatic sample distance; 0: by the spacing of the voxels alone" })
    .Option("--error-tolerance", "E")
    .Argument();
  fields
    .Add("acceleration", &Options::acceleration, ChoiceForm(AccelerationNames()),
      { "the field by which our mapper skips samples", "", nullptr,
        ": `off`, `cells`, `variation`, `optical`; `variation` is the published field of "
        "`Documentation/Published.md`" })
    .Option("--acceleration");
  fields
    .Add("integration", &Options::integration, ChoiceOrAutoForm(IntegrationNames()),
      { "the rule that integrates composites between samples", "", nullptr,
        ": `midpoint`, `pre-integrated`, `simpson`, `published-sum`, `first-hit`, or `\"auto\"`; "
        "with shading, `pre-integrated` and `simpson` take values and gradients as linear between "
        "samples; the two published rules, `published-sum` and `first-hit`, are refused with "
        "shading, gradient opacities, ambient occlusion, several components or volumes, labels and "
        "nearest interpolation" })
    .Option("--integration");
  fields
    .Add("variationTolerance", &Options::variationTolerance, NumberOrAutoForm({ 0.0 }),
      { "the difference of values by which the fields of cells and of variations limit steps, in "
        "units of the data",
        "", nullptr,
        ", or `\"auto\"`; for `cells`: the largest difference between the values of a block that a "
        "ray crosses in one step; for `variation`: the difference that a voxel within a step must "
        "stay below" })
    .Option("--tolerance", "E");
  fields
    .Add("earlyTermination", &Options::earlyTerminationTransmittance,
      NumberForm({ 0.0, 1.0, false, true }),
      { "the transmittance below which a ray ends, if the error tolerance is 0: from 0 to less "
        "than 1",
        "", "1/1024" })
    .Option("--early-termination", "T")
    .Argument();
}

void AddVoxelsAndSteps(Fields<RenderOptions>& fields)
{
  using Options = RenderOptions;
  fields
    .Add("interpolation", &Options::interpolation, ChoiceForm(InterpolationNames()),
      { "the values between the voxels", "", nullptr,
        ": `nearest`, `linear`, or `cubic`, a spline without staircases (isosurfaces and VTK's "
        "mappers are then linear)" })
    .Option("--interpolation")
    .Argument();
  fields
    .Add("detail", &Options::level, ChoiceForm(LevelNames()),
      { "the detail of a volume that is drawn from its file: `voxels`, `coarse`, the means of 4 x "
        "4 x 4 voxels, which are in memory, `refined`, which is `coarse` at first and then takes "
        "voxels where the image needs them, in rounds, or `automatic`, which is `coarse` while "
        "somebody interacts and `voxels` otherwise" })
    .Option("--detail");
  fields
    .Add("jitter", &Options::jitter, BooleanForm(),
      { "offset the samples of each ray by blue noise, which turns the rings of long steps into "
        "grain" })
    .Option("--jitter")
    .Argument();
  fields
    .Add("sampleDistanceVoxels", &Options::sampleDistanceVoxels, NumberOrAutoForm(Positive),
      { "the distance between samples in units of the smallest voxel spacing", "", nullptr,
        ", instead of `sampleDistance`, or `\"auto\"`" })
    .Option("--sample-distance-voxels", "N");
  fields
    .Add("steps", &Options::mostSteps, IntegerForm(0),
      { "with a given sample distance: the number of these distances after which a ray ends", "",
        "0, no limit", ", for `first-hit` the number of samples behind the hit" })
    .Option("--steps", "N");
  fields
    .Add("firstDistance", &Options::firstDistanceMm, NumberForm({ 0.0 }),
      { "the distance from the eye at which rays begin, for an eye in the volume", "mm" })
    .Option("--first-distance", "MM");
}

void AddViewFields(Fields<Scene>& fields)
{
  fields.Add("camera", &Scene::camera, ObjectForm(&CameraFields),
    { "the position of the eye", "", "in front of the patient" });
  fields.Add("cuts", &Scene::cuts, ObjectForm(&CutsFields),
    { "the part of the volume that is visible", "", "all of it" });
  fields.Add("slices", &Scene::slices, ObjectForm(&SlicesFields),
    { "settings of the viewer's slices", "", "the middle of the volume" });
  AddMeasureFields(fields);
  fields
    .Add("keyImages", &Scene::keyImages, ListForm(ObjectForm(&KeyImageFields), 0, MostKeyImages),
      { "views that are marked for the report" })
    .OmitDefault();
  fields.Add(
    "labels", &Scene::labels, LabelsForm(), { "a segmentation that is drawn over the volume" });
  fields
    .Add("overlays", &Scene::overlays, OverlaysForm(),
      { "up to three further volumes that are drawn together with the first" })
    .OmitDefault();
}

void AddLook(Fields<Scene>& fields)
{
  const JsonForm<Preset> preset = PresetForm();
  fields
    .AddField(
      "look",
      { "the name of a preset, or an object: the transfer function, with the quality and the "
        "background that suit it" },
      preset.describe,
      [=](const JsonCursor& json, Scene& scene)
      {
        // The preset's settings come first, so that the scene's own keys override them.
        Preset read;
        preset.read(json, read);
        TakePreset(read, scene);
      },
      [](const Scene& scene) { return LookFields().Write(scene.look); })
    .Required();
}

Fields<Scene> MakeSceneFields(bool haveVolume)
{
  Fields<Scene> list("scene");
  // Editors find the schema through "$schema"; it is ignored here.
  list.AddField(
    "$schema", {}, TextForm().describe, [](const JsonCursor&, Scene&) {},
    [](const Scene&) { return std::nullopt; });
  if (haveVolume)
  {
    list.Require("volume", &Scene::volume, VolumeForm(), { "where the voxels come from" });
  }
  AddLook(list);
  AddLightFields(list);
  AddViewFields(list);
  list.Add("render", &Scene::render, ObjectForm(&RenderFields),
    { "the quality", "", "the mapper's choice" });
  list
    .Add("size", &Scene::size, IntegersForm<2>(1, LargestPictureSide),
      { "width and height", "pixels" })
    .Option("--size", "WxH");
  list
    .Add("background", &Scene::background, NumbersForm<3>(UnitInterval),
      { "background colour: red, green, blue, each from 0 to 1", "",
        "the look's; else `[0, 0, 0]`" })
    .Option("--background", "R,G,B");
  return list;
}

}

const Fields<Camera>& CameraFields()
{
  static const Fields<Camera> fields("camera",
    [](Fields<Camera>& list)
    {
      list
        .Add("view", &Camera::view, ChoiceForm(ViewNames()),
          { "the side of the patient that the eye is on", "", nullptr,
            ": `anterior`, `posterior`, `left`, `right`, `superior`, `inferior`; or `automatic`: "
            "the "
            "anterior side or, of a volume that is ten times as thin along one axis as along both "
            "others, its face" })
        .Option("--view")
        .Argument();
      list
        .Add("azimuth", &Camera::azimuthDegrees, NumberForm(),
          { "rotation of the eye about the image's vertical; from anterior, to the patient's left",
            "degrees" })
        .Option("--azimuth", "DEG")
        .Argument();
      list
        .Add("elevation", &Camera::elevationDegrees, NumberForm({ -90.0, 90.0, true, true }),
          { "elevation of the eye after that, between -90 and 90", "degrees" })
        .Option("--elevation", "DEG")
        .Argument();
      list
        .Add("zoom", &Camera::zoom, NumberForm(Positive),
          { "magnification: at 1 the volume's box just fits the image" })
        .Option("--zoom", "Z")
        .Argument();
      list.Add("projection", &Camera::parallel, ChoiceForm(ProjectionNames()),
        { "`perspective` or `parallel`" });
      list.Add("viewAngle", &Camera::viewAngleDegrees, NumberForm({ 0.0, 180.0, true, true }),
        { "vertical angle of the perspective", "degrees" });
      list.Add("pose", &Camera::pose, ObjectForm(&PoseFields),
        { "a camera that was moved by hand, instead of `view`, `azimuth`, `elevation` and "
          "`zoom`" });
      list
        .Add("clippingRange", &Camera::clippingRangeMm,
          Checked(NumbersForm<2>(Positive), &IsAscending<2>,
            "expected the nearer distance first, found the farther one or two equal ones"),
          { "the nearest and the farthest distance from the eye that is drawn", "mm", "all" })
        .Option("--clipping-range", "NEAR,FAR");
    });
  return fields;
}

const Fields<SceneCuts>& CutsFields()
{
  static const Fields<SceneCuts> fields("cuts",
    [](Fields<SceneCuts>& list)
    {
      list.Add("box", &SceneCuts::box, NumbersForm<6>(UnitInterval),
        { "first and last visible position along the volume's axes x, y, z; 0 is the first voxel, "
          "1 "
          "the last" });
      list.Add("planes", &SceneCuts::planes, ListForm(ObjectForm(&PlaneFields), 0, MostCuts),
        { "planes, of which each leaves one side" });
      list.Add("scissors", &SceneCuts::scissors, ListForm(ObjectForm(&ScissorsFields), 0, MostCuts),
        { "outlines that cut through the depth of the volume" });
      list
        .Add("bodyOnly", &SceneCuts::bodyOnly, BooleanForm(),
          { "leave out the table, the head rest, clothes and the air around the body of a CT "
            "scan" })
        .Option("--body-only");
      list
        .Add("faceDepth", &SceneCuts::faceDepthMm, NumberForm({ 0.0 }),
          { "cut the front half of a head away to this depth behind its smoothed surface, such as "
            "15 mm; look at the image: this is no anonymization",
            "", "0, it stays", " (see the user guide; overlays are then not drawn)" })
        .Option("--remove-face", "MM");
    });
  return fields;
}

const Fields<SliceSettings>& SlicesFields()
{
  static const Fields<SliceSettings> fields("slices",
    [](Fields<SliceSettings>& list)
    {
      using Settings = SliceSettings;
      list.Add("crosshair", &Settings::crosshairMm, NumbersForm<3>(),
        { "the point that the planes meet in", "mm, LPS", "the middle" });
      list
        .Add("turn", &Settings::turn, NumbersForm<3>({ -MostTurnDegrees, MostTurnDegrees }),
          { "a rotation of the three planes about the crosshair: its direction is the axis, its "
            "length "
            "the angle in degrees" })
        .OmitDefault();
      list.Add("windowLevel", &Settings::windowLevel, NumbersForm<2>(),
        { "the range of values that is shown and its middle", "", "from the file or the data" });
      list.Add("slab", &Settings::slabMm, NumberForm({ 0.0 }), { "the thickness of a slab", "mm" });
      list.Add("slabBlend", &Settings::slabBlend, ChoiceForm(SlabBlendNames()),
        { "`maximum`, `minimum` or `mean` of its values" });
      list.Add("fusion", &Settings::fusion, ChoiceForm(SliceFusionNames()),
        { "how slices show overlays: `blend` or `checkerboard`" });
      list.Add("fusionOpacity", &Settings::fusionOpacity, NumberForm(UnitInterval),
        { "their part in a blend, 0 to 1" });
      list
        .Add("curveTurn", &Settings::curveTurnDegrees,
          NumberForm({ -MostTurnDegrees, MostTurnDegrees }),
          { "turns the cut along a curve about it", "degrees", "0" })
        .OmitDefault();
    });
  return fields;
}

const Fields<RenderOptions>& RenderFields()
{
  static const Fields<RenderOptions> fields("render",
    [](Fields<RenderOptions>& list)
    {
      AddSampling(list);
      AddVoxelsAndSteps(list);
    });
  return fields;
}

const Fields<Scene>& SceneFields()
{
  static const Fields<Scene> fields = MakeSceneFields(true);
  return fields;
}

const Fields<Scene>& FieldsBesideVolume()
{
  static const Fields<Scene> fields = MakeSceneFields(false);
  return fields;
}

}
