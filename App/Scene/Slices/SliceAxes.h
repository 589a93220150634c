#ifndef Varimarch_Scene_SliceAxes_h
#define Varimarch_Scene_SliceAxes_h

#include <array>
#include <string>

namespace varimarch
{

/// Anatomical planes.
enum class SlicePlane
{
  Axial,    ///< seen from the feet: patient's right at the left, front at the top
  Coronal,  ///< seen from the front: patient's right at the left, head at the top
  Sagittal, ///< seen from the patient's left: front at the left, head at the top
};

/// Directions of a slice's image in world space (LPS): along its rows, down its columns, and from
/// one slice to the next. Unit vectors, perpendicular to each other.
struct SliceAxes
{
  std::array<double, 3> right;
  std::array<double, 3> down;
  std::array<double, 3> through;
};

/// A rotation of all three planes about the crosshair: its direction is the axis, its length the
/// angle [degrees], counterclockwise as seen against the axis. 0: the anatomical planes.
using SliceTurn = std::array<double, 3>;

/// The axes of a plane that is turned. The image is turned in its plane as little as possible, so
/// that a turn about `through` changes the other two planes only.
SliceAxes AxesOf(SlicePlane plane, const SliceTurn& turn = {});

/// A turn, followed by one about an axis of unit length.
SliceTurn TurnedBy(const SliceTurn& turn, const std::array<double, 3>& axis, double degrees);

/// Names a direction in world space (LPS) by the letters of Left, Right, Posterior, Anterior,
/// Superior and Inferior: "L" for +x. An oblique direction has several letters, the largest
/// component first, as in "AR"; components below a twentieth of the length are left out. The zero
/// vector gives an empty string.
std::string AnatomicalDirection(const double directionWorld[3]);

}

#endif
