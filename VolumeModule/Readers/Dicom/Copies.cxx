#include "Readers/Dicom/Copies.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

namespace varimarch
{
namespace
{

bool HaveSameAttributes(const DicomFrame& a, const DicomFrame& b)
{
  return a.size == b.size && a.file->frameCount == b.file->frameCount &&
    a.positionMm == b.positionMm && a.axes == b.axes && a.heightMm == b.heightMm &&
    a.instanceNumber == b.instanceNumber && a.differences == b.differences && a.slope == b.slope &&
    a.intercept == b.intercept;
}

}

bool Copies::IsCopy(const std::vector<DicomFrame>& frames)
{
  const DicomFrame& first = frames.front();
  const DicomFile& file = *first.file;
  if (file.instanceUid.empty())
  {
    return false;
  }
  std::vector<DicomFrame>& others = this->known[{ file.seriesUid, file.instanceUid }];
  const bool isCopy = std::any_of(others.begin(), others.end(),
    [&](const DicomFrame& other)
    {
      return HaveSameAttributes(first, other) &&
        this->DigestOf(file) == this->DigestOf(*other.file);
    });
  if (!isCopy)
  {
    this->sharedUids += others.empty() ? 0 : 1;
    others.push_back(first);
  }
  return isCopy;
}

/// A digest of the end of a file, which are its pixels; of its second half if they are compressed.
std::size_t Copies::DigestOf(const DicomFile& file)
{
  const auto known = this->digests.find(file.path);
  if (known != this->digests.end())
  {
    return known->second;
  }
  std::error_code ignored;
  const double fileBytes = double(std::filesystem::file_size(file.path, ignored));
  const double pixelBytes =
    IsUncompressed(file) ? StoredBytes(file, file.frameCount) : fileBytes / 2;
  std::string bytes(ignored ? 0 : std::size_t(std::min(pixelBytes, fileBytes)), '\0');
  std::ifstream stream(file.path, std::ios::binary);
  stream.seekg(-std::streamoff(bytes.size()), std::ios::end);
  stream.read(bytes.data(), std::streamsize(bytes.size()));
  return this->digests[file.path] = std::hash<std::string>()(bytes);
}

}
