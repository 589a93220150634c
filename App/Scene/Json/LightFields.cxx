#include "Scene/Json/SceneFields.h"

#include "Scene/Model/SceneLights.h"

namespace varimarch
{

namespace
{

bool HasDirection(const SceneLight& light)
{
  return light.kind == LightKind::Camera || light.kind == LightKind::Directional;
}

// Each kind of light has its own keys, so that a place that it ignores is an error.
const Fields<SceneLight>& SceneLightFields()
{
  static const Fields<SceneLight> fields("light",
    [](Fields<SceneLight>& list)
    {
      list.Require("kind", &SceneLight::kind, ChoiceForm(LightKindNames()),
        { "where it is: `head`, at the eye; `camera`, far away in a direction that turns with the "
          "camera; `directional`, far away in a direction that is fixed in the patient; "
          "`positional`, at a point" });
      list
        .Require("direction", &SceneLight::direction,
          Checked(NumbersForm<3>(), &HasLength,
            "expected a vector towards the light, found one of length 0"),
          { "of `camera` and `directional`: a vector of any length towards the light; to the "
            "right, "
            "upwards and towards the eye, or in LPS" })
        .OnlyIf(&HasDirection);
      list
        .Require("position", &SceneLight::positionMm, NumbersForm<3>(),
          { "of `positional`: the point", "mm, LPS" })
        .OnlyIf([](const SceneLight& light) { return light.kind == LightKind::Positional; });
      list.Add("color", &SceneLight::rgb, NumbersForm<3>(UnitInterval),
        { "red, green, blue, each from 0 to 1", "", "white" });
      list.Add("intensity", &SceneLight::intensity, NumberForm({ 0.0, 1000.0, true }),
        { "a factor of the colour, above 0" });
      list
        .Add("softness", &SceneLight::softnessDegrees, NumberForm({ 0.0, LargestSoftnessDegrees }),
          { "half the angle of the cone that a light other than at the eye comes from, 0 to 60 "
            "degrees: the softness of its shadows",
            "", "0" })
        .OmitDefault()
        .OnlyIf([](const SceneLight& light) { return light.kind != LightKind::Head; });
    });
  return fields;
}

// Whether there are shadows, or their strength.
JsonForm<double> ShadowsForm()
{
  return { [](const JsonCursor& json, double& strength)
    { strength = json.IsBoolean() ? double(json.Boolean()) : json.Number(UnitInterval); },
    [](const double& strength)
    { return strength == 1.0 ? nlohmann::ordered_json(true) : nlohmann::ordered_json(strength); },
    [](FormatDescription& format)
    {
      return nlohmann::ordered_json{ { "oneOf",
        { BooleanForm().describe(format), SchemaOf(UnitInterval) } } };
    } };
}

const Fields<Scattering>& ScatteringFields()
{
  static const Fields<Scattering> fields("scattering",
    [](Fields<Scattering>& list)
    {
      list
        .Require("blending", &Scattering::blending, NumberForm({ 0.0, 2.0 }),
          { "the part of the light that matter scatters and surfaces do not reflect, 0 to 2 as in "
            "VTK; all from 1 on",
            "", "0" })
        .Option("--scattering", "B")
        .Argument();
      list
        .Add("anisotropy", &Scattering::anisotropy, NumberForm({ -0.99, 0.99 }),
          { "mean cosine of the angle by which it turns light, -0.99 (back) to 0.99 (straight "
            "on)" })
        .Option("--anisotropy", "G")
        .Argument();
      list
        .Add("reach", &Scattering::reach, NumberForm(UnitInterval),
          { "how far matter dims scattered light, 0 (not at all) to 1 (everywhere)", "", nullptr,
            "; with `shadows` all dims" })
        .Option("--scattering-reach", "R")
        .Argument();
    });
  return fields;
}

const Fields<Occlusion>& OcclusionFields()
{
  static const Fields<Occlusion> fields("occlusion",
    [](Fields<Occlusion>& list)
    {
      list
        .Require("strength", &Occlusion::strength, NumberForm(UnitInterval),
          { "ambient occlusion: how much darker places are that see little of what is around the "
            "volume, 0 to 1",
            "", "0" })
        .Option("--occlusion", "S")
        .Argument();
      list
        .Add("reach", &Occlusion::reachMm, NumberForm({ 0.0 }),
          { "the distance beyond which matter does not occlude", "mm", "0, which is 16 voxels" })
        .Option("--occlusion-reach", "MM")
        .Argument();
    });
  return fields;
}

}

template <class Lit>
void AddLightFields(Fields<Lit>& fields)
{
  fields
    .Add("lights", &Lit::lights, ListForm(ObjectForm(&SceneLightFields), 0, MostLights),
      { "the lights on a shaded volume", "", "a white one at the eye" })
    .OmitDefault();
  fields
    .Add("shadows", &Lit::shadows, ShadowsForm(),
      { "strength of the shadows that volumes cast on themselves and on each other, from lights "
        "that are not at the eye, 0 (none) to 1 (no light of a lamp is left where none arrives)",
        "", "0",
        "; `true` is 1. Shaded volumes show them; an image takes about three times as long (VTK's "
        "mappers cast none)" })
    .OmitDefault()
    .Option("--shadow-strength", "S");
  fields
    .Add("scattering", &Lit::scattering, ObjectForm(&ScatteringFields),
      { "light that matter scatters, of a shaded composite (VTK's mappers have none)", "", "off" })
    .OmitIf([](const Lit& lit) { return !(lit.scattering.blending > 0.0); });
  fields
    .Add("occlusion", &Lit::occlusion, ObjectForm(&OcclusionFields),
      { "ambient occlusion of a composite (VTK's mappers have none)", "", "off" })
    .OmitIf([](const Lit& lit) { return !(lit.occlusion.strength > 0.0); });
}

template void AddLightFields(Fields<Scene>&);
template void AddLightFields(Fields<Lighting>&);

}
