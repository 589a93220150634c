#ifndef Varimarch_Frame_CurveNodes_h
#define Varimarch_Frame_CurveNodes_h

#include "Core/Look/TransferFunction.h"

#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

// VTK's functions as nodes of a TransferFunction. What they mean is what VTK's GetValue() and
// GetColor() return, limited to [0, 1].

namespace varimarch
{

/// The nodes of an opacity curve. They are VTK's own, with midpoints and sharpness, if the curve is
/// linear between values and stays within [0, 1]; otherwise the nodes follow it to 1/20000. A curve
/// that is not clamped steps to 0 at its ends. On a logarithmic scale VTK's function has no values
/// between nodes that are not above 0; a curve with such nodes is linear.
std::vector<OpacityNode> NodesOf(vtkPiecewiseFunction* function);

/// The nodes of a colour function: VTK's own if it interpolates linearly in RGB within [0, 1];
/// otherwise they follow it, also one of a subclass, to 1/20000, and its jumps exactly. An indexed
/// lookup is ignored. A function without nodes is black.
std::vector<ColorNode> NodesOf(vtkColorTransferFunction* function);

/// The gray nodes of an opacity curve.
std::vector<ColorNode> GrayNodesOf(vtkPiecewiseFunction* function);

/// Sentences that name what an image of a function lacks, each followed by a space; empty if it
/// lacks nothing.
std::string MissingFeatures(vtkPiecewiseFunction* function);
std::string MissingFeatures(vtkColorTransferFunction* function);

}

#endif
