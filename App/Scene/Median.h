#ifndef Varimarch_Scene_Median_h
#define Varimarch_Scene_Median_h

#include <vector>

namespace varimarch
{

/// Median of at least one number; for an even count, the mean of the two in the middle.
double Median(std::vector<double> numbers);

}

#endif
