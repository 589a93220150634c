#include "March/VolumeParametersBuilder.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "March/MaterialParameters.h"

#include "vtkVolumeProperty.h"

#include <glm/common.hpp>

namespace varimarch
{

namespace
{

void SetPlace(VolumeParameters& p, const Frame& frame, const VoxelRegion& voxels)
{
  p.worldFromGrid = frame.geometry.WorldFromGridDirection();
  p.firstVoxelGrid = glm::dvec3(voxels.first);
  p.voxelCount = glm::dvec3(voxels.count);
  p.voxelCountInverse = 1.0 / glm::dvec3(voxels.count);
}

void SetField(VolumeParameters& p, glm::ivec3 size)
{
  p.fieldSize = glm::dvec3(size);
  p.fieldSizeInverse = 1.0 / glm::dvec3(size);
  p.cellsPerBrick = float(BrickRanges::CellsPerSide);
}

void SetExtreme(
  VolumeParameters& p, const Frame& frame, const VolumeResources& volume, const TexelMapping& first)
{
  p.sense = frame.settings.blend == Blend::MaximumIntensity ? 1.0f : -1.0f;
  if (frame.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeSteps steps = volume.ExtremeStepsOf(frame.settings.blend);
    p.scalarFromField =
      glm::dvec2(steps.valuePerStep / first.scale, (steps.firstValue - first.offset) / first.scale);
  }
}

// The range of an extreme is that of all interpolated values, that of a sum the range of the
// voxels.
void SetProjection(
  VolumeParameters& p, const Frame& frame, const VolumeResources& volume, const Mappings& mappings)
{
  const bool isExtreme = IsExtreme(frame.settings.blend);
  const std::vector<ScalarTexels>& texels = volume.Blocks().TexelsOfComponents();
  for (int i = 0; i < int(texels.size()); ++i)
  {
    const TexelMapping& mapping = mappings[i];
    const double smallest =
      mapping.TexelOf(isExtreme ? texels[i].smallestValue : texels[i].smallestScalar);
    const double largest =
      mapping.TexelOf(isExtreme ? texels[i].largestValue : texels[i].largestScalar);
    p.smallestScalars[i] = float(smallest);
    p.largestScalars[i] = float(largest);
    p.grayPerScalars[i] = float(largest > smallest ? 1.0 / (largest - smallest) : 0.0);
    p.averagedLower[i] = float(mapping.LimitedTexelOf(frame.averagedRange[0]));
    p.averagedUpper[i] = float(mapping.LimitedTexelOf(frame.averagedRange[1]));
  }
}

void SetGaps(VolumeParameters& p, const Frame& frame, glm::ivec3 cells)
{
  p.gapCellCount = glm::dvec3(cells);
  p.gapCellCountInverse = 1.0 / glm::dvec3(cells);
  p.gapShift = frame.blanking.IsOfVoxels() ? 0.5f : 0.0f;
  p.gapOptical = FillsGaps(frame.settings) ? frame.gapOptical : glm::dvec4(0.0);
}

void SetMask(VolumeParameters& p, const Frame& frame, const VolumeResources& volume)
{
  const glm::dvec3 size(volume.Mask().Size());
  p.maskVoxelCount = size;
  p.maskVoxelsPerVoxel = size / glm::dvec3(frame.geometry.dimensions);
  p.labelPart = float(frame.labelPart);
  p.leastContent = frame.settings.mask == Mask::Binary ? 0.5f : -1.0f;
}

void SetSpacing(VolumeParameters& p, const Frame& frame, const UnevenBins& bins)
{
  p.spacingFirstBins = glm::dvec3(bins.first);
  p.spacingLastBins = glm::dvec3(bins.last);
  p.spacingLowerGrid = bins.lowerGrid;
  p.spacingBinsPerGrid = bins.binsPerGrid;
  p.spacingVoxelCount = glm::dvec3(frame.geometry.dimensions);
}

void SetSlice(VolumeParameters& p, const SliceSurface& slice)
{
  p.sliceMatrix = slice.matrix;
  p.sliceCenterGrid = slice.centerGrid;
}

}

MarchedVolume VolumeOfShaders(const Frame& frame, const VolumeResources& volume,
  const VolumeBlock* block, const VoxelRegion& voxels)
{
  MarchedVolume marched{ {}, voxels, volume.Field().Size(), glm::ivec3(1) };
  for (const ScalarTexels& texels : volume.Blocks().TexelsOfComponents())
  {
    marched.mappings.push_back(texels.mapping);
  }
  if (block)
  {
    const bool isOfCells = frame.settings.acceleration == Acceleration::ScalarField;
    marched.fieldSize = isOfCells ? block->scalarField.Size() : marched.fieldSize;
    marched.gapCells = block->gaps.Size();
  }
  return marched;
}

MarchedVolume VolumeOfProcessor(const Frame& frame, const VolumeResources& volume)
{
  return { Mappings(volume.Blocks().TexelsOfComponents().size()),
    { glm::ivec3(0), frame.geometry.dimensions }, volume.Field().Size(),
    volume.PacketGaps().count };
}

VolumeParameters VolumeParametersOf(
  const Frame& frame, const VolumeResources& volume, const MarchedVolume& marched)
{
  const Mappings& mappings = marched.mappings;
  VolumeParameters p = {};
  SetPlace(p, frame, marched.voxels);
  SetField(p, marched.fieldSize);
  SetTables(p, frame, volume, mappings);
  SetMaterials(p, frame, volume, mappings);
  if (IsExtreme(frame.settings.blend))
  {
    SetExtreme(p, frame, volume, mappings.front());
  }
  SetProjection(p, frame, volume, mappings);
  SetGaps(p, frame, marched.gapCells);
  SetMask(p, frame, volume);
  SetSpacing(p, frame, volume.SpacingBins());
  SetSlice(p, frame.slice);
  p.ownLowerGrid = volume.VisibleBox().lower;
  p.ownUpperGrid = glm::max(volume.VisibleBox().lower, volume.VisibleBox().upper);
  p.ownGridFromRays = glm::dmat4(1.0);
  return p;
}

}
