#include "Readers/Dicom/TaggedSeries.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/DicomSeries.h"
#include "Readers/Packed/Unpacked.h"

#include <filesystem>

namespace varimarch
{

TaggedSeries::TaggedSeries(
  const std::string& path, const std::string& series, ReadProgress& progress)
{
  const DecoderSession session;
  ReadProgress unpacking = progress.Part(0.0, 0.5);
  ReadProgress finding = progress.Part(0.5, 1.0);
  std::vector<std::string> warnings;
  this->copies = UnpackedIfPacked(path, warnings, unpacking);
  const std::string place = this->copies ? this->copies->Path() : path;
  const DicomScan scan = FindDicomSeries(place, finding);
  for (const DicomFrame& frame : SeriesNamed(path, scan.series, series).frames)
  {
    if (this->files.empty() || this->files.back() != frame.file->path)
    {
      this->files.push_back(frame.file->path);
    }
  }
}

TaggedSeries::~TaggedSeries() = default;

std::string TaggedSeries::Name(std::size_t index) const
{
  return std::filesystem::path(this->files[index]).filename().string();
}

std::vector<DicomTag> TaggedSeries::Tags(std::size_t index) const
{
  return TagsOf(this->files[index]);
}

}
