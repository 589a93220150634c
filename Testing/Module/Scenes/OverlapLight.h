#ifndef Varimarch_Testing_OverlapLight_h
#define Varimarch_Testing_OverlapLight_h

#include "Module/Scenes/OverlapScene.h"

#include <optional>
#include <vector>

/// A white light at infinity.
struct TestLamp
{
  glm::dvec3 towards; ///< unit vector to the light
  double softnessDegrees = 0.0;
};

/// Light in overlapping volumes, of which those that are shaded send diffuse light only.
struct OverlapLight
{
  std::vector<TestLamp> lamps;
  bool hasHeadLight = false;
  bool hasShadows = true;
  bool isScattered = false; ///< to all sides alike, by all matter that is shaded
  double occlusion = 0.0;
  double occlusionReachMm = 6.0;
  std::optional<varimarch::Box> opaque = {}; ///< an opaque box [mm], outside the view
};

/// Lights a scene.
void UseLight(OverlapScene& scene, const OverlapLight& light);

/// The reference's image of a scene in a light: rays to the lights are integrated in double
/// precision through all of its volumes.
std::vector<float> TruthInLight(OverlapScene& scene, const OverlapLight& light, double tolerance);

#endif
