#include "BenchMethods.h"

#include "Comparison/vtkComparisonMapper.h"
#include "FrameCost.h"
#include "Scene/Pipeline/ScenePipeline.h"

#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>
#include <sstream>

namespace varimarch
{

namespace
{

RenderOptions With(Acceleration acceleration, Integration integration = Integration::Midpoint)
{
  RenderOptions options;
  options.acceleration = acceleration;
  options.integration = integration;
  return options;
}

std::vector<BenchSetting> SampleDistances(vtkImageData* image, const RenderOptions& options)
{
  std::vector<BenchSetting> settings;
  for (const double voxels : { 4.0, 2.0, 1.0, 0.5, 0.25, 0.125 })
  {
    settings.push_back(AtDistance(image, voxels, options));
  }
  return settings;
}

// Sample distances that reach the errors of the finest error tolerances, for comparison with them.
std::vector<BenchSetting> FineSampleDistances(vtkImageData* image, const RenderOptions& options)
{
  std::vector<BenchSetting> settings = SampleDistances(image, options);
  for (const double voxels : { 0.0625, 0.03125 })
  {
    settings.push_back(AtDistance(image, voxels, options));
  }
  return settings;
}

// Distances between slices of voxels.
std::vector<BenchSetting> WholeVoxels(vtkImageData* image, const RenderOptions& options)
{
  std::vector<BenchSetting> settings;
  for (const double voxels : { 4.0, 2.0, 1.0 })
  {
    settings.push_back(AtDistance(image, voxels, options));
  }
  return settings;
}

// Settings for which the mapper chooses the sample distance.
std::vector<BenchSetting> ErrorTolerances(vtkImageData* /*image*/, const RenderOptions& options)
{
  std::vector<BenchSetting> settings;
  for (const int part : { 4, 8, 16, 32, 64, 128, 255 })
  {
    settings.push_back({ "tolerance 1/" + std::to_string(part), options });
    settings.back().options.errorTolerance = 1.0 / part;
  }
  return settings;
}

enum class Pictures
{
  All,
  Composites,
  UnshadedComposites,
  ShadedComposites,
  PlainComposites,         ///< without cuts and gradient opacity
  UnshadedPlainComposites, ///< the same, unshaded
};

/// A row of the table of methods.
struct Row
{
  BenchMethod method;
  RenderOptions options;
  std::vector<BenchSetting> (*sweep)(vtkImageData*, const RenderOptions&);
  double variation255; ///< tolerance of a field of values, in 1/255 of the value range
  Pictures pictures;   ///< the scenes to which the method applies
};

// Integration rules and fields are compared in shaders, because packets do not have all of them.
constexpr MapperKind Shaders = MapperKind::VarimarchShaders;

RenderOptions WithoutField(bool fromBehind)
{
  RenderOptions options = With(Acceleration::Off);
  options.earlyTerminationTransmittance = 0.0;
  options.fromBehind = fromBehind;
  return options;
}

RenderOptions WithStoredGradients()
{
  RenderOptions options = With(Acceleration::OpticalField);
  options.storedGradients = true;
  return options;
}

const std::vector<Row>& Rows()
{
  const RenderOptions cells = With(Acceleration::CellField);
  const RenderOptions optical = With(Acceleration::OpticalField);
  const RenderOptions preIntegrated = With(Acceleration::OpticalField, Integration::PreIntegrated);
  const RenderOptions simpson = With(Acceleration::OpticalField, Integration::Simpson);
  const RenderOptions published = With(Acceleration::VariationField, Integration::PublishedSum);
  static const std::vector<Row> rows = {
    { { "tolerance", "Varimarch, error tolerances", MapperKind::Varimarch }, {}, ErrorTolerances,
      0.0, Pictures::All },
    { { "optical", "Varimarch, optical field", Shaders }, optical, FineSampleDistances, 0.0,
      Pictures::All },
    { { "off", "Varimarch, no field", Shaders }, With(Acceleration::Off), SampleDistances, 0.0,
      Pictures::All },
    { { "cells-1", "Varimarch, cell field, E 1/255", Shaders }, cells, SampleDistances, 1.0,
      Pictures::All },
    { { "cells-4", "Varimarch, cell field, E 4/255", Shaders }, cells, SampleDistances, 4.0,
      Pictures::All },
    { { "cells-10", "Varimarch, cell field, E 10/255", Shaders }, cells, SampleDistances, 10.0,
      Pictures::All },
    { { "pre-integrated", "Varimarch, optical, pre-integrated", Shaders }, preIntegrated,
      FineSampleDistances, 0.0, Pictures::Composites },
    { { "simpson", "Varimarch, optical, Simpson", Shaders }, simpson, FineSampleDistances, 0.0,
      Pictures::UnshadedComposites },
    { { "published", "Banquero et al. 2016, E 4/255", Shaders }, published, SampleDistances, 4.0,
      Pictures::UnshadedComposites },
    { { "vtk-gpu", "VTK GPU mapper", MapperKind::VtkGpu }, {}, SampleDistances, 0.0,
      Pictures::All },
    { { "vtk-cpu", "VTK fixed-point mapper", MapperKind::VtkCpu }, {}, SampleDistances, 0.0,
      Pictures::All },
  };
  return rows;
}

// Choices of our mapper that are slower, or cost more memory, and are there to be compared.
const std::vector<Row>& RowsOfChoices()
{
  static const std::vector<Row> rows = {
    { { "whole-rays", "Varimarch, no field, no early end", Shaders }, WithoutField(false),
      SampleDistances, 0.0, Pictures::Composites },
    { { "back-to-front", "Varimarch, no field, back to front", Shaders }, WithoutField(true),
      SampleDistances, 0.0, Pictures::Composites },
    { { "stored-gradients", "Varimarch, optical, stored gradients", Shaders },
      WithStoredGradients(), FineSampleDistances, 0.0, Pictures::ShadedComposites },
  };
  return rows;
}

// Methods of others, which only the benchmarks draw.
const std::vector<Row>& RowsOfOthers()
{
  const auto row = [](const std::string& name, const std::string& title, int method,
                     Pictures pictures = Pictures::PlainComposites) {
    return Row{ { name, title, Shaders, method }, {}, SampleDistances, 0.0, pictures };
  };
  static const std::vector<Row> rows = {
    row("slices-object", "object-aligned slices", vtkComparisonMapper::ObjectSlices),
    { { "slices-object-2d", "object-aligned slices, 2D textures", Shaders,
        vtkComparisonMapper::ObjectSlices2D },
      {}, WholeVoxels, 0.0, Pictures::UnshadedPlainComposites },
    row("slices-view", "view-aligned slices", vtkComparisonMapper::ViewSlices),
    row("shells", "spherical shells", vtkComparisonMapper::Shells),
    row("passes", "march in passes", vtkComparisonMapper::Passes),
    { { "corrected-table", "march in passes, opacities of whole steps in a table", Shaders,
        vtkComparisonMapper::Passes, VoxelStorage::Bits16, true },
      {}, SampleDistances, 0.0, Pictures::PlainComposites },
    row("half-angle", "half-angle slices, with shadows: not the same image",
      vtkComparisonMapper::HalfAngle),
    row("light-volume", "slices with shadows from a volume of light: not the same image",
      vtkComparisonMapper::LightVolume),
  };
  return rows;
}

// The march in passes, with voxels in other forms than the 16 bits of the row "passes".
const std::vector<Row>& RowsOfStorages()
{
  const auto row = [](const std::string& name, const std::string& title, VoxelStorage storage)
  {
    return Row{ { name, title, Shaders, vtkComparisonMapper::Passes, storage }, {}, SampleDistances,
      0.0, Pictures::PlainComposites };
  };
  static const std::vector<Row> rows = {
    row("bits-8", "8 bits", VoxelStorage::Bits8),
    row("bits-8-rgba", "8 bits, four voxels in RGBA8", VoxelStorage::FourInTexel),
    row("bits-6", "6 bits, five voxels in a word", VoxelStorage::Bits6),
    row("bits-4-rgba", "4 bits, four voxels in RGBA4", VoxelStorage::FourInTexel4),
    row("bits-1", "1 bit, 32 voxels in a word", VoxelStorage::Bit1),
    row(
      "slices-side-by-side", "slices in a 2D texture, two bilinear reads", VoxelStorage::Slices2D),
  };
  return rows;
}

std::vector<Row> AllRows()
{
  std::vector<Row> rows = Rows();
  for (const std::vector<Row>& more : { RowsOfChoices(), RowsOfOthers(), RowsOfStorages() })
  {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

bool IsPlain(const Scene& scene)
{
  const SceneCuts& cuts = scene.cuts;
  return scene.look.gradientOpacities.empty() && cuts.box == SceneCuts().box &&
    cuts.planes.empty() && !NeedMask(cuts);
}

bool IsUsedIn(Pictures pictures, const Scene& scene)
{
  const bool isComposite = scene.look.blend == Blend::Composite;
  const bool isShaded = scene.look.shading.enabled;
  switch (pictures)
  {
    case Pictures::All:
      return true;
    case Pictures::Composites:
      return isComposite;
    case Pictures::UnshadedComposites:
      return isComposite && !isShaded;
    case Pictures::ShadedComposites:
      return isComposite && isShaded;
    case Pictures::PlainComposites:
      return isComposite && IsPlain(scene);
    case Pictures::UnshadedPlainComposites:
      return isComposite && !isShaded && IsPlain(scene);
  }
  return false;
}

}

std::vector<std::string> BenchMethodNames()
{
  std::vector<std::string> names;
  for (const Row& row : AllRows())
  {
    names.push_back(row.method.name);
  }
  return names;
}

std::vector<BenchRun> WorkPrecisionRuns(
  const Scene& scene, vtkImageData* image, const std::vector<std::string>& chosen)
{
  std::vector<BenchRun> runs;
  for (const Row& row : AllRows())
  {
    const bool wanted =
      chosen.empty() || std::find(chosen.begin(), chosen.end(), row.method.name) != chosen.end();
    if (wanted && CanBlend(row.method.kind, scene.look.blend) && IsUsedIn(row.pictures, scene))
    {
      RenderOptions options = row.options;
      options.variationTolerance = Variation(image, row.variation255);
      runs.push_back({ row.method, row.sweep(image, options) });
    }
  }
  return runs;
}

BenchSetting AtDistance(vtkImageData* image, double voxels, const RenderOptions& options)
{
  std::ostringstream label;
  label << voxels << " voxels";
  BenchSetting setting = { label.str(), options };
  setting.options.sampleDistanceMm = voxels * VoxelMm(image);
  return setting;
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

MethodView::MethodView(const BenchMethod& method, const Scene& scene, vtkImageData* image)
  : view(scene, image, method.kind)
{
  if (method.comparison)
  {
    this->comparison = vtkSmartPointer<vtkComparisonMapper>::New();
    this->comparison->SetMethod(*method.comparison);
    this->comparison->SetStorage(method.storage);
    this->comparison->SetCorrectedTable(method.correctedTable);
    this->comparison->SetInputDataObject(image);
    this->view.Pipeline().Volume()->SetMapper(this->comparison);
  }
}

MethodView::~MethodView() = default;

void MethodView::SetOptions(const RenderOptions& options)
{
  this->view.Pipeline().SetRenderOptions(options);
  if (this->comparison)
  {
    this->comparison->SetSampleDistance(options.sampleDistanceMm.value_or(1.0));
    this->comparison->SetEarlyTerminationTransmittance(options.earlyTerminationTransmittance);
  }
}

double MethodView::UsedSampleDistanceMm() const
{
  return this->comparison ? this->comparison->GetSampleDistance()
                          : this->view.Pipeline().UsedSampleDistanceMm();
}

double MethodView::EstimatedError()
{
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->view.Pipeline().Mapper());
  return ours && !this->comparison ? ours->GetEstimatedError() : 0.0;
}

std::optional<double> MethodView::Fetches()
{
  return this->comparison ? std::nullopt : FetchesPerPixel(this->view);
}

std::optional<double> MethodView::Bytes()
{
  return this->comparison ? this->comparison->GetGraphicsMemoryBytes() : GraphicsBytes(this->view);
}

}
