#include "Resources/CasterResources.h"

#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
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

// True if two surfaces differ at most by their matrices.
bool AreOfSameTriangles(const CastingSurface& one, const CastingSurface& other)
{
  return one.data == other.data && one.time == other.time && one.planesWorld == other.planesWorld;
}

}

void CasterResources::Update(const Frame& frame, Marcher marcher)
{
  if (!frame.settings.casters)
  {
    this->Release(frame.view.window);
    return;
  }
  if (!this->tree || this->made.fingerprint != frame.casters.fingerprint)
  {
    this->texture.Release(frame.view.window);
    if (!this->Move(frame.casters))
    {
      this->Make(frame.casters);
    }
    this->made = frame.casters;
  }
  if (marcher == Marcher::Processor)
  {
    this->texture.Release(frame.view.window);
  }
  else if (this->texture.Bytes() == 0)
  {
    CheckTexels(this->tree->Texels().size());
    this->texture.Upload(frame.view.window, this->tree->Texels());
  }
}

// Moves the triangles of surfaces. Returns false if the tree must be made anew.
bool CasterResources::Move(const ShadowCasters& casters)
{
  const std::vector<CastingSurface>& now = casters.surfaces;
  const std::vector<CastingSurface>& before = this->made.surfaces;
  if (!this->tree ||
    !std::equal(now.begin(), now.end(), before.begin(), before.end(), AreOfSameTriangles))
  {
    return false;
  }
  for (std::size_t i = 0; i < now.size(); ++i)
  {
    const bool stays = now[i].worldFromData == before[i].worldFromData &&
      casters.originWorld == this->made.originWorld;
    // Planes cut other triangles of a surface that moves.
    if (!stays &&
      (!now[i].planesWorld.empty() || !this->tree->Move(i, TrianglesOf(casters, i).corners)))
    {
      return false;
    }
  }
  return true;
}

void CasterResources::Make(const ShadowCasters& casters)
{
  TriangleGroups groups;
  this->sources.clear();
  for (std::size_t i = 0; i < casters.surfaces.size(); ++i)
  {
    CasterTriangles triangles = TrianglesOf(casters, i);
    groups.push_back(std::move(triangles.corners));
    this->sources.insert(this->sources.end(), triangles.sources.begin(), triangles.sources.end());
  }
  this->tree.emplace(groups);
}

MarchTexture CasterResources::Tree() const
{
  return { this->texture.Texture(), this->tree ? this->tree->Texels().data() : nullptr };
}

void CasterResources::Release(vtkWindow* window)
{
  this->texture.Release(window);
  this->tree.reset();
  this->sources.clear();
  this->made = {};
}

}
