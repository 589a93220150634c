#ifndef Varimarch_Scene_CurvedPicture_h
#define Varimarch_Scene_CurvedPicture_h

#include "Scene/Slices/SlicePicture.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// A smooth curve through points in world space, and a direction across it that turns about it as
/// little as possible. The curve is a centripetal Catmull-Rom spline (Yuksel, Schaefer and Keyser,
/// "Parameterization and applications of Catmull-Rom curves", 2011), which makes neither loops nor
/// cusps between points of any distances.
class CurvePath
{
public:
  /// @param pointsMm  at least one; a point at the place of the one before is left out
  explicit CurvePath(const std::vector<std::array<double, 3>>& pointsMm);

  /// The curve with all points moved into a plane, along a direction that is perpendicular to its
  /// chord and is then `across` at each place. A picture along it is the stretched one of
  /// A. Kanitsar and others ("CPR - curved planar reformation", 2002): it shows the surface that a
  /// line of this direction sweeps along this curve, and all distances within the surface are
  /// right. Each point becomes one point.
  /// @param turnDegrees  turns the direction about the chord
  CurvePath Stretched(double turnDegrees) const;

  double LengthMm() const { return this->lengthsMm.back(); }

  /// Points along the curve, close enough to draw lines between them.
  const std::vector<glm::dvec3>& Points() const { return this->points; }

  /// The length of the curve up to each of them [mm].
  const std::vector<double>& LengthsMm() const { return this->lengthsMm; }

  struct Place
  {
    glm::dvec3 pointMm;
    glm::dvec3 along;  ///< unit vector
    glm::dvec3 across; ///< unit vector, perpendicular to `along`
  };

  /// The place at a distance along the curve, limited to its ends. Requires a length > 0.
  /// @param turnDegrees  turns `across` about the curve, counterclockwise against its direction
  Place At(double distanceMm, double turnDegrees) const;

  /// The distance along the curve of its place nearest to a point [mm].
  double NearestMm(const glm::dvec3& pointMm) const;

private:
  CurvePath() = default;
  void FindLengths();
  void FindDirections();
  void FindAlong();

  std::vector<glm::dvec3> points;
  std::vector<double> lengthsMm;  ///< length of the curve up to each point
  std::vector<glm::dvec3> along;  ///< at each point
  std::vector<glm::dvec3> across; ///< at each point
};

/// A volume that is straightened along a curve: the curve runs through the middle row from left to
/// right, and each column shows the line across it. Both have the same scale, so that distances
/// along the curve and across it are right; others are right along a stretched curve only.
struct CurvedRequest
{
  double mmPerPixel; ///< > 0
  int width;         ///< pixels
  int height;
  double turnDegrees; ///< turns the lines across the curve about it, see CurvePath::At
  SlabLook look;      ///< the slab is perpendicular to the curve and to the lines
};

/// Grey pixels, row by row from the upper left. Columns beyond the end of the curve are black.
std::vector<std::uint8_t> CurvedPicture(
  vtkImageData* image, const CurvePath& path, const CurvedRequest& request);

/// The point that a pixel shows in the middle of the slab, in world space [mm].
/// @param column, row  continuous; the centre of the upper left pixel is at 0.5, 0.5
glm::dvec3 PointInCurved(
  const CurvePath& path, const CurvedRequest& request, double column, double row);

}

#endif
