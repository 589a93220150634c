#include "Resources/SceneResources.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

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

namespace
{

bool IsEmpty(const Box& box)
{
  return glm::any(glm::greaterThanEqual(box.lower, box.upper));
}

// The smallest box around two boxes, either of which may be empty.
Box Around(const Box& box, const Box& other, const glm::dmat4& boxFromOther)
{
  Box around = box;
  bool isEmpty = IsEmpty(box);
  for (int corner = 0; corner < 8 && !IsEmpty(other); ++corner)
  {
    const glm::dvec3 place(boxFromOther *
      glm::dvec4(corner & 1 ? other.upper.x : other.lower.x,
        corner & 2 ? other.upper.y : other.lower.y, corner & 4 ? other.upper.z : other.lower.z,
        1.0));
    around = { isEmpty ? place : glm::min(around.lower, place),
      isEmpty ? place : glm::max(around.upper, place) };
    isEmpty = false;
  }
  return around;
}

using Volumes = std::vector<std::unique_ptr<VolumeResources>>;

// Releases all volumes but the first ones.
void ReleaseBehind(Volumes& volumes, vtkWindow* window, std::size_t kept)
{
  for (std::size_t i = kept; i < volumes.size(); ++i)
  {
    volumes[i]->Release(window);
  }
  volumes.resize(std::min(kept, volumes.size()));
}

// Makes as many volumes as there are frames, with their voxels.
void UpdateVoxelsOf(Volumes& volumes, const std::vector<Frame>& frames, vtkWindow* window)
{
  ReleaseBehind(volumes, window, frames.size());
  while (volumes.size() < frames.size())
  {
    volumes.push_back(std::make_unique<VolumeResources>());
  }
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    volumes[i]->UpdateVoxels(frames[i]);
  }
}

}

void SceneResources::UpdateVoxels(const Frame& frame)
{
  this->first.UpdateVoxels(frame);
  UpdateVoxelsOf(this->others, frame.others, frame.view.window);
  UpdateVoxelsOf(this->coarser, frame.coarser, frame.view.window);
}

bool SceneResources::AnyFits8Bits() const
{
  const auto fits = [](const VolumeResources& volume)
  { return volume.Blocks().Texels().fits8Bits; };
  return fits(this->first) ||
    std::any_of(
      this->others.begin(), this->others.end(), [&](const auto& other) { return fits(*other); });
}

void SceneResources::Update(const Frame& frame, MarchPlan& plan, const MemoryElsewhere& ofImages)
{
  this->UpdateDepth(frame, plan);
  this->UpdateNoise(frame, plan);
  this->casters.Update(frame, plan.marcher);
  this->UpdateOthers(frame, plan);
  if (plan.marcher == Marcher::Device)
  {
    ReleaseBehind(this->coarser, frame.view.window, 0); // shaders draw voxels only
  }
  for (std::size_t level = 0; level < this->coarser.size(); ++level)
  {
    plan.coarser[level] = this->coarser[level]->Update(MarchOfCoarser(frame, plan, level), {});
  }
  plan.volumes.front() = this->first.Update(MarchOf(frame, plan), this->BesideFirst(ofImages));
  plan.triesPreIntegration = this->first.MayTryPreIntegration(frame);
  plan.choosesIntegration =
    plan.choosesIntegration && (plan.triesPreIntegration || MarchesMaterial(frame.settings));
  this->drawnBox = this->BoxOfAll(frame);
}

bool SceneResources::IsTooLarge() const
{
  return this->first.Division().IsTooLarge() ||
    std::any_of(this->others.begin(), this->others.end(),
      [](const auto& other) { return other->Division().IsTooLarge(); });
}

void SceneResources::CheckOverlap(const MarchPlan& plan) const
{
  if (this->IsTooLarge())
  {
    throw std::runtime_error(
      "Overlapping volumes cannot be drawn in blocks: the maximum graphics memory, or the device's "
      "3D textures, are too small for them, and packets of rays on the processor are off or cannot "
      "draw them");
  }
  const bool haveGaps = std::any_of(plan.volumes.begin(), plan.volumes.end(),
    [](const VolumeFindings& findings) { return findings.hasGaps; });
  if (!this->others.empty() && haveGaps)
  {
    throw std::runtime_error("Overlapping volumes cannot be drawn with values that are not finite");
  }
}

void SceneResources::UpdatePreIntegrated(const Frame& frame, const MarchPlan& plan)
{
  this->first.UpdatePreIntegrated(MarchOf(frame, plan));
  for (std::size_t level = 0; level < this->coarser.size(); ++level)
  {
    this->coarser[level]->UpdatePreIntegrated(MarchOfCoarser(frame, plan, level));
  }
}

void SceneResources::BeginPicture(
  const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& ofImages)
{
  this->first.BeginPicture(march, inView, this->BesideFirst(ofImages));
}

void SceneResources::UpdateDepth(const Frame& frame, const MarchPlan& plan)
{
  if (!frame.settings.sceneGeometry)
  {
    this->depth.Release(frame.view.window);
    return;
  }
  this->depth.Capture(frame.view.window, plan.viewport.left, plan.viewport.bottom,
    plan.viewport.width, plan.viewport.height);
}

void SceneResources::UpdateNoise(const Frame& frame, const MarchPlan& plan)
{
  if (!frame.settings.jitter)
  {
    this->noise.Release(frame.view.window);
    return;
  }
  this->noise.MakeTile();
  plan.marcher == Marcher::Processor ? this->noise.ReleaseTexture(frame.view.window)
                                     : this->noise.Upload(frame.view.window);
}

void SceneResources::UpdateOthers(const Frame& frame, MarchPlan& plan)
{
  for (std::size_t i = 0; i < this->others.size(); ++i)
  {
    plan.volumes[i + 1] = this->others[i]->Update(MarchOfOther(frame, plan, i), {});
  }
}

RayTextures SceneResources::Textures() const
{
  RayTextures textures = {};
  textures.depthTexture = this->depth.Texture();
  textures.noiseTexture = this->noise.Texture();
  textures.casterTree = this->casters.Tree();
  textures.clippingPlanes = this->first.ClippingPlanes();
  return textures;
}

Box SceneResources::BoxOfAll(const Frame& frame) const
{
  Box box = this->first.Division().VisibleBox();
  for (std::size_t i = 0; i < this->others.size(); ++i)
  {
    box = Around(box, this->others[i]->Division().VisibleBox(),
      GridFromGrid(frame.geometry, frame.others[i].geometry));
  }
  return box;
}

bool SceneResources::MissesCurve() const
{
  return this->first.Materials().MissesCurve() ||
    std::any_of(this->others.begin(), this->others.end(),
      [](const auto& other) { return other->Materials().MissesCurve(); });
}

template <class Number>
Number SceneResources::SumOfLight(Number (LightResources::*number)() const) const
{
  Number sum = (this->first.Light().*number)();
  for (const auto& other : this->others)
  {
    sum += (other->Light().*number)();
  }
  return sum;
}

std::size_t SceneResources::LightBytes() const
{
  return this->SumOfLight(&LightResources::Bytes);
}

int SceneResources::LightLatticeBuilds() const
{
  return this->SumOfLight(&LightResources::Builds);
}

bool SceneResources::IsNothingDrawn() const
{
  return IsEmpty(this->drawnBox);
}

std::size_t SceneResources::BytesBesideFirst() const
{
  std::size_t bytes = this->depth.Bytes() + this->noise.Bytes() + this->casters.Bytes();
  for (const Volumes* volumes : { &this->others, &this->coarser })
  {
    for (const auto& volume : *volumes)
    {
      bytes += volume->Bytes();
    }
  }
  return bytes;
}

MemoryElsewhere SceneResources::BesideFirst(const MemoryElsewhere& ofImages) const
{
  return { ofImages.fixedBytes + this->BytesBesideFirst(), ofImages.accumulationBytes };
}

void SceneResources::Release(vtkWindow* window)
{
  ReleaseBehind(this->others, window, 0);
  ReleaseBehind(this->coarser, window, 0);
  this->first.Release(window);
  this->depth.Release(window);
  this->noise.Release(window);
  this->casters.Release(window);
}

}
