#ifndef Varimarch_Testing_PhantomDicom_h
#define Varimarch_Testing_PhantomDicom_h

#include "PhantomFiles.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// DICOM files, written according to PS3.5 and PS3.10 without any library: explicit VR,
/// little-endian.
namespace phantom_dicom
{

/// An attribute: its type, such as "DS", and its value as bytes.
struct Element
{
  std::string type;
  std::string value;
  bool isEncapsulated = false; ///< true: the value is the items of compressed pixels
};

/// Attributes by tag, such as 0x00280010 for Rows.
using Elements = std::map<std::uint32_t, Element>;

Element Text(const std::string& type, const std::string& text);
/// Decimal numbers, type DS.
Element Decimals(const std::vector<double>& numbers);
/// Unsigned 16-bit numbers, type US.
Element Shorts(const std::vector<int>& numbers);
Element Sequence(const std::vector<Elements>& items);
/// Pixels of 16 bits.
Element Pixels(const std::vector<int>& values);
/// Pixels of one frame in run-length coding, in one or more fragments.
Element RunLengthPixels(const std::vector<int>& values, int fragmentCount);

/// The attributes of a slice of a volume.
Elements SliceElements(const StoredVolume& volume, int slice, const DicomOptions& options = {});

constexpr const char* ExplicitSyntax = "1.2.840.10008.1.2.1";
constexpr const char* DeflatedSyntax = "1.2.840.10008.1.2.1.99";
constexpr const char* RunLengthSyntax = "1.2.840.10008.1.2.5";

std::string FileBytes(const Elements& elements, const std::string& syntax = ExplicitSyntax);

}

#endif
