// The resources and uniforms of materials: what gives a point of the volume its look beyond one
// transfer function.

#include "Lights.h"
#include "PropertyTransferFunction.h"
#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

namespace varimarch
{

namespace
{

// So many that a piecewise linear function loses less than a display can show.
constexpr int GradientOpacityEntryCount = 4096;

// The largest gradient that VTK tells from larger ones.
double LargestGradient(const ScalarTexels& texels)
{
  const double range = texels.largestScalar - texels.smallestScalar;
  return 0.25 * (range > 0.0 ? range : 1.0);
}

std::vector<glm::vec4> GradientOpacityEntries(vtkPiecewiseFunction* function, double largest)
{
  const TransferFunction curve = OpacityCurveOf(function);
  std::vector<glm::vec4> entries(GradientOpacityEntryCount);
  for (int i = 0; i < GradientOpacityEntryCount; ++i)
  {
    entries[i] = glm::vec4(curve.Opacity(largest * i / (GradientOpacityEntryCount - 1)));
  }
  return entries;
}

}

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

void RayMarcher::UpdateGradientOpacity(const Frame& frame)
{
  if (!frame.settings.gradientOpacity)
  {
    this->gradientOpacity.Release(frame.window);
    this->gradientOpacitySource.clear();
    return;
  }
  vtkPiecewiseFunction* const function = frame.property->GetGradientOpacity();
  const double largest = LargestGradient(this->blocks.Texels());
  const std::vector<double> source = { double(function->GetMTime()), largest };
  if (this->gradientOpacitySource != source)
  {
    this->gradientOpacity.Upload(frame.window, GradientOpacityEntries(function, largest));
    this->gradientOpacitySource = source;
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
  if (frame.settings.shading)
  {
    this->SetLightUniforms(frame);
  }
  if (frame.settings.gradientOpacity)
  {
    this->SetGradientOpacityUniforms(frame);
  }
}

void RayMarcher::SetGradientOpacityUniforms(const Frame& frame)
{
  const ScalarTexels& texels = this->blocks.Texels();
  const double last = GradientOpacityEntryCount - 1;
  this->gradientOpacity.Texture()->Activate();
  this->program.Set("gradientOpacityTable", this->gradientOpacity.Texture());
  this->program.Set("lastGradientEntry", last);
  this->program.Set("spacingFactors", frame.geometry.gradientFactors);
  this->program.Set(
    "entriesPerGradient", glm::dvec4(texels.mapping.scale / LargestGradient(texels) * last));
  this->program.Set(
    "opacityUnitDistancesMm", glm::dvec4(frame.property->GetScalarOpacityUnitDistance()));
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
