#ifndef Varimarch_Frame_QualityChoices_h
#define Varimarch_Frame_QualityChoices_h

#include "Frame/Frame.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct MapperNumbers;

/// Chooses the error budget, the sample distance and the integration rule of a frame whose other
/// settings are complete.
void ChooseQuality(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame);

/// Refuses a published integration rule for a composite that it does not define, in whose place
/// another rule would be drawn.
/// @param settings  those of all volumes of a frame
/// @throws std::runtime_error with a sentence for the user
void CheckIntegrationRule(vtkVariationFieldVolumeMapper* mapper, const RenderSettings& settings);

/// Chooses the part of rays that is marched.
void ChooseSpan(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame);

}

#endif
