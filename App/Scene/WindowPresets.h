#ifndef Varimarch_Scene_WindowPresets_h
#define Varimarch_Scene_WindowPresets_h

#include <string>
#include <vector>

namespace varimarch
{

/// A grey scale that radiologists use for a part of the body [HU].
struct WindowPreset
{
  std::string name; ///< English
  double window;
  double level;
};

/// The usual windows of CT, at most nine. Empty for other modalities, whose values have no common
/// unit.
/// @param modality  of DICOM, such as "CT"
const std::vector<WindowPreset>& WindowPresetsOf(const std::string& modality);

}

#endif
