#ifndef Varimarch_Testing_TorsoOnDisk_h
#define Varimarch_Testing_TorsoOnDisk_h

#include "Module/Files/PhantomFiles.h"
#include "Module/Scenes/MapperScene.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <string>

/// A torso whose voxels stay in their file.
class TorsoOnDisk : public testing::Test
{
protected:
  /// Memory in which the voxels do not fit.
  static constexpr vtkIdType TooLittleForTorso = 60000;

  vtkImageData* Read(const std::string& path, vtkIdType memory)
  {
    this->reader->SetFileName(path.c_str());
    this->reader->SetMaximumHostMemory(memory);
    this->reader->Update();
    return this->reader->GetOutput();
  }

  /// A torso as a file of raw voxels.
  std::string WriteTorso()
  {
    vtkDataArray* const scalars = this->torso->GetPointData()->GetScalars();
    return this->folder.Write("torso.raw",
      { static_cast<const char*>(scalars->GetVoidPointer(0)),
        std::size_t(2 * scalars->GetNumberOfValues()) });
  }

  vtkImageData* ReadTorso(const std::string& path)
  {
    this->reader->SetRawDimensions(this->torso->GetDimensions());
    this->reader->SetRawScalarType(VTK_SHORT);
    this->reader->SetRawSpacing(this->torso->GetSpacing());
    return this->Read(path, TooLittleForTorso);
  }

  TemporaryFolder folder;
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  vtkNew<vtkVolumeFileReader> reader;
};

#endif
