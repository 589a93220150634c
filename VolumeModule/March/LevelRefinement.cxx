#include "March/LevelRefinement.h"

#include "Core/Look/OpticalTable.h"
#include "Frame/Lights.h"
#include "Readers/VoxelLayout.h"
#include "Resources/MaterialTables.h"
#include "Resources/ValueFocus.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
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
    !settings.sceneGeometry && !Peels(frame.pass.kind) && settings.mask == Mask::None &&
    frame.cuts.boxGrid.lower == frame.geometry.boxGrid.lower &&
    frame.cuts.boxGrid.upper == frame.geometry.boxGrid.upper;
  const bool hasClearGaps = !hasGaps || frame.material.gapOptical.a == 0.0;
  return settings.blend == Blend::Composite && settings.functionOf == FunctionOf::Value &&
    !settings.cubic && !settings.gradientOpacity && !settings.windowLevel && !settings.scattering &&
    isWhole && hasClearGaps && frame.others.empty() && frame.userCode.IsEmpty();
}

// The largest number that lights make of a colour of at most 1, on a surface that faces them all.
// It is infinite for a lamp that is brighter the nearer it is, without a limit.
double LitByAllLights(const Frame& frame)
{
  vtkRenderer* const renderer = frame.view.renderer;
  auto [diffuse, specular] = HeadLightColorsOf(renderer);
  const LightTexels lamps = LightTexelsOf(renderer);
  for (int lamp = 0; lamp < lamps.distantCount + lamps.nearCount; ++lamp)
  {
    const glm::vec4* const texel = &lamps.texels[std::size_t(lamp) * LightTexels::PerLight];
    const double strength = lamp < lamps.distantCount ? 1.0 : 1.0 / double(texel[3].x);
    diffuse += strength * glm::dvec3(texel[1]);
    specular += strength * glm::dvec3(texel[2]);
  }
  const glm::dvec4 reflectance = ReflectanceOf(frame.material.property, 0);
  const glm::dvec3 lit =
    reflectance.x * AmbientLightOf(renderer) + reflectance.y * diffuse + reflectance.z * specular;
  return std::max({ 1.0, lit.x, lit.y, lit.z });
}

std::optional<double> BrightestOf(const Frame& frame)
{
  if (frame.settings.shading)
  {
    return LitByAllLights(frame);
  }
  return frame.settings.occlusion ? std::optional<double>(1.0) : std::nullopt;
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
    BuildOpticalTable(this->look, this->resolved.lower, this->resolved.upper);
  return BlockLooks(*this->summary, this->type, table, this->brightest);
}

std::optional<LevelInputs> LevelInputsOf(
  const std::shared_ptr<const VolumeSummary>& summary, const Frame& frame)
{
  const std::optional<VoxelType> type = VoxelTypeOf(frame.voxels.scalars->GetDataType());
  if (!type || !IsPlainComposite(frame, !summary->areFinite))
  {
    return std::nullopt;
  }
  const std::optional<double> brightest = BrightestOf(frame);
  if (brightest && !std::isfinite(*brightest))
  {
    return std::nullopt;
  }
  const glm::dmat4 worldFromGrid(frame.geometry.worldFromGrid);
  const TransferFunction look =
    MaterialTablesOf(frame.material.property, frame.settings).front().transferFunction;
  const ScalarTexels all = ScalarTexelsOf(frame.voxels.components).front();
  return LevelInputs{ summary, *type, look, Focused(all, all, look.ChangingValues()).resolved,
    frame.fingerprint,
    ComputePixelRays(ClipFromWorld(frame.view.renderer) * worldFromGrid, frame.geometry.boxGrid),
    glm::ivec2(frame.view.viewport.width, frame.view.viewport.height), glm::dmat3(worldFromGrid),
    frame.geometry.boxGrid, brightest };
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
