#include "Readers/Dicom/Record.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileHeader.h"

#include <vtkDICOMDictHash.h>

#include <algorithm>

namespace varimarch
{

DicomRecord RecordOf(const std::string& path)
{
  const DicomHeader header = ReadDicomHeader(path);
  DicomRecord record;
  if (!header.file)
  {
    return record;
  }
  const DicomAttributes attributes(header.meta);
  const auto text = [&](const vtkDICOMTag& tag) { return attributes.Value(tag).AsUTF8String(); };
  record.patientName = text(DC::PatientName);
  record.patientId = text(DC::PatientID);
  record.studyUid = text(DC::StudyInstanceUID);
  record.studyDate = text(DC::StudyDate);
  record.studyDescription = text(DC::StudyDescription);
  record.seriesUid = header.file->seriesUid;
  record.seriesNumber = int(std::clamp(header.file->seriesNumber, -1e9, 1e9));
  record.seriesDescription = header.file->seriesDescription;
  record.modality = header.file->modality;
  record.imageUid = header.file->instanceUid;
  return record;
}

}
