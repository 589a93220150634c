#ifndef Varimarch_Scene_TorsoPhantom_h
#define Varimarch_Scene_TorsoPhantom_h

#include <glm/vec3.hpp>

#include <variant>
#include <vector>

namespace varimarch
{

/// A torso as CT shows it, in Hounsfield units: skin, fat, muscle, lungs with vessels, a heart and
/// an aorta full of contrast medium, liver, spine, ribs and breastbone. It is made of simple
/// solids, each painted over those before it, with edges as soft as a scanner's. It has no noise.
///
/// Positions are in mm, LPS, the origin in the middle of the chest.
class TorsoPhantom
{
public:
  struct Ellipsoid
  {
    glm::dvec3 center;
    glm::dvec3 radii;
  };

  /// An upright cylinder; the radii are those along x and y and half the height.
  struct EllipticCylinder
  {
    glm::dvec3 center;
    glm::dvec3 radii;
  };

  /// A line segment whose radius changes linearly from one end to the other.
  struct Capsule
  {
    glm::dvec3 start;
    glm::dvec3 end;
    double startRadius;
    double endRadius;
  };

  using Shape = std::variant<Ellipsoid, EllipticCylinder, Capsule>;

  struct Solid
  {
    Shape shape;
    double hounsfield;
    glm::dvec3 lower; ///< box that holds the shape and its soft edge
    glm::dvec3 upper;
  };

  /// Size of the box to sample [mm]: left-right, front-back, down-up. The body is cut off at the
  /// top and the bottom.
  static glm::dvec3 ExtentMm() { return { 380.0, 260.0, 320.0 }; }

  /// @param edgeWidthMm  width of the transition between two tissues, > 0: about a voxel
  /// @param seed         of the random lung vessels
  TorsoPhantom(double edgeWidthMm, unsigned seed);

  /// Hounsfield units at `count` positions that start at `firstMm` and continue along +x.
  std::vector<double> Row(glm::dvec3 firstMm, double stepMm, int count) const;

private:
  void Paint(double hounsfield, const Shape& shape);
  void PaintTube(double hounsfield, const std::vector<glm::dvec3>& path, double radius);
  void PaintBody();
  void PaintLungVessels(double side, unsigned seed);
  void PaintAirways();
  void PaintHeartAndVessels();
  void PaintSpine();
  void PaintRibs(double side);

  std::vector<Solid> solids;
  double edgeWidthMm;
};

}

#endif
