#ifndef Varimarch_Readers_Dicom_GdcmCopy_h
#define Varimarch_Readers_Dicom_GdcmCopy_h

#include <cstddef>
#include <memory>
#include <string>

namespace varimarch
{

/// A file in memory, without a name in any folder. It vanishes with this object or the process.
class ScratchFile
{
public:
  /// @throws std::runtime_error if the file cannot be created
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  void operator=(const ScratchFile&) = delete;

  const std::string& Path() const { return this->path; }

private:
  int descriptor;
  std::string path;
};

// Copies of files that vtk-dicom cannot read itself, the compressed ones by GDCM. They are null if
// they cannot be made.

/// Copies a file whose attributes are compressed too ("deflated").
std::shared_ptr<const ScratchFile> InflatedCopy(const std::string& path);

/// Copies a file whose pixels are compressed, without compression.
std::shared_ptr<const ScratchFile> UncompressedCopy(const std::string& path);

/// Copies an uncompressed file that ends early, with as many more bytes as all its pixels have.
std::shared_ptr<const ScratchFile> LengthenedCopy(const std::string& path, double pixelBytes);

/// Number of the fragments that the compressed pixels of a file are stored in; 0 if unknown.
std::size_t FragmentCount(const std::string& path);

/// True if GDCM knows the coding of pixels with this UID.
bool IsKnownSyntax(const std::string& transferSyntax);

}

#endif
