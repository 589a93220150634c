#ifndef Varimarch_Frame_FiniteRange_h
#define Varimarch_Frame_FiniteRange_h

#include "Core/Look/ValueRange.h"
#include "Frame/VoxelInput.h"

#include "VarimarchVolumeModule.h"

namespace varimarch
{

/// The range of the finite values of a component, none if there are none. Reads the voxels on all
/// cores, which takes a small part of the time of vtkDataArray::GetFiniteRange.
ValueRange FiniteRangeOf(const VoxelComponent& component);

/// The range of nine tenths of the finite values of a component, without the lowest and the highest
/// twentieth, by some thousand of its voxels; none if there are none.
ValueRange UsualRangeOf(const VoxelComponent& component);

/// The values that projections show as black and white: the range of the finite scalars, as in VTK.
/// If they reach far beyond those that count in an average, it is the range of these.
/// @param counted  the values that count
VARIMARCHVOLUME_EXPORT ValueRange GrayRangeOf(const VoxelComponent& component, ValueRange counted);

}

#endif
