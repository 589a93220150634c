#include "Readers/Dicom/DicomIndex.h"

#include "Readers/VtkMessages.h"
#include "Readers/VtkProgress.h"

#include <vtkDICOMDirectory.h>
#include <vtkStringArray.h>

#include <filesystem>

namespace varimarch
{

std::vector<std::string> FilesOfIndex(const std::string& index, ReadProgress& progress)
{
  VtkMessages silenced;
  vtkNew<vtkDICOMDirectory> directory;
  silenced.Observe(directory);
  const auto folder = std::filesystem::path(index).parent_path();
  directory->SetDirectoryName(folder.empty() ? "." : folder.c_str());
  UpdateWithProgress(directory, progress);
  std::vector<std::string> files;
  for (int series = 0; series < directory->GetNumberOfSeries(); ++series)
  {
    vtkStringArray* const names = directory->GetFileNamesForSeries(series);
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      files.push_back(names->GetValue(i));
    }
  }
  return files;
}

}
