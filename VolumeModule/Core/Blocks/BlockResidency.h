#ifndef Varimarch_Core_Blocks_BlockResidency_h
#define Varimarch_Core_Blocks_BlockResidency_h

#include <cstddef>
#include <map>
#include <vector>

namespace varimarch
{

/// Which blocks of a volume are held in a memory that may be too small for all of them. It only
/// decides; whoever asks makes and frees the textures.
///
/// The next picture is taken to use the blocks that this one uses, in the same order. The block
/// whose next use is farthest away goes first (Belady, "A study of replacement algorithms for a
/// virtual-storage computer", 1966): what is not in the picture, least recently used first; then
/// what this picture has used last. To let go the least recently used of a picture, whose turn
/// comes next, would leave not one block to be found again.
class BlockResidency
{
public:
  /// @param order  the blocks of the picture that begins, in the order of their use
  void BeginPicture(const std::vector<int>& order);

  /// The next block of the order, of these bytes, will be used and held.
  /// @return the blocks to let go before, so that no more than `capacity` bytes are held
  /// @throws std::runtime_error when the block alone is larger than that
  std::vector<int> Use(int block, std::size_t bytes, std::size_t capacity);

  /// @return the blocks to let go, so that no more than `capacity` bytes are held
  std::vector<int> Shrink(std::size_t capacity);

  bool Holds(int block) const { return this->held.count(block) > 0; }
  std::size_t Bytes() const;
  void Clear();

private:
  std::size_t NextUse(int block) const;

  struct Held
  {
    std::size_t bytes;
    std::size_t lastUse; ///< time
  };
  std::map<int, Held> held;
  std::map<int, std::size_t> places; ///< of the picture's blocks in its order
  std::size_t place = 0;             ///< of the next use
  std::size_t time = 0;              ///< uses so far, in all pictures
};

}

#endif
