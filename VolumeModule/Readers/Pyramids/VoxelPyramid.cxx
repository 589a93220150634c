#include "Readers/Pyramids/VoxelPyramid.h"

#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <vtkSetGet.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

double VoxelsOf(const BrickSource::Level& level)
{
  return double(level.dimensions[0]) * double(level.dimensions[1]) * double(level.dimensions[2]);
}

}

std::array<std::int64_t, 3> SizeOf(const BrickSource::Box& box)
{
  return { box.upper[0] - box.lower[0], box.upper[1] - box.lower[1], box.upper[2] - box.lower[2] };
}

std::int64_t VoxelCount(const BrickSource::Box& box)
{
  const std::array<std::int64_t, 3> size = SizeOf(box);
  return size[0] * size[1] * size[2];
}

bool LiesIn(const BrickSource::Box& box, const BrickSource::Level& level)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.lower[axis] < 0 || box.lower[axis] >= box.upper[axis] ||
      box.upper[axis] > level.dimensions[axis])
    {
      return false;
    }
  }
  return true;
}

std::array<std::int64_t, 3> ChunkCount(const BrickSource::Level& level)
{
  std::array<std::int64_t, 3> count;
  for (int axis = 0; axis < 3; ++axis)
  {
    count[axis] = (level.dimensions[axis] - 1) / level.chunk[axis] + 1;
  }
  return count;
}

double ValueIn(const std::vector<char>& bytes, int scalarType)
{
  switch (scalarType)
  {
    vtkTemplateMacro(VTK_TT value; std::memcpy(&value, bytes.data(), sizeof(value));
                     return double(value));
  }
  return 0.0;
}

void SetScales(const std::string& path, PyramidForm& form)
{
  for (std::size_t level = 0; level < form.levels.size(); ++level)
  {
    if (level > 0 && VoxelsOf(form.levels[level]) > VoxelsOf(form.levels[level - 1]))
    {
      FailToRead(path, "levels from fine to coarse",
        "more voxels in level " + std::to_string(level) + " than before");
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double stepMm = glm::length(form.geometries[level].axesMm[axis]);
      const double scale = stepMm / glm::length(form.geometries[0].axesMm[axis]);
      if (!std::isnormal(stepMm) || !std::isnormal(scale))
      {
        FailToRead(path, "voxels of a finite size above 0",
          "one of " + std::to_string(stepMm) + " mm in level " + std::to_string(level));
      }
      form.levels[level].scale[axis] = scale;
    }
  }
}

void WarnOfScale(
  std::optional<double> factor, std::optional<double> offset, std::vector<std::string>& warnings)
{
  if (factor.value_or(1.0) != 1.0 || offset.value_or(0.0) != 0.0)
  {
    char text[160];
    std::snprintf(text, sizeof(text),
      "The file says that its values are %g times the stored ones plus %g; the stored ones were "
      "read.",
      factor.value_or(1.0), offset.value_or(0.0));
    warnings.push_back(text);
  }
}

std::uint64_t CheckedChunkBytes(
  const std::string& path, const std::vector<std::int64_t>& sizes, std::int64_t valueBytes)
{
  // A product of doubles cannot overflow, and is exact for all that fits in memory.
  double bytes = double(valueBytes);
  for (const std::int64_t size : sizes)
  {
    bytes *= double(size);
  }
  const double freeBytes = FreeMemoryBytes();
  if (!(bytes <= freeBytes))
  {
    FailToRead(path, "chunks that fit in the free memory of " + ByteText(freeBytes),
      "chunks of " + ByteText(bytes));
  }
  return std::uint64_t(bytes);
}

Hdf5Path Hdf5PathOf(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code unknown;
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
  {
    const std::string file = path.substr(0, end);
    const bool isFile = fs::is_regular_file(file, unknown);
    if (isFile && end + 1 < path.size())
    {
      return { file, path.substr(end) };
    }
  }
  return { path, "" };
}

}
