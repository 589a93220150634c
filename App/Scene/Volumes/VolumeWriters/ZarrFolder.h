#ifndef Varimarch_Scene_ZarrFolder_h
#define Varimarch_Scene_ZarrFolder_h

#include "Scene/Volumes/VolumeLoading.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A volume of which any box can be asked for, so that one larger than memory can be written.
struct ZarrInput
{
  std::array<std::int64_t, 3> dimensions; ///< voxels along each axis, x fastest
  int scalarType;                         ///< a VTK type
  int componentCount = 1;
  glm::dvec3 originMm = glm::dvec3(0.0);
  glm::dvec3 spacingMm = glm::dvec3(1.0);
  glm::dmat3 direction = glm::dmat3(1.0); ///< column a is the direction of axis a
  std::optional<std::array<double, 2>> windowLevel = {};
  bool isLabels = false;    ///< true for values between which there is no mean
  bool statesSides = false; ///< true if it is known which side is the patient's left
  /// Fills memory with the voxels from `lower` to before `upper`, x fastest, with the components of
  /// a voxel together. Called from several threads at the same time.
  std::function<void(const std::array<std::int64_t, 3>& lower,
    const std::array<std::int64_t, 3>& upper, void* voxels)>
    read = {};
  /// True once voxels were read that the file does not have; null for volumes in memory.
  std::shared_ptr<const std::atomic<bool>> lacksChunks = nullptr;
};

/// A volume in memory, which must outlive the result.
ZarrInput ZarrInputOf(const LoadedVolume& volume);

/// A volume in a file that is read in boxes; none if its format has no chunks. Adds warnings of the
/// reader.
/// @throws std::runtime_error if it cannot be read
std::optional<ZarrInput> ChunkedInput(const FileSource& source, std::vector<std::string>& warnings);

/// The volume with its axes in that order, and those backwards, in which they lie as near as
/// possible to those of LPS: x to the patient's left, y to the back, z to the head.
ZarrInput InLpsOrder(const ZarrInput& input);

/// Writes OME-Zarr 0.4 into an empty folder: levels of half the voxels along each axis with more
/// than 64, by means, until no axis has more; chunks of 64 x 64 x 64 voxels, in blosc with zstd.
/// The axes are in the order of LPS, which the orientations of RFC-4 say if the sides are known.
/// @param observer  receives the part that is done, [0, 1], and returns false to cancel
/// @throws std::runtime_error with one sentence if a file cannot be written, or the observer
/// cancels
void WriteZarr(const ZarrInput& input, const std::string& folder, const LoadObserver& observer);

/// A sentence about the directions, which the format does not hold; empty if they are axes of the
/// world.
std::string LossOfZarr(const ZarrInput& input);

}

#endif
