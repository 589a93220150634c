#include "Resources/VolumeResources.h"

#include "Core/Geometry/PixelRays.h"
#include "Core/Geometry/ProjectedBox.h"
#include "Core/Geometry/SplineCoefficients.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FiniteRange.h"
#include "Frame/SceneFingerprint.h"
#include "Readers/Paging/MappedMemory.h"
#include "Resources/ComponentCopy.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/RayAccumulation.h"
#include "Resources/ValueFocus.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();

// The number of blocks that fill the memory: enough that invisible blocks need not be resident, few
// enough that shared voxels and draw calls cost little.
constexpr std::size_t BlocksInMemory = 16;

// The limits of a volume that is not on the device.
BlockLimits WithoutLimits()
{
  return { std::numeric_limits<int>::max(), 1, NoLimit };
}

void CheckIsDrawnInBlocks(const RenderSettings& settings)
{
  if (settings.uneven)
  {
    throw std::runtime_error("Rectilinear grids cannot be drawn in blocks: the maximum graphics "
                             "memory, or the device's 3D textures, are too small for this one");
  }
  if (settings.countFetches)
  {
    throw std::runtime_error("Fetch counts cannot be drawn for a volume in blocks: the maximum "
                             "graphics memory, or the device's 3D textures, are too small for it");
  }
  if (settings.components != Components::One && settings.blend == Blend::AverageIntensity)
  {
    throw std::runtime_error(
      "The average intensity of several components cannot be drawn for a volume "
      "in blocks: the maximum graphics memory, or the device's 3D textures, "
      "are too small for it");
  }
}

}

std::size_t VolumeDivision::BytesForBlocks(
  const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const std::size_t accumulated =
    std::max(RayAccumulation::BytesFor(march.plan.viewport), elsewhere.accumulationBytes);
  const bool isWhole = this->blocks.Partition().Count() == 1;
  const std::size_t others = elsewhere.fixedBytes + (isWhole ? 0 : accumulated);
  return march.frame.device.mostMemoryBytes == 0
    ? NoLimit
    : march.frame.device.mostMemoryBytes - std::min(march.frame.device.mostMemoryBytes, others);
}

bool VolumeDivision::FitsMemory(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const glm::ivec3 voxels = march.frame.geometry.dimensions;
  const std::size_t most = march.frame.device.mostMemoryBytes;
  const std::size_t wholeBytes = this->blocks.BytesPerVoxel() * voxels.x * voxels.y * voxels.z;
  return most == 0 || elsewhere.fixedBytes + wholeBytes <= most;
}

bool VolumeDivision::MustBeDivided(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  return !this->FitsMemory(march, elsewhere) ||
    BlockPartition(march.frame.geometry.dimensions, this->LimitsOf(march, elsewhere)).Count() > 1;
}

BlockLimits VolumeDivision::LimitsOf(
  const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const glm::ivec3 voxels = march.frame.geometry.dimensions;
  BlockLimits limits{ vtkTextureObject::GetMaximumTextureSize3D(march.frame.view.window),
    this->blocks.BytesPerVoxel(), 0 };
  limits.largestBytes = limits.bytesPerVoxel *
    VolumeTexture::MostTexels(glm::min(voxels, limits.largestSide),
      this->blocks.TexelsOfComponents().size(), this->blocks.Format());
  if (this->FitsMemory(march, elsewhere))
  {
    return limits;
  }
  const std::size_t most = march.frame.device.mostMemoryBytes;
  const std::size_t others = elsewhere.fixedBytes +
    std::max(RayAccumulation::BytesFor(march.plan.viewport), elsewhere.accumulationBytes);
  const std::size_t smallest = BlockPartition::SmallestBytes(limits.bytesPerVoxel);
  if (others + smallest > most)
  {
    throw std::runtime_error("Cannot draw in a maximum graphics memory of " + std::to_string(most) +
      " bytes: this image of the volume needs at least " + std::to_string(others + smallest));
  }
  // Sizes are powers of two, so that a resized window rarely changes the division.
  std::size_t largest = most / BlocksInMemory;
  while (largest > most - others)
  {
    largest /= 2;
  }
  limits.largestBytes = std::min(limits.largestBytes, std::max(largest, smallest));
  return limits;
}

bool VolumeDivision::Update(
  const VolumeMarch& march, const FieldResources& fields, const MemoryElsewhere& elsewhere)
{
  vtkOpenGLRenderWindow* const window = march.frame.view.window;
  const bool isForDevice = march.plan.marcher == Marcher::Device;
  this->isTooLarge =
    isForDevice && march.settings.overlaps && this->MustBeDivided(march, elsewhere);
  const bool isInMemory = !isForDevice || this->isTooLarge;
  if (this->blocks.Divide(window, isInMemory ? WithoutLimits() : this->LimitsOf(march, elsewhere)))
  {
    this->visibleOfField = -1;
  }
  this->UpdateVisibleBoxes(march, fields);
  if (isInMemory)
  {
    this->blocks.BeginPicture(window, {}, 0); // releases all blocks
    return false;
  }
  if (this->blocks.Partition().Count() == 1)
  {
    this->blocks.BeginPicture(window, { 0 }, this->BytesForBlocks(march, elsewhere));
    const bool hasGaps = this->blocks.Take(window, 0).HasGaps();
    if (march.settings.uneven && hasGaps)
    {
      throw std::runtime_error("Rectilinear grids cannot be drawn with values that are not finite");
    }
    return hasGaps;
  }
  CheckIsDrawnInBlocks(march.settings);
  return this->blocks.MayHaveGaps();
}

// Rays begin at the box around the visible part, and rays that miss it are not marched.
void VolumeDivision::UpdateVisibleBoxes(const VolumeMarch& march, const FieldResources& fields)
{
  const bool knowsWhatIsVisible = march.settings.acceleration == Acceleration::OpticalField &&
    !IsProjection(march.settings.blend);
  const int fieldBuild = knowsWhatIsVisible ? fields.Builds() : 0;
  const Box& left = march.frame.cuts.boxGrid;
  if (this->visibleOfField == fieldBuild && this->visibleOfBox.lower == left.lower &&
    this->visibleOfBox.upper == left.upper)
  {
    return;
  }
  const auto visible = [&](const Box& box)
  {
    const Box part{ glm::max(box.lower, left.lower), glm::min(box.upper, left.upper) };
    const bool isEmpty = glm::any(glm::greaterThanEqual(part.lower, part.upper));
    return knowsWhatIsVisible && !isEmpty ? fields.OfBricks().VisibleBoxGrid(part) : part;
  };
  const BlockPartition& partition = this->blocks.Partition();
  this->visibleBox = visible(march.frame.geometry.boxGrid);
  this->visibleBoxes.clear();
  for (int block = 0; block < partition.Count(); ++block)
  {
    this->visibleBoxes.push_back(visible(partition.BoxOf(block, march.frame.geometry.boxGrid)));
  }
  this->visibleOfField = fieldBuild;
  this->visibleOfBox = left;
}

std::vector<int> VolumeDivision::InView(const VolumeMarch& march) const
{
  const glm::dmat4 clipFromGrid = march.frame.ClipFromGrid();
  const PixelRays rays = ComputePixelRays(clipFromGrid, this->visibleBox);
  std::vector<int> inView;
  for (int block : this->blocks.Partition().FrontToBack(rays.eyeGrid))
  {
    const Box& box = this->visibleBoxes[block];
    if (glm::all(glm::lessThan(box.lower, box.upper)) && IsInView(box, clipFromGrid))
    {
      inView.push_back(block);
    }
  }
  return inView;
}

void VolumeDivision::BeginPicture(
  const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere)
{
  this->blocks.BeginPicture(
    march.frame.view.window, inView, this->BytesForBlocks(march, elsewhere));
}

void VolumeDivision::Release(vtkWindow* window)
{
  this->blocks.Release(window);
  this->visibleOfField = -1;
}

namespace
{

template <class Coefficient>
vtkSmartPointer<vtkDataArray> CoefficientsOf(const ComponentCopy& voxels, glm::ivec3 dimensions)
{
  if (!voxels.allFinite)
  {
    throw std::runtime_error("Cubic interpolation of voxels that are not finite is not supported");
  }
  auto* const coefficients = static_cast<Coefficient*>(voxels.array->GetVoidPointer(0));
  TurnIntoSplineCoefficients(coefficients, dimensions);
  return voxels.array;
}

}

SplineVolume::SplineVolume(const VoxelComponents& components, glm::ivec3 dimensions)
{
  for (const VoxelComponent& component : components)
  {
    // Floats are precise enough for floats and for integers of up to 16 bits.
    const bool single =
      component.array->GetDataType() == VTK_FLOAT || component.array->GetDataTypeSize() <= 2;
    this->coefficients.push_back(single
        ? CoefficientsOf<float>(CopyAsFloats(component), dimensions)
        : CoefficientsOf<double>(CopyAsDoubles(component), dimensions));
  }
}

VoxelComponents SplineVolume::Components() const
{
  VoxelComponents components;
  for (const auto& array : this->coefficients)
  {
    components.push_back({ array, 0 });
  }
  return components;
}

std::vector<ScalarTexels> SplineVolume::Texels(const VoxelComponents& voxels) const
{
  std::vector<ScalarTexels> texels = ScalarTexelsOf(this->Components());
  const std::vector<ScalarTexels> texelsOfVoxels = ScalarTexelsOf(voxels);
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    texels[i].smallestScalar = texelsOfVoxels[i].smallestScalar;
    texels[i].largestScalar = texelsOfVoxels[i].largestScalar;
    texels[i].gray = texelsOfVoxels[i].gray;
    texels[i].finite = true;
  }
  return texels;
}

void VolumeResources::UpdateVoxels(const Frame& frame)
{
  this->Blocks().SetBlanking(frame.voxels.blanking);
  const bool isCubic = frame.settings.cubic;
  const VoxelComponents& components = frame.voxels.components;
  Fingerprint newVoxels(VoxelFingerprint(frame), isCubic);
  const bool areNew = this->voxels != newVoxels;
  Fingerprint valueInputs = ValueInputs(frame);
  if (!areNew && this->valueInputs == valueInputs)
  {
    return;
  }
  if (areNew)
  {
    this->voxels = {};
    const glm::ivec3 dimensions = frame.geometry.dimensions;
    this->spline = isCubic ? SplineVolume(components, dimensions) : SplineVolume();
    this->allValues = isCubic ? VoxelValues{ this->spline.Components(), dimensions,
      this->spline.Texels(components), SplineReachVoxels }
                              : VoxelValues{ components, dimensions, ScalarTexelsOf(components) };
    this->packets.SetVoxels(this->allValues.components, dimensions);
  }
  this->SetValues(frame, areNew);
  this->voxels = std::move(newVoxels);
  this->valueInputs = std::move(valueInputs);
}

// Other transfer functions need other texels only if some voxels are far beyond the values at which
// they change.
void VolumeResources::SetValues(const Frame& frame, bool areNew)
{
  VoxelValues values = this->allValues;
  const std::vector<ScalarTexels>& present = this->Blocks().TexelsOfComponents();
  const std::vector<std::optional<ValueRange>> matter = ValuesThatMatter(frame);
  for (std::size_t i = 0; i < values.texels.size(); ++i)
  {
    ScalarTexels& texels = values.texels[i];
    CheckReach(texels, matter[i]);
    texels = Focused(texels, areNew ? texels : present[i], matter[i]);
    if (IsProjection(frame.settings.blend))
    {
      const auto [lower, upper] = frame.material.averagedRange;
      texels.gray = GrayRangeOf(frame.voxels.components[i], { lower, upper });
    }
  }
  if (areNew || values.texels != present)
  {
    this->Blocks().SetVoxels(values);
    this->packets.SetTexels(values.texels);
    ++this->voxelsBuild;
  }
}

VolumeFindings VolumeResources::Update(const VolumeMarch& march, const MemoryElsewhere& elsewhere)
{
  this->UpdateCuts(march);
  this->UpdateMask(march);
  this->UpdateSpacing(march);
  this->materials.Update(march, this->Blocks().TexelsOfComponents());
  this->packets.Update(march, this->Blocks().Values());
  this->Blocks().SetFilter(march.plan.filters8Bits);
  this->Blocks().SetGradients(march.frame.view.window,
    march.plan.marcher == Marcher::Device && ReadsStoredGradients(march.settings));
  this->fields.Update({ march, this->Blocks(), this->materials, this->mask, this->voxelsBuild });
  this->light.Update(march, this->materials);
  const bool blocksHaveGaps =
    this->division.Update(march, this->fields, this->BesideBlocks(march, elsewhere));
  return { this->fields.OfBricks().SkipsAny(), blocksHaveGaps || this->packets.HasGaps() };
}

void VolumeResources::BeginPicture(
  const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere)
{
  this->division.BeginPicture(march, inView, this->BesideBlocks(march, elsewhere));
}

// A table that is only tried out must leave most of the memory to the volume.
bool VolumeResources::MayTryPreIntegration(const Frame& frame) const
{
  const std::size_t most = frame.device.mostMemoryBytes;
  return most == 0 || 4 * PreIntegratedTableBytes(this->materials.OpticalTables().Table()) <= most;
}

// Adds the memory of this volume that is not for its blocks.
MemoryElsewhere VolumeResources::BesideBlocks(
  const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const bool isTriedOut = march.plan.budget.StepTolerance() > 0.0;
  const bool mayPreIntegrate = UsesPreIntegration(march.settings) ||
    (isTriedOut && march.settings.blend == Blend::Composite &&
      this->MayTryPreIntegration(march.frame));
  const std::size_t trialBytes = FloatFramebuffer::BytesFor(TrialPixels(march.plan.viewport));
  const std::size_t tableBytes = PreIntegratedTableBytes(this->materials.OpticalTables().Table());
  return { this->BytesBesideBlocks() + elsewhere.fixedBytes + (mayPreIntegrate ? tableBytes : 0) +
      (isTriedOut ? trialBytes : 0),
    elsewhere.accumulationBytes };
}

void VolumeResources::UpdateMask(const VolumeMarch& march)
{
  if (march.settings.mask == Mask::None)
  {
    this->mask.Release(march.frame.view.window);
  }
  else
  {
    const auto summary = SummaryOf(march.frame.voxels.scalars);
    const bool hasLargeBricks = summary && summary->ranges.Side() > BrickRanges::CellsPerSide;
    const bool isEven = march.frame.voxels.axes.empty() && !hasLargeBricks;
    this->mask.Update(march.frame.view.window, march.frame.voxels.mask,
      isEven ? march.frame.geometry.dimensions : glm::ivec3(0), march.plan.marcher);
  }
}

void VolumeResources::UpdateCuts(const VolumeMarch& march)
{
  const std::vector<glm::dvec4>& planes = march.frame.cuts.planesGrid;
  this->clippingPlanes.Set(march.frame.view.window,
    march.settings.clipping ? std::vector<glm::vec4>(planes.begin(), planes.end())
                            : std::vector<glm::vec4>());
  this->clippingPlanes.Update(march.frame.view.window, march.plan.marcher);
}

void VolumeResources::UpdateSpacing(const VolumeMarch& march)
{
  UnevenBins uneven = BinsOf(march.frame.voxels.axes);
  if (uneven.bins != this->spacingBins.bins)
  {
    this->fields.ForgetBricks(); // they belong to the even grid
  }
  this->spacing.Set(march.frame.view.window, uneven.bins);
  this->spacing.Update(march.frame.view.window, march.plan.marcher);
  this->spacingBins = std::move(uneven);
}

VolumeTextures VolumeResources::Textures(
  const RenderSettings& settings, const VolumeBlock* block) const
{
  VolumeTextures textures = this->materials.Textures();
  textures.fieldTexture.onDevice = this->fields.OfBricks().Texture();
  textures.gapTexture.inMemory = this->packets.GapTexels();
  textures.maskTexture = this->mask.Texture();
  textures.spacingTable = this->spacing.Texture();
  textures.skyDirections = this->light.SkyDirections();
  if (block)
  {
    const bool isOfValues = IsOfValues(settings.acceleration);
    textures.volumeTexture.onDevice = block->volume.Texture();
    textures.gradientTexture.onDevice = block->gradients.Texture();
    textures.gapTexture.onDevice = block->gaps.Texture();
    textures.fieldTexture.onDevice =
      isOfValues ? block->valueField.Texture() : textures.fieldTexture.onDevice;
  }
  return textures;
}

VolumeBuilds VolumeResources::Builds() const
{
  return { this->voxelsBuild, this->fields.RangesBuilds(), this->fields.Builds(),
    this->materials.TableBuilds() };
}

std::size_t VolumeResources::Bytes() const
{
  return this->BytesBesideBlocks() + this->materials.PreIntegrated().Bytes() +
    this->Blocks().Bytes();
}

std::size_t VolumeResources::BytesBesideBlocks() const
{
  return this->materials.Bytes() + this->fields.Bytes() + this->mask.Bytes() +
    this->light.GraphicsBytes() + this->clippingPlanes.Bytes() + this->spacing.Bytes();
}

void VolumeResources::Release(vtkWindow* window)
{
  this->division.Release(window);
  this->fields.Release(window);
  this->materials.Release(window);
  this->packets.Release();
  this->light.Release(window);
  this->mask.Release(window);
  this->clippingPlanes.Release(window);
  this->spacing.Release(window);
  this->spacingBins = UnevenBins();
  this->spline = SplineVolume();
  this->voxels = {};
}

}
