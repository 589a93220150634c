#include "BenchMethods.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/ReportedErrors.h"
#include "Comparison/vtkComparisonMapper.h"
#include "LightScenes.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Median.h"

#include <vtkCamera.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

/// A way to compute shadows, with fixed settings.
struct LightMethod
{
  std::string name;  ///< name in tables
  std::string title; ///< a few words on what it does
  /// One of vtkComparisonMapper::Methods; empty: our mapper.
  std::optional<int> comparison = {};
  bool hasShadows = true;
  double toleranceFactor = 1.0; ///< our mapper's error tolerance, relative to that of the options
  double spreadDegrees = 0.0;   ///< vtkComparisonMapper::SpreadDegrees
  double leastTransmittance = 1.0 / 1024.0; ///< transmittance at which rays end
};

/// The cost and the error of a method in a scene with one light. Times are medians of all rounds.
struct LightMethodCost
{
  double firstMs = 0.0;        ///< the first frame of a new window
  double stillMs = 0.0;        ///< a frame of the same view
  double draggedMs = 0.0;      ///< a frame for which the light has turned by two degrees
  ImageError error = {};       ///< against the scene's fine image
  double lightMegabytes = 0.0; ///< memory for light alone, at most
};

// Ours at the error tolerance, ours without shadows, and the methods of others, whose samples and
// slices are a voxel apart.
const std::vector<LightMethod>& LightMethods()
{
  using Mapper = vtkComparisonMapper;
  static const std::vector<LightMethod> methods = {
    { "ours", "Varimarch at the error tolerance" },
    { "ours, coarse", "Varimarch at four times the tolerance", {}, true, 4.0 },
    { "no shadows", "Varimarch without shadows", {}, false },
    { "second march", "a second march from each sample (Gorkin, slides 12 and 32)",
      Mapper::SecondMarch },
    { "light volume", "slices in a precomputed volume of light of half the resolution (Gorkin)",
      Mapper::LightVolume },
    { "half-angle", "half-angle slices in two passes (Gorkin, slides 32 to 35)",
      Mapper::HalfAngle },
    { "half-angle, blurred", "the same with a blurred buffer of light (slides 37 and 38)",
      Mapper::HalfAngle, true, 1.0, 20.0 },
    { "VTK's rays", "a ray from each sample as in VTK 9.2", Mapper::VtkShadows, true, 1.0, 0.0,
      1.0 / 255.0 },
  };
  return methods;
}

constexpr std::size_t MostFrames = 5;
constexpr double LeastMs = 500.0; // frames of a measurement end after this time
constexpr double BytesPerMegabyte = 1e6;

/// A view by one of the methods.
class MethodInLight
{
public:
  MethodInLight(const LightMethod& method, const Scene& scene, vtkImageData* image)
    : view(scene, image, MapperKind::Varimarch)
    , light(scene.lights.front())
  {
    if (method.comparison)
    {
      this->comparison = vtkSmartPointer<vtkComparisonMapper>::New();
      this->comparison->SetMethod(*method.comparison);
      this->comparison->SetSampleDistance(VoxelMm(image));
      this->comparison->SetSpreadDegrees(method.spreadDegrees);
      this->comparison->SetEarlyTerminationTransmittance(method.leastTransmittance);
      // Light on a grid of half the resolution, as others have it.
      const int* const size = image->GetDimensions();
      this->comparison->SetLightPoints(std::max(*std::max_element(size, size + 3) / 2, 2));
      this->comparison->SetInputDataObject(image);
      this->view.Pipeline().Volume()->SetMapper(this->comparison);
      this->ShineByComparison();
    }
  }

  double FrameMs() { return 1000.0 * this->view.Render(); }

  double StillMs()
  {
    return this->MedianMs([] {});
  }

  double DraggedMs()
  {
    return this->MedianMs([this] { this->DragLight(); });
  }

  std::vector<float> Pixels() { return PixelsOf(this->view); }

  double LightBytes()
  {
    auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->view.Pipeline().Mapper());
    return this->comparison ? double(this->comparison->GetLightMemoryBytes())
                            : double(ours->GetLightMemoryBytes());
  }

private:
  template <class Change>
  double MedianMs(const Change& change)
  {
    std::vector<double> times;
    for (double sum = 0.0; times.size() < MostFrames && sum < LeastMs; sum += times.back())
    {
      change();
      times.push_back(this->FrameMs());
    }
    return Median(times);
  }

  void DragLight()
  {
    this->light = Turned(this->light, 2.0);
    if (this->comparison)
    {
      this->ShineByComparison();
    }
    else
    {
      this->view.Pipeline().SetLights({ this->light });
    }
  }

  // The comparison mapper's light is relative to the camera.
  void ShineByComparison()
  {
    vtkCamera* const camera = this->view.Pipeline().Renderer()->GetActiveCamera();
    const glm::dvec3 toEye = -glm::make_vec3(camera->GetDirectionOfProjection());
    const glm::dvec3 viewUp = glm::make_vec3(camera->GetViewUp());
    const glm::dvec3 up = glm::normalize(viewUp - glm::dot(viewUp, toEye) * toEye);
    const glm::dvec3 toLight = glm::make_vec3(this->light.direction.data());
    this->comparison->SetLightDirection(
      glm::dot(toLight, glm::cross(up, toEye)), glm::dot(toLight, up), glm::dot(toLight, toEye));
  }

  OffscreenView view;
  SceneLight light;
  vtkSmartPointer<vtkComparisonMapper> comparison; ///< null for our mapper
};

Scene SceneOf(const LightMethod& method, const Scene& plain, const Scene& shadowed)
{
  Scene scene = method.hasShadows ? shadowed : plain;
  scene.render.errorTolerance *= method.toleranceFactor;
  return scene;
}

// The times of a method, one of each for each round.
struct MethodTimes
{
  std::vector<double> first;
  std::vector<double> still;
  std::vector<double> dragged;
};

// Draws frames by each method in turn. The errors are against an image of our mapper without a
// lattice of light, with samples FineDistanceVoxels apart.
std::vector<LightMethodCost> MeasureLightMethods(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  const Scene plain = LitScene(loaded, options);
  const Scene shadowed = WithFeature(plain, options.feature);
  vtkImageData* const image = loaded.volume.image;
  onStep("fine image");
  OffscreenView fine(FineScene(shadowed, options.errorTolerance), image, MapperKind::Varimarch);
  const std::vector<float> truth = PixelsOf(fine);
  const std::vector<LightMethod>& methods = LightMethods();
  std::vector<LightMethodCost> measured(methods.size());
  std::vector<MethodTimes> times(methods.size());
  for (int round = 0; round < options.rounds; ++round)
  {
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      onStep(methods[i].name + ", round " + std::to_string(round + 1));
      MethodInLight view(methods[i], SceneOf(methods[i], plain, shadowed), image);
      times[i].first.push_back(view.FrameMs());
      times[i].still.push_back(view.StillMs());
      if (round == 0)
      {
        const std::vector<float> pixels = view.Pixels();
        measured[i].error = CompareImages(pixels.data(), truth.data(), truth.size() / 4);
        measured[i].lightMegabytes =
          methods[i].hasShadows ? view.LightBytes() / BytesPerMegabyte : 0.0;
      }
      times[i].dragged.push_back(view.DraggedMs());
      ThrowIfVtkReportedError();
    }
  }
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    measured[i].firstMs = Median(times[i].first);
    measured[i].stillMs = Median(times[i].still);
    measured[i].draggedMs = Median(times[i].dragged);
  }
  return measured;
}

nlohmann::ordered_json ToJson(const std::vector<LightMethodCost>& costs)
{
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < costs.size(); ++i)
  {
    json[LightMethods()[i].name] = { { "firstMs", costs[i].firstMs },
      { "stillMs", costs[i].stillMs }, { "draggedMs", costs[i].draggedMs },
      { "lightMegabytes", costs[i].lightMegabytes }, { "error", ToJson(costs[i].error) } };
  }
  return json;
}

void RunLightMethods(const LightCostOptions& options, BenchResults& results)
{
  AddLightConditions(options, results);
  for (const LightMethod& method : LightMethods())
  {
    results.json["methods"].push_back({ { "name", method.name }, { "title", method.title } });
  }
  MeasureSceneByScene(options.scenes, results,
    [&](const LoadedScene& scene, const OnStep& onStep)
    {
      results.json["scenes"].push_back({ { "scene", scene.name },
        { "methods", ToJson(MeasureLightMethods(scene, options, onStep)) } });
    });
}

}

Benchmark LightMethodsBenchmark()
{
  return MakeBenchmark("light-methods",
    "Measure our shadows beside those of others: error, time and memory",
    "Example:\n  varimarch-bench light-methods --volumes volumes -o report --side 256",
    AddLightOptions, RunLightMethods);
}

}
