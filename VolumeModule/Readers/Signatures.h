#ifndef Varimarch_Readers_Signatures_h
#define Varimarch_Readers_Signatures_h

#include <string>

namespace varimarch
{

// True for the first bytes of a file of the kind. Those of whole formats are in Formats.h.
bool IsBmp(const std::string& head);
bool IsJpeg(const std::string& head);
bool IsPng(const std::string& head);
bool IsZip(const std::string& head);

/// True for DICOM with its usual preamble, or a data set that begins with group 2 or 8 in explicit
/// or implicit encoding (PS3.5, section 7.1). The latter has no letters, so that the next element
/// must follow in order too, lest bare voxels be taken for it.
bool IsDicom(const std::string& head);

/// True for the first bytes, decompressed, of an archive: tar or ZIP.
bool IsArchive(const std::string& head);

}

#endif
