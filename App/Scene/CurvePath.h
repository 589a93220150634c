#ifndef Varimarch_Scene_CurvePath_h
#define Varimarch_Scene_CurvePath_h

#include <glm/vec3.hpp>

#include <array>
#include <vector>

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

}

#endif
