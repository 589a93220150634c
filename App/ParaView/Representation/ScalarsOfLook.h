#ifndef Varimarch_ScalarsOfLook_h
#define Varimarch_ScalarsOfLook_h

#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkScalarsToColors;

namespace varimarch
{

/// The scalars that a transfer function of one component maps, made from an array of vectors: their
/// magnitude or a component, as the function's vector mode says.
vtkSmartPointer<vtkDataArray> ScalarsOfLook(vtkDataArray* vectors, vtkScalarsToColors* look);

}

#endif
