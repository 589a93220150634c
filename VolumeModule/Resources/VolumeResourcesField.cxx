// The fields: what rays may leave out of a volume.

#include "Resources/VolumeResources.h"

#include "Core/Recipe/ShaderRecipe.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

namespace varimarch
{

namespace
{

// The tolerance of the field when none is given, as a part of the range of the scalars.
constexpr double DefaultToleranceOfRange = 1.0 / 256.0;

}

void VolumeResources::UpdateField(const Frame& frame)
{
  if (frame.settings.acceleration != Acceleration::ScalarField)
  {
    this->blocks.SetScalarField(frame.window, {});
  }
  switch (frame.settings.acceleration)
  {
    case Acceleration::Off:
      this->field.Release(frame.window);
      this->fieldSource.reset();
      this->rangesOfVolume = 0;
      break;
    case Acceleration::ScalarField:
      this->UpdateScalarField(frame);
      break;
    case Acceleration::OpticalField:
      if (IsExtreme(frame.settings.blend))
      {
        this->UpdateExtremes(frame);
      }
      else if (frame.settings.blend == Blend::Isosurface)
      {
        this->UpdateIsosurfaceField(frame);
      }
      else
      {
        this->UpdateOpticalField(frame);
      }
      break;
  }
}

void VolumeResources::UpdateScalarField(const Frame& frame)
{
  const ScalarTexels& texels = this->blocks.Texels();
  const double range = texels.largestScalar - texels.smallestScalar;
  const double tolerance =
    frame.variationTolerance >= 0.0 ? frame.variationTolerance : DefaultToleranceOfRange * range;
  const FieldSource source{ Acceleration::ScalarField, this->builds.volumeTexture, 0, tolerance };
  if (this->fieldSource == source)
  {
    return;
  }
  this->field.Release(frame.window);
  this->rangesOfVolume = 0;
  this->blocks.SetScalarField(frame.window, tolerance);
  this->fieldSource = source;
  ++this->builds.field;
}

// Whether there is not yet this field for the rays of a frame; what it is made of is then ready.
// One for other rays counts as no other: what it shows is the same.
bool VolumeResources::BeginsField(const Frame& frame, FieldSource& source)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  const PixelRays rays = ComputePixelRays(clipFromGrid, frame.geometry.boxGrid);
  source.towards = this->fieldDirections.Next(DirectionsOf(rays));
  if (this->fieldSource == source)
  {
    return false;
  }
  this->builds.field += this->fieldSource && this->fieldSource->ShowsSame(source) ? 0 : 1;
  this->fieldSource.reset();
  this->UpdateRanges(frame);
  return true;
}

void VolumeResources::UpdateOpticalField(const Frame& frame)
{
  const double longestRayMm = frame.geometry.DiagonalMm();
  const OpticalTolerance tolerance =
    MarchesMaterial(frame.settings) || IsProjection(frame.settings.blend)
    ? OpticalTolerance::Nothing(longestRayMm)
    : OpticalTolerance::ForError(frame.fieldError, longestRayMm);
  FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture,
    this->builds.opticalTable, tolerance.color / tolerance.longestRayMm, 0.0, frame.marcher };
  if (!this->BeginsField(frame, source))
  {
    return;
  }
  std::vector<ComponentTable> tables;
  for (std::size_t i = 0; i < this->materialTables.size(); ++i)
  {
    if (this->materialTables[i].decidesOnOpacity)
    {
      tables.push_back({ this->materialTables[i].component, &this->opticalTable.Tables()[i] });
    }
  }
  this->field.BuildOpticalField(frame.window, tables, tolerance, source.towards, frame.marcher);
  this->fieldSource = source;
}

void VolumeResources::UpdateExtremes(const Frame& frame)
{
  const bool largest = frame.settings.blend == Blend::MaximumIntensity;
  const FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture,
    this->builds.opticalTable, frame.fieldError, largest ? 1.0 : -1.0, frame.marcher };
  if (this->fieldSource == source)
  {
    return;
  }
  this->fieldSource.reset();
  this->UpdateRanges(frame);
  const ExtremeLook look{ this->opticalTable.Table(),
    frame.property->GetScalarOpacityUnitDistance(), frame.fieldError };
  this->field.BuildExtremes(frame.window, look, largest, frame.marcher);
  this->fieldSource = source;
  ++this->builds.field;
}

void VolumeResources::UpdateIsosurfaceField(const Frame& frame)
{
  FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture, 0, 0.0, 0.0,
    frame.marcher };
  source.isovalues = frame.isovalues;
  if (this->BeginsField(frame, source))
  {
    this->field.BuildIsosurfaceField(frame.window, frame.isovalues, source.towards, frame.marcher);
    this->fieldSource = source;
  }
}

void VolumeResources::UpdateRanges(const Frame& frame)
{
  if (this->rangesOfVolume != this->builds.volumeTexture)
  {
    this->field.BuildRanges(this->blocks.Values(), frame.axes);
    this->rangesOfVolume = this->builds.volumeTexture;
    ++this->builds.brickRanges;
  }
}

// What a ray has found is the extreme of a brick even where rounding has made it less.
ExtremeSteps VolumeResources::ExtremeStepsOf(Blend blend) const
{
  constexpr double rounding = 1.0 / 64.0; // of a step
  const double sense = blend == Blend::MaximumIntensity ? 1.0 : -1.0;
  const BrickRanges& ranges = this->field.Ranges();
  return { sense, ranges.FirstValue() - sense * rounding * ranges.ValuePerStep(),
    ranges.ValuePerStep() };
}

double VolumeResources::FieldBuildSeconds() const
{
  const bool isOfCells =
    this->fieldSource && this->fieldSource->acceleration == Acceleration::ScalarField;
  return isOfCells ? this->blocks.FieldBuildSeconds() : this->field.BuildSeconds();
}

}
