#ifndef Varimarch_Benchmarks_FrameCost_h
#define Varimarch_Benchmarks_FrameCost_h

#include "Scene/OffscreenView.h"

#include <optional>
#include <vector>

namespace varimarch
{

/// What pictures of one mapper cost, from its first on. Times are those of one
/// vtkRenderWindow::Render, until the device has finished.
struct FrameCost
{
  double firstMs;       ///< the first picture of a new window and mapper, the volume in memory
  double stillMs;       ///< the median of the next, of which nothing has changed: five, or 50 ms
  double rebuildMs;     ///< how much longer the one after a change of transfer function takes
  double firstFieldMs;  ///< building the field for the first picture; 0 without a field
  double changeFieldMs; ///< building it again for the changed transfer function
};

/// Draws pictures. The view must be new, and shows a changed look afterwards.
/// @throws std::runtime_error when the mapper reports an error
FrameCost CostOfFrames(OffscreenView& view, const Look& look);

/// Of each time by itself; of at least one cost.
FrameCost MedianOf(const std::vector<FrameCost>& rounds);

/// How often a ray reads the volume: the mean over all pixels, also those that see no volume.
/// Empty for VTK's mappers, which do not tell, and for volumes that the device has no texture for.
std::optional<double> FetchesPerPixel(OffscreenView& view);

/// What the mapper holds of the graphics memory. Empty for VTK's mappers, which do not tell.
std::optional<double> GraphicsBytes(OffscreenView& view);

}

#endif
