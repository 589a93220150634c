#include "March/LevelOfDetail.h"

#include "Core/Quality/LevelBound.h"
#include "Frame/FrameBuilder.h"
#include "Readers/MappedScalars.h"
#include "Resources/MaterialTables.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// True if nothing but the values along its rays decides on an image.
bool IsPlainComposite(const Frame& frame, bool hasGaps)
{
  const RenderSettings& settings = frame.settings;
  const bool isWhole = !settings.clipping && !settings.cropping && !settings.limitsSpan &&
    !settings.sceneGeometry && settings.mask == Mask::None &&
    frame.cuts.boxGrid.lower == frame.geometry.boxGrid.lower &&
    frame.cuts.boxGrid.upper == frame.geometry.boxGrid.upper;
  const bool hasClearGaps = !hasGaps || frame.material.gapOptical.a == 0.0;
  return settings.blend == Blend::Composite && settings.functionOf == FunctionOf::Value &&
    !settings.cubic && !settings.gradientOpacity && !settings.windowLevel && isWhole &&
    hasClearGaps && frame.others.empty() && frame.userCode.IsEmpty();
}

// Computes the bound of a frame of voxels. It has copies of all inputs, because a program may ask
// for the bound when the camera, the look or the whole scene has changed.
std::function<double()> BoundOf(
  const std::shared_ptr<const VolumeSummary>& summary, const Frame& frame)
{
  if (!IsPlainComposite(frame, !summary->areFinite))
  {
    return [] { return 1.0; };
  }
  const glm::dmat4 worldFromGrid(frame.geometry.worldFromGrid);
  return
    [summary, worldFromGrid,
      look = MaterialTablesOf(frame.material.property, frame.settings).front().transferFunction,
      rays = ComputePixelRays(
        ClipFromWorld(frame.view.renderer) * worldFromGrid, frame.geometry.boxGrid),
      pixels = glm::ivec2(frame.view.viewport.width, frame.view.viewport.height),
      isLit = frame.settings.shading || frame.settings.occlusion]
  {
    const OpticalTable table = BuildOpticalTable(look, summary->smallest, summary->largest);
    const std::vector<float> bounds =
      LevelBounds({ summary->ranges, table, rays, pixels, glm::dmat3(worldFromGrid), isLit });
    return bounds.empty() ? 0.0 : double(*std::max_element(bounds.begin(), bounds.end()));
  };
}

}

bool IsInteractive(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  constexpr double LongestInteractiveSeconds = 1.0;
  return mapper->GetAutoAdjustSampleDistances() &&
    volume->GetAllocatedRenderTime() < LongestInteractiveSeconds && !Picks(frame.pass.kind);
}

// Both levels fill the same places: the voxels of the coarse one are in the middle of their cubes.
void LevelOfDetail::UpdateImage(const std::shared_ptr<const VolumeSummary>& newSummary,
  vtkDataArray* scalarsOfVoxels, vtkImageData* voxels)
{
  constexpr double Side = CoarseLevel::Side;
  if (this->summary != newSummary)
  {
    const CoarseLevel& coarse = newSummary->coarse;
    const auto scalars = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(scalarsOfVoxels->GetDataType()));
    const vtkIdType count =
      vtkIdType(coarse.voxelCount.x) * coarse.voxelCount.y * coarse.voxelCount.z;
    // The array only reads: its owner is the summary.
    scalars->SetVoidArray(const_cast<std::uint8_t*>(coarse.voxels.data()), count, 1);
    scalars->SetName(scalarsOfVoxels->GetName());
    this->image = vtkSmartPointer<vtkImageData>::New();
    this->image->SetDimensions(coarse.voxelCount.x, coarse.voxelCount.y, coarse.voxelCount.z);
    this->image->GetPointData()->SetScalars(scalars);
    this->summary = newSummary;
  }
  const int* const extent = voxels->GetExtent();
  double origin[3];
  constexpr double Middle = 0.5 * (Side - 1.0);
  voxels->TransformContinuousIndexToPhysicalPoint(
    extent[0] + Middle, extent[2] + Middle, extent[4] + Middle, origin);
  const double* const spacing = voxels->GetSpacing();
  this->image->SetOrigin(origin);
  this->image->SetSpacing(Side * spacing[0], Side * spacing[1], Side * spacing[2]);
  this->image->SetDirectionMatrix(voxels->GetDirectionMatrix());
}

std::optional<Frame> LevelOfDetail::FrameInstead(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  if (Picks(frame.pass.kind))
  {
    return std::nullopt; // points and cells have the numbers of the voxels
  }
  this->bound = nullptr;
  const int wanted = mapper->GetLevelOfDetail();
  const bool isCoarse = wanted == vtkVariationFieldVolumeMapper::CoarseLevel ||
    (wanted == vtkVariationFieldVolumeMapper::AutomaticLevel &&
      IsInteractive(mapper, volume, frame));
  auto* const voxels = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  const bool mayBeCoarse = isCoarse && voxels && frame.others.empty() &&
    frame.settings.mask == Mask::None && !frame.voxels.blanking.Any();
  const auto known = mayBeCoarse ? SummaryOf(frame.voxels.scalars) : nullptr;
  const bool hasLevel = known && !known->coarse.voxels.empty() &&
    frame.voxels.scalars->GetNumberOfTuples() == voxels->GetNumberOfPoints();
  if (!hasLevel)
  {
    return std::nullopt;
  }
  this->UpdateImage(known, frame.voxels.scalars, voxels);
  std::optional<Frame> coarse = BuildFrame(mapper, frame.view.renderer, volume, this->image);
  if (coarse)
  {
    this->bound = BoundOf(known, frame);
  }
  return coarse;
}

void LevelOfDetail::Release(vtkWindow* window)
{
  this->marcher.Release(window);
}

}
