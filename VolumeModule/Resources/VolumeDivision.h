#ifndef Varimarch_Resources_VolumeDivision_h
#define Varimarch_Resources_VolumeDivision_h

#include "Core/Geometry/Box.h"
#include "Frame/MarchPlan.h"
#include "Resources/FieldResources.h"
#include "Resources/VolumeBlocks.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The graphics memory that an image takes beside the blocks of its volume.
struct MemoryElsewhere
{
  std::size_t fixedBytes = 0;
  std::size_t accumulationBytes = 0; ///< For the rays, if the volume was in blocks before.
};

/// A volume in as many blocks as the graphics memory asks for, and the boxes of what is visible in
/// it. A volume that the processor marches is one block without textures.
class VolumeDivision
{
public:
  /// Divides the volume and has its only block, if it is one, on the device.
  /// @return true if it has gaps; true for several blocks if any of them may have some
  /// @throws std::runtime_error if the memory is too small, or a feature is not drawn in blocks
  bool Update(
    const VolumeMarch& march, const FieldResources& fields, const MemoryElsewhere& elsewhere);

  /// Begins an image of several blocks, which are then taken in this order.
  void BeginPicture(
    const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere);

  /// The blocks in which something visible may be in view, front to back.
  std::vector<int> InView(const VolumeMarch& march) const;

  VolumeBlocks& Blocks() { return this->blocks; }
  const VolumeBlocks& Blocks() const { return this->blocks; }
  /// The box of what cuts and field leave visible [grid space].
  const Box& VisibleBox() const { return this->visibleBox; }
  const Box& VisibleBoxOf(int block) const { return this->visibleBoxes[block]; }
  void Release(vtkWindow* window);

private:
  void UpdateVisibleBoxes(const VolumeMarch& march, const FieldResources& fields);
  BlockLimits LimitsOf(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesForBlocks(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;

  VolumeBlocks blocks;
  Box visibleBox = {};
  std::vector<Box> visibleBoxes; ///< One for each block.
  int visibleOfField = -1; ///< The build of the field that the boxes belong to; 0: they need none.
  Box visibleOfBox = {};   ///< The box that cuts left then.
};

}

#endif
