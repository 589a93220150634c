#ifndef Varimarch_March_CommonSteps_h
#define Varimarch_March_CommonSteps_h

#include "Core/Geometry/Box.h"
#include "Core/Quality/StepSearch.h"
#include "Frame/MarchPlan.h"

namespace varimarch
{

/// Steps that several mappers share, each of which draws a part of a volume.
struct CommonSteps
{
  StepChoice step;      ///< [mm]
  bool isPreIntegrated; ///< True for pre-integration, false for midpoints, if a trial may choose.
  LightSource light;    ///< The way to the light of the images.
  Box wholeData;        ///< The box around all parts, in the coordinates of the data.
};

}

#endif
