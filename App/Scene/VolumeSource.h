#ifndef Varimarch_Scene_VolumeSource_h
#define Varimarch_Scene_VolumeSource_h

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace varimarch
{

/// Layout of a raw file, which the file itself does not record.
struct RawLayout
{
  std::array<int, 3> dimensions = {}; ///< voxels along each axis, x fastest
  std::string type = "uint8";         ///< one of RawTypeNames()
  std::array<double, 3> spacingMm = { 1.0, 1.0, 1.0 };
  bool bigEndian = false;
  std::int64_t headerBytes = 0; ///< size of the header before the first voxel, >= 0
};

/// Kinds of volume, levels and channels of a file are at most these.
constexpr int LargestKind = 99999;
constexpr int LargestLevel = 99;
constexpr int LargestChannel = 99999;

struct FileSource
{
  std::string path;             ///< a file, or a folder with a DICOM series
  std::optional<RawLayout> raw; ///< layout of a file without a header; otherwise empty
  std::string series = {};      ///< which of several DICOM series, as named by vtkVolumeFileReader
  /// True resamples tilted or unevenly spaced slices on an even grid, false keeps them as scanned;
  /// empty resamples those that would be drawn elsewhere than they were scanned.
  std::optional<bool> rectified = {};
  /// Memory that the program may use [MB]: larger voxels stay in their file; 0: the machine's.
  double memoryMegabytes = 0.0;
  /// The level of a file with several, the finest of which is 0; empty for the finest that fits in
  /// half of the free memory or can stay in its chunks.
  std::optional<int> level = {};
  /// A channel of a file with several, counted from 0; empty for all of two to four that can be
  /// read as a whole, or else the first.
  std::optional<int> channel = {};
  int time = 0;                           ///< which of several times, counted from 0
  std::optional<double> timeSeconds = {}; ///< if given, the time nearest to this one is read
  bool filesAreTimes = false;             ///< as vtkVolumeFileReader::SetFilesAreTimes
  int kind = 0; ///< the kind of volume in a DICOM series, counted from 1; 0: the first
};

enum class ProceduralKind
{
  Shells,        ///< nested spherical shells
  MarschnerLobb, ///< the classic test signal for reconstruction
  Torso,         ///< a CT of a torso
  Checkerboard,  ///< voxels that all differ from their neighbours
  Ramp,          ///< values that rise linearly
};

/// A volume that is computed: see ProceduralVolume.h.
struct ProceduralSource
{
  ProceduralKind kind = ProceduralKind::Shells;
  std::array<int, 3> dimensions = { 128, 128, 128 }; ///< each from 2 to LargestProceduralSide
  unsigned seed = 1; ///< seed of the noise, for kinds that have noise
};

constexpr int LargestProceduralSide = 1024;

using VolumeSource = std::variant<FileSource, ProceduralSource>;

}

#endif
