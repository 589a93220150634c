#include "LightOptions.h"

#include "Scene/SceneLights.h"

#include <CLI/CLI.hpp>

#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

constexpr const char* Group = "Look"; // in the help

void AddScatteringOptions(CLI::App& command, SceneArguments& arguments)
{
  command
    .add_option("--scattering", arguments.scattering,
      "The part of the light that matter scatters and surfaces do not reflect, 0 to 2 as in\n"
      "VTK; all from 1 on (default 0)")
    ->check(CLI::Range(0.0, 2.0).description(""))
    ->type_name("B")
    ->group(Group);
  command
    .add_option("--anisotropy", arguments.anisotropy,
      "Mean cosine of the angle by which it turns light, -0.99 (back) to 0.99 (straight on;\n"
      "default 0)")
    ->check(CLI::Range(-0.99, 0.99).description(""))
    ->type_name("G")
    ->group(Group);
  command
    .add_option("--scattering-reach", arguments.scatteringReach,
      "How far matter dims scattered light, 0 (not at all, the default) to 1 (everywhere)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("R")
    ->group(Group);
}

void AddOcclusionOptions(CLI::App& command, SceneArguments& arguments)
{
  command
    .add_option("--occlusion", arguments.occlusion,
      "Ambient occlusion: how much darker places are that see little of what is around\n"
      "the volume, 0 to 1 (default 0)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("S")
    ->group(Group);
  command
    .add_option("--occlusion-reach", arguments.occlusionReachMm,
      "Distance beyond which matter does not occlude, mm (default: 16 voxels)")
    ->check(CLI::NonNegativeNumber.description(""))
    ->type_name("MM")
    ->group(Group);
}

void AddShadowOptions(CLI::App& command, SceneArguments& arguments)
{
  command
    .add_option("--softness", arguments.softnessDegrees,
      "Softness of the shadows of all lights that are not at the eye: half the angle of the\n"
      "cones that they come from, degrees, 0 to 60 (default: the scene's)")
    ->check(CLI::Range(0.0, 60.0).description(""))
    ->type_name("DEG")
    ->group(Group);
  command
    .add_flag_callback(
      "--shadows", [&] { arguments.shadows = 1.0; },
      "Let the volume cast shadows, from lights that are not at the eye; takes about\n"
      "three times as long")
    ->group(Group);
  command
    .add_option("--shadow-strength", arguments.shadows,
      "Strength of these shadows, 0 (none) to 1 (no light of a lamp is left where none\n"
      "arrives; the default with --shadows)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("S")
    ->group(Group);
}

}

void AddLightOptions(CLI::App& command, SceneArguments& arguments)
{
  const auto setLights = [&](const std::vector<std::pair<double, double>>& angles)
  {
    for (const auto& [azimuth, elevation] : angles)
    {
      arguments.lights.push_back(CameraLight(azimuth, elevation));
    }
  };
  command
    .add_option_function<std::vector<std::pair<double, double>>>("--light", setLights,
      "A light this far to the right of and above the eye, degrees; may be repeated\n"
      "(default: at the eye). Scenes have more kinds of lights")
    ->check(CLI::Range(-180.0, 180.0).description(""))
    ->delimiter(',')
    ->type_name("AZ,EL")
    ->group(Group);
  command
    .add_flag("--preset-light", arguments.presetLight,
      "Light the volume in the light that suits its preset; the options of light change it")
    ->group(Group);
  AddShadowOptions(command, arguments);
  command
    .add_option("--damping", arguments.dampingGradient,
      "Gradient below which shading weakens, in units of the look's values per mm")
    ->check(CLI::NonNegativeNumber.description(""))
    ->type_name("G")
    ->group(Group);
  AddScatteringOptions(command, arguments);
  AddOcclusionOptions(command, arguments);
}

}
