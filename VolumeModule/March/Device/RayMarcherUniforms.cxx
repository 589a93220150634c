// The uniforms of a frame beside those of its volumes.

#include "March/RayMarcher.h"

#include "Frame/OverlappingVolumes.h"

#include "vtkRenderer.h"

#include <glm/gtc/matrix_access.hpp>

namespace varimarch
{

void RayMarcher::SetRayUniforms(
  const Frame& frame, const DrawnBlock& drawn, const glm::dmat4& clipFromGrid)
{
  // The same rays for every block, to the last bit: none then has a gap where two blocks meet.
  const PixelRays rays = ComputePixelRays(clipFromGrid, this->drawnBox);
  const Viewport& viewport = frame.viewport;

  this->program.Set("clipFromGrid", clipFromGrid);
  this->program.Set(
    "viewportOriginPixels", glm::dvec2(viewport.left, viewport.bottom) - frame.rayOffsetPixels);
  this->program.Set("viewportPixelsInverse", 1.0 / glm::dvec2(viewport.width, viewport.height));
  this->program.Set("startGrid", rays.startGrid);
  this->program.Set("directionGrid", rays.directionGrid);
  this->program.Set("nearPlaneGrid", rays.nearPlaneGrid);
  this->program.Set("farPlaneGrid", rays.farPlaneGrid);
  this->program.Set("boxLowerGrid", drawn.boxGrid.lower);
  this->program.Set("boxUpperGrid", drawn.boxGrid.upper);
  this->program.Set("mostSegments", MostSegmentsOf(frame));
}

void RayMarcher::SetResumeUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  vtkTextureObject* const gathered = frame.settings.pass == RayPass::Block
    ? this->accumulation.Drawn()
    : this->accumulation.Finished();
  gathered->Activate();
  this->program.Set("gatheredTexture", gathered);
  this->program.Set("sharedUpperGrid", drawn.sharedUpperGrid);
}

void RayMarcher::SetDepthUniforms(const Frame& frame, const glm::dmat4& clipFromGrid)
{
  if (!frame.settings.sceneGeometry)
  {
    return;
  }
  this->program.Set("depthPixelsPerPixel",
    glm::dvec2(this->depth.SizePixels()) / glm::dvec2(frame.viewport.width, frame.viewport.height));
  this->depth.Texture()->Activate();
  this->program.Set("depthTexture", this->depth.Texture());
  this->program.Set("clipDepthRow", glm::row(clipFromGrid, 2));
  this->program.Set("clipWeightRow", glm::row(clipFromGrid, 3));
}

void RayMarcher::SetNoiseUniforms(const Frame& frame)
{
  if (!frame.settings.jitter)
  {
    return;
  }
  this->picture.noise.Texture()->Activate();
  this->program.Set("noiseTexture", this->picture.noise.Texture());
  this->program.Set("noisePixelsMask", glm::ivec2(BlueNoiseTexture::Pixels - 1));
}

// Beside those of its volume.
void RayMarcher::SetMarchUniforms(const Frame& frame, const glm::dmat4& clipFromGrid)
{
  this->SetNoiseUniforms(frame);
  this->SetUniformsOfOthers(frame);
  this->SetPassUniforms(frame, clipFromGrid);
  this->program.SetUniformsOf(frame.volume);
}

void RayMarcher::SetUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  const RayPass pass = frame.settings.pass;
  if (frame.settings.marching != Marching::Within)
  {
    this->SetPacketUniforms(frame, clipFromGrid);
    return;
  }
  if (pass == RayPass::Accumulated)
  {
    this->SetMeanUniforms(frame, clipFromGrid);
    return;
  }
  VolumeUniforms ofVolume(this->program, this->volume, frame);
  this->SetRayUniforms(frame, drawn, clipFromGrid);
  ofVolume.SetPlace(drawn);
  ofVolume.SetCuts();
  if (pass == RayPass::Block || pass == RayPass::Picture)
  {
    this->SetResumeUniforms(frame, drawn);
  }
  if (pass == RayPass::Upscaled || pass == RayPass::Averaged)
  {
    this->SetResampledUniforms(frame);
  }
  else
  {
    ofVolume.SetBlend();
  }
  if (Marches(frame.settings))
  {
    ofVolume.SetMarch(drawn);
    this->SetMarchUniforms(frame, clipFromGrid);
  }
  else if (pass == RayPass::Picture && IsProjection(frame.settings.blend))
  {
    ofVolume.SetClassify();
  }
  this->SetDepthUniforms(frame, clipFromGrid);
}

}
