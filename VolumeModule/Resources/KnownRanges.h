#ifndef Varimarch_Resources_KnownRanges_h
#define Varimarch_Resources_KnownRanges_h

#include "Core/Fields/BrickRanges.h"
#include "Frame/Fingerprint.h"

#include <cstddef>
#include <list>
#include <memory>

namespace varimarch
{

/// The ranges of bricks of the components that were drawn last, so that the times of a scan that is
/// played again and again are read once. It keeps no voxels, and at most MostBytes of ranges, or a
/// 32nd of the memory that the program may use.
class KnownRanges
{
public:
  static constexpr std::size_t MostBytes = std::size_t(128) << 20;

  /// @param key  everything that the ranges depend on
  /// @return null if they are not known
  std::shared_ptr<const BrickRanges> Find(const Fingerprint& key);
  /// @param hostBytes  memory that the program may use; 0: no limit
  void Add(const Fingerprint& key, const std::shared_ptr<const BrickRanges>& ranges,
    std::size_t hostBytes);
  void Clear() { this->entries.clear(); }

private:
  struct Entry
  {
    Fingerprint key;
    std::shared_ptr<const BrickRanges> ranges;
  };

  std::list<Entry> entries; ///< The entry that was used last is the first.
};

}

#endif
