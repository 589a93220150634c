// The resources and uniforms of what is drawn of surfaces: isosurfaces and slices.

#include "PropertyTransferFunction.h"
#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame)
{
  const TransferFunction transferFunction =
    TransferFunctionOf(frame.property, frame.surfaceComponent);
  std::vector<glm::vec4> entries;
  for (double isovalue : frame.isovalues)
  {
    const double depth = -std::log1p(-transferFunction.Opacity(isovalue));
    entries.emplace_back(transferFunction.Color(isovalue), std::min(depth, 100.0));
    entries.emplace_back(isovalue);
  }
  return entries;
}

void RayMarcher::UpdateIsosurfaceField(const Frame& frame)
{
  FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture, 0, 0.0, 0.0,
    frame.marcher };
  source.isovalues = frame.isovalues;
  if (this->BeginsField(frame, source))
  {
    this->field.BuildIsosurfaceField(frame.window, frame.isovalues, source.towards, frame.marcher);
    this->fieldSource = source;
  }
}

void RayMarcher::UpdateIsosurfaces(const Frame& frame)
{
  if (frame.settings.blend != Blend::Isosurface || frame.marcher == Marcher::Processor)
  {
    this->isosurfaces.Release(frame.window);
    return;
  }
  std::vector<glm::vec4> texels = IsosurfaceEntriesOf(frame);
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  for (std::size_t i = 0; i < frame.isovalues.size(); ++i)
  {
    texels[2 * i + 1].x = float(mapping.LimitedTexelOf(frame.isovalues[i]));
  }
  this->isosurfaces.Upload(frame.window, texels);
}

void RayMarcher::SetExactUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  this->program.Set("voxelCount", glm::dvec3(drawn.voxels.count));
  if (frame.settings.blend == Blend::Slice)
  {
    this->program.Set("sliceMatrix", frame.slice.matrix);
    this->program.Set("sliceCenterGrid", frame.slice.centerGrid);
    this->program.Set("sliceUnitDistanceMm", frame.property->GetScalarOpacityUnitDistance());
  }
  if (frame.settings.blend != Blend::Isosurface)
  {
    return;
  }
  this->isosurfaces.Texture()->Activate();
  this->program.Set("isosurfaces", this->isosurfaces.Texture());
  this->program.Set("isosurfaceCount", int(frame.isovalues.size()));
  this->program.Set("voxelSizeTexture", 1.0 / glm::dvec3(drawn.voxels.count));
  this->program.Set("surfaceReflectance", ReflectanceOf(frame.property, frame.surfaceComponent));
  if (frame.settings.shading)
  {
    this->SetLightUniforms(frame);
  }
}

}
