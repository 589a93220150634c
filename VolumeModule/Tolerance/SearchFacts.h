#ifndef Varimarch_Tolerance_SearchFacts_h
#define Varimarch_Tolerance_SearchFacts_h

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Quality/StepSearch.h"
#include "Resources/VolumeResources.h"

#include <string>
#include <vector>

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

/// The lights that the result of a tolerance search depends on.
struct ToleranceLights
{
  Fingerprint colors; ///< All lights but for where they are.
  std::vector<glm::vec3>
    places; ///< The places or directions of lamps, and the axes of their cones.
  std::vector<glm::vec3> towards; ///< The directions from the middle of the volumes to lamps.

  /// Adds the lights of one volume.
  void Add(const Frame& frame);

  /// True if no lamp has moved by much.
  bool IsNear(const ToleranceLights& other) const;
  bool operator==(const ToleranceLights& other) const
  {
    return this->colors == other.colors && this->places == other.places;
  }
  bool operator!=(const ToleranceLights& other) const { return !(*this == other); }
};

/// Everything that the result of a tolerance search depends on.
struct ToleranceInputs
{
  std::vector<std::string> recipe; ///< The shader files of the request.
  Fingerprint rule;                ///< Other inputs of the choice of the rule, without voxels.
  Fingerprint voxels;              ///< The voxels of each volume, and the values told apart.
  Fingerprint scene;               ///< Other inputs of the image in any view.
  ToleranceLights lights;
  Fingerprint casters;           ///< The geometry that casts shadows on the volumes.
  std::vector<CornersClip> view; ///< The corners of the volumes in the view.

  /// Adds the inputs of one volume.
  void Add(const VolumeMarch& march, const VolumeResources& volume);

  bool HasRuleOf(const ToleranceInputs& other) const
  {
    return this->recipe == other.recipe && this->rule == other.rule;
  }
  /// True if the scene is the same but for its lights and the places of geometry that casts
  /// shadows.
  bool HasVolumesOf(const ToleranceInputs& other) const
  {
    return this->HasRuleOf(other) && this->voxels == other.voxels && this->scene == other.scene;
  }
  bool operator==(const ToleranceInputs& other) const
  {
    return this->HasVolumesOf(other) && this->lights == other.lights &&
      this->casters == other.casters && this->view == other.view;
  }
};

/// The integration rule and the steps that keep an error tolerance.
struct ToleranceChoice
{
  ToleranceInputs inputs; ///< The inputs of the image whose rays have tried it.
  Integration integration;
  StepChoice step;
  double missedOfLimit = 0.0; ///< The error that no sample distance shows, in parts of the limit.
  LightSource light = {};     ///< The way to the light of the image.
  double searchedMm = 0.0;    ///< The sample distance of the search that found it.
  std::vector<CornersClip> searchedView; ///< The view of that search.
  ToleranceLights searchedLights;        ///< The lights of that search.
  bool isOfOther = false; ///< True if that search was for another image, and fewer rays tried it.
};

/// True if two views, each the corners of all volumes, are nearly the same.
bool IsNear(const std::vector<CornersClip>& view, const std::vector<CornersClip>& other);

}

#endif
