#ifndef Varimarch_Scene_ReferenceCache_h
#define Varimarch_Scene_ReferenceCache_h

#include "Scene/ReferencePicture.h"

#include <cstdint>
#include <string>

namespace varimarch
{

/// Reference pictures in a folder, so that each is drawn once. A picture is found by a digest of
/// all that it depends on: voxels, geometry, transfer function, light, blend mode, rays, size and
/// tolerance; a change of any draws another. Several processes may share a folder.
class ReferenceCache
{
public:
  static constexpr std::uintmax_t DefaultLargestBytes = std::uintmax_t(1) << 30;

  /// @param folder        made when needed; empty: nothing is kept
  /// @param largestBytes  of all pictures; those not used for longest are deleted beyond it
  explicit ReferenceCache(
    std::string folder = DefaultFolder(), std::uintmax_t largestBytes = DefaultLargestBytes);

  /// "varimarch/reference" in $XDG_CACHE_HOME, or in ~/.cache; empty where neither is known.
  static std::string DefaultFolder();

  /// As DrawReferencePicture, which draws what is not there or damaged. That a picture cannot be
  /// kept, as on a full disk, is no error.
  std::optional<ReferencePicture> Picture(const Scene& scene, vtkImageData* image, double tolerance,
    const ProgressFunction& progress = {}) const;

private:
  void Keep(const std::string& path, const ReferencePicture& picture) const;
  void DeleteOldest() const;

  std::string folder;
  std::uintmax_t largestBytes;
};

}

#endif
