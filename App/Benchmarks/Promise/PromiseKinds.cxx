#include "PromiseKinds.h"

namespace varimarch
{

const std::vector<PromiseKind>& PromiseKinds()
{
  static const std::vector<PromiseKind> kinds = []
  {
    std::vector<PromiseKind> all;
    for (auto* const make : { MatterPromiseKinds, FeaturePromiseKinds, EditPromiseKinds,
           ShadowPromiseKinds, LightPromiseKinds, OcclusionPromiseKinds })
    {
      const std::vector<PromiseKind> some = make();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kinds;
}

const std::vector<std::string>& PromiseKindsUnderWork()
{
  static const std::vector<std::string> kinds = {
    // Gradients of even matter were lit as surfaces; not judged in the suite since.
    "head-light",
    "lamps",
    // Light where matter changes within a voxel.
    "shadow-along-sheet",
    "shadow-bands",
    "shadow-look-edits",
    "shadow-mask-edits",
    "shadow-moves",
    "soft-bands",
    "scattering-bands",
    "occlusion",
    "occlusion-noise",
    "occlusion-walls",
    "occlusion-bands",
    "occlusion-sheets",
    "occlusion-nearest",
    "occlusion-unlit",
    "occlusion-shadows",
    "occlusion-pet-over-ct",
    "occlusion-edits",
  };
  return kinds;
}

}
