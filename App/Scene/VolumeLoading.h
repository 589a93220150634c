#ifndef Varimarch_Scene_VolumeLoading_h
#define Varimarch_Scene_VolumeLoading_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
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

/// Told the part of the work that is done, [0, 1]; says whether to go on.
using LoadObserver = std::function<bool(double)>;

/// Reads or computes the volume of a scene. Procedural volumes know no progress.
/// @throws std::runtime_error with one sentence that names the file and what is wrong with it, or
///   says that the observer did not want to go on
LoadedVolume LoadVolume(const VolumeSource& source, const LoadObserver& observer = {});

struct PresetSuggestion
{
  std::string name;
  std::string reason; ///< "the file says that it is CT"
};

/// A preset for a volume nobody has described: for CT, known by its modality or by values as low as
/// air's in Hounsfield units, "ct-bone"; else "mr-head".
PresetSuggestion SuggestedPreset(const LoadedVolume& volume);

}

#endif
