#ifndef Varimarch_Frame_GrayRange_h
#define Varimarch_Frame_GrayRange_h

#include "Core/Look/ValueRange.h"
#include "Frame/VoxelInput.h"

#include "VarimarchVolumeModule.h"

namespace varimarch
{

/// The values that projections show as black and white: the range of the finite scalars, as in VTK.
/// If they reach far beyond those that count in an average, it is the range of these.
/// @param counted  the values that count
VARIMARCHVOLUME_EXPORT ValueRange GrayRangeOf(const VoxelComponent& component, ValueRange counted);

}

#endif
