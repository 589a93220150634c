#ifndef Varimarch_Frame_ComponentFunctions_h
#define Varimarch_Frame_ComponentFunctions_h

#include "Core/Look/TransferFunction.h"

class vtkVolumeProperty;

namespace varimarch
{

/// The transfer function of an independent component. A property that has none for a component
/// answers with VTK's default, which is opaque for all values, so that the volume would be a box.
/// Such a component has the opacities of the first one, and its colours if it has none either.
TransferFunction FunctionOfComponent(vtkVolumeProperty* property, int component);

/// True if the opacities of a component are its own.
bool HasOpacities(vtkVolumeProperty* property, int component);

}

#endif
