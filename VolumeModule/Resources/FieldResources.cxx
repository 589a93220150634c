#include "Resources/FieldResources.h"

#include "Core/Geometry/PixelRays.h"
#include "Core/Recipe/MaterialRecipe.h"
#include "Resources/ValueFocus.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

namespace varimarch
{

namespace
{

// The default tolerance of a field of values, as a fraction of the range of values.
constexpr double DefaultToleranceOfRange = 1.0 / 256.0;

// The tables that determine where a volume is visible. Each row of a mask of labels shows one of
// them, and the row 1 of a binary mask shows all.
std::vector<ComponentTable> TablesOfOpacity(const MaterialResources& materials, Mask mask)
{
  std::vector<ComponentTable> tables;
  for (std::size_t i = 0; i < materials.MaterialTables().size(); ++i)
  {
    const MaterialFunction& table = materials.MaterialTables()[i];
    if (table.decidesOnOpacity)
    {
      const std::size_t row = mask == Mask::Labels ? i : 1;
      tables.push_back(
        { table.component, &materials.OpticalTables().Tables()[i], std::uint16_t(row) });
    }
  }
  return tables;
}

}

void FieldResources::Update(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  if (!IsOfValues(march.settings.acceleration))
  {
    inputs.blocks.SetValueField(march.frame.view.window, {});
  }
  switch (march.settings.acceleration)
  {
    case Acceleration::Off:
      this->Release(march.frame.view.window);
      break;
    case Acceleration::CellField:
    case Acceleration::VariationField:
      this->UpdateValueField(inputs);
      break;
    case Acceleration::OpticalField:
      if (IsExtreme(march.settings.blend))
      {
        this->UpdateExtremes(inputs);
      }
      else if (march.settings.blend == Blend::Isosurface)
      {
        this->UpdateIsosurfaceField(inputs);
      }
      else
      {
        this->UpdateOpticalField(inputs);
      }
      break;
  }
}

void FieldResources::UpdateValueField(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  const ValueRange values =
    NearValues(inputs.blocks.Texels().resolved, ValuesThatMatter(march.frame).front());
  const double tolerance = march.frame.quality.variationTolerance >= 0.0
    ? march.frame.quality.variationTolerance
    : DefaultToleranceOfRange * (values.upper - values.lower);
  const FieldSource source{ march.settings.acceleration, inputs.volumeBuild, 0, 0, tolerance };
  if (this->madeFrom == source)
  {
    return;
  }
  this->field.Release(march.frame.view.window);
  this->rangesOfVolume = 0;
  inputs.blocks.SetValueField(
    march.frame.view.window, ValueField{ march.settings.acceleration, tolerance });
  this->madeFrom = source;
  ++this->builds;
}

// Returns true if the field must be built for the rays of the frame, after making the ranges of
// bricks. A field that differs only in its ray directions does not count as another build, because
// the image is the same.
bool FieldResources::BeginsField(const FieldInputs& inputs, FieldSource& source)
{
  const VolumeMarch& march = inputs.march;
  const glm::dmat4 clipFromGrid = march.frame.ClipFromGrid();
  const PixelRays rays = ComputePixelRays(clipFromGrid, march.frame.geometry.boxGrid);
  // Rays to lights and to the sky go anywhere.
  source.towards = IsInWayOfLights(march.settings) || IsInWayOfSky(march.settings)
    ? glm::ivec3(0)
    : this->directions.Next(DirectionsOf(rays));
  if (this->madeFrom == source)
  {
    return false;
  }
  this->builds += this->madeFrom && ShowSame(*this->madeFrom, source) ? 0 : 1;
  this->madeFrom.reset();
  this->UpdateRanges(inputs);
  return true;
}

void FieldResources::UpdateOpticalField(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  const double longestRayMm = march.frame.geometry.DiagonalMm();
  const OpticalTolerance tolerance =
    MarchesMaterial(march.settings) || IsProjection(march.settings.blend)
    ? OpticalTolerance::Nothing(longestRayMm)
    : OpticalTolerance::ForError(march.frame.quality.budget.FieldError(), longestRayMm);
  FieldSource source{ Acceleration::OpticalField, inputs.volumeBuild,
    inputs.materials.TableBuilds(), inputs.mask.Builds(), tolerance.color / tolerance.longestRayMm,
    0.0, march.plan.marcher };
  if (!this->BeginsField(inputs, source))
  {
    return;
  }
  const std::vector<ComponentTable> tables = TablesOfOpacity(inputs.materials, march.settings.mask);
  this->field.BuildOpticalField(march.frame.view.window, tables, inputs.mask.Rows(), tolerance,
    source.towards, march.plan.marcher);
  this->madeFrom = source;
}

void FieldResources::UpdateExtremes(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  const bool largest = march.settings.blend == Blend::MaximumIntensity;
  const FieldSource source{ Acceleration::OpticalField, inputs.volumeBuild,
    inputs.materials.TableBuilds(), 0, march.frame.quality.budget.FieldError(),
    largest ? 1.0 : -1.0, march.plan.marcher };
  if (this->madeFrom == source)
  {
    return;
  }
  this->madeFrom.reset();
  this->UpdateRanges(inputs);
  const ExtremeLook look{ inputs.materials.OpticalTables().Table(),
    march.frame.material.functions.opacityUnitDistancesMm[0],
    march.frame.quality.budget.FieldError() };
  this->field.BuildExtremes(march.frame.view.window, look, largest, march.plan.marcher);
  this->madeFrom = source;
  ++this->builds;
}

void FieldResources::UpdateIsosurfaceField(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  FieldSource source{ Acceleration::OpticalField, inputs.volumeBuild, 0, 0, 0.0, 0.0,
    march.plan.marcher };
  source.isovalues = march.frame.material.isovalues;
  if (this->BeginsField(inputs, source))
  {
    this->field.BuildIsosurfaceField(
      march.frame.view.window, march.frame.material.isovalues, source.towards, march.plan.marcher);
    this->madeFrom = source;
  }
}

void FieldResources::UpdateRanges(const FieldInputs& inputs)
{
  const VolumeMarch& march = inputs.march;
  if (this->rangesOfVolume != inputs.volumeBuild)
  {
    const bool areBuilt = this->field.BuildRanges(
      inputs.blocks.Values(), march.frame.voxels, march.frame.device.mostHostBytes);
    this->rangesOfVolume = inputs.volumeBuild;
    this->rangesBuilds += areBuilt ? 1 : 0;
  }
}

// Values are shifted by a fraction of a step, so that the extreme that a ray has found reaches that
// of its brick in spite of rounding.
ExtremeSteps FieldResources::ExtremeStepsOf(Blend blend) const
{
  constexpr double rounding = 1.0 / 64.0; // [steps]
  const double sense = blend == Blend::MaximumIntensity ? 1.0 : -1.0;
  const BrickRanges& ranges = this->field.Ranges();
  const double perStep = ranges.LastStep() > 0 ? ranges.ValuePerStep() : 0.0;
  return { sense, ranges.FirstValue() - sense * rounding * perStep, perStep };
}

double FieldResources::BuildSeconds(const VolumeBlocks& blocks) const
{
  const bool isOfValues = this->madeFrom && IsOfValues(this->madeFrom->acceleration);
  return isOfValues ? blocks.FieldBuildSeconds() : this->field.BuildSeconds();
}

void FieldResources::ForgetBricks()
{
  this->madeFrom.reset();
  this->rangesOfVolume = 0;
}

void FieldResources::Release(vtkWindow* window)
{
  this->field.Release(window);
  this->ForgetBricks();
}

}
