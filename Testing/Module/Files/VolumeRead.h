#ifndef Varimarch_Testing_VolumeRead_h
#define Varimarch_Testing_VolumeRead_h

#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

/// The result of vtkVolumeFileReader for a file.
struct VolumeRead
{
  std::string error;
  std::string warnings; ///< one on each line
  std::vector<double> values;
  int componentCount = 0;
  int timeCount = 0;
  glm::dvec3 spacingMm = glm::dvec3(0.0);
  glm::dvec3 originMm = glm::dvec3(0.0);

  bool WarnsOf(const std::string& words) const
  {
    return this->warnings.find(words) != std::string::npos;
  }
};

inline VolumeRead ReadVolumeAt(const std::string& path)
{
  const ExpectedVtkErrors errors;
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  VolumeRead read;
  read.error = reader->GetErrorMessage();
  for (vtkIdType i = 0; i < reader->GetWarnings()->GetNumberOfValues(); ++i)
  {
    read.warnings += reader->GetWarnings()->GetValue(i) + '\n';
  }
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; scalars && i < scalars->GetNumberOfValues(); ++i)
  {
    read.values.push_back(scalars->GetVariantValue(i).ToDouble());
  }
  read.componentCount = scalars ? scalars->GetNumberOfComponents() : 0;
  read.timeCount = reader->GetNumberOfTimes();
  image->GetSpacing(&read.spacingMm[0]);
  image->GetOrigin(&read.originMm[0]);
  return read;
}

#endif
