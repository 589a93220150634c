#ifndef Varimarch_Readers_RawVoxelSource_h
#define Varimarch_Readers_RawVoxelSource_h

#include "Core/Blocks/BrickSource.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The voxels of a file that has them as they are in memory, one after the other.
class RawVoxelSource : public BrickSource
{
public:
  /// @param layout  one component of a type of VoxelTypeOf
  /// @param offset  offset of the first voxel in the file
  /// @throws std::runtime_error if the file cannot be opened
  RawVoxelSource(const std::string& path, const VoxelLayout& layout, std::uint64_t offset);
  ~RawVoxelSource() override;
  RawVoxelSource(const RawVoxelSource&) = delete;
  RawVoxelSource& operator=(const RawVoxelSource&) = delete;

  const std::vector<Level>& Levels() const override { return this->levels; }
  VoxelType Type() const override { return this->type; }
  void Read(int level, const Box& box, void* voxels) const override;
  /// Holes of a sparse file are not read.
  Box Occupied(const Box& box) const override;

private:
  void ReadRun(std::uint64_t firstVoxel, std::uint64_t count, char* voxels) const;

  std::string path;
  std::uint64_t offset;
  std::uint64_t valueBytes;
  std::vector<Level> levels;
  VoxelType type;
  int descriptor;
};

}

#endif
