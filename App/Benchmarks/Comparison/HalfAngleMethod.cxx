#include "HalfAngleMethod.h"

#include "SliceGeometry.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr int BufferSide = 256; // pixels of the buffer of light along each side

/// The view of a distant light of the whole volume.
glm::dmat4 LightFromGrid(const VolumeGeometry& geometry, const glm::dvec3& toLightWorld)
{
  const glm::dvec3 middle(geometry.worldFromGrid *
    glm::dvec4(0.5 * (geometry.boxGrid.lower + geometry.boxGrid.upper), 1.0));
  const double radiusMm = 0.5 * geometry.DiagonalMm();
  const glm::dvec3 up =
    std::abs(toLightWorld.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dmat4 view = glm::lookAt(middle + 2.0 * radiusMm * toLightWorld, middle, up);
  return glm::ortho(-radiusMm, radiusMm, -radiusMm, radiusMm, radiusMm, 3.0 * radiusMm) * view *
    geometry.worldFromGrid;
}

void DrawSlice(const ComparisonFrame& frame, const std::vector<glm::vec3>& slice)
{
  frame.program.SetTriangles(slice);
  frame.program.DrawAll();
  frame.program.DeactivateTextures();
}

}

void HalfAngleMethod::Draw(
  const ComparisonFrame& frame, ComparisonImage& image, double spreadDegrees)
{
  const glm::dvec3& toLightWorld = frame.toLightWorld;
  const ComparedView& view = frame.view;
  const VolumeGeometry& geometry = frame.volume.Geometry();
  // Slices are met in the order of the light. The eye meets them in the same order if it is on the
  // light's side, and in the opposite order if not; then the axis turns away from the eye.
  const bool sameSide = glm::dot(toLightWorld, view.directionWorld) < 0.0;
  const glm::dvec3 along =
    glm::normalize((sameSide ? view.directionWorld : -view.directionWorld) - toLightWorld);
  const double radiusMm = 0.5 * geometry.DiagonalMm();
  const double blurMm = frame.sampleDistanceMm * std::tan(glm::radians(spreadDegrees));
  const Light light = { LightFromGrid(geometry, toLightWorld),
    glm::vec2(float(0.5 * blurMm / radiusMm)) };
  for (ComparisonImage& buffer : this->buffers)
  {
    buffer.Begin(view.window, glm::ivec2(BufferSide), glm::vec4(1.0f));
  }
  for (const glm::dvec4& plane :
    PlanesAlong(along, frame.sampleDistanceMm, geometry.boxGrid, geometry.worldFromGrid))
  {
    std::vector<glm::vec3> slice;
    AddFan(SlicePolygon(geometry.boxGrid, plane), slice);
    image.Continue(view.window);
    SetComparisonState(
      view.window, sameSide ? ComparisonBlending::Under : ComparisonBlending::Over);
    frame.Use("Slice.frag.glsl", "Shadow/LightBuffer.glsl");
    frame.program.Set("clipFromGrid", glm::mat4(view.clipFromGrid));
    frame.program.Set("sliceMm", float(frame.sampleDistanceMm));
    frame.program.Set("lightFromGrid", glm::mat4(light.lightFromGrid));
    frame.program.Set("lightTexture", this->buffers[this->present].Color());
    DrawSlice(frame, slice);
    this->DimLight(frame, light, slice);
  }
  image.Continue(view.window);
}

void HalfAngleMethod::DimLight(
  const ComparisonFrame& frame, const Light& light, const std::vector<glm::vec3>& slice)
{
  vtkOpenGLRenderWindow* const window = frame.view.window;
  if (light.blurTexture.x > 0.0f)
  {
    ComparisonImage& before = this->buffers[this->present];
    this->present = 1 - this->present;
    this->buffers[this->present].Continue(window);
    SetComparisonState(window, ComparisonBlending::Replace);
    frame.program.Use(window, "Screen.vert.glsl", { "Blur.frag.glsl" });
    frame.program.Set("lightTexture", before.Color());
    frame.program.Set("blurTexture", light.blurTexture);
    DrawSlice(frame, { { -1.0f, -1.0f, 0.0f }, { 3.0f, -1.0f, 0.0f }, { -1.0f, 3.0f, 0.0f } });
  }
  this->buffers[this->present].Continue(window);
  SetComparisonState(window, ComparisonBlending::Dim);
  frame.Use("Shadow.frag.glsl");
  frame.program.Set("clipFromGrid", glm::mat4(light.lightFromGrid));
  frame.program.Set("sliceMm", float(frame.sampleDistanceMm));
  DrawSlice(frame, slice);
}

std::size_t HalfAngleMethod::Bytes() const
{
  return this->buffers[0].Bytes() + this->buffers[1].Bytes();
}

void HalfAngleMethod::Release(vtkWindow* window)
{
  for (ComparisonImage& buffer : this->buffers)
  {
    buffer.Release(window);
  }
}

}
