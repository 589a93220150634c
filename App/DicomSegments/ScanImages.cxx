#include "DicomSegments/ScanImages.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

void RequireNoImage(const std::vector<std::string>& images, const std::string& path)
{
  for (const std::string& image : images)
  {
    std::error_code unknown;
    if (std::filesystem::equivalent(path, image, unknown))
    {
      throw std::runtime_error(
        path + ": this is an image of the scan, which is not replaced; choose another name");
    }
  }
}

DcmFileFormat ImageOfScan(const std::string& image)
{
  DcmFileFormat file;
  const OFCondition read = file.loadFileUntilTag(
    image.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData);
  if (read.bad())
  {
    throw std::runtime_error(image +
      ": expected an image of the scan, whose patient and study are needed, found: " + read.text());
  }
  return file;
}

void ConvertTextsToUtf8(DcmDataset& scan, const std::string& image)
{
  const OFCondition converted = scan.convertToUTF8();
  if (converted.bad())
  {
    OFString named;
    scan.findAndGetOFStringArray(DCM_SpecificCharacterSet, named);
    const std::string set = named.empty() ? "none" : named.c_str();
    throw std::runtime_error(image +
      ": expected texts in the character set that the image names (" + set +
      "), found others, so that the name of the patient would be another one: " + converted.text());
  }
}

ImageUids UidsOf(DcmDataset& image)
{
  ImageUids uids;
  image.findAndGetOFString(DCM_SOPClassUID, uids.ofClass);
  image.findAndGetOFString(DCM_SOPInstanceUID, uids.ofInstance);
  return uids;
}

OFString Decimal(double number)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.10g", number);
  return text.data();
}

}
