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

/// Chooses the part of rays that is marched.
void ChooseSpan(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame);

}

#endif
