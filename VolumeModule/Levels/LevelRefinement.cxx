#include "Levels/LevelRefinement.h"

#include "Core/Geometry/LightCone.h"
#include "Core/Geometry/SphereQuadrature.h"
#include "Core/Look/OpticalTable.h"
#include "Core/Packets/PacketScene.h"
#include "Readers/Paging/MappedMemory.h"
#include "Readers/VoxelLayout.h"
#include "Resources/ValueFocus.h"

#include "vtkDataArray.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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

// The largest number that a lamp makes of a colour of at most 1, on a surface that faces it.
double LitBy(const glm::dvec4& reflectance, const glm::vec4* texels)
{
  const glm::dvec3 lit =
    reflectance.y * glm::dvec3(texels[1]) + reflectance.z * glm::dvec3(texels[2]);
  return std::max({ lit.x, lit.y, lit.z });
}

// The largest number that lights make of a colour of at most 1, on a surface that faces them all.
// It is infinite for a lamp that is brighter the nearer it is, without a limit.
double LitByAllLights(const Frame& frame)
{
  auto [diffuse, specular] = frame.lights.head;
  const LightTexels& lamps = frame.lights.lamps;
  for (int lamp = 0; lamp < lamps.Count(); ++lamp)
  {
    const glm::vec4* const texel = &lamps.texels[std::size_t(lamp) * LightTexels::PerLight];
    const double strength = lamp < lamps.distantCount ? 1.0 : 1.0 / double(texel[3].x);
    diffuse += strength * glm::dvec3(texel[1]);
    specular += strength * glm::dvec3(texel[2]);
  }
  const glm::dvec4& reflectance = frame.material.reflectances.front();
  const glm::dvec3 lit =
    reflectance.x * frame.lights.ambient + reflectance.y * diffuse + reflectance.z * specular;
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

int ShadowedCount(const Frame& frame, const LightTexels& lamps)
{
  return frame.settings.shadows ? std::min(lamps.Count(), MostShadowedLights) : 0;
}

const glm::vec4* TexelsOf(const LightTexels& lamps, int lamp)
{
  return &lamps.texels[std::size_t(lamp) * LightTexels::PerLight];
}

// A light from infinity that casts shadows, one with a cone as all of its directions.
void AddDistant(const Frame& frame, const glm::vec4* texels, std::vector<LevelLight>& lights)
{
  const glm::dvec4& reflectance = frame.material.reflectances.front();
  const glm::dmat3 gridFromWorld = glm::inverse(frame.geometry.WorldFromGridDirection());
  const glm::dvec3 towards(texels[0]);
  const double strength = frame.material.surfacesInShadow * LitBy(reflectance, texels);
  const double coneHeight = texels[0].w;
  if (coneHeight == 0.0 && strength > 0.0)
  {
    lights.push_back({ gridFromWorld * towards, strength });
  }
  for (int i = 0; i < ConeDirections && coneHeight > 0.0 && strength > 0.0; ++i)
  {
    const WeightedDirection one =
      DirectionsInCone(towards, std::acos(1.0 - coneHeight))[std::size_t(i)];
    lights.push_back({ gridFromWorld * one.direction, one.weight * strength });
  }
}

// A lamp near the volume that casts sharp shadows, where it is brightest.
void AddNear(const Frame& frame, const glm::vec4* texels, std::vector<LevelLight>& lights)
{
  const glm::dvec4& reflectance = frame.material.reflectances.front();
  const double strength =
    frame.material.surfacesInShadow * LitBy(reflectance, texels) / double(texels[3].x);
  const glm::dmat4 worldFromGrid(frame.geometry.worldFromGrid);
  const glm::dvec4 place = glm::inverse(worldFromGrid) * glm::dvec4(glm::dvec3(texels[0]), 1.0);
  if (strength > 0.0)
  {
    lights.push_back({ glm::dvec3(0.0), strength, std::numeric_limits<double>::infinity(),
      LampPlace{ glm::dvec3(place), glm::dmat3(worldFromGrid) } });
  }
}

// The directions of ambient occlusion, which darkens all that a place shows.
void AddSky(const Frame& frame, double brightest, std::vector<LevelLight>& lights)
{
  const glm::dmat3 gridFromWorld = glm::inverse(frame.geometry.WorldFromGridDirection());
  const double reachMm = std::min(frame.material.occlusionReachMm, frame.geometry.DiagonalMm());
  for (const WeightedDirection& one : SphereQuadrature())
  {
    lights.push_back({ gridFromWorld * one.direction,
      one.weight * frame.material.occlusion * brightest, reachMm });
  }
}

// Everything that matter may keep from a place.
std::vector<LevelLight> DimmedLightsOf(const Frame& frame, double brightest)
{
  const LightTexels& lamps = frame.lights.lamps;
  std::vector<LevelLight> lights;
  for (int lamp = 0; lamp < ShadowedCount(frame, lamps); ++lamp)
  {
    lamp < lamps.distantCount ? AddDistant(frame, TexelsOf(lamps, lamp), lights)
                              : AddNear(frame, TexelsOf(lamps, lamp), lights);
  }
  if (frame.settings.occlusion && frame.material.occlusion > 0.0)
  {
    AddSky(frame, brightest, lights);
  }
  return lights;
}

bool HasSoftLamps(const Frame& frame)
{
  const LightTexels& lamps = frame.lights.lamps;
  bool isSoft = false;
  for (int lamp = lamps.distantCount; lamp < ShadowedCount(frame, lamps); ++lamp)
  {
    isSoft = isSoft || TexelsOf(lamps, lamp)->w > 0.0f;
  }
  return isSoft;
}

// Half of the memory of the voxels; the program, fields and levels have the rest.
double MemoryOf(const Frame& frame)
{
  const auto voxels = PagedVoxelsOf(frame.voxels.scalars);
  return voxels ? 0.5 * double(MostBytesOf(*voxels)) : std::numeric_limits<double>::infinity();
}

std::optional<VoxelUnits> UnitsOf(const Frame& frame)
{
  const auto voxels = PagedVoxelsOf(frame.voxels.scalars);
  return voxels && voxels->Units() ? std::optional<VoxelUnits>(*voxels->Units()) : std::nullopt;
}

double LargestOf(const std::vector<double>& bounds)
{
  return bounds.empty() ? 0.0 : *std::max_element(bounds.begin(), bounds.end());
}

std::size_t CountOf(const BlockLevels& levels, BlockLevel level)
{
  return std::size_t(std::count(levels.ofBlocks.begin(), levels.ofBlocks.end(), level));
}

std::size_t CountVisible(const BlockLevels& levels)
{
  return levels.ofBlocks.size() - CountOf(levels, BlockLevel::Nothing);
}

}

BlockLooks LevelInputs::Looks() const
{
  const OpticalTable table =
    BuildOpticalTable(this->look, this->resolved.lower, this->resolved.upper);
  return BlockLooks(*this->summary, this->type, table, this->brightest, this->middle);
}

std::optional<LevelInputs> LevelInputsOf(const std::shared_ptr<const VolumeSummary>& summary,
  const std::vector<MiddleLevel>& middle, const Frame& frame)
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
  const TransferFunction& look = frame.material.functions.ofMaterials.front().transferFunction;
  const ScalarTexels all = ScalarTexelsOf(frame.voxels.components).front();
  return LevelInputs{ summary, middle, *type, look,
    Focused(all, all, look.ChangingValues()).resolved, frame.fingerprint,
    ComputePixelRays(frame.ClipFromGrid(), frame.geometry.boxGrid),
    glm::ivec2(frame.view.viewport.width, frame.view.viewport.height), glm::dmat3(worldFromGrid),
    frame.geometry.boxGrid, brightest, DimmedLightsOf(frame, brightest.value_or(1.0)),
    HasSoftLamps(frame), MemoryOf(frame), UnitsOf(frame) };
}

double BoundOfLevelAlone(const LevelInputs& inputs)
{
  const BlockLooks looks = inputs.Looks();
  const std::vector<double> bounds = LevelBounds(inputs.SceneOf(looks, true), looks.Coarse());
  return LargestOf(bounds);
}

LevelRefinement::LevelRefinement(
  Fingerprint newFingerprint, const LevelInputs& newInputs, const LevelRefinement* sameLooks)
  : fingerprint(std::move(newFingerprint))
  , inputs(newInputs)
  , looks(sameLooks ? sameLooks->looks : nullptr)
{
}

double LevelRefinement::BlockBytes() const
{
  const std::size_t voxelBytes =
    ByVoxelType(this->inputs.type, [](auto voxel) { return sizeof(voxel); });
  const double side = this->looks->CellsPerSide();
  return side * side * side * double(voxelBytes);
}

double LevelRefinement::HeldBytes() const
{
  return this->inputs.units ? double(this->inputs.units->MostBytesFor(*this->levels))
                            : double(this->refined) * this->BlockBytes();
}

// An image takes at most 128 MB of voxels more than the one before, which are read from chunks in a
// second or a few, or twice as many, so that all images read little more than the last does.
RefinementRound LevelRefinement::NextRound(double tolerance) const
{
  constexpr double PartPerRound = 1.0 / 4.0;
  constexpr double MostBytes = 128e6;
  if (!this->NextFits())
  {
    return { tolerance };
  }
  return { std::max(tolerance, PartPerRound * this->bound),
    std::size_t(std::max({ 1.0, MostBytes / this->BlockBytes(), double(this->refined) })) };
}

void LevelRefinement::Refine(double tolerance)
{
  if (this->bound <= tolerance)
  {
    return;
  }
  ++this->rounds;
  if (!this->levels)
  {
    this->Begin();
    if (this->bound < 1.0)
    {
      return; // an image with its error is shown before voxels are read
    }
  }
  const auto next = std::make_shared<BlockLevels>(*this->levels);
  varimarch::Refine(
    this->inputs.SceneOf(*this->looks, false), this->NextRound(tolerance), *next, this->bounds);
  this->bound = LargestOf(this->bounds);
  this->levels = next;
  this->refined = CountOf(*next, BlockLevel::Voxels);
  this->heldBytes = this->HeldBytes();
}

void LevelRefinement::Begin()
{
  this->looks = this->looks ? this->looks : std::make_shared<BlockLooks>(this->inputs.Looks());
  this->levels = std::make_shared<BlockLevels>(this->looks->Begun());
  this->visible = CountVisible(*this->levels);
  this->bounds = LevelBounds(this->inputs.SceneOf(*this->looks, false), *this->levels);
  this->bound = LargestOf(this->bounds);
}

}
