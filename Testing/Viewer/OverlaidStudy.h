#ifndef Varimarch_Testing_OverlaidStudy_h
#define Varimarch_Testing_OverlaidStudy_h

#include "Scene/Volumes/Placing.h"
#include "SmallStudy.h"

/// A PET of 12 voxels along each axis around the middle of a scan, with 1000 Bq/ml in the middle 8
/// and a factor of 0.002: an SUV of 2.
inline std::shared_ptr<const varimarch::Study> PetOver(vtkImageData* scan)
{
  using namespace varimarch;
  LoadedVolume volume;
  volume.image = vtkSmartPointer<vtkImageData>::New();
  volume.image->SetDimensions(12, 12, 12);
  volume.image->SetSpacing(8.0, 8.0, 8.0);
  const double* const middle = scan->GetCenter();
  volume.image->SetOrigin(middle[0] - 44.0, middle[1] - 44.0, middle[2] - 44.0);
  volume.image->AllocateScalars(VTK_FLOAT, 1);
  auto* const values = static_cast<float*>(volume.image->GetScalarPointer());
  const auto isMiddle = [](int index) { return index >= 2 && index < 10; };
  for (int i = 0; i < 12 * 12 * 12; ++i)
  {
    values[i] = isMiddle(i % 12) && isMiddle(i / 12 % 12) && isMiddle(i / 144) ? 1000.0F : 0.0F;
  }
  volume.modality = "PT";
  volume.uptakeValueFactor = 0.002;
  ImageStatistics statistics(volume.image);
  return std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

inline void AddPet(varimarch::SceneModel& model, const std::string& file = "/scans/pet")
{
  const auto pet = PetOver(model.CurrentStudy()->volume.image);
  model.AddOverlay(
    varimarch::OverlayOf(varimarch::FileSource{ file, std::nullopt }, pet->volume, pet->statistics),
    pet, "add a scan");
}

#endif
