#ifndef Varimarch_Testing_LabelledStudy_h
#define Varimarch_Testing_LabelledStudy_h

#include "SmallStudy.h"

/// Labels on the grid of an image: 3 in the lower half of its slices, 5 in the first row of the
/// others, and 0 elsewhere.
inline varimarch::LoadedVolume LabelsOf(vtkImageData* scan)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(scan);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const int* const count = image->GetDimensions();
  for (int z = 0; z < count[2]; ++z)
  {
    for (int y = 0; y < count[1]; ++y)
    {
      for (int x = 0; x < count[0]; ++x)
      {
        *static_cast<unsigned char*>(image->GetScalarPointer(x, y, z)) = 2 * z < count[2] ? 3
          : y == 0                                                                        ? 5
                                                                                          : 0;
      }
    }
  }
  return { image, "", {} };
}

/// The small torso with these labels over it.
inline std::shared_ptr<const varimarch::Study> LabelledStudy()
{
  const auto scan = SmallStudy();
  return varimarch::WithLabels(
    *scan, varimarch::LabelMapOf(LabelsOf(scan->volume.image), "labels.nrrd", scan->volume));
}

#endif
