#ifndef Varimarch_Core_Blocks_BlockResidency_h
#define Varimarch_Core_Blocks_BlockResidency_h

#include <cstddef>
#include <map>
#include <vector>

namespace varimarch
{

/// Decides which blocks of a volume stay in a memory that may be too small for all of them. The
/// caller creates and frees the textures.
///
/// The next frame is expected to use the same blocks in the same order. The block whose next use
/// is farthest in the future is evicted first (Belady, "A study of replacement algorithms for a
/// virtual-storage computer", 1966): first blocks outside the frame, least recently used first,
/// then the block that this frame has used last. Evicting the frame's own least recently used
/// block would be the worst choice: its turn comes next, and no block would ever be found in
/// memory.
class BlockResidency
{
public:
  /// @param order  the blocks of the frame that begins, in order of use
  void BeginPicture(const std::vector<int>& order);

  /// Records that the next block of the order is used and held.
  /// @param bytes  size of the block
  /// @return the blocks to evict before, so that at most `capacity` bytes are held
  /// @throws std::runtime_error if the block alone is larger than `capacity`
  std::vector<int> Use(int block, std::size_t bytes, std::size_t capacity);

  /// @return the blocks to evict, so that at most `capacity` bytes are held
  std::vector<int> Shrink(std::size_t capacity);

  bool Holds(int block) const { return this->held.count(block) > 0; }
  std::size_t Bytes() const;
  void Clear();

private:
  std::size_t NextUse(int block) const;

  struct Held
  {
    std::size_t bytes;
    std::size_t lastUse; ///< value of `time` at that use
  };
  std::map<int, Held> held;
  std::map<int, std::size_t> positions; ///< position of each of the frame's blocks in its order
  std::size_t position = 0;             ///< position of the next use in the frame's order
  std::size_t time = 0;                 ///< number of uses so far, in all frames
};

}

#endif
