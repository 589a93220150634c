#ifndef Varimarch_Viewer_SizedTimes_h
#define Varimarch_Viewer_SizedTimes_h

#include "Scene/VolumeLoading.h"

#include <array>

namespace varimarch
{

struct Scene;

/// Reads the times of a volume, all of the same size, within the memory that the user lets the
/// program use.
class SizedTimes
{
public:
  /// @param volume  the number of a volume of the scene, which is a file
  /// @param shown   that volume at one of its times
  SizedTimes(const Scene& scene, int volume, const LoadedVolume& shown);

  /// The volume at a time.
  /// @param observer  as for LoadVolume
  /// @throws std::runtime_error with one sentence if it is cancelled, the file cannot be read, or
  ///         the time has another size than the others: labels, cuts and masks lie on their grid
  LoadedVolume Read(int time, const LoadObserver& observer);

private:
  /// Voxels along each axis, and components of each.
  using Size = std::array<int, 4>;

  static Size SizeOf(const LoadedVolume& volume);

  TimeReader reader;
  Size size;
};

}

#endif
