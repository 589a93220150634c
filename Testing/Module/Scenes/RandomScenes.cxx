#include "Module/Scenes/RandomScenes.h"

#include "Frame/PropertyTransferFunction.h"
#include "Module/Scenes/ReferenceMixture.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// The subjects of the dice.
enum Subject
{
  Kind,
  Volume,
  View,
  Cuts,
  Blending,
  Quality,
  Material,
  Look, ///< one for each component
};

const std::vector<std::pair<int, std::string>> BlendModes = {
  { Mapper::COMPOSITE_BLEND, "composite" },
  { Mapper::MAXIMUM_INTENSITY_BLEND, "maximum" },
  { Mapper::MINIMUM_INTENSITY_BLEND, "minimum" },
  { Mapper::AVERAGE_INTENSITY_BLEND, "average" },
  { Mapper::ISOSURFACE_BLEND, "isosurfaces" },
  { Mapper::ADDITIVE_BLEND, "additive" },
};

int RandomComponents(Dice& dice)
{
  return dice.Chance(0.8) ? 1 : dice.Whole(2, 4);
}

// The surfaces that steps and opaque values of a function make.
RandomEdges EdgesOf(vtkVolumeProperty* property, int component)
{
  const varimarch::TransferFunction function = varimarch::TransferFunctionOf(property, component);
  const auto& opacities = function.Opacities();
  const bool isOpaque = std::any_of(opacities.begin(), opacities.end(),
    [](const varimarch::OpacityNode& node) { return node.opacity == 1.0; });
  const RandomEdges ofSteps = function.HasStep() ? RandomEdges::Faces : RandomEdges::None;
  return isOpaque ? RandomEdges::Hard : ofSteps;
}

// The steps of a function. Two nodes within an entry of the table are a step to it.
std::vector<varimarch::ValueRange> StepsOf(
  const varimarch::TransferFunction& function, double entry)
{
  std::vector<varimarch::ValueRange> steps;
  const std::vector<double> nodes = function.NodeValues();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const bool isClose = i + 1 < nodes.size() && nodes[i + 1] - nodes[i] <= entry;
    if (isClose || function.HasStepAt(nodes[i]))
    {
      steps.push_back({ nodes[i], isClose ? nodes[i + 1] : nodes[i] });
    }
  }
  return steps;
}

// True if components 0 to 2 of 4 are colours of full range.
bool MayBeColors(const RandomVolume& volume)
{
  const int type = volume.image->GetScalarType();
  const bool isWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  const bool isUnit = volume.values.lower == 0.0 && volume.values.upper == 1.0;
  return isWhole ? type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT : isUnit;
}

}

RandomScene::RandomScene(std::uint64_t seed, vtkHeadlessRenderWindow* window)
{
  const auto subject = [&](int number) { return Dice(seed, std::uint64_t(number)); };
  Dice kind = subject(Subject::Kind);
  this->components = RandomComponents(kind);
  Dice ofVolume = subject(Subject::Volume);
  this->volume = MakeRandomVolume(ofVolume, this->components);
  this->scene = std::make_unique<MapperScene>(this->volume.image, 48, window);
  this->description = "seed " + std::to_string(seed) + ": " + this->volume.description;
  Dice view = subject(Subject::View);
  this->description += SetRandomView(*this->scene, view);
  Dice cuts = subject(Subject::Cuts);
  this->description += SetRandomCuts(*this->scene, cuts);
  Dice material = subject(Subject::Material);
  this->SetMaterial(material);
  Dice blending = subject(Subject::Blending);
  this->SetBlend(blending);
  for (int component = 0; component < this->components; ++component)
  {
    Dice look = subject(Subject::Look + component);
    vtkVolumeProperty* const property = this->scene->volume->GetProperty();
    this->description += SetRandomLook(property, component, this->volume, this->isMixture, look);
    this->edges = std::max(this->edges, EdgesOf(property, component));
  }
  Dice quality = subject(Subject::Quality);
  this->SetQuality(quality);
}

bool RandomScene::IsExact() const
{
  vtkVolumeProperty* const property = this->scene->volume->GetProperty();
  vtkDataArray* const voxels = this->volume.image->GetPointData()->GetScalars();
  const double entry = this->volume.values.Width() / 65536.0;
  constexpr int VoxelsOfCell = 8;
  const int most = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION ? 1 : VoxelsOfCell;
  for (int component = 0; component < this->components; ++component)
  {
    const varimarch::TransferFunction function = varimarch::TransferFunctionOf(property, component);
    for (const varimarch::ValueRange& step : StepsOf(function, entry))
    {
      int atStep = 0;
      for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
      {
        const double value = voxels->GetComponent(i, component);
        atStep += step.lower - entry <= value && value <= step.upper + entry;
      }
      if (atStep >= most)
      {
        return false;
      }
    }
  }
  return true;
}

void RandomScene::SetMaterial(Dice& dice)
{
  vtkVolumeProperty* const property = this->scene->volume->GetProperty();
  const bool mayDepend =
    this->components == 2 || (this->components == 4 && MayBeColors(this->volume));
  const bool depends = this->components == 3 ? false : mayDepend && dice.Chance(0.4);
  property->SetIndependentComponents(!depends);
  property->SetShade(!depends && dice.Chance(0.4));
  // The reference's cells are voxels then, and cannot be the cells of the grid.
  const bool mayBeNearest = !this->volume.image->GetCellGhostArray();
  const bool isNearest = dice.Chance(0.25) && mayBeNearest;
  property->SetInterpolationType(isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  const bool hasFaces = isNearest || this->scene->mapper->GetCropping();
  this->edges = this->volume.hasFarValues ? RandomEdges::Hard
                                          : (hasFaces ? RandomEdges::Faces : RandomEdges::None);
  this->isMixture = this->components > 1;
  for (int component = 0; component < this->components; ++component)
  {
    property->SetComponentWeight(component, this->components > 1 ? dice.Between(0.2, 1.0) : 1.0);
  }
  this->description += std::string(depends ? ", dependent" : "") +
    (property->GetShade() ? ", shaded" : "") + (isNearest ? ", nearest" : "");
  if (this->components == 1 && !this->volume.hasGaps && dice.Chance(0.12))
  {
    this->SetGradientOpacity(dice);
  }
}

void RandomScene::SetGradientOpacity(Dice& dice)
{
  vtkNew<vtkPiecewiseFunction> factors;
  const double most = 0.25 * this->volume.values.Width();
  const double from = dice.Between(0.0, 0.5) * most;
  factors->AddPoint(from, dice.Between(0.0, 0.5));
  factors->AddPoint(from + dice.Between(0.2, 1.0) * most, dice.Between(0.5, 1.0));
  this->scene->volume->GetProperty()->SetGradientOpacity(factors);
  this->isMixture = true;
  this->description += ", gradient opacity";
}

void RandomScene::SetBlend(Dice& dice)
{
  vtkVolumeProperty* const property = this->scene->volume->GetProperty();
  const bool isOfValues = this->components == 1 && !this->isMixture;
  const int last = isOfValues ? 5 : (property->GetIndependentComponents() ? 3 : 0);
  // Sums and means count far values too, to which all others are equally black. Beside a far value,
  // surfaces and extremes are at the faces of cells, where rounding decides.
  const bool isComposite =
    dice.Chance(0.45) || property->HasGradientOpacity() || this->volume.hasFarValues;
  const auto& [mode, name] = BlendModes[isComposite ? 0 : std::size_t(dice.Whole(0, last))];
  this->scene->mapper->SetBlendMode(mode);
  this->description += ", " + name;
  const auto value = [&]
  { return this->volume.values.lower + dice.Between(0.05, 0.95) * this->volume.values.Width(); };
  if (mode == Mapper::ISOSURFACE_BLEND)
  {
    this->edges = std::max(this->edges, RandomEdges::Faces);
    const int count = dice.Whole(1, 3);
    for (int i = 0; i < count; ++i)
    {
      const double isovalue = value();
      property->GetIsoSurfaceValues()->SetValue(i, isovalue);
      this->description += " " + std::to_string(isovalue);
    }
  }
  if (mode == Mapper::AVERAGE_INTENSITY_BLEND && isOfValues && dice.Chance(0.5))
  {
    const auto [from, to] = std::minmax({ value(), value() });
    this->scene->mapper->SetAverageIPScalarRange(from, to);
    this->description += " of " + std::to_string(from) + " to " + std::to_string(to);
  }
}

void RandomScene::SetQuality(Dice& dice)
{
  const double parts = dice.OneOf<double>({ 16.0, 32.0, 64.0, 64.0, 128.0, 255.0 });
  this->scene->mapper->SetErrorTolerance(1.0 / parts);
  this->scene->mapper->SetAccelerationMode(dice.Chance(0.8) ? Mapper::OpticalField : Mapper::Off);
  this->scene->mapper->SetProcessorMarching(dice.Chance(0.6));
  std::ostringstream text;
  text << "; 1/" << parts << (this->scene->mapper->GetAccelerationMode() ? "" : ", no field")
       << (this->scene->mapper->GetProcessorMarching() ? ", packets" : ", shaders");
  if (this->volume.hasGaps && this->scene->mapper->GetBlendMode() == Mapper::COMPOSITE_BLEND &&
    dice.Chance(0.3))
  {
    this->scene->mapper->SetNanColor(0.2, 0.9, 0.4);
    this->scene->mapper->SetNanOpacity(dice.OneOf<double>({ 0.1, 0.6, 1.0 }));
    text << ", gaps of opacity " << this->scene->mapper->GetNanOpacity();
  }
  this->description += text.str();
}

std::vector<float> RandomScene::Draw()
{
  return this->scene->Draw();
}

std::vector<float> RandomScene::Truth()
{
  if (this->scene->mapper->GetBlendMode() == Mapper::COMPOSITE_BLEND && this->isMixture)
  {
    const ReferenceMixture mixture(*this->scene);
    return this->scene->TruthOf(
      [&](glm::dvec3 position, const varimarch::Ray& ray) { return mixture.At(position, ray); });
  }
  if (this->components == 1)
  {
    return this->scene->Truth();
  }
  std::vector<float> sum(std::size_t(4 * this->scene->size * this->scene->size));
  for (int component = 0; component < this->components; ++component)
  {
    const float weight = float(this->scene->volume->GetProperty()->GetComponentWeight(component));
    const std::vector<float> one = this->scene->Truth(1e-5, component);
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      const bool isOfMean = this->scene->mapper->GetBlendMode() == Mapper::AVERAGE_INTENSITY_BLEND;
      sum[i] = isOfMean && i % 4 == 3 ? one[i] : std::min(sum[i] + weight * one[i], 1.0f);
    }
  }
  return sum;
}
