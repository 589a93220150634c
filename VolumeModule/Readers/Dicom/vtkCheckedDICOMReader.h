#ifndef Varimarch_Readers_Dicom_vtkCheckedDICOMReader_h
#define Varimarch_Readers_Dicom_vtkCheckedDICOMReader_h

#include <vtkDICOMReader.h>

/// A vtkDICOMReader that fails if GDCM cannot decode compressed pixels. That of vtk-dicom 0.8.14
/// ignores this, so that its image is black, and lets GDCM write more than its buffer holds.
class vtkCheckedDICOMReader : public vtkDICOMReader
{
public:
  static vtkCheckedDICOMReader* New();
  vtkTypeMacro(vtkCheckedDICOMReader, vtkDICOMReader);

protected:
  bool ReadFileDelegated(
    const char* path, int index, unsigned char* buffer, vtkIdType bufferSize) override;
};

#endif
