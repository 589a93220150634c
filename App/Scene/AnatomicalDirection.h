#ifndef Varimarch_Scene_AnatomicalDirection_h
#define Varimarch_Scene_AnatomicalDirection_h

#include <string>

namespace varimarch
{

/// Where a direction in world space (LPS) points in the patient, by the letters of Left, Right,
/// Posterior, Anterior, Superior and Inferior: "L" for +x, "AR" for one between them, the nearest
/// first. A part of the direction below a twentieth of it is left out. Empty for no direction.
std::string AnatomicalDirection(const double directionWorld[3]);

}

#endif
