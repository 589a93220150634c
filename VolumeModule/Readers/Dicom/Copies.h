#ifndef Varimarch_Readers_Dicom_Copies_h
#define Varimarch_Readers_Dicom_Copies_h

#include "Readers/Dicom/DicomFrame.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

/// Finds files that are copies of others. Files of one image have one UID; but programs that remove
/// names have given one to all images of a series, so that files with the same UID are copies only
/// if they have the same places, numbers and pixels.
class Copies
{
public:
  /// True if a file is a copy of an earlier one; otherwise it becomes known.
  /// @param frames  the frames of the file, at least one
  bool IsCopy(const std::vector<DicomFrame>& frames);

  /// Number of files that share the UID of an earlier file and are no copies.
  std::size_t SharedUids() const { return this->sharedUids; }

private:
  std::size_t DigestOf(const DicomFile& file);

  /// The first frames of the files of each image, by the UIDs of its series and its own.
  std::map<std::pair<std::string, std::string>, std::vector<DicomFrame>> known;
  /// Digests of the files whose UID occurred again, by path.
  std::map<std::string, std::size_t> digests;
  std::size_t sharedUids = 0;
};

}

#endif
