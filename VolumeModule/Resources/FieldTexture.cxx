#include "Resources/FieldTexture.h"

#include "Core/Fields/BrickRanges.h"
#include "Core/Fields/CellField.h"
#include "Core/Fields/VariationField.h"
#include "Readers/Paging/MappedMemory.h"
#include "Resources/VolumeTexture.h"
#include "VtkVersions.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <utility>

namespace varimarch
{

std::shared_ptr<const BrickRanges> KnownRanges::Find(const Fingerprint& key)
{
  const auto found = std::find_if(this->entries.begin(), this->entries.end(),
    [&](const Entry& entry) { return entry.key == key; });
  if (found == this->entries.end())
  {
    return nullptr;
  }
  this->entries.splice(this->entries.begin(), this->entries, found);
  return this->entries.front().ranges;
}

void KnownRanges::Add(
  const Fingerprint& key, const std::shared_ptr<const BrickRanges>& ranges, std::size_t hostBytes)
{
  constexpr std::size_t PartOfHost = 32;
  const std::size_t mostBytes =
    hostBytes > 0 ? std::min(MostBytes, hostBytes / PartOfHost) : MostBytes;
  this->entries.push_front({ key, ranges });
  std::size_t bytes = 0;
  const auto tooMany = std::find_if(this->entries.begin(), this->entries.end(),
    [&](const Entry& entry)
    {
      bytes += entry.ranges->Bytes();
      return bytes > mostBytes;
    });
  this->entries.erase(tooMany, this->entries.end());
}

namespace
{

// Shrinks each block [c - k, c + k], because values at its border depend on voxels outside it.
void Narrow(CellField& field, int reachVoxels)
{
  for (std::uint8_t& cell : field.cells)
  {
    cell = std::uint8_t(std::max(cell - reachVoxels, 0));
  }
}

/// The texels of a field, x fastest.
struct FieldTexels
{
  glm::ivec3 count;
  std::vector<std::uint8_t> texels;
};

template <class Scalar>
FieldTexels TexelsOf(const ScalarGrid<Scalar>& grid, const ValueField& chosen, int reachVoxels)
{
  if (chosen.kind == Acceleration::VariationField)
  {
    VariationField field = BuildVariationField(grid, chosen.tolerance, VoxelDistance::Euclidean);
    return { field.voxelCount, std::move(field.voxels) };
  }
  CellField field = BuildCellField(grid, chosen.tolerance);
  Narrow(field, reachVoxels);
  return { field.cellCount, std::move(field.cells) };
}

FieldTexels TexelsOf(const ScalarRegion& region, const ValueField& chosen, int reachVoxels)
{
  vtkDataArray* const array = region.components.front().array;
  void* const voxels = array->GetVoidPointer(0);
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return TexelsOf(
      ScalarGrid<VTK_TT>(static_cast<VTK_TT*>(voxels), region.dimensions).Part(region.voxels),
      chosen, reachVoxels));
  }
  return {};
}

template <class Scalar>
BrickRanges RangesOf(const Scalar* scalars, const VoxelValues& values, std::size_t index)
{
  const ScalarTexels& texels = values.texels[index];
  vtkDataArray* const array = values.components[index].array;
  const auto summary = SummaryOf(array);
  // A volume on disk has bricks so large that their ranges fit into memory.
  const int side = summary ? summary->ranges.Side() : BrickRanges::CellsPerSide;
  const int stride = array->GetNumberOfComponents();
  const glm::ivec3 dimensions = values.dimensions;
  if (stride == 1)
  {
    return BuildBrickRanges(ScalarGrid<Scalar>(scalars, dimensions), texels.resolved.lower,
      texels.resolved.upper, values.reachVoxels, side);
  }
  // Only one component is copied at a time, to save memory.
  std::vector<Scalar> component(std::size_t(dimensions.x) * dimensions.y * dimensions.z);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    component[i] = scalars[i * stride];
  }
  return BuildBrickRanges(ScalarGrid<Scalar>(component.data(), dimensions), texels.resolved.lower,
    texels.resolved.upper, values.reachVoxels, side);
}

BrickRanges BuiltRanges(const VoxelValues& values, std::size_t index)
{
  const VoxelComponent& component = values.components[index];
  void* const voxels = component.array->GetVoidPointer(component.index);
  switch (component.array->GetDataType())
  {
    vtkTemplateMacro(return RangesOf(static_cast<const VTK_TT*>(voxels), values, index));
  }
  return {};
}

// Voxels that stay in their file have ranges already.
std::shared_ptr<const BrickRanges> KeptRanges(const VoxelValues& values, std::size_t index)
{
  const ScalarTexels& texels = values.texels[index];
  const auto summary = SummaryOf(values.components[index].array);
  const bool tellsApart = summary && values.reachVoxels == 0 &&
    (texels.normalized || texels.resolved == ValueRange{ summary->smallest, summary->largest });
  return tellsApart ? std::shared_ptr<const BrickRanges>(summary, &summary->ranges) : nullptr;
}

// Everything that the ranges of a component depend on.
Fingerprint KeyOfRanges(const VoxelValues& values, const VoxelInput& voxels, std::size_t index)
{
  const VoxelComponent& component = values.components[index];
  const ValueRange& resolved = values.texels[index].resolved;
  return Fingerprint(voxels.time, component, values.dimensions, resolved.lower, resolved.upper);
}

// If a smaller part of the bricks can be skipped, testing bricks costs more than it saves.
constexpr double LeastSkippablePart = 1.0 / 8.0;

// The side of a block [bricks]: large enough that blocks are few, and small enough that rays begin
// close to the visible parts.
constexpr int BricksPerBlock = 2;

VisibleBlocks VisibleBlocksOf(const OpticalField& field)
{
  const float side = float(BricksPerBlock * field.side);
  // The volume may extend half a voxel beyond the outermost voxels.
  VisibleBlocks blocks{ side + 2.0f, {} };
  for (const glm::ivec3& block : VisibleHull(field, BricksPerBlock))
  {
    blocks.centersGrid.push_back((glm::vec3(block) + 0.5f) * side);
  }
  return blocks;
}

class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->start).count();
  }

private:
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

}

template <class Texel>
void AccelerationField::Upload(
  vtkOpenGLRenderWindow* window, glm::ivec3 size, const std::vector<Texel>& texels)
{
  constexpr bool narrow = sizeof(Texel) == 1;
  AllocateTexture3D(this->texture, window, size, narrow ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT,
    narrow ? GL_R8 : GL_R16, 1, "an acceleration field");
  this->size = size;
  this->bytes = texels.size() * sizeof(Texel);

  // Texels are not interpolated, because a value between two of them would have no meaning.
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size.x, size.y, size.z, GL_RED,
    narrow ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT, texels.data());
  this->texture->Deactivate();
}

void AccelerationField::BuildValueField(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
  const ValueField& chosen, int reachVoxels)
{
  const Stopwatch stopwatch;
  const FieldTexels field = TexelsOf(region, chosen, reachVoxels);
  this->buildSeconds = stopwatch.Seconds();
  this->Upload(window, field.count, field.texels);
}

void AccelerationField::SetTexels(
  vtkOpenGLRenderWindow* window, glm::ivec3 size, const std::vector<std::uint8_t>& texels)
{
  this->Upload(window, size, texels);
}

bool AccelerationField::BuildRanges(
  const VoxelValues& values, const VoxelInput& voxels, std::size_t hostBytes)
{
  const Stopwatch stopwatch;
  bool areBuilt = false;
  this->ranges.clear();
  for (std::size_t i = 0; i < values.components.size(); ++i)
  {
    std::shared_ptr<const BrickRanges> ofVoxels = KeptRanges(values, i);
    const Fingerprint key = KeyOfRanges(values, voxels, i);
    ofVoxels = ofVoxels || values.reachVoxels > 0 ? ofVoxels : this->knownRanges.Find(key);
    if (!ofVoxels)
    {
      ofVoxels = std::make_shared<BrickRanges>(BuiltRanges(values, i));
      areBuilt = true;
      if (values.reachVoxels == 0) // the arrays of a spline do not last
      {
        this->knownRanges.Add(key, ofVoxels, hostBytes);
      }
    }
    this->ranges.push_back(voxels.axes.empty()
        ? ofVoxels
        : std::make_shared<BrickRanges>(EvenBricks(*ofVoxels, voxels.axes)));
  }
  this->rangeSeconds = stopwatch.Seconds();
  return areBuilt;
}

void AccelerationField::BuildOpticalField(vtkOpenGLRenderWindow* window,
  const std::vector<ComponentTable>& tables, const BrickRows& rows,
  const OpticalTolerance& tolerance, glm::ivec3 towards, Marcher marcher)
{
  const Stopwatch stopwatch;
  std::vector<OpticalChannel> components;
  for (const ComponentTable& shown : tables)
  {
    components.push_back({ *this->ranges[shown.component], *shown.table, shown.row });
  }
  OpticalField field = varimarch::BuildOpticalField(components, rows, tolerance, towards);
  this->ReleaseField(window);
  this->SetVisible(field, marcher);
  this->AddBuildSeconds(stopwatch.Seconds());
  const Box all{ glm::dvec3(0.0), double(field.side) * glm::dvec3(field.brickCount) };
  if (field.SkippablePart(this->visible.Bounds(all)) >= LeastSkippablePart)
  {
    this->SetBricks(window, std::move(field), marcher);
  }
}

void AccelerationField::BuildIsosurfaceField(vtkOpenGLRenderWindow* window,
  const std::vector<double>& isovalues, glm::ivec3 towards, Marcher marcher)
{
  const Stopwatch stopwatch;
  OpticalField field = varimarch::BuildIsosurfaceField(this->Ranges(), isovalues, towards);
  this->ReleaseField(window);
  this->SetVisible(field, marcher);
  this->AddBuildSeconds(stopwatch.Seconds());
  this->SetBricks(window, std::move(field), marcher);
}

void AccelerationField::SetVisible(const OpticalField& field, Marcher marcher)
{
  const bool isForProcessor = marcher == Marcher::Processor;
  tbb::parallel_invoke([&] { this->visible = VisibleBricks(field); },
    [&] { this->visibleBlocks = isForProcessor ? VisibleBlocksOf(field) : VisibleBlocks(); });
}

void AccelerationField::SetBricks(
  vtkOpenGLRenderWindow* window, OpticalField field, Marcher marcher)
{
  if (marcher == Marcher::Device)
  {
    this->Upload(window, field.brickCount, field.bricks);
    return;
  }
  this->size = field.brickCount;
  this->bricks = std::move(field.bricks);
}

void AccelerationField::AddBuildSeconds(double seconds)
{
  this->buildSeconds = std::exchange(this->rangeSeconds, 0.0) + seconds;
}

void AccelerationField::BuildExtremes(
  vtkOpenGLRenderWindow* window, const ExtremeLook& look, bool largest, Marcher marcher)
{
  const Stopwatch stopwatch;
  const BrickRanges& values = this->Ranges();
  std::vector<std::uint16_t> built = BuildExtremeBricks(values, look, largest);
  this->AddBuildSeconds(stopwatch.Seconds());
  this->ReleaseField(window);
  if (marcher == Marcher::Device)
  {
    this->Upload(window, values.BrickCount(), built);
    return;
  }
  this->size = values.BrickCount();
  this->extremeBlocks = JoinExtremeBricks(built, this->size, largest);
  this->extremes = std::move(built);
}

void AccelerationField::ReleaseField(vtkWindow* window)
{
  this->bricks = {};
  this->visibleBlocks = {};
  this->visibleDepths = {};
  this->extremes = {};
  this->extremeBlocks = {};
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

void AccelerationField::Release(vtkWindow* window)
{
  this->ReleaseField(window);
  this->ranges.clear();
  this->knownRanges.Clear();
  this->visible = VisibleBricks();
}

}
