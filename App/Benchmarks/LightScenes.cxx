#include "LightScenes.h"

#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/SceneLights.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The direction to the upper right of a camera, fixed in the world.
std::array<double, 3> UpperRightOf(vtkCamera* camera)
{
  const glm::dvec3 toEye = -glm::make_vec3(camera->GetDirectionOfProjection());
  const glm::dvec3 up = glm::make_vec3(camera->GetViewUp());
  const glm::dvec3 direction = toEye + 0.8 * glm::normalize(glm::cross(up, toEye)) + 0.7 * up;
  return { direction.x, direction.y, direction.z };
}

}

const std::vector<LightFeature>& LightFeatures()
{
  static const std::vector<LightFeature> features = {
    { "shadows", "shadows", "light", [](Scene& scene) { scene.shadows = 1.0; } },
    { "occlusion", "ambient occlusion of strength 0.5 and a reach of 16 voxels", "strength",
      [](Scene& scene) { scene.occlusion.strength = 0.5; } },
    { "soft-shadows", "shadows of a light of 10 degrees to either side", "light",
      [](Scene& scene)
      {
        scene.shadows = 1.0;
        scene.lights.front().softnessDegrees = 10.0;
      } },
    { "scattering", "shadows, and half of the light scattered", "light",
      [](Scene& scene)
      {
        scene.shadows = 1.0;
        scene.scattering.blending = 0.5;
      } },
  };
  return features;
}

void AddLightOptions(CLI::App& command, LightCostOptions& options)
{
  AddBenchSceneOptions(command, options.scenes);
  AddSideOption(command, options.side);
  command.add_option("--tolerance", options.errorTolerance, "The error tolerance (default 1/64)")
    ->check(CLI::Range(1e-4, 1.0).description(""))
    ->type_name("ERROR");
  AddRoundsOption(command, options.rounds);
}

void AddLightConditions(const LightCostOptions& options, BenchResults& results)
{
  results.json.update({ { "side", options.side }, { "errorTolerance", options.errorTolerance },
    { "rounds", options.rounds }, { "fineVoxels", FineDistanceVoxels(options.errorTolerance) } });
}

Scene LitScene(const LoadedScene& loaded, const LightCostOptions& options)
{
  Scene scene = loaded.scene;
  scene.look.shading.enabled = true;
  scene.size = { options.side, options.side };
  scene.render.errorTolerance = options.errorTolerance;
  ScenePipeline pipeline(scene, loaded.volume.image, MapperKind::Varimarch);
  scene.lights = { { LightKind::Directional,
    UpperRightOf(pipeline.Renderer()->GetActiveCamera()) } };
  return scene;
}

Scene WithFeature(Scene scene, const LightFeature& feature)
{
  feature.add(scene);
  return scene;
}

double FineDistanceVoxels(double errorTolerance)
{
  constexpr double Finest = 1.0 / 32.0;
  constexpr double Coarsest = 1.0 / 8.0;
  return std::clamp(4.0 * errorTolerance, Finest, Coarsest);
}

Scene FineScene(Scene scene, double errorTolerance)
{
  scene.render.sampleDistanceVoxels = FineDistanceVoxels(errorTolerance);
  scene.render.errorTolerance = 0.0;
  return scene;
}

SceneLight Turned(SceneLight light, double degrees)
{
  LightAngles angles = AnglesOf(light.direction, light.kind);
  angles.azimuthDegrees = std::remainder(angles.azimuthDegrees + degrees, 360.0);
  light.direction = DirectionOf(angles, light.kind);
  return light;
}

std::vector<float> PixelsOf(OffscreenView& view)
{
  const auto picture = view.FloatImage();
  const auto* const channels = static_cast<const float*>(picture->GetScalarPointer());
  return std::vector<float>(channels, channels + 4 * picture->GetNumberOfPoints());
}

}
