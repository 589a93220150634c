// The parameters and textures that a shader program gets for a drawing.

#include "March/RayMarcher.h"

#include "March/RayParametersBuilder.h"
#include "March/VolumeParametersBuilder.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolume.h"

#include <glm/matrix.hpp>

namespace varimarch
{

namespace
{

VolumeTextures TexturesOf(
  const Frame& frame, const VolumeResources& volume, const VolumeBlock* block)
{
  VolumeTextures textures = {};
  textures.fieldTexture = volume.Field().Texture();
  if (block)
  {
    const int filter =
      frame.settings.nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
    textures.volumeTexture = block->volume.Texture();
    textures.volumeTexture->SetMinificationFilter(filter);
    textures.volumeTexture->SetMagnificationFilter(filter);
    textures.gapTexture = block->gaps.Texture();
    const bool isOfCells = frame.settings.acceleration == Acceleration::ScalarField;
    textures.fieldTexture = isOfCells ? block->scalarField.Texture() : textures.fieldTexture;
  }
  textures.maskTexture = volume.Mask().Texture();
  textures.opticalTable = volume.OpticalTables().Texture();
  textures.preIntegratedTable = volume.PreIntegrated().Texture();
  textures.twoValueTable = volume.TwoValues().Texture();
  textures.gradientOpacityTable = volume.GradientOpacity().Texture();
  textures.lightTexels = volume.LightTexels().Texture();
  textures.isosurfaces = volume.Isosurfaces().Texture();
  textures.spacingTable = volume.Spacing().Texture();
  return textures;
}

}

RayTextures RayMarcher::TexturesOfRays(const Frame& frame) const
{
  RayTextures textures = {};
  textures.depthTexture = this->depth.Texture();
  textures.noiseTexture = this->picture.noise.Texture();
  textures.clippingPlanes = this->volume.ClippingPlanes().Texture();
  textures.gatheredTexture = frame.settings.pass == RayPass::Block ? this->accumulation.Drawn()
                                                                   : this->accumulation.Finished();
  textures.coarseTexture = this->picture.rays.Texture();
  textures.sumTexture = this->picture.accumulated.Sum();
  textures.marchedTexture = this->packets.Texture();
  return textures;
}

RayParameters RayMarcher::ParametersOfRays(const Frame& frame, const DrawnBlock& drawn) const
{
  const Viewport& viewport = frame.viewport;
  RayParameters rays = RayParametersOf(frame, this->drawnBox);
  rays.boxLowerGrid = drawn.boxGrid.lower;
  rays.boxUpperGrid = drawn.boxGrid.upper;
  rays.sharedUpperGrid = drawn.sharedUpperGrid;
  rays.depthPixelsPerPixel =
    glm::dvec2(this->depth.SizePixels()) / glm::dvec2(viewport.width, viewport.height);
  rays.imageCount = float(this->picture.accumulated.Count());
  rays.rowsOfNext = this->picture.accumulated.RowsOfNext();
  if (frame.settings.role == ShaderRole::ShowMarchedImage)
  {
    const Viewport& pixels = this->packets.Pixels();
    rays.marchedColumns = pixels.width;
    rays.marchedPixels = pixels.width * pixels.height;
    rays.viewportOriginPixels =
      glm::dvec2(viewport.left + pixels.left, viewport.bottom + pixels.bottom);
  }
  return rays;
}

// Volumes that overlap stand in the shader before the volume whose rays they have.
void RayMarcher::SetVolumes(const Frame& frame, const DrawnBlock& drawn)
{
  const std::size_t count = frame.others.size() + 1;
  for (std::size_t i = 0; drawn.block && i < frame.others.size(); ++i)
  {
    const Frame& other = frame.others[i];
    VolumeResources& resources = *this->others[i];
    const VolumeBlock& block = resources.Blocks().Take(frame.window, 0);
    VolumeParameters parameters = VolumeParametersOf(other, resources,
      VolumeOfShaders(other, resources, &block, { glm::ivec3(0), other.geometry.dimensions }));
    parameters.ownGridFromRays = GridFromGrid(other, frame);
    this->program.SetVolume(i, count, parameters, TexturesOf(other, resources, &block));
  }
  this->program.SetVolume(count - 1, count,
    VolumeParametersOf(
      frame, this->volume, VolumeOfShaders(frame, this->volume, drawn.block, drawn.voxels)),
    TexturesOf(frame, this->volume, drawn.block));
}

void RayMarcher::SetParameters(const Frame& frame, const DrawnBlock& drawn)
{
  this->program.SetRays(this->ParametersOfRays(frame, drawn), this->TexturesOfRays(frame));
  if (frame.settings.role == ShaderRole::MarchRays && frame.settings.pass != RayPass::Accumulated)
  {
    this->SetVolumes(frame, drawn);
  }
  if (Peels(frame.settings.pass))
  {
    frame.volumePass.renderPass->SetShaderParameters(
      this->program.Program(), nullptr, frame.volume, nullptr);
  }
  if (frame.settings.role == ShaderRole::MarchRays && Marches(frame.settings))
  {
    this->program.SetUniformsOf(frame.volume);
  }
}

}
