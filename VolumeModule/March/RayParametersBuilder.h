#ifndef Varimarch_March_RayParametersBuilder_h
#define Varimarch_March_RayParametersBuilder_h

#include "Core/Geometry/Box.h"
#include "Core/Parameters/MarchParameters.h"
#include "Frame/MarchPlan.h"

namespace varimarch
{

/// The grid of rays of a frame that is drawn with rays this far apart [pixels]. Several rays in a
/// pixel form a regular grid.
Viewport RaysOf(const Viewport& frame, double imageSampleDistance);

/// True if shadows may be wrong because the device ends shaders that take long: the segments of
/// rays to lights are longer than the sample distance asks for, or rays look for opaque geometry
/// too.
bool HasLongShadowSteps(const VolumeMarch& march);

/// The parameters of a march that follow from the frame alone. Parameters of earlier drawings, such
/// as an image of depths, are left at zero; the caller sets them.
/// @param boxGrid  the box through which all rays of the frame are marched
RayParameters RayParametersOf(const VolumeMarch& march, const Box& boxGrid);

}

#endif
