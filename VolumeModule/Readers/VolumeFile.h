#ifndef Varimarch_Readers_VolumeFile_h
#define Varimarch_Readers_VolumeFile_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// How the values of a volume are meant to be shown, in units of the data.
struct WindowLevel
{
  double window; ///< width, > 0
  double level;  ///< centre
};

/// What a file holds: an image placed in LPS space [mm], and what the file says about it.
/// Nothing here identifies a patient.
struct Volume
{
  vtkSmartPointer<vtkImageData> image;
  std::string modality; ///< "CT", "MR", another DICOM modality, or empty
  std::string bodyPart; ///< as DICOM has it, "HEAD", "CHEST"; or empty
  bool hasContrastAgent = false;
  std::string weighting; ///< of MR: "T1", "T2", "angiography", or empty
  std::optional<WindowLevel> windowLevel;
  std::vector<std::string> warnings; ///< sentences: what is doubtful about the volume
  /// Where the first voxels of the scanned slices lie, in their order along the normal, if these
  /// were tilted or lie at uneven distances [LPS, mm]; otherwise none.
  std::vector<glm::dvec3> irregularSlicesMm;
};

/// A warning for files that have no orientation.
constexpr const char* UnknownSides =
  "The file does not say which side is the patient's left, so pictures may be mirrored.";

/// A warning for files with several volumes.
inline std::string OnlyFirstVolume(std::int64_t count)
{
  return "The file holds " + std::to_string(count) +
    " volumes (time points or a list); only the first was read.";
}

/// What a file of bare voxels does not say about itself.
struct RawOptions
{
  std::array<int, 3> dimensions = { 0, 0, 0 }; ///< voxels along each axis, x fastest; 0 is unset
  int scalarType = VTK_UNSIGNED_CHAR;
  int componentCount = 1;
  std::array<double, 3> spacingMm = { 1.0, 1.0, 1.0 };
  std::int64_t headerBytes = 0; ///< to skip before the first voxel
  bool bigEndian = false;
};

/// What a caller can choose about reading.
struct ReadOptions
{
  RawOptions raw;
  std::string series;   ///< DICOM series to read, see SeriesNamed
  bool rectify = false; ///< whether slices that lie irregularly are resampled on an even grid
};

/// Thrown when the user has stopped the reading.
struct ReadCancelled
{
};

/// Tells a user how far reading is, and asks whether to go on.
class ReadProgress
{
public:
  /// @param goesOn  gets the part done, in [0, 1]; returns false to stop
  explicit ReadProgress(std::function<bool(double)> goesOn)
    : goesOn(std::move(goesOn))
  {
  }

  /// @throws ReadCancelled
  void Report(double partDone)
  {
    if (!this->goesOn(partDone))
    {
      throw ReadCancelled();
    }
  }

  /// Progress of a part of the work, which counts from 0 to 1 itself. Must not outlive this.
  ReadProgress Part(double from, double to)
  {
    return ReadProgress(
      [this, from, to](double partDone)
      {
        this->Report(from + partDone * (to - from));
        return true;
      });
  }

private:
  std::function<bool(double)> goesOn;
};

}

#endif
