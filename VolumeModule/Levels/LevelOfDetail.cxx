#include "Levels/LevelOfDetail.h"

#include "Frame/FrameBuilder.h"
#include "Readers/Paging/MappedMemory.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

// True if blocks may have different levels: what their voxels look like depends on no other block,
// and no light is brighter than all bounds. A lamp that dims with the distance alone is.
bool CanBeRefined(const LevelInputs& inputs)
{
  return inputs.summary->areFinite && !inputs.hasSoftLamps &&
    std::all_of(inputs.lights.begin(), inputs.lights.end(),
      [](const LevelLight& light) { return std::isfinite(light.strength); });
}

// True while a scene whose voxels are drawn in parts is still shown by its coarse level: parts of
// voxels may take long to be read, or steps to be found for them.
bool Begins(const DrawnView& view, const Fingerprint& fingerprint, bool lastIsWhole)
{
  return view.begun != fingerprint || (view.beginsStill && !lastIsWhole);
}

// True if images of a frame are drawn in parts, of which the first ones show the coarse level.
bool IsInParts(vtkVariationFieldVolumeMapper* mapper, const Frame& frame)
{
  return mapper->GetLongestPartSeconds() > 0.0 && !frame.accumulation.fingerprint.IsEmpty() &&
    frame.pass.kind == RayPass::Whole;
}

// True if an image is of the coarse level for what the mapper wants of it alone.
bool WantsCoarseLevel(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  const int wanted = mapper->GetLevelOfDetail();
  return wanted == vtkVariationFieldVolumeMapper::CoarseLevel ||
    (wanted != vtkVariationFieldVolumeMapper::VoxelLevel && IsInteractive(mapper, volume, frame));
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

namespace
{

vtkSmartPointer<vtkImageData> ImageOf(vtkDataArray* scalars, const glm::ivec3& voxelCount)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(voxelCount.x, voxelCount.y, voxelCount.z);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// Means that are in the middle of their cubes.
vtkSmartPointer<vtkImageData> ImageOfMeans(const CoarseLevel& coarse, vtkDataArray* voxels)
{
  const auto scalars =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(voxels->GetDataType()));
  const vtkIdType count =
    vtkIdType(coarse.voxelCount.x) * coarse.voxelCount.y * coarse.voxelCount.z;
  // The array only reads: its owner is the summary.
  scalars->SetVoidArray(const_cast<std::uint8_t*>(coarse.voxels.data()), count, 1);
  scalars->SetName(voxels->GetName());
  return ImageOf(scalars, coarse.voxelCount);
}

/// Puts the image of a level where its voxels are among those of another.
/// @param first  place of its first voxel, counted from the first of the other
/// @param scale  distances of its voxels, in those of the other
void Place(
  vtkImageData* image, const glm::dvec3& first, const glm::dvec3& scale, vtkImageData* other)
{
  const int* const extent = other->GetExtent();
  double origin[3];
  other->TransformContinuousIndexToPhysicalPoint(
    extent[0] + first.x, extent[2] + first.y, extent[4] + first.z, origin);
  const double* const spacing = other->GetSpacing();
  image->SetOrigin(origin);
  image->SetSpacing(scale.x * spacing[0], scale.y * spacing[1], scale.z * spacing[2]);
  image->SetDirectionMatrix(other->GetDirectionMatrix());
}

}

// All levels fill the same places.
void LevelOfDetail::UpdateImages(const std::shared_ptr<const VolumeSummary>& newSummary,
  vtkDataArray* scalarsOfVoxels, vtkImageData* voxels)
{
  if (this->summary != newSummary)
  {
    this->middle.clear();
    this->images.clear();
    for (const PagedLevel& level : PagedVoxelsOf(scalarsOfVoxels)->Coarser())
    {
      this->middle.push_back({ SummaryOf(level.scalars), level.first, level.scale });
      this->images.push_back(ImageOf(level.scalars, level.voxelCount));
    }
    this->images.push_back(ImageOfMeans(newSummary->coarse, scalarsOfVoxels));
    this->summary = newSummary;
  }
  for (std::size_t i = 0; i < this->middle.size(); ++i)
  {
    Place(this->images[i], this->middle[i].first, this->middle[i].scale, voxels);
  }
  const double side = newSummary->coarse.side;
  Place(this->images.back(), glm::dvec3(0.5 * (side - 1.0)), glm::dvec3(side), voxels);
}

// The level for the next image: VoxelLevel, CoarseLevel or RefinedLevel.
int LevelOfDetail::LevelNow(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole)
{
  const int wanted = mapper->GetLevelOfDetail();
  DrawnView& view = this->ViewOf(frame);
  view.isComplete = true;
  if (wanted != vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    view.refinement.reset();
  }
  if (WantsCoarseLevel(mapper, volume, frame))
  {
    return vtkVariationFieldVolumeMapper::CoarseLevel;
  }
  if (wanted != vtkVariationFieldVolumeMapper::AutomaticLevel)
  {
    return wanted;
  }
  if (!IsInParts(mapper, frame))
  {
    return vtkVariationFieldVolumeMapper::VoxelLevel;
  }
  view.beginsStill = Begins(view, frame.accumulation.fingerprint, lastIsWhole);
  view.begun = frame.accumulation.fingerprint;
  view.isComplete = !view.beginsStill;
  return view.beginsStill ? vtkVariationFieldVolumeMapper::CoarseLevel
                          : vtkVariationFieldVolumeMapper::VoxelLevel;
}

std::optional<Frame> LevelOfDetail::CoarseFrameAhead(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole)
{
  auto* const voxels = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  const auto known = SummaryWithLevel(frame, voxels);
  const auto view = this->FindView(frame);
  const bool isAutomatic =
    mapper->GetLevelOfDetail() == vtkVariationFieldVolumeMapper::AutomaticLevel;
  const bool begins = isAutomatic && IsInParts(mapper, frame) &&
    (view == this->views.end() || Begins(*view, frame.accumulation.fingerprint, lastIsWhole));
  if (!known || !(begins || WantsCoarseLevel(mapper, volume, frame)))
  {
    return std::nullopt;
  }
  this->UpdateImages(known, frame.voxels.scalars, voxels);
  return this->CoarseFrame(mapper, volume, frame);
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
  const auto known = SummaryWithLevel(frame, vtkImageData::SafeDownCast(mapper->GetDataSetInput()));
  if (!known)
  {
    this->ForgetScene(this->ViewOf(frame));
    return std::nullopt;
  }
  const int level = this->LevelNow(mapper, volume, frame, lastIsWhole);
  if (level == vtkVariationFieldVolumeMapper::VoxelLevel)
  {
    return std::nullopt;
  }
  this->UpdateImages(
    known, frame.voxels.scalars, vtkImageData::SafeDownCast(mapper->GetDataSetInput()));
  const std::optional<LevelInputs> inputs = LevelInputsOf(known, this->middle, frame);
  if (level == vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    if (!inputs || !CanBeRefined(*inputs))
    {
      return std::nullopt;
    }
    DrawnView& view = this->views.front();
    this->Refine(view, frame.refinement, *inputs, lastIsWhole ? LevelTolerance(frame) : 1.0);
    view.isComplete = view.refinement->Bound() <= LevelTolerance(frame);
    if (view.refinement->Rounds() > 0)
    {
      return this->RefinedFrame(*view.refinement, frame, this->LevelFrames(mapper, volume, frame));
    }
  }
  this->bound = [inputs] { return inputs ? BoundOfLevelAlone(*inputs) : 1.0; };
  this->drawn.level = vtkVariationFieldVolumeMapper::CoarseLevel;
  return this->CoarseFrame(mapper, volume, frame);
}

std::optional<Frame> LevelOfDetail::CoarseFrame(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  return BuildFrame(mapper, frame.view.renderer, volume, this->images.back());
}

std::vector<Frame> LevelOfDetail::LevelFrames(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame)
{
  std::vector<Frame> frames;
  for (const vtkSmartPointer<vtkImageData>& image : this->images)
  {
    // A frame is empty only where that of the voxels is.
    frames.push_back(*BuildFrame(mapper, frame.view.renderer, volume, image));
  }
  return frames;
}

void LevelOfDetail::ForgetScene(DrawnView& view)
{
  view.isComplete = true;
  view.refinement.reset();
  view.begun = {};
}

// Several renderers, and the eyes of a stereo image, are drawn in turn.
std::list<DrawnView>::iterator LevelOfDetail::FindView(const Frame& frame)
{
  return std::find_if(this->views.begin(), this->views.end(),
    [&](const DrawnView& view)
    { return view.renderer == frame.view.renderer && view.isLeftEye == frame.view.isLeftEye; });
}

DrawnView& LevelOfDetail::ViewOf(const Frame& frame)
{
  constexpr std::size_t MostViews = 64; // one more than are drawn in turn would never be refined
  this->views.remove_if([](const DrawnView& view) { return !view.renderer; });
  const auto found = this->FindView(frame);
  if (found == this->views.end())
  {
    this->views.emplace_front();
    this->views.front().renderer = frame.view.renderer;
    this->views.front().isLeftEye = frame.view.isLeftEye;
    if (this->views.size() > MostViews)
    {
      this->views.pop_back();
    }
  }
  else
  {
    this->views.splice(this->views.begin(), this->views, found);
  }
  this->views.front().lastDrawing = ++this->drawings;
  return this->views.front();
}

// A view that nobody draws any more is left out after a round of the others.
bool LevelOfDetail::MayBeRefined() const
{
  return std::any_of(this->views.begin(), this->views.end(),
    [&](const DrawnView& view)
    { return !view.isComplete && this->drawings - view.lastDrawing < this->views.size(); });
}

// The first image of a scene is of the coarse level.
void LevelOfDetail::Refine(
  DrawnView& view, const Fingerprint& fingerprint, const LevelInputs& inputs, double tolerance)
{
  if (view.refinement && view.refinement->IsOf(fingerprint))
  {
    view.refinement->Refine(tolerance);
    return;
  }
  const auto other = std::find_if(this->views.begin(), this->views.end(),
    [&](const DrawnView& drawnView)
    { return drawnView.refinement && drawnView.refinement->HasLooksFor(inputs); });
  view.refinement = std::make_unique<LevelRefinement>(
    fingerprint, inputs, other == this->views.end() ? nullptr : other->refinement.get());
}

Frame LevelOfDetail::RefinedFrame(
  const LevelRefinement& refinement, const Frame& frame, std::vector<Frame> coarser)
{
  this->bound = [bound = refinement.Bound()] { return bound; };
  this->drawn.level = vtkVariationFieldVolumeMapper::RefinedLevel;
  this->drawn.visibleBlocks = refinement.VisibleBlocks();
  this->drawn.refinedBlocks = refinement.RefinedBlocks();
  this->drawn.nextFits = refinement.NextFits();
  Frame refined = frame;
  refined.coarser = std::move(coarser);
  refined.blockLevels = refinement.Levels();
  refined.voxelsFit = refinement.NextFits();
  QualityRequest& quality = refined.quality;
  quality.budget.tolerance *= 1.0 - LevelShare;
  quality.earlyTerminationTransmittance =
    quality.budget.EarlyTermination(quality.earlyTerminationTransmittance);
  for (Frame& level : refined.coarser)
  {
    level.quality = quality;
  }
  // Other levels make another image, which needs other steps.
  refined.levelRound = refinement.Rounds();
  if (!refined.accumulation.fingerprint.IsEmpty())
  {
    refined.accumulation.fingerprint.Add(refined.levelRound);
  }
  return refined;
}

void LevelOfDetail::Release(vtkWindow* window)
{
  this->marcher.Release(window);
}

}
