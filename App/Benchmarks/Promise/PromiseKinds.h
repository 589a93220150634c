#ifndef Varimarch_Promise_PromiseKinds_h
#define Varimarch_Promise_PromiseKinds_h

#include "PromiseScene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A family of random scenes that are hard in one way.
struct PromiseKind
{
  std::string name;
  bool isLit; ///< with shadows, scattered light or ambient occlusion
  void (*make)(PromiseScene& scene);
};

/// All kinds, those without light first.
const std::vector<PromiseKind>& PromiseKinds();

///@{
/// The kinds by what makes them hard.
std::vector<PromiseKind> MatterPromiseKinds();
std::vector<PromiseKind> FeaturePromiseKinds();
std::vector<PromiseKind> EditPromiseKinds();
std::vector<PromiseKind> ShadowPromiseKinds();
std::vector<PromiseKind> LightPromiseKinds();
std::vector<PromiseKind> OcclusionPromiseKinds();
///@}

}

#endif
