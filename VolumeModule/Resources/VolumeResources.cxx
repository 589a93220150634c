#include "Resources/VolumeResources.h"

#include "Core/Geometry/SplineCoefficients.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/GrayRange.h"
#include "Frame/SceneFingerprint.h"
#include "Readers/MappedScalars.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/ValueFocus.h"

#include "vtkOpenGLRenderWindow.h"

#include <utility>

namespace varimarch
{

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
