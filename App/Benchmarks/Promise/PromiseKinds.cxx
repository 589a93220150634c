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

}
