#ifndef Varimarch_Readers_Dicom_DicomFrame_h
#define Varimarch_Readers_Dicom_DicomFrame_h

#include <glm/mat2x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A file, or a part of it, that cannot be used.
struct DicomFault
{
  std::string path;
  std::string expected; ///< as FailToRead expects it
  std::string found;
  std::string seriesUid = {}; ///< empty if unknown
};

/// A table that replaces stored values, such as the modality lookup table or a palette.
template <class Entry>
struct DicomTable
{
  int first = 0; ///< the stored value that the first entry replaces; lower ones count as this one
  std::vector<Entry> entries;
};

/// A DICOM file with pixels: the attributes that all its frames share. Nothing in it identifies the
/// patient.
struct DicomFile
{
  std::string path;
  bool isDeflated = false;    ///< true if the attributes are compressed too
  std::string transferSyntax; ///< UID of the coding of the pixels; once inflated, if deflated
  std::string seriesUid;      ///< UID of the series
  std::string instanceUid;
  std::string seriesDescription;
  std::string frameOfReference; ///< UID of the space of all positions; may be empty
  std::string modality;
  bool isSegmentation = false; ///< true if the pixels are masks of segments or labels
  double seriesNumber = 0.0;

  int rows = 0; ///< size of the stored image
  int columns = 0;
  int frameCount = 1;
  bool isTruncated = false; ///< true if the file ends before the last frame
  int samples = 1;          ///< values per pixel as stored
  int bitsAllocated = 16;
  int bitsStored = 16;
  int highBit = 15;
  bool hasSwappedBytes = false; ///< true if bytes are stored in big-endian words
  bool isSigned = false;
  bool isFloat = false;
  std::string colours; ///< photometric interpretation, such as "MONOCHROME2"
  /// Red, green and blue of the stored values; empty unless the pixels are numbers of colours.
  DicomTable<std::array<std::uint8_t, 3>> palette;
};

/// True for pixels that are stored without compression.
bool IsUncompressed(const DicomFile& file);

/// Bytes that the frames need as the file stores them without compression.
double StoredBytes(const DicomFile& file, int frameCount);

/// Checks that all frames of a file fit in memory once decoded.
/// @param path  path for error messages
/// @throws std::runtime_error otherwise
void CheckFrames(const std::string& path, const DicomFile& file);

/// Attributes by which images of one place differ, most telling first.
enum class DicomDifference
{
  ImageType,
  Component,
  Segment,
  View,
  Echo,
  InversionTime,
  FlipAngle,
  DiffusionWeighting,
  DiffusionDirection,
  Energy,
  TimePoint,
  TriggerTime,
  CardiacPhase,
  RespiratoryPhase,
  FrameNumber,
  AcquisitionNumber,
  AcquisitionTime,
  Kernel,
  Stack,
  ContentTime,
  Count
};

/// One image, and everything that decides where it belongs and what its values mean.
struct DicomFrame
{
  std::shared_ptr<const DicomFile> file;
  int number = 0; ///< index in the file
  /// The part of the stored image that the frame is: all of it, or a tile of a mosaic.
  glm::ivec2 firstPixel = glm::ivec2(0);
  glm::ivec2 size = glm::ivec2(0); ///< columns and rows

  std::optional<glm::dvec3> positionMm; ///< centre of the first pixel [LPS]
  std::optional<glm::dmat2x3> axes;     ///< unit vectors along a row and along a column
  std::optional<glm::dvec2> pixelMm;    ///< distances of columns and of rows
  double pixelAspect =
    1.0; ///< distance of columns, in distances of rows; used if pixelMm is unknown
  std::optional<double> distanceMm; ///< distance of slices that the file states
  bool isDistanceThickness = false; ///< true if distanceMm is only the thickness of the slices
  std::optional<double> heightMm;   ///< position along the normal, without a known origin
  /// True if the file says that its frames are images of one place, or views of one thing.
  bool sharesPlace = false;
  bool isPatientSpace = true; ///< false for positions in a space of the transducer
  double instanceNumber = 0.0;
  std::array<std::string, std::size_t(DicomDifference::Count)> differences;
  std::optional<double> timeSeconds; ///< time since the first frame, or another fixed moment

  double slope = 1.0;
  double intercept = 0.0;
  std::shared_ptr<const DicomTable<std::uint16_t>> table; ///< modality lookup table, or null
  bool isRealWorld = false; ///< true for the slope and intercept of a real-world value map
  std::string otherMap;     ///< unit or label of such a map that is not applied, or empty
  std::optional<std::array<double, 2>> padding; ///< range of stored values outside the image
  bool isLossy = false;
};

/// The name of the file of a frame, without its folder, and the frame's number if there are
/// several.
std::string FrameName(const DicomFrame& frame);

/// Names as part of a sentence: "a.dcm", "b.dcm" and 7 others.
/// @param names  already quoted
std::string NameList(const std::vector<std::string>& names);

/// The names of frames as NameList has them; the tiles of a mosaic, which share a name, are named
/// once.
std::string FrameList(const std::vector<DicomFrame>& frames);

/// Seconds since 1970 of a date and a time as DICOM writes them: "YYYYMMDD" and "HHMMSS" with an
/// optional fraction. A shorter time lacks minutes or seconds; what follows is ignored, such as a
/// time zone. Empty for shorter texts (PS3.5 table 6.2-1).
std::optional<double> SecondsOfMoment(const std::string& date, const std::string& time);

/// Seconds by which the local time is ahead of UTC, from the last five letters of a text, such as
/// "+0130"; empty if they are none of a time zone.
std::optional<double> SecondsOfZone(const std::string& text);

}

#endif
