#include "March/LevelOfDetail.h"

#include "Frame/FrameBuilder.h"
#include "Frame/SceneFingerprint.h"
#include "Readers/MappedScalars.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

namespace varimarch
{

namespace
{

// Levels and everything else may each use half of the tolerance.
constexpr double LevelShare = 0.5;

double LevelTolerance(const Frame& frame)
{
  constexpr double WithoutTolerance = 1.0 / 64.0;
  const ErrorBudget& budget = frame.quality.budget;
  return LevelShare * (budget.HasTolerance() ? budget.tolerance : WithoutTolerance);
}

// True if blocks may have different levels: what their voxels look like depends on no other block.
bool MayBeRefined(const LevelInputs& inputs, const Frame& frame)
{
  return inputs.summary->areFinite && !frame.settings.shadows && !frame.settings.occlusion;
}

// The level for the next image: VoxelLevel, CoarseLevel or RefinedLevel.
int LevelNow(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  const int wanted = mapper->GetLevelOfDetail();
  const bool isMoving =
    wanted != vtkVariationFieldVolumeMapper::VoxelLevel && IsInteractive(mapper, volume, frame);
  const int atRest = wanted == vtkVariationFieldVolumeMapper::AutomaticLevel
    ? vtkVariationFieldVolumeMapper::VoxelLevel
    : wanted;
  return isMoving ? vtkVariationFieldVolumeMapper::CoarseLevel : atRest;
}

// The summary of voxels that are drawn alone, with a coarse level; null for others.
std::shared_ptr<const VolumeSummary> SummaryWithLevel(const Frame& frame, vtkImageData* voxels)
{
  const bool arePlain = voxels && frame.others.empty() && frame.settings.mask == Mask::None &&
    !frame.voxels.blanking.Any();
  auto known = arePlain ? SummaryOf(frame.voxels.scalars) : nullptr;
  const bool hasLevel = known && !known->coarse.voxels.empty() &&
    frame.voxels.scalars->GetNumberOfTuples() == voxels->GetNumberOfPoints();
  return hasLevel ? known : nullptr;
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
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole)
{
  if (Picks(frame.pass.kind))
  {
    return std::nullopt; // points and cells have the numbers of the voxels
  }
  this->bound = nullptr;
  this->drawn = {};
  const int level = LevelNow(mapper, volume, frame);
  const auto known = level != vtkVariationFieldVolumeMapper::VoxelLevel
    ? SummaryWithLevel(frame, vtkImageData::SafeDownCast(mapper->GetDataSetInput()))
    : nullptr;
  const std::optional<LevelInputs> inputs = known ? LevelInputsOf(known, frame) : std::nullopt;
  const bool isRefined = level == vtkVariationFieldVolumeMapper::RefinedLevel;
  if (!known || (isRefined && !(inputs && MayBeRefined(*inputs, frame))))
  {
    return std::nullopt;
  }
  std::optional<Frame> coarse = this->CoarseFrame(mapper, volume, frame, known);
  if (coarse && isRefined)
  {
    this->Refine(
      ImageFingerprint(mapper, frame), *inputs, lastIsWhole ? LevelTolerance(frame) : 1.0);
    this->drawn.mayBeRefined = this->refinement->Bound() > LevelTolerance(frame);
    if (this->refinement->Rounds() > 0)
    {
      return this->RefinedFrame(frame, *coarse);
    }
  }
  if (coarse)
  {
    this->bound = [inputs] { return inputs ? BoundOfLevelAlone(*inputs) : 1.0; };
    this->drawn.level = vtkVariationFieldVolumeMapper::CoarseLevel;
  }
  return coarse;
}

std::optional<Frame> LevelOfDetail::CoarseFrame(vtkVariationFieldVolumeMapper* mapper,
  vtkVolume* volume, const Frame& frame, const std::shared_ptr<const VolumeSummary>& known)
{
  this->UpdateImage(
    known, frame.voxels.scalars, vtkImageData::SafeDownCast(mapper->GetDataSetInput()));
  return BuildFrame(mapper, frame.view.renderer, volume, this->image);
}

// The first image of a scene is of the coarse level.
void LevelOfDetail::Refine(
  const std::vector<double>& fingerprint, const LevelInputs& inputs, double tolerance)
{
  if (this->refinement && this->refinement->IsOf(fingerprint))
  {
    this->refinement->Refine(tolerance);
  }
  else
  {
    this->refinement =
      std::make_unique<LevelRefinement>(fingerprint, inputs, this->refinement.get());
  }
}

Frame LevelOfDetail::RefinedFrame(const Frame& frame, const Frame& coarse)
{
  this->bound = [bound = this->refinement->Bound()] { return bound; };
  this->drawn.level = vtkVariationFieldVolumeMapper::RefinedLevel;
  this->drawn.visibleBlocks = this->refinement->VisibleBlocks();
  this->drawn.refinedBlocks = this->refinement->RefinedBlocks();
  Frame refined = frame;
  refined.coarser = { coarse };
  refined.blockLevels = this->refinement->Levels();
  QualityRequest& quality = refined.quality;
  quality.budget.tolerance *= 1.0 - LevelShare;
  quality.earlyTerminationTransmittance =
    quality.budget.EarlyTermination(quality.earlyTerminationTransmittance);
  refined.coarser.front().quality = quality;
  // Other levels make another image, which needs other steps.
  refined.levelRound = this->refinement->Rounds();
  if (!refined.accumulation.fingerprint.empty())
  {
    refined.accumulation.fingerprint.push_back(refined.levelRound);
  }
  return refined;
}

void LevelOfDetail::Release(vtkWindow* window)
{
  this->marcher.Release(window);
}

}
