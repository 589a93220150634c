#ifndef Varimarch_Scene_AnatomicalDirection_h
#define Varimarch_Scene_AnatomicalDirection_h

#include <string>

namespace varimarch
{

/// Names a direction in world space (LPS) by the letters of Left, Right, Posterior, Anterior,
/// Superior and Inferior: "L" for +x. An oblique direction has several letters, the largest
/// component first, as in "AR"; components below a twentieth of the length are left out. The zero
/// vector gives an empty string.
std::string AnatomicalDirection(const double directionWorld[3]);

}

#endif
