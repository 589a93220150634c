#ifndef Varimarch_Readers_Parsing_FileContent_h
#define Varimarch_Readers_Parsing_FileContent_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// A test of a file's first bytes.
using Signature = std::function<bool(const std::string& head)>;

/// True for bytes that have one of the texts at an offset.
Signature TextAt(std::size_t offset, std::vector<std::string> texts);

/// The first bytes of a file, at most 4096, decompressed.
/// @throws std::runtime_error if the file cannot be read, or is compressed but corrupt
std::string FirstBytes(const std::string& path);

/// A noun phrase such as "a PDF document" for a file that is known and not a volume; empty for
/// others.
std::string KnownContent(const std::string& head);

/// A noun phrase that describes any content: KnownContent, or else the first bytes themselves.
std::string DescribedContent(const std::string& head);

/// The regular files of a folder and its subfolders, sorted by their paths, without hidden ones.
std::vector<std::string> FilesBelow(const std::string& folder);

/// A noun phrase such as "3 files, the first of which is a PDF document", for error messages.
std::string DescribedFolder(const std::string& folder);

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
