#include "ComparisonMethods.h"

#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <glm/matrix.hpp>

#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// The faces of a box, counterclockwise from outside. Corner i has the upper x, y or z if bit 0, 1
// or 2 of i is set.
std::vector<glm::vec3> FacesOf(const Box& box)
{
  constexpr std::array<int, 36> Corners = { 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2,
    6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5 };
  std::vector<glm::vec3> triangles;
  for (const int corner : Corners)
  {
    triangles.emplace_back(corner & 1 ? box.upper.x : box.lower.x,
      corner & 2 ? box.upper.y : box.lower.y, corner & 4 ? box.upper.z : box.lower.z);
  }
  return triangles;
}

enum class Faces
{
  Front,
  Back,
};

void DrawFaces(const ComparisonFrame& frame, Faces faces)
{
  vtkOpenGLState* const state = frame.view.window->GetState();
  const bool mirrored = glm::determinant(frame.volume.Geometry().WorldFromGridDirection()) < 0.0;
  const bool cullsBack = (faces == Faces::Front) != mirrored;
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(cullsBack ? GL_BACK : GL_FRONT);
  frame.program.Set("clipFromGrid", glm::mat4(frame.view.clipFromGrid));
  frame.program.DrawAll();
  frame.program.DeactivateTextures();
}

}

void PassMethod::Draw(
  const ComparisonFrame& frame, ComparisonImage& image, const PassSettings& settings)
{
  const ComparedView& view = frame.view;
  if (unsigned(view.sizePixels.x) != this->depth->GetWidth() ||
    unsigned(view.sizePixels.y) != this->depth->GetHeight())
  {
    this->depth->ReleaseGraphicsResources(view.window);
    this->depth->SetContext(view.window);
    this->depth->AllocateDepth(
      unsigned(view.sizePixels.x), unsigned(view.sizePixels.y), vtkTextureObject::Fixed24);
  }
  frame.program.SetTriangles(FacesOf(frame.volume.Geometry().boxGrid));
  this->SetUpRays(frame);
  image.Begin(view.window, view.sizePixels, glm::vec4(0.0f), this->depth);
  this->ended.Begin(view.window, view.sizePixels, glm::vec4(0.0f), this->depth);
  view.window->GetState()->vtkglDepthMask(GL_TRUE);
  view.window->GetState()->vtkglClearDepth(1.0);
  view.window->GetState()->vtkglClear(GL_DEPTH_BUFFER_BIT);
  const int steps = int(std::ceil(frame.volume.Geometry().DiagonalMm() / frame.sampleDistanceMm));
  this->passes = 0;
  for (int first = 0; first < steps; first += settings.stepsPerPass)
  {
    image.Continue(view.window);
    this->March(frame, settings, first);
    this->EndRays(frame, image, (first + settings.stepsPerPass) * frame.sampleDistanceMm,
      settings.leastTransmittance);
    ++this->passes;
  }
  image.Continue(view.window);
}

void PassMethod::SetUpRays(const ComparisonFrame& frame)
{
  const ComparedView& view = frame.view;
  SetComparisonState(view.window, ComparisonBlending::Replace);
  this->fronts.Begin(view.window, view.sizePixels, glm::vec4(0.0f));
  frame.program.Use(view.window, "Grid.vert.glsl", { "FrontFace.frag.glsl" });
  DrawFaces(frame, Faces::Front);
  this->directions.Begin(view.window, view.sizePixels, glm::vec4(0.0f));
  frame.program.Use(view.window, "Grid.vert.glsl", { "BackFace.frag.glsl" });
  frame.program.Set("frontTexture", this->fronts.Color());
  frame.program.Set("worldFromGrid", glm::mat3(frame.volume.Geometry().WorldFromGridDirection()));
  DrawFaces(frame, Faces::Back);
}

void PassMethod::March(const ComparisonFrame& frame, const PassSettings& settings, int firstStep)
{
  const ComparedView& view = frame.view;
  SetComparisonState(view.window, ComparisonBlending::Under);
  view.window->GetState()->vtkglEnable(GL_DEPTH_TEST);
  view.window->GetState()->vtkglDepthFunc(GL_LESS);
  frame.Use("MarchPass.frag.glsl", settings.shadow);
  frame.program.Set("shadowStepMm", float(frame.sampleDistanceMm));
  frame.program.Set("directionTexture", this->directions.Color());
  frame.program.Set("stepMm", float(frame.sampleDistanceMm));
  frame.program.Set("firstStep", firstStep);
  frame.program.Set("stepCount", settings.stepsPerPass);
  DrawFaces(frame, Faces::Front);
}

void PassMethod::EndRays(
  const ComparisonFrame& frame, ComparisonImage& image, double marchedMm, double leastTransmittance)
{
  const ComparedView& view = frame.view;
  this->ended.Continue(view.window);
  SetComparisonState(view.window, ComparisonBlending::Replace);
  view.window->GetState()->vtkglEnable(GL_DEPTH_TEST);
  view.window->GetState()->vtkglDepthFunc(GL_ALWAYS);
  view.window->GetState()->vtkglDepthMask(GL_TRUE);
  frame.program.Use(view.window, "Grid.vert.glsl", { "EndRays.frag.glsl" });
  frame.program.Set("directionTexture", this->directions.Color());
  frame.program.Set("gatheredTexture", image.Color());
  frame.program.Set("marchedMm", float(marchedMm));
  frame.program.Set("leastTransmittance", float(leastTransmittance));
  DrawFaces(frame, Faces::Front);
}

void PassMethod::Release(vtkWindow* window)
{
  this->fronts.Release(window);
  this->directions.Release(window);
  this->ended.Release(window);
  this->depth->ReleaseGraphicsResources(window);
}

}
