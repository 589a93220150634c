#ifndef Varimarch_Readers_SegmentOverlap_h
#define Varimarch_Readers_SegmentOverlap_h

#include "Readers/VolumeFile.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

/// Puts segments that may overlap into one label map: those of higher numbers over the others.
/// Keeps account of what they cover.
class SegmentOverlap
{
public:
  /// @param numbers  segments of some voxels; 0 leaves a voxel as it is
  /// @param voxels   as many
  void Put(const std::vector<std::uint16_t>& numbers, std::uint16_t* voxels);

  /// Warns of the segments that were covered in part.
  void Warn(const std::vector<LabelledSegment>& segments, std::vector<std::string>& warnings) const;

private:
  /// Number of voxels for each pair of a covered and a covering segment.
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::int64_t> covered;
};

}

#endif
