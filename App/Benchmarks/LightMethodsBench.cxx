#include "LightMethodsBench.h"

#include "BenchMethods.h"
#include "CommandLine/VtkMessages.h"
#include "Comparison/vtkComparisonMapper.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"

#include <vtkCamera.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

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

}

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

LightMethodsCase MeasureLightMethods(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  const Scene plain = LitScene(loaded, options);
  const Scene shadowed = WithFeature(plain, options.feature);
  vtkImageData* const image = loaded.volume.image;
  onStep("fine image");
  OffscreenView fine(FineScene(shadowed, options.errorTolerance), image, MapperKind::Varimarch);
  const std::vector<float> truth = PixelsOf(fine);
  const std::vector<LightMethod>& methods = LightMethods();
  LightMethodsCase measured = { loaded.name, std::vector<LightMethodCost>(methods.size()) };
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
        measured.methods[i].error = CompareImages(pixels.data(), truth.data(), truth.size() / 4);
        measured.methods[i].lightMegabytes =
          methods[i].hasShadows ? view.LightBytes() / BytesPerMegabyte : 0.0;
      }
      times[i].dragged.push_back(view.DraggedMs());
      ThrowIfVtkReportedError();
    }
  }
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    measured.methods[i].firstMs = Median(times[i].first);
    measured.methods[i].stillMs = Median(times[i].still);
    measured.methods[i].draggedMs = Median(times[i].dragged);
  }
  return measured;
}

}
