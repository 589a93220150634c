#ifndef Varimarch_Frame_PropertyTransferFunction_h
#define Varimarch_Frame_PropertyTransferFunction_h

#include "Core/Look/TransferFunction.h"

#include "VarimarchVolumeModule.h"

#include <vector>

class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace varimarch
{

/// The transfer function that a property's curves for a component describe, exactly:
/// VTK's nodes with midpoint and sharpness, its gray or colour channel, and clamping off as a step
/// to nothing. A colour function in another space than linear RGB is sampled finely between nodes.
VARIMARCHVOLUME_EXPORT TransferFunction TransferFunctionOf(
  vtkVolumeProperty* property, int component = 0);

/// The labels of a mask that have curves of their own, ascending. Row i + 1 of the tables is that
/// of the i-th label; row 0 is that of all other labels.
std::vector<int> LabelsOf(vtkVolumeProperty* property);

/// The transfer function of a label. Where it has no curve of its own, it is that without a label.
TransferFunction LabelTransferFunctionOf(vtkVolumeProperty* property, int label);

/// A curve of opacities, as VTK has it; without colours.
TransferFunction OpacityCurveOf(vtkPiecewiseFunction* function);

/// When one of those curves changed last.
unsigned long TransferFunctionTimeOf(vtkVolumeProperty* property, int component = 0);

}

#endif
