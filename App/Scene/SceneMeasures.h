#ifndef Varimarch_Scene_SceneMeasures_h
#define Varimarch_Scene_SceneMeasures_h

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// Measurements and annotations; MeasureKinds.h says what each has.
enum class MeasureKind
{
  Distance,
  Angle,     ///< between two arms from a vertex
  CobbAngle, ///< between two lines anywhere
  Box,       ///< along the volume's axes, with statistics of its voxels
  Ellipse,   ///< in a plane, with statistics
  Freehand,  ///< an outline in a plane, with statistics
  Curve,     ///< a smooth line, along which the volume can be straightened
  Arrow,     ///< with words at its tail
  Text,
};

/// A measurement or an annotation, drawn over the image. World space, LPS.
struct Measure
{
  MeasureKind kind;
  /// Distance, box: both ends. Angle: an end, the vertex, the other end. Cobb angle: both ends of
  /// the first line, then of the second. Ellipse: the middle, and the ends of two conjugate
  /// half-diameters. Freehand: the outline. Curve: the points it passes through. Arrow: the tail
  /// and the tip. Text: its place.
  std::vector<std::array<double, 3>> pointsMm;
  std::string name = {}; ///< the words of an arrow or a text; may be empty
  bool visible = true;
};

/// Far more than anybody measures by hand, and as many as older files can have.
constexpr std::size_t MostMeasures = 3000;

/// Points of an outline or a curve. Screens have fewer pixels along an edge.
constexpr std::size_t MostMeasurePoints = 10000;

}

#endif
