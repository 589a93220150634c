#ifndef Varimarch_March_SearchFacts_h
#define Varimarch_March_SearchFacts_h

#include "Core/Quality/StepSearch.h"
#include "Resources/VolumeResources.h"

namespace varimarch
{

/// The shortest step that a search tries, of rays of the eye and of rays to lights, in voxels.
inline constexpr double FinestStepVoxels = 1.0 / 128.0;

/// Everything that a search for steps must know about a volume besides its trial images.
struct SearchFacts
{
  ErrorLimit limit = {};
  StepRange range = {}; ///< The sample distances to search [mm].
  double firstMm = 0.0; ///< The smallest distance of two voxels [mm].
  Integration usual = Integration::Midpoint;
  bool choosesIntegration = false;   ///< True if a trial may choose pre-integration.
  bool preIntegratesByTable = false; ///< True if each distance has a table of its own.
  bool hasLight = false;             ///< True if an image without light is another.
  bool isShaded = false;
  bool looksForPeaks = false;   ///< True for a composite whose opacity depends on values alone.
  bool hasNarrowPeaks = false;  ///< True if samples may miss peaks of the transfer function.
  bool losesByTable = false;    ///< True if pre-integration's table may move edges.
  bool hasNodesInTable = false; ///< True if nodes lie closer together than that table's values.
  bool mayPreIntegrate = false; ///< False if the table's losses rule out pre-integration.
  bool tracesLight = false;     ///< True if rays to lights or to all sides begin at samples.
  /// True if light may be interpolated in lattices, whose error no sample distance shows.
  bool keepsLight = false;
  /// The error that lattices and longer steps of light may add, in parts of the limit.
  double lightOfLimit = 0.0;
  double preIntegrationCost = 1.0; ///< The cost of a pre-integrated step, in midpoint steps.
};

SearchFacts FactsOf(const VolumeMarch& march, const VolumeResources& volume);

/// The coarsest sample distance of a search [mm].
/// @param grid  the box of the volume, or of the whole of which it is a part, in its grid
/// coordinates
/// @param longestRayMm  through it
double CoarsestDistanceMm(const Frame& frame, const Box& grid, double longestRayMm);

}

#endif
