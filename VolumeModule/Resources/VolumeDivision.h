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

/// The graphics memory that an image takes besides the blocks of its volume [bytes].
struct MemoryElsewhere
{
  std::size_t fixedBytes = 0;        ///< The memory of everything else.
  std::size_t accumulationBytes = 0; ///< The memory of RayAccumulation at present.
};

/// A volume in as many blocks as the graphics memory requires, and the boxes around its visible
/// parts. A volume that the processor marches is one block without textures.
class VolumeDivision
{
public:
  /// Divides the volume. A single block is uploaded to the device at once. A volume that overlaps
  /// others is not divided: the device does not get it if it is too large.
  /// @return true if the volume has gaps or, if it is in several blocks, may have gaps
  /// @throws std::runtime_error if the memory is too small, or a feature is not available in blocks
  bool Update(
    const VolumeMarch& march, const FieldResources& fields, const MemoryElsewhere& elsewhere);

  /// Begins an image of several blocks, which must then be taken in the given order.
  void BeginPicture(
    const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere);

  /// The blocks that may have visible parts in view, front to back.
  std::vector<int> InView(const VolumeMarch& march) const;

  /// True if the device cannot hold a volume that overlaps others, which has no blocks.
  bool IsTooLarge() const { return this->isTooLarge; }

  VolumeBlocks& Blocks() { return this->blocks; }
  const VolumeBlocks& Blocks() const { return this->blocks; }
  /// The box around the part that is visible after cuts and by the field [grid space].
  const Box& VisibleBox() const { return this->visibleBox; }
  const Box& VisibleBoxOf(int block) const { return this->visibleBoxes[block]; }
  void Release(vtkWindow* window);

private:
  void UpdateVisibleBoxes(const VolumeMarch& march, const FieldResources& fields);
  bool FitsMemory(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  bool MustBeDivided(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  BlockLimits LimitsOf(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesForBlocks(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;

  VolumeBlocks blocks;
  bool isTooLarge = false;
  Box visibleBox = {};
  std::vector<Box> visibleBoxes; ///< The box around the visible part of each block.
  int visibleOfField = -1;       ///< The build number of the field behind the boxes; 0: no field.
  Box visibleOfBox = {};         ///< The box of the cuts behind the boxes.
};

}

#endif
