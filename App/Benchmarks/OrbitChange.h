#ifndef Varimarch_Benchmarks_OrbitChange_h
#define Varimarch_Benchmarks_OrbitChange_h

#include "CommandLine/Truth.h"
#include "MethodView.h"

#include <vector>

namespace varimarch
{

/// The change of a method's error between neighbouring frames of an orbit, which the eye sees as
/// popping, crawling or flicker: the RMSE of (frame - fine frame) - (previous frame - previous fine
/// frame) [1/255]. The fine frames take the motion of the volume itself out.
struct OrbitChange
{
  int frames; ///< frames of the orbit
  double degreesPerFrame;
  double median; ///< the median change of all pairs of neighbours
  double largest;
  double largestAtDegrees; ///< azimuth from the scene's camera at which the largest change ends
};

/// The azimuth of an orbit [degrees]: it turns the view from an axis to the next.
constexpr double OrbitDegrees = 90.0;

/// Draws the same orbit with all methods, and with our mapper at eight samples per voxel as the
/// fine frames. The cameras are as before afterwards.
/// @param views   methods with their settings
/// @param frames  at least 2
std::vector<OrbitChange> ChangesInOrbit(const std::vector<MethodView*>& views, const Scene& scene,
  vtkImageData* image, int frames, const OnStep& onStep);

/// The summary of the changes from frame to frame of an orbit.
/// @param changes  one for each frame but the first, at least one
OrbitChange SummaryOf(const std::vector<double>& changes);

}

#endif
