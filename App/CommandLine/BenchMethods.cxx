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

RenderOptions With(Acceleration acceleration)
{
  RenderOptions options;
  options.acceleration = acceleration;
  return options;
}

}

const std::vector<BenchMethod>& BenchMethods()
{
  constexpr MapperKind Ours = MapperKind::Varimarch;
  const RenderOptions off = With(Acceleration::Off);
  const RenderOptions scalar = With(Acceleration::ScalarField);
  const RenderOptions optical = With(Acceleration::OpticalField);
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

std::vector<BenchSetting> SettingsOf(const BenchMethod& method, vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  const double* range = image->GetScalarRange();
  std::vector<BenchSetting> settings;
  for (const double voxels : { 4.0, 2.0, 1.0, 0.5, 0.25, 0.125 })
  {
    BenchSetting setting = { voxels, method.options };
    setting.options.sampleDistanceMm = voxels * std::min({ spacing[0], spacing[1], spacing[2] });
    setting.options.variationTolerance = method.variation255 * (range[1] - range[0]) / 255.0;
    settings.push_back(setting);
  }
  return settings;
}

}
