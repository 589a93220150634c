#ifndef Varimarch_Frame_PropertyTransferFunction_h
#define Varimarch_Frame_PropertyTransferFunction_h

#include "Core/Look/TransferFunction.h"
#include "Frame/Fingerprint.h"

#include "VarimarchVolumeModule.h"

#include <vector>

class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace varimarch
{

/// The transfer function that a property's curves describe for a component. It is exact: it has
/// VTK's midpoints and sharpness, gray or colour nodes, and a step to zero at the ends of a curve
/// without clamping. Only colour spaces other than linear RGB are sampled finely between nodes.
VARIMARCHVOLUME_EXPORT TransferFunction TransferFunctionOf(
  vtkVolumeProperty* property, int component = 0);

/// The labels of a mask that have curves of their own, ascending. Row i + 1 of the tables belongs
/// to the i-th label, row 0 to all other labels.
std::vector<int> LabelsOf(vtkVolumeProperty* property);

/// The transfer function of a label. A missing curve is replaced by that of unlabelled voxels.
TransferFunction LabelTransferFunctionOf(vtkVolumeProperty* property, int label);

/// VTK's opacity curve as a transfer function without colours.
TransferFunction OpacityCurveOf(vtkPiecewiseFunction* function);

/// Everything that the transfer function of a component is made from.
Fingerprint TransferFunctionInputs(vtkVolumeProperty* property, int component);

}

#endif
