#include "BenchMethods.h"

#include <algorithm>
#include <array>

namespace varimarch
{

namespace
{

// Colours that people with any kind of colour vision tell apart: M. Okabe, K. Ito, "Color universal
// design", 2008.
constexpr std::array<unsigned char, 3> Black = { 0, 0, 0 };
constexpr std::array<unsigned char, 3> Blue = { 0, 114, 178 };
constexpr std::array<unsigned char, 3> SkyBlue = { 86, 180, 233 };
constexpr std::array<unsigned char, 3> Green = { 0, 158, 115 };
constexpr std::array<unsigned char, 3> Vermilion = { 213, 94, 0 };

constexpr std::array<unsigned char, 3> Purple = { 204, 121, 167 };
constexpr std::array<unsigned char, 3> Orange = { 230, 159, 0 };

RenderOptions With(Acceleration acceleration, Integration integration = Integration::Midpoint)
{
  RenderOptions options;
  options.acceleration = acceleration;
  options.integration = integration;
  return options;
}

}

const std::vector<BenchMethod>& BenchMethods()
{
  constexpr MapperKind Ours = MapperKind::Varimarch;
  const RenderOptions off = With(Acceleration::Off);
  const RenderOptions scalar = With(Acceleration::ScalarField);
  const RenderOptions optical = With(Acceleration::OpticalField);
  const RenderOptions preIntegrated = With(Acceleration::OpticalField, Integration::PreIntegrated);
  const RenderOptions simpson = With(Acceleration::OpticalField, Integration::Simpson);
  const RenderOptions published = With(Acceleration::ScalarField, Integration::PublishedSum);
  static const std::vector<BenchMethod> methods = {
    { "optical", "Varimarch, optical field", Ours, optical, 0.0, false,
      { Blue, Marker::Circle, Stroke::Solid } },
    { "off", "Varimarch, no field", Ours, off, 0.0, false,
      { SkyBlue, Marker::Diamond, Stroke::Dashed } },
    { "scalar-1", "Varimarch, scalar field, E 1/255", Ours, scalar, 1.0, false,
      { Green, Marker::Circle, Stroke::Solid } },
    { "scalar-4", "Varimarch, scalar field, E 4/255", Ours, scalar, 4.0, false,
      { Green, Marker::Diamond, Stroke::Dashed } },
    { "scalar-10", "Varimarch, scalar field, E 10/255", Ours, scalar, 10.0, false,
      { Green, Marker::Square, Stroke::Dotted } },
    { "pre-integrated", "Varimarch, optical, pre-integrated", Ours, preIntegrated, 0.0, true,
      { Purple, Marker::Circle, Stroke::Solid } },
    { "simpson", "Varimarch, optical, Simpson", Ours, simpson, 0.0, true,
      { Purple, Marker::Square, Stroke::Dashed } },
    { "published", "published sum, scalar, E 4/255", Ours, published, 4.0, true,
      { Orange, Marker::Diamond, Stroke::Solid } },
    { "vtk-gpu", "VTK GPU mapper", MapperKind::VtkGpu, {}, 0.0, false,
      { Vermilion, Marker::Square, Stroke::Solid } },
    { "vtk-cpu", "VTK fixed-point mapper", MapperKind::VtkCpu, {}, 0.0, false,
      { Black, Marker::Diamond, Stroke::Dashed } },
  };
  return methods;
}

std::vector<std::string> BenchMethodNames()
{
  std::vector<std::string> names;
  for (const BenchMethod& method : BenchMethods())
  {
    names.push_back(method.name);
  }
  return names;
}

std::vector<BenchRun> WorkPrecisionRuns(
  const Scene& scene, vtkImageData* image, const std::vector<std::string>& chosen)
{
  std::vector<BenchRun> runs;
  for (const BenchMethod& method : BenchMethods())
  {
    const bool wanted =
      chosen.empty() || std::find(chosen.begin(), chosen.end(), method.name) != chosen.end();
    if (!wanted || (method.unshadedOnly && scene.look.shading.enabled))
    {
      continue;
    }
    BenchRun run = { method, {} };
    for (const double voxels : { 4.0, 2.0, 1.0, 0.5, 0.25, 0.125 })
    {
      BenchSetting setting = { voxels, method.options };
      setting.options.sampleDistanceMm = voxels * VoxelMm(image);
      setting.options.variationTolerance = Variation(image, method.variation255);
      run.settings.push_back(setting);
    }
    runs.push_back(run);
  }
  return runs;
}

double VoxelMm(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return std::min({ spacing[0], spacing[1], spacing[2] });
}

double Variation(vtkImageData* image, double variation255)
{
  const double* range = image->GetScalarRange();
  return variation255 * (range[1] - range[0]) / 255.0;
}

}
