#ifndef Varimarch_Readers_MappedFile_h
#define Varimarch_Readers_MappedFile_h

#include "Readers/PagedVoxels.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The bytes of a file in the address space, read from disk when they are touched. They may be
/// written; what is written stays in memory and never reaches the file.
///
/// Bytes that the file has lost since, because it was made shorter or its disk fails, are 0 instead
/// of ending the program; Problem() then says so.
class MappedFile : public PagedVoxels
{
public:
  /// @param offset  first byte of the file
  /// @throws std::runtime_error if the file is shorter, or cannot be mapped
  MappedFile(const std::string& path, std::uint64_t offset, std::uint64_t byteCount);
  ~MappedFile() override;

  std::string Problem() const override;
  bool AreInForkedProcesses() const override { return true; }
  std::vector<Part> DroppableParts(const PageMap& map, std::uint64_t now) override;
  std::size_t Drop(std::size_t index, const PageMap& map) override;

private:
  static constexpr std::size_t PartBytes = 4 << 20;
  /// The looks that see all parts once. Rays wait while parts are looked at, which takes longer
  /// than dropping them, so that a look is at every fourth part.
  static constexpr std::size_t LooksPerRound = 4;

  /// Memory of a part as PageMap::DroppableBytes has it, when it was last looked at.
  struct Look
  {
    std::size_t residentBytes = 0;
    std::uint64_t grew = 0;
  };

  std::size_t BytesOfPart(std::size_t index) const;

  std::string path;
  std::uint64_t size = 0; ///< size of the file when it was mapped
  std::int64_t modified = 0;
  int descriptor = -1;
  std::vector<Look> looks; ///< one for each part
  std::size_t nextLook = 0;
  int guard = -1; ///< number of its entry among the guarded addresses
};

}

#endif
