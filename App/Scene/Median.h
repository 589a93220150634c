#ifndef Varimarch_Scene_Median_h
#define Varimarch_Scene_Median_h

#include <vector>

namespace varimarch
{

/// The middle one, or the mean of the two in the middle; of at least one.
double Median(std::vector<double> numbers);

}

#endif
