#ifndef Varimarch_DicomSegments_ScanImages_h
#define Varimarch_DicomSegments_ScanImages_h

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <string>
#include <vector>

namespace varimarch
{

// The images of a scan, for DICOM objects that are derived from it.

/// @throws std::runtime_error if a path is that of an image, which is not to be replaced
void RequireNoImage(const std::vector<std::string>& images, const std::string& path);

/// Reads the attributes of an image, without its pixels.
/// @throws std::runtime_error if it cannot be read
DcmFileFormat ImageOfScan(const std::string& image);

/// Converts the texts of an image to UTF-8, as DICOM objects of this program have them.
/// @throws std::runtime_error with one sentence if they are not in the character set that the image
///         names
void ConvertTextsToUtf8(DcmDataset& scan, const std::string& image);

/// The identifiers of an image and of its kind, by which other objects refer to it.
struct ImageUids
{
  OFString ofClass;
  OFString ofInstance;
};

ImageUids UidsOf(DcmDataset& image);

/// A number as a decimal string of DICOM, which has at most 16 characters.
OFString Decimal(double number);

}

#endif
