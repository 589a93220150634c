#ifndef Varimarch_Frame_PropertyTransferFunction_h
#define Varimarch_Frame_PropertyTransferFunction_h

#include "Core/Look/TransferFunction.h"
#include "Frame/Fingerprint.h"

#include "VarimarchVolumeModule.h"

#include <string>
#include <vector>

class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace varimarch
{

/// The transfer function that a property's curves describe for a component: the values that VTK's
/// GetValue() and GetColor() return, limited to [0, 1].
VARIMARCHVOLUME_EXPORT TransferFunction TransferFunctionOf(
  vtkVolumeProperty* property, int component = 0);

/// The labels of a mask that have curves of their own, ascending. Row i + 1 of the tables belongs
/// to the i-th label, row 0 to all other labels.
std::vector<int> LabelsOf(vtkVolumeProperty* property);

/// The transfer function of a label. A missing curve is replaced by that of unlabelled voxels.
/// @param without  the function of unlabelled voxels
TransferFunction LabelTransferFunctionOf(
  vtkVolumeProperty* property, int label, const TransferFunction& without);

/// VTK's opacity curve as a transfer function without colours.
TransferFunction OpacityCurveOf(vtkPiecewiseFunction* function);

/// Sentences that name what an image of a property's curves lacks, each followed by a space; empty
/// if it lacks nothing.
/// @param components  the number of components that have curves of their own
std::string MissingFunctionFeatures(vtkVolumeProperty* property, int components);

/// Everything that the transfer function of a component is made from.
Fingerprint TransferFunctionInputs(vtkVolumeProperty* property, int component);

/// The transfer function of an independent component behind the first. A property that has none for
/// a component answers with VTK's default, which is opaque for all values, so that the volume would
/// be a box. Such a component has the opacities of the first one, and its colours if it has none
/// either.
/// @param first  the function of the first component
TransferFunction FunctionOfComponent(
  vtkVolumeProperty* property, int component, const TransferFunction& first);

/// True if the opacities of a component are its own.
bool HasOpacities(vtkVolumeProperty* property, int component);

}

#endif
