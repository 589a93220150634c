#ifndef Varimarch_Readers_Dicom_TaggedSeries_h
#define Varimarch_Readers_Dicom_TaggedSeries_h

#include "VarimarchVolumeModule.h"

#include "Readers/Dicom/Metadata.h"
#include "Readers/VolumeFile.h"

#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

class Unpacked;

/// The files of a DICOM series, for reading their attributes one file at a time. The files of an
/// archive are unpacked into a private folder for as long as this object lives.
class VARIMARCHVOLUME_EXPORT TaggedSeries
{
public:
  /// @param path    as for vtkVolumeFileReader
  /// @param series  as vtkVolumeFileReader::SetDICOMSeriesUID takes it
  /// @throws std::runtime_error if there is no such series
  /// @throws ReadCancelled
  TaggedSeries(const std::string& path, const std::string& series, ReadProgress& progress);
  ~TaggedSeries();
  TaggedSeries(const TaggedSeries&) = delete;
  void operator=(const TaggedSeries&) = delete;

  /// Number of files; a file may hold several images.
  std::size_t Count() const { return this->files.size(); }
  /// The files, in the order of the images, with their folders.
  const std::vector<std::string>& Files() const { return this->files; }
  /// The name of a file, without its folder.
  std::string Name(std::size_t index) const;
  /// @throws std::runtime_error as TagsOf does
  std::vector<DicomTag> Tags(std::size_t index) const;

private:
  std::unique_ptr<Unpacked> copies;
  std::vector<std::string> files; ///< paths, in the order of the images
};

}

#endif
