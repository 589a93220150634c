// Several volumes that overlap: each has resources and uniforms of its own, and all are drawn in
// one march, along rays in the grid of the first.

#include "March/RayMarcher.h"

#include "Frame/Lights.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <stdexcept>

namespace varimarch
{

namespace
{

bool IsEmpty(const Box& box)
{
  return glm::any(glm::greaterThanEqual(box.lower, box.upper));
}

// The box around both, be one of them empty or not.
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

// Of a volume that overlaps with others, after its blocks are there.
void CheckOneBlock(const VolumeResources& resources, const Frame& frame)
{
  if (resources.Blocks().Partition().Count() > 1)
  {
    throw std::runtime_error("Volumes that overlap are not drawn in blocks: the maximum graphics "
                             "memory, or the device's 3D textures, are too small for them");
  }
  if (frame.settings.gaps)
  {
    throw std::runtime_error("Volumes that overlap are not drawn where values are not finite");
  }
}

// Where rays of several volumes begin and end is what all have; what may be visible is their own.
void TakeDepths(PacketScene& scene)
{
  scene.constituent.visible = scene.depths;
  scene.depths = {};
}

PacketSurroundings SurroundingsOfOther(const Frame& frame)
{
  PacketSurroundings around = {};
  around.drawnBox = frame.geometry.boxGrid;
  if (frame.settings.lights)
  {
    around.lights = LightTexelsOf(frame.renderer);
  }
  return around;
}

}

glm::dmat4 GridFromGrid(const Frame& to, const Frame& from)
{
  return glm::inverse(to.geometry.worldFromGrid) * from.geometry.worldFromGrid;
}

void RayMarcher::UpdateVoxelsOfOthers(const Frame& frame)
{
  const std::size_t count = frame.others.size();
  this->ReleaseOthers(frame.window, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i == this->others.size())
    {
      this->others.push_back(std::make_unique<VolumeResources>());
    }
    this->others[i]->UpdateVoxels(frame.others[i]);
  }
}

void RayMarcher::UpdateOthers(Frame& frame)
{
  frame.settings.others.clear();
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    VolumeResources& resources = *this->others[i];
    Frame& other = frame.others[i];
    other.marcher = frame.marcher;
    resources.Update(other, {});
    CheckOneBlock(resources, other);
    frame.settings.others.push_back(other.settings);
  }
}

Box RayMarcher::BoxOfAll(const Frame& frame) const
{
  if (!frame.others.empty())
  {
    CheckOneBlock(this->volume, frame);
  }
  Box box = this->volume.VisibleBox();
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    box = Around(box, this->others[i]->VisibleBox(), GridFromGrid(frame, frame.others[i]));
  }
  return box;
}

void RayMarcher::ReleaseOthers(vtkWindow* window, std::size_t first)
{
  for (std::size_t i = first; i < this->others.size(); ++i)
  {
    this->others[i]->Release(window);
  }
  this->others.resize(std::min(first, this->others.size()));
}

std::size_t RayMarcher::BytesOfOthers() const
{
  std::size_t bytes = 0;
  for (const auto& other : this->others)
  {
    bytes += other->Bytes();
  }
  return bytes;
}

MixedScenes RayMarcher::MixScenes(
  PacketScene& first, const Frame& frame, const Viewport& pixels) const
{
  MixedScenes mixed;
  if (!IsMixture(frame))
  {
    return mixed;
  }
  std::vector<PacketScene> own = ConstituentsOf(frame, this->volume, first);
  for (PacketScene& scene : own)
  {
    if (!frame.others.empty())
    {
      TakeDepths(scene);
    }
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    const Frame& other = frame.others[i];
    VolumeResources& resources = *this->others[i];
    mixed.volumes.emplace_back(other, resources, SurroundingsOfOther(other), pixels);
    for (PacketScene& scene : ConstituentsOf(other, resources, mixed.volumes.back().scene))
    {
      scene.parameters.ownGridFromRays = GridFromGrid(other, frame);
      TakeDepths(scene);
      mixed.scenes.push_back(scene);
    }
  }
  mixed.scenes.insert(mixed.scenes.end(), own.begin() + 1, own.end());
  first = own.front();
  first.constituent.others = mixed.scenes.data();
  first.constituent.otherCount = int(mixed.scenes.size());
  return mixed;
}

}
