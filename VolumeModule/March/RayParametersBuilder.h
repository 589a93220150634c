#ifndef Varimarch_March_RayParametersBuilder_h
#define Varimarch_March_RayParametersBuilder_h

#include "Core/Geometry/Box.h"
#include "Core/Parameters/MarchParameters.h"
#include "Frame/MarchPlan.h"

namespace varimarch
{

/// The rays of a frame that is drawn with rays this far apart [pixels]; several rays in a pixel
/// stand in equal rows.
Viewport RaysOf(const Viewport& frame, double imageSampleDistance);

/// The numbers of a march that follow from the frame alone. Numbers of what was drawn before, such
/// as an image of depths, are left at zero for those who have it.
/// @param boxGrid  box that all rays of the frame are marched in
RayParameters RayParametersOf(const VolumeMarch& march, const Box& boxGrid);

}

#endif
