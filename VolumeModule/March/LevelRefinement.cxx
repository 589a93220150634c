#include "March/LevelRefinement.h"

#include "Core/Look/OpticalTable.h"
#include "Readers/VoxelLayout.h"
#include "Resources/MaterialTables.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <utility>

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

double LargestOf(const std::vector<double>& bounds)
{
  return bounds.empty() ? 0.0 : *std::max_element(bounds.begin(), bounds.end());
}

std::size_t BlocksOfVoxels(const BlockLevels& levels)
{
  return std::size_t(std::count(levels.areVoxels.begin(), levels.areVoxels.end(), std::uint8_t(1)));
}

}

BlockLooks LevelInputs::Looks() const
{
  const OpticalTable table =
    BuildOpticalTable(this->look, this->summary->smallest, this->summary->largest);
  return BlockLooks(*this->summary, this->type, table, this->isLit);
}

std::optional<LevelInputs> LevelInputsOf(
  const std::shared_ptr<const VolumeSummary>& summary, const Frame& frame)
{
  const std::optional<VoxelType> type = VoxelTypeOf(frame.voxels.scalars->GetDataType());
  if (!type || !IsPlainComposite(frame, !summary->areFinite))
  {
    return std::nullopt;
  }
  const glm::dmat4 worldFromGrid(frame.geometry.worldFromGrid);
  return LevelInputs{ summary, *type,
    MaterialTablesOf(frame.material.property, frame.settings).front().transferFunction,
    frame.fingerprint,
    ComputePixelRays(ClipFromWorld(frame.view.renderer) * worldFromGrid, frame.geometry.boxGrid),
    glm::ivec2(frame.view.viewport.width, frame.view.viewport.height), glm::dmat3(worldFromGrid),
    frame.geometry.boxGrid, frame.settings.shading || frame.settings.occlusion };
}

double BoundOfLevelAlone(const LevelInputs& inputs)
{
  const BlockLooks looks = inputs.Looks();
  const std::vector<double> bounds = LevelBounds(inputs.SceneOf(looks, true), looks.Coarse());
  return LargestOf(bounds);
}

LevelRefinement::LevelRefinement(
  std::vector<double> newFingerprint, const LevelInputs& newInputs, const LevelRefinement* before)
  : fingerprint(std::move(newFingerprint))
  , inputs(newInputs)
  , bounds(std::size_t(newInputs.pixels.x) * std::size_t(newInputs.pixels.y), 1.0)
  , looks(before && before->inputs.HasLooksOf(newInputs) ? before->looks : nullptr)
{
}

void LevelRefinement::Refine(double tolerance)
{
  constexpr double PartPerRound = 1.0 / 4.0;
  if (this->bound <= tolerance)
  {
    return;
  }
  if (!this->levels)
  {
    this->looks = this->looks ? this->looks : std::make_shared<BlockLooks>(this->inputs.Looks());
    this->levels = std::make_shared<BlockLevels>(this->looks->Begun());
    this->visible = this->levels->areVoxels.size() - BlocksOfVoxels(*this->levels);
  }
  const auto next = std::make_shared<BlockLevels>(*this->levels);
  varimarch::Refine(this->inputs.SceneOf(*this->looks, false),
    std::max(tolerance, PartPerRound * this->bound), *next, this->bounds);
  this->bound = LargestOf(this->bounds);
  this->levels = next;
  this->refined = BlocksOfVoxels(*next) - (next->areVoxels.size() - this->visible);
  ++this->rounds;
}

}
