// The resources and uniforms of materials: what gives a point of the volume its look beyond one
// transfer function.

#include "Lights.h"
#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

namespace varimarch
{

void RayMarcher::UpdateLights(const Frame& frame)
{
  if (frame.settings.lights)
  {
    this->lights.Upload(frame.window, LightTexelsOf(frame.renderer).texels);
  }
  else
  {
    this->lights.Release(frame.window);
  }
}

void RayMarcher::SetMaterialUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  const std::array<double, 2>& visible = this->opticalTable.VisibleValues();
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  this->program.Set("visibleScalars",
    glm::dvec2(mapping.LimitedTexelOf(visible[0]), mapping.LimitedTexelOf(visible[1])));
  this->program.Set("voxelSizeTexture", 1.0 / glm::dvec3(drawn.voxels.count));
  this->program.Set("reflectance",
    glm::dvec4(frame.property->GetAmbient(), frame.property->GetDiffuse(),
      frame.property->GetSpecular(), frame.property->GetSpecularPower()));
  this->SetLightUniforms(frame);
}

void RayMarcher::SetLightUniforms(const Frame& frame)
{
  this->program.Set("worldFromGradient", frame.geometry.WorldFromGridNormal());
  if (!frame.settings.lights)
  {
    const HeadLightColors light = HeadLightColorsOf(frame.renderer);
    this->program.Set("diffuseLight", light.diffuse);
    this->program.Set("specularLight", light.specular);
    return;
  }
  this->lights.Texture()->Activate();
  this->program.Set("lightTexels", this->lights.Texture());
  this->program.Set("lightCount", LightTexelsOf(frame.renderer).lightCount);
  this->program.Set("ambientLight", AmbientLightOf(frame.renderer));
  this->program.Set("backsLit", frame.renderer->GetTwoSidedLighting() ? 1.0 : 0.0);
  this->program.Set("worldOfGridOrigin", glm::dvec3(frame.geometry.worldFromGrid[3]));
}

}
