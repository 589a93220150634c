#include "Scene/WindowPresets.h"

namespace varimarch
{

const std::vector<WindowPreset>& WindowPresetsOf(const std::string& modality)
{
  static const std::vector<WindowPreset> ofCt = {
    { "Abdomen", 400.0, 50.0 },
    { "Lungs", 1500.0, -600.0 },
    { "Mediastinum", 350.0, 50.0 },
    { "Bone", 1800.0, 400.0 },
    { "Brain", 80.0, 40.0 },
    { "Subdural", 200.0, 75.0 },
    { "Stroke", 40.0, 40.0 },
    { "Liver", 150.0, 30.0 },
    { "Vessels", 600.0, 170.0 },
  };
  static const std::vector<WindowPreset> none;
  return modality == "CT" ? ofCt : none;
}

}
