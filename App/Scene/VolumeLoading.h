#ifndef Varimarch_Scene_VolumeLoading_h
#define Varimarch_Scene_VolumeLoading_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

struct LoadedVolume
{
  vtkSmartPointer<vtkImageData> image; ///< world space is LPS [mm]
  std::string modality;                ///< as DICOM has it: "CT", "MR"; empty when not known
  std::vector<std::string> warnings;   ///< one sentence each
};

/// Reads or computes the volume of a scene.
/// @throws std::runtime_error with one sentence that names the file and what is wrong with it
LoadedVolume LoadVolume(const VolumeSource& source);

/// A preset that suits a volume nobody has described: for CT, known by its modality or by values
/// as low as air's in Hounsfield units, "ct-bone"; else "mr-head".
std::string SuitablePreset(const LoadedVolume& volume);

}

#endif
