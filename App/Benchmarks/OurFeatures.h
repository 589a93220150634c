#ifndef Varimarch_Benchmarks_OurFeatures_h
#define Varimarch_Benchmarks_OurFeatures_h

#include "FeatureList.h"

namespace varimarch
{

/// Switches for features that only our mapper has. With another mapper they do nothing.
void CubicOn(const FeatureStage& stage);
void CubicOff(const FeatureStage& stage);
void DampingOn(const FeatureStage& stage);
void DampingOff(const FeatureStage& stage);

}

#endif
