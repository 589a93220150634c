#ifndef Varimarch_Scene_ReferenceCache_h
#define Varimarch_Scene_ReferenceCache_h

#include "Scene/Reference/ReferencePicture.h"

#include <cstdint>
#include <string>

namespace varimarch
{

/// Reference images kept in a folder, so that each is computed once. The key is a digest of
/// the scene's JSON, without what does not affect the image, of voxels, rays and tolerance. Several
/// processes may share a folder.
class ReferenceCache
{
public:
  static constexpr std::uintmax_t DefaultLargestBytes = std::uintmax_t(1) << 30;

  /// @param folder        created when needed; if empty, nothing is kept
  /// @param largestBytes  total size; beyond it the least recently used images are deleted
  explicit ReferenceCache(
    std::string folder = DefaultFolder(), std::uintmax_t largestBytes = DefaultLargestBytes);

  /// "varimarch/reference" in $XDG_CACHE_HOME, or in ~/.cache; empty if neither is known.
  static std::string DefaultFolder();

  /// Returns the image of DrawReferencePicture, which is called if the image is missing or damaged.
  /// Failing to keep it, as on a full disk, is not an error.
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
