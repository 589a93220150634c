#ifndef Varimarch_Testing_ScanOfPatient_h
#define Varimarch_Testing_ScanOfPatient_h

#include "Module/Files/PhantomDicom.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Writes three slices of the CT of a patient whose name needs its character set, in the study
/// 1.2.77 and the frame of reference 1.2.52.
/// @param charset  the character set that the files name; the name is always in ISO_IR 100
/// @return the files
inline std::vector<std::string> WriteScanOfPatient(const TemporaryFolder& folder,
  const std::string& charset = "ISO_IR 100", const std::string& study = "1.2.77")
{
  std::vector<std::string> files;
  for (int slice = 0; slice < 3; ++slice)
  {
    phantom_dicom::Elements elements = phantom_dicom::SliceElements(phantom::Stored(0), slice);
    elements[0x00080005] = phantom_dicom::Text("CS", charset);
    elements[0x00080060] = phantom_dicom::Text("CS", "CT");
    elements[0x00100010] = phantom_dicom::Text("PN", "M\xfcller^Ute");
    elements[0x0020000d] = phantom_dicom::Text("UI", study);
    elements[0x00200052] = phantom_dicom::Text("UI", "1.2.52");
    files.push_back(
      folder.Write("slice" + std::to_string(slice), phantom_dicom::FileBytes(elements)));
  }
  return files;
}

}

#endif
