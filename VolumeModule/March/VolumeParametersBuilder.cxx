#include "March/VolumeParametersBuilder.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "March/MaterialParameters.h"
#include "March/SkyParameters.h"

#include "vtkVolumeProperty.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace varimarch
{

namespace
{

void SetPlace(VolumeParameters& p, const VolumeMarch& march, const VoxelRegion& voxels)
{
  p.worldFromGrid = march.frame.geometry.WorldFromGridDirection();
  p.gridFromWorld = glm::inverse(march.frame.geometry.WorldFromGridDirection());
  p.worldOfGridOrigin = glm::dvec3(march.frame.geometry.worldFromGrid[3]);
  p.firstVoxelGrid = glm::dvec3(voxels.first);
  p.voxelCount = glm::dvec3(voxels.count);
  p.voxelCountInverse = 1.0 / glm::dvec3(voxels.count);
}

void SetField(VolumeParameters& p, glm::ivec3 size, int cellsPerBrick)
{
  p.fieldSize = glm::dvec3(size);
  p.fieldSizeInverse = 1.0 / glm::dvec3(size);
  p.cellsPerBrick = float(cellsPerBrick);
}

void SetExtreme(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const TexelMapping& first)
{
  p.sense = march.settings.blend == Blend::MaximumIntensity ? 1.0f : -1.0f;
  if (march.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeSteps steps = volume.Fields().ExtremeStepsOf(march.settings.blend);
    p.scalarFromField =
      glm::dvec2(steps.valuePerStep / first.scale, (steps.firstValue - first.offset) / first.scale);
  }
}

// Maximum and minimum use the range of all interpolated values, average and sum the range that they
// show in gray.
void SetProjection(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const Mappings& mappings)
{
  const bool isExtreme = IsExtreme(march.settings.blend);
  const std::vector<ScalarTexels>& texels = volume.Blocks().TexelsOfComponents();
  for (int i = 0; i < int(texels.size()); ++i)
  {
    const TexelMapping& mapping = mappings[i];
    const double smallest =
      mapping.LimitedTexelOf(isExtreme ? texels[i].smallestValue : texels[i].gray.lower);
    const double largest =
      mapping.LimitedTexelOf(isExtreme ? texels[i].largestValue : texels[i].gray.upper);
    p.smallestScalars[i] = float(smallest);
    p.largestScalars[i] = float(largest);
    p.grayPerScalars[i] = float(largest > smallest ? 1.0 / (largest - smallest) : 0.0);
    p.averagedLower[i] = float(mapping.LimitedTexelOf(march.frame.material.averagedRange[0]));
    p.averagedUpper[i] = float(mapping.LimitedTexelOf(march.frame.material.averagedRange[1]));
  }
}

void SetGaps(VolumeParameters& p, const VolumeMarch& march, glm::ivec3 cells)
{
  p.gapCellCount = glm::dvec3(cells);
  p.gapCellCountInverse = 1.0 / glm::dvec3(cells);
  p.gapShift = march.frame.voxels.blanking.IsOfVoxels() ? 0.5f : 0.0f;
  p.gapOptical = FillsGaps(march.settings) ? march.frame.material.gapOptical : glm::dvec4(0.0);
}

void SetMask(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume)
{
  const glm::dvec3 size(volume.Mask().Size());
  p.maskVoxelCount = size;
  p.maskVoxelsPerVoxel = size / glm::dvec3(march.frame.geometry.dimensions);
  p.labelPart = float(march.frame.material.labelBlend);
  p.leastContent = march.settings.mask == Mask::Binary ? 0.5f : -1.0f;
}

void SetSpacing(VolumeParameters& p, const VolumeMarch& march, const UnevenBins& bins)
{
  p.spacingFirstBins = glm::dvec3(bins.first);
  p.spacingLastBins = glm::dvec3(bins.last);
  p.spacingLowerGrid = bins.lowerGrid;
  p.spacingBinsPerGrid = bins.binsPerGrid;
  p.spacingVoxelCount = glm::dvec3(march.frame.geometry.dimensions);
}

void SetSlice(VolumeParameters& p, const SliceSurface& slice)
{
  p.sliceMatrix = slice.matrix;
  p.sliceCenterGrid = slice.centerGrid;
}

}

MarchedVolume VolumeOfShaders(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeBlock* block, const VoxelRegion& voxels)
{
  MarchedVolume marched{ {}, voxels, volume.Fields().OfBricks().Size(), glm::ivec3(1) };
  for (const ScalarTexels& texels : volume.Blocks().TexelsOfComponents())
  {
    marched.mappings.push_back(texels.mapping);
  }
  if (block)
  {
    const bool isOfValues = IsOfValues(march.settings.acceleration);
    marched.fieldSize = isOfValues ? block->valueField.Size() : marched.fieldSize;
    marched.gapCells = block->gaps.Size();
  }
  return marched;
}

MarchedVolume VolumeOfProcessor(const VolumeResources& volume)
{
  return { volume.Packets().Mappings(), { glm::ivec3(0), volume.Packets().VoxelCount() },
    volume.Fields().OfBricks().Size(), volume.Packets().GapCells() };
}

VolumeParameters VolumeParametersOf(
  const VolumeMarch& march, const VolumeResources& volume, const MarchedVolume& marched)
{
  const Mappings& mappings = marched.mappings;
  VolumeParameters p = {};
  SetPlace(p, march, marched.voxels);
  SetField(p, marched.fieldSize, volume.Fields().OfBricks().CellsPerBrick());
  SetTables(p, march, volume, mappings);
  SetMaterials(p, march, volume, mappings);
  if (IsExtreme(march.settings.blend))
  {
    SetExtreme(p, march, volume, mappings.front());
  }
  SetProjection(p, march, volume, mappings);
  SetSky(p, march, volume.Light().Sky(march));
  SetGaps(p, march, marched.gapCells);
  SetMask(p, march, volume);
  SetSpacing(p, march, volume.SpacingBins());
  SetSlice(p, march.frame.material.slice);
  p.ownLowerGrid = volume.Division().VisibleBox().lower;
  p.ownUpperGrid =
    glm::max(volume.Division().VisibleBox().lower, volume.Division().VisibleBox().upper);
  p.ownGridFromRays = glm::dmat4(1.0);
  return p;
}

}
