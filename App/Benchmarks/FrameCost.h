#ifndef Varimarch_Benchmarks_FrameCost_h
#define Varimarch_Benchmarks_FrameCost_h

#include "Scene/Images/OffscreenView.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <vector>

namespace varimarch
{

/// The cost of one mapper's frames, beginning with the first. A time is that of one
/// vtkRenderWindow::Render, until the device has finished.
struct FrameCost
{
  double firstMs;       ///< time of the first frame of a new window and mapper, volume in memory
  double stillMs;       ///< median time of the next frames, without changes: five, or 50 ms of them
  double rebuildMs;     ///< extra time of the frame after a change of the transfer function
  double firstFieldMs;  ///< time to build the field for the first frame; 0 without a field
  double changeFieldMs; ///< time to rebuild the field for the changed transfer function
};

/// Draws frames. The view must be new, and has another look afterwards.
/// @throws std::runtime_error when the mapper reports an error
FrameCost CostOfFrames(OffscreenView& view, const Look& look);

/// The median of each time separately, over at least one round.
FrameCost MedianOf(const std::vector<FrameCost>& rounds);

nlohmann::ordered_json ToJson(const FrameCost& cost);

/// Fetches from the volume per pixel, as the mean over all pixels, including those without volume.
/// Empty for VTK's mappers, which do not count them, and for volumes that are too large for a
/// texture.
std::optional<double> FetchesPerPixel(OffscreenView& view);

/// The mapper's graphics memory [bytes]. Empty for VTK's mappers, which do not report it.
std::optional<double> GraphicsBytes(OffscreenView& view);

}

#endif
