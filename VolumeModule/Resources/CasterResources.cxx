#include "Resources/CasterResources.h"

#include "Core/Geometry/TriangleTree.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

void CheckTexels(std::size_t count)
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (count > std::size_t(most))
  {
    throw std::runtime_error("The opaque geometry that casts shadows takes " +
      std::to_string(count) + " texels, but the device allows " + std::to_string(most) +
      ": simplify the geometry, or let parts of it cast none (CASTS_SHADOWS)");
  }
}

}

void CasterResources::Update(const Frame& frame, Marcher marcher)
{
  if (!frame.settings.casters)
  {
    this->Release(frame.view.window);
    return;
  }
  if (this->inputs != frame.casters.fingerprint)
  {
    CasterTriangles triangles = TrianglesOf(frame.casters);
    const TriangleTree made(triangles.corners);
    this->sources = std::move(triangles.sources);
    this->tree.Set(frame.view.window, made.Texels());
    this->texelCount = made.Texels().size();
    this->inputs = frame.casters.fingerprint;
  }
  if (marcher == Marcher::Device)
  {
    CheckTexels(this->texelCount);
  }
  this->tree.Update(frame.view.window, marcher);
}

void CasterResources::Release(vtkWindow* window)
{
  this->tree.Release(window);
  this->sources.clear();
  this->inputs.clear();
}

}
