#include "Scene/Json/SceneFields.h"

#include "Scene/Looks/LookFormats/LookContext.h"
#include "Scene/Looks/LookRegions.h"
#include "Scene/Looks/Presets.h"

namespace varimarch
{

namespace
{

template <class Node>
void RequireOrder(const JsonCursor& json, const std::vector<Node>& nodes)
{
  if (nodes.size() > 1 && nodes.back().value < nodes[nodes.size() - 2].value)
  {
    json.At("value").Fail("expected nodes in the order of their values, found one below the "
                          "node before it");
  }
}

// Adds the shape of the curve to the next node, which files have only if it is unusual.
template <class Node>
void AddShape(Fields<Node>& fields)
{
  const auto isUsual = [](const Node& node)
  {
    return node.shape.midpoint == NodeShape().midpoint &&
      node.shape.sharpness == NodeShape().sharpness;
  };
  const auto add = [&](const char* key, double NodeShape::*member, const FieldText& text)
  {
    const JsonForm<double> form = NumberForm(UnitInterval);
    fields
      .AddField(
        key, text, form.describe,
        [=](const JsonCursor& json, Node& node) { form.read(json, node.shape.*member); },
        [=](const Node& node) { return std::optional(form.write(node.shape.*member)); })
      .OmitIf(isUsual);
  };
  add("midpoint", &NodeShape::midpoint,
    { "the part of the way to the next node at which the curve is half way", "", "0.5" });
  add("sharpness", &NodeShape::sharpness,
    { "0 for a linear curve, 1 for a step at the midpoint", "", "0" });
}

const Fields<ColorNode>& ColorNodeFields()
{
  static const Fields<ColorNode> fields("colorNode",
    [](Fields<ColorNode>& list)
    {
      list.Require("value", &ColorNode::value, NumberForm(), { "the value" });
      list.Require("rgb", &ColorNode::rgb, ColorForm(), { "red, green, blue, each from 0 to 1" });
      AddShape(list);
    });
  return fields;
}

const Fields<OpacityNode>& OpacityNodeFields()
{
  static const Fields<OpacityNode> fields("opacityNode",
    [](Fields<OpacityNode>& list)
    {
      list.Require("value", &OpacityNode::value, NumberForm(),
        { "the value, or the magnitude of the gradient" });
      list.Require("opacity", &OpacityNode::opacity, NumberForm(UnitInterval),
        { "opacity over the look's unit distance, or a factor of it, 0 to 1" });
      AddShape(list);
    });
  return fields;
}

const Fields<Shading>& ShadingFields()
{
  static const Fields<Shading> fields("shading",
    [](Fields<Shading>& list)
    {
      list.Add("enabled", &Shading::enabled, BooleanForm(), { "`true` lights the volume" });
      list.Add("ambient", &Shading::ambient, NumberForm(UnitInterval),
        { "the part of the light that comes from everywhere, 0 to 1" });
      list.Add("diffuse", &Shading::diffuse, NumberForm(UnitInterval),
        { "the part that surfaces scatter to all sides, 0 to 1" });
      list.Add("specular", &Shading::specular, NumberForm(UnitInterval),
        { "the part that surfaces mirror, 0 to 1" });
      list.Add("specularPower", &Shading::specularPower, NumberForm({ 1.0, 1000.0 }),
        { "the exponent of the mirrored part, 1 to 1000: the larger, the smaller highlights are" });
    });
  return fields;
}

const Fields<Isosurface>& IsosurfaceFields()
{
  static const Fields<Isosurface> fields("isosurface",
    [](Fields<Isosurface>& list)
    {
      list.Require("value", &Isosurface::value, NumberForm(), { "the value of the surface" });
      list.Require("rgb", &Isosurface::rgb, ColorForm(), { "red, green, blue, each from 0 to 1" });
      list.Add("opacity", &Isosurface::opacity, NumberForm(UnitInterval),
        { "its opacity, however thick the material behind it, 0 to 1" });
    });
  return fields;
}

const Fields<LookChannel>& ChannelFields()
{
  static const Fields<LookChannel> fields("channel",
    [](Fields<LookChannel>& list)
    {
      list.Add("name", &LookChannel::name, TextForm(), { "for people", "", "that of the file" });
      list.Add("rgb", &LookChannel::rgb, ColorForm(),
        { "its colour, in place of the colours of the look", "",
          "none; without `channels`, that of the file, or else green, magenta, blue and amber" });
      list.Add("visible", &LookChannel::visible, BooleanForm(), { "`true` or `false`" });
      list.Add("opacity", &LookChannel::opacity, NumberForm(UnitInterval),
        { "factor of the opacities, from 0 to 1" });
      list.Add("window", &LookChannel::window,
        Checked(NumbersForm<2>(), &IsAscending<2>,
          "expected the smaller value first, found the larger one or two equal ones"),
        { "the values that look as the first and the last value of `opacities` do; the curves are "
          "stretched between them",
          "", "the look's own; with a `domain` other than `data`, those of this channel" });
    });
  return fields;
}

JsonForm<std::array<double, 2>> SideForm(const NumberRange& range)
{
  return Checked(NumbersForm<2>(range), &IsAscending<2>,
    "expected the smaller end first, found the larger one or two equal ones");
}

const Fields<LookRegion>& RegionFields()
{
  static const Fields<LookRegion> fields("region",
    [](Fields<LookRegion>& list)
    {
      list.Require("shape", &LookRegion::shape, ChoiceForm(RegionShapeNames()),
        { "`rectangle` or `ellipse`, which touches the sides of that rectangle" });
      list.Require("values", &LookRegion::values, SideForm({}), { "the first and the last value" });
      list.Require("gradients", &LookRegion::gradients, SideForm({ 0.0 }),
        { "the smallest and the largest magnitude of the gradient, in units of the look's values "
          "per mm" });
      list.Require("rgb", &LookRegion::rgb, ColorForm(), { "red, green, blue, each from 0 to 1" });
      list.Require("opacity", &LookRegion::opacity, NumberForm(UnitInterval),
        { "opacity over the look's unit distance, 0 to 1" });
      list.Add("softness", &LookRegion::softness, NumberForm(UnitInterval),
        { "the part of the way from the edge to the middle over which the opacity falls to 0, from "
          "0 "
          "to 1; a rectangle that begins at the gradient 0 has no edge there" });
    });
  return fields;
}

JsonForm<std::vector<OpacityNode>> OpacitiesForm()
{
  return ListForm(ObjectForm(&OpacityNodeFields), 1, MostLookNodes, &RequireOrder<OpacityNode>);
}

void AddCurveFields(Fields<Look>& fields)
{
  fields.Add("name", &Look::name, TextForm(), { "for people" });
  fields.Add("description", &Look::description, TextForm(), { "for people: one line of text" });
  fields.Add("domain", &Look::domain, ChoiceForm(DomainNames()),
    { "the meaning of the nodes' values", "", nullptr,
      ". `data`: they are the volume's, such as Hounsfield units. `relative`: 0 is the volume's "
      "1st percentile and 1 its 99.9th, for MR, whose values have no unit. `hounsfield`: "
      "Hounsfield units; in a volume without negative values they are spread over what its "
      "histogram says is air, soft tissue and bone" });
  fields.Require("colors", &Look::colors,
    ListForm(ObjectForm(&ColorNodeFields), 1, MostLookNodes, &RequireOrder<ColorNode>),
    { "nodes in the order of their values: `value`, `rgb`" });
  fields.Require(
    "opacities", &Look::opacities, OpacitiesForm(), { "nodes: `value`, `opacity` from 0 to 1" });
  fields
    .Add("lengths", &Look::lengths, ChoiceForm(LengthsNames()),
      { "the meaning of the distance in `opacityUnitDistance`, and of the lengths in gradients", "",
        "`millimetres`",
        ". `millimetres`: as given. `relative`, as in the presets: they suit a patient, and hold "
        "where the file is about one (DICOM, NIfTI and other formats of patients, NRRD and "
        "MetaImage that name the patient's sides) or the values are Hounsfield units, and the "
        "longest side is 20 mm to 3 m. In any other volume they are as long in proportion, as if a "
        "cube as large had a side of 200 mm. What is saved are the millimetres that were found; "
        "`varimarch info` and `render` tell them" })
    .OmitDefault();
  fields.Add("opacityUnitDistance", &Look::opacityUnitDistanceMm, NumberForm(Positive),
    { "the distance in which a node's opacity is reached", "mm" });
}

void AddMoreLookFields(Fields<Look>& fields)
{
  fields
    .Add("channels", &Look::channels, ListForm(ObjectForm(&ChannelFields), 1, MostChannels),
      { "the components of a volume with two to four that are independent, in their order: see "
        "below",
        "", "each in its window and colour" })
    .OmitDefault();
  fields
    .Add("gradientOpacities", &Look::gradientOpacities, OpacitiesForm(),
      { "nodes as in `opacities`: factors of the opacity; `value` is the magnitude of the "
        "gradient, "
        "in units of the look's values per mm; composites only" })
    .OmitDefault();
  fields
    .Add("regions", &Look::regions, RegionsForm(),
      { "a transfer function of value and gradient magnitude, in place of `colors`, `opacities` "
        "and "
        "`gradientOpacities`: parts of that plane, of which later ones lie over earlier ones; "
        "composites of one component only, not by VTK's CPU mapper; segments of a label map keep "
        "their own colours" })
    .OmitDefault();
  fields.Add("shading", &Look::shading, ObjectForm(&ShadingFields),
    { "Blinn-Phong under the scene's `lights`", "", "on, 0.2, 0.8, 0.2, 16" });
  fields
    .Add("damping", &Look::dampingGradient, NumberForm({ 0.0 }),
      { "the magnitude of the gradient below which diffuse and specular light are reduced in "
        "proportion, in units of the look's values per mm",
        "", "0, none", ": noise in homogeneous material does not glitter" })
    .OmitDefault()
    .Option("--damping", "G")
    .Argument();
  fields
    .Add("blend", &Look::blend, ChoiceForm(BlendNames()),
      { "the blend mode: how the samples of a ray become a pixel", "", nullptr,
        ": `composite`; `maximum` or `minimum`, of the values, seen through the look; `average` or "
        "`additive`, the mean or the integral of opacity times value, in grey from the smallest to "
        "the largest voxel, without those far beyond the averaged range; `isosurface`, the "
        "surfaces of `isosurfaces`" })
    .Option("--blend");
  fields
    .Add("isosurfaces", &Look::isosurfaces,
      ListForm(ObjectForm(&IsosurfaceFields), 1, MostLookNodes, &RequireOrder<Isosurface>),
      { "surfaces of equal value in the order of their values, at least one for that blend mode: "
        "`value`, `rgb`, `opacity` (default 1)" })
    .OmitDefault();
  fields.Add("averagedRange", &Look::averagedRange,
    Checked<std::array<double, 2>>(
      NumbersForm<2>(), [](const std::array<double, 2>& range) { return range[0] <= range[1]; },
      "expected the smaller value first, found the larger first"),
    { "the first and the last value that counts in an average", "", "all" });
}

const Fields<Lighting>& LightingFields()
{
  static const Fields<Lighting> fields(
    "lighting", [](Fields<Lighting>& list) { AddLightFields(list); });
  return fields;
}

}

JsonForm<std::vector<LookRegion>> RegionsForm()
{
  return ListForm(ObjectForm(&RegionFields), 1, MostRegions);
}

const Fields<Look>& LookFields()
{
  static const Fields<Look> fields("look",
    [](Fields<Look>& list)
    {
      AddCurveFields(list);
      AddMoreLookFields(list);
      list.AddCheck(
        [](const JsonCursor& json, const Look& look)
        {
          if (look.blend == Blend::Isosurface && look.isosurfaces.empty())
          {
            json.Fail("the blend mode \"isosurface\" expects the key \"isosurfaces\", found none");
          }
        });
    });
  return fields;
}

const Fields<Preset>& PresetFields()
{
  static const Fields<Preset> fields("look",
    [](Fields<Preset>& list)
    {
      list.AddAllOf(&Preset::look, LookFields());
      list.Add("errorTolerance", &Preset::errorTolerance, NumberForm(UnitInterval),
        { "the scene's, if it has none of its own: as in `render`" });
      list.Add("background", &Preset::background, NumbersForm<3>(UnitInterval),
        { "the scene's, if it has none of its own: red, green, blue" });
      list.Add("light", &Preset::light, ObjectForm(&LightingFields),
        { "the light that suits the look, which scenes take only on request (`--preset-light`): "
          "`lights`, `shadows`, `scattering` and `occlusion` as in a scene" });
    });
  return fields;
}

JsonForm<Preset> PresetForm()
{
  const JsonForm<Preset> object = ObjectForm(&PresetFields);
  return { [=](const JsonCursor& json, Preset& preset)
    {
      preset = {};
      if (!json.IsText())
      {
        object.read(json, preset);
        return;
      }
      const std::string name = json.Text();
      if (!IsPresetName(name))
      {
        json.Fail("unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
      }
      preset = BuiltInPreset(name);
    },
    object.write,
    [=](FormatDescription& format)
    {
      return nlohmann::ordered_json{ { "oneOf",
        { nlohmann::ordered_json{ { "enum", PresetNames() } }, object.describe(format) } } };
    } };
}

}
