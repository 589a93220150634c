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

/// Recommended range of values to show, in units of the data.
struct WindowLevel
{
  double window; ///< width of the range, > 0
  double level;  ///< centre of the range
};

/// A segment of a label map: the voxels of one value.
struct LabelledSegment
{
  int value;                     ///< not 0, which means no segment
  std::string name;              ///< may be empty
  std::optional<glm::dvec3> rgb; ///< [0, 1]; empty if the file gives no colour
};

/// An independent component of the voxels, such as the light of one stain.
struct VolumeChannel
{
  std::string name;              ///< may be empty
  std::optional<glm::dvec3> rgb; ///< the colour that the file gives it, [0, 1]
};

/// The times of a file: one volume each, of which one is read.
struct VolumeTimes
{
  std::vector<double> values = { 0.0 }; ///< at least one, in ascending order
  bool areSeconds = false;              ///< otherwise numbers, counted from 0
};

/// The content of a file: an image in LPS space [mm] and its metadata, none of which identifies a
/// patient.
struct Volume
{
  vtkSmartPointer<vtkImageData> image;
  std::string modality; ///< "CT", "MR", another DICOM modality, or empty
  std::string bodyPart; ///< in DICOM's terms such as "HEAD" or "CHEST"; or empty
  bool hasContrastAgent = false;
  std::string weighting; ///< for MR: "T1", "T2", "angiography", or empty
  std::optional<WindowLevel> windowLevel;
  std::optional<double> lowestInside; ///< the lowest value of the image if padding lies below it
  bool isInverted = false;            ///< true if slices are meant with their smallest values white
  std::vector<std::string> warnings;  ///< sentences about doubtful input
  /// Positions of the first voxels of the scanned slices [LPS, mm], in order along the normal, if
  /// the slices were tilted or are unevenly spaced; otherwise empty.
  std::vector<glm::dvec3> irregularSlicesMm;
  bool isMisplaced = false; ///< True if slices are drawn elsewhere than scanned, with small gaps.
  bool isRectified = false; ///< True if they have been resampled.
  /// The segments that the file describes if its values are labels; otherwise empty. Values may
  /// occur that have no description.
  std::optional<std::vector<LabelledSegment>> segments;
  std::optional<double> uptakeValueFactor; ///< for PET: from values to SUV [g/ml]
  std::string frameOfReference; ///< UID of the DICOM space that positions are in; or empty
  VolumeTimes times;            ///< times of the file, or elements of its list of volumes
  /// True if the file is about a patient, so that lengths of a body's size are those of a body.
  bool showsPatient = false;
  bool holdsColors = false; ///< true if the components of a voxel are its colour
  /// The components if they are independent and the file tells about each; otherwise empty.
  std::vector<VolumeChannel> channels;
  /// Names of the kinds of volume that a DICOM series holds, of which one was read; empty for other
  /// formats. A single one may have no name.
  std::vector<std::string> kinds;
};

/// The warning for files without orientation.
constexpr const char* UnknownSides =
  "The file does not say which side is the patient's left, so images may be mirrored.";

/// The warning for files without the size of a voxel.
constexpr const char* UnknownSpacing =
  "The file does not say how large a voxel is; 1 mm along each axis was assumed.";

/// The warning for binary files without their byte order.
constexpr const char* UnknownByteOrder =
  "The file does not say its byte order; little endian was assumed.";

/// The layout of a file of raw voxels.
struct RawOptions
{
  std::array<int, 3> dimensions = { 0, 0, 0 }; ///< voxels along each axis, x fastest; 0 if not set
  int scalarType = VTK_UNSIGNED_CHAR;
  int componentCount = 1;
  std::array<double, 3> spacingMm = { 1.0, 1.0, 1.0 };
  std::int64_t headerBytes = 0; ///< bytes before the first voxel
  bool bigEndian = false;
};

/// The irregular slices that are resampled to an even grid.
enum class Rectify
{
  Never,
  Misplaced, ///< Slices that would be drawn elsewhere than they were scanned, with small gaps.
  Always
};

struct KeptInput;

/// The wish for a coarse copy of a volume, if the volume itself would first have to be read whole.
struct PreviewWish
{
  /// The sentence that says what the copy is; empty if there is none, and the volume was read.
  std::string sentence;
  /// Distances of the copy's voxels, in those of the file.
  std::array<double, 3> steps = { 1.0, 1.0, 1.0 };
};

/// All channels of a file with levels and two to four of them, as components of the voxels, if they
/// can be read as a whole; otherwise the first.
constexpr int AllChannels = -1;

/// Options of a reader.
struct ReadOptions
{
  RawOptions raw;
  std::string series; ///< the DICOM series to read, see SeriesNamed
  int kind = 0;       ///< the kind of volume in it, see KindsOf, counted from 1; 0: the first
  Rectify rectify = Rectify::Never;
  std::int64_t time = 0;      ///< the time to read, counted from 0
  bool filesAreTimes = false; ///< true if the files of a folder, or of one name, are times
  KeptInput* kept = nullptr;  ///< memory from one time to the next; may be null
  /// Memory that the program may use [bytes]; 0: all of the machine's. Voxels that need more than a
  /// quarter of it stay in their file where that is possible.
  std::uint64_t mostMemoryBytes = 0;
  PreviewWish* preview = nullptr; ///< null if only the volume itself is wanted
  /// The level of a file with several to read, the finest of which is 0; empty for the finest that
  /// fits in the memory that is free, or can stay in its chunks.
  std::optional<int> level;
  /// The channel to read of a file with levels and several channels, or AllChannels.
  int channel = 0;
  bool areCopies = false; ///< true for unpacked files, which are removed once they were read

  bool Rectifies(const Volume& volume) const
  {
    return this->rectify == Rectify::Always ? !volume.irregularSlicesMm.empty()
                                            : this->rectify != Rectify::Never && volume.isMisplaced;
  }
};

/// Thrown if the user has cancelled the reader.
struct ReadCancelled
{
};

/// Reports progress to the user, and asks whether to continue.
class ReadProgress
{
public:
  /// @param goesOn  receives the finished part, [0, 1]; returns false to cancel
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

  /// Progress of a part of the work, which counts from 0 to 1 itself. Must not outlive this object.
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
