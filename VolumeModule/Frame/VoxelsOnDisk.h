#ifndef Varimarch_Frame_VoxelsOnDisk_h
#define Varimarch_Frame_VoxelsOnDisk_h

#include "Frame/Frame.h"

#include "VarimarchVolumeModule.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkDataArray;

namespace varimarch
{

class PagedVoxels;

/// The number of voxels of each value of scalars that stayed on disk, from the smallest value
/// that occurs to the largest; empty for scalars in memory, and for types wider than 16 bits.
struct ValueCounts
{
  double smallest = 0.0;
  std::vector<std::int64_t> counts;
};
VARIMARCHVOLUME_EXPORT ValueCounts CountsOnDisk(vtkDataArray* scalars);

/// The voxels of a frame that stayed on disk, with their coarser levels; none if all are in memory.
class VoxelsOnDisk
{
public:
  /// @param mostBytes  bound of the program's memory from now on [bytes]; 0: the bound that it has
  VoxelsOnDisk(const Frame& frame, vtkIdType mostBytes);

  /// @throws std::runtime_error if a file has changed since it was opened, or a chunk cannot be
  /// read, so that the image is wrong
  void Check() const;

private:
  std::vector<std::shared_ptr<PagedVoxels>> all;
};

}

#endif
