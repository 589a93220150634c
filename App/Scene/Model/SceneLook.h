#ifndef Varimarch_Scene_SceneLook_h
#define Varimarch_Scene_SceneLook_h

#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/RenderSettings.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Meaning of the values of a look's nodes.
enum class Domain
{
  Data,       ///< units of the data
  Relative,   ///< 0 is the data's 1st percentile, 1 its 99.9th: for MR, which has no units
  Hounsfield, ///< Hounsfield units, also for a CT whose values are others: see HounsfieldScale
};

/// Meaning of the lengths of a look: its unit distance, and those in its gradients.
enum class Lengths
{
  Millimetres,
  Relative, ///< right for a patient; in other volumes as long in proportion, see LengthFactor
};

/// Blinn-Phong coefficients, as vtkVolumeProperty has them.
struct Shading
{
  bool enabled = true;
  double ambient = 0.2;        ///< [0, 1]
  double diffuse = 0.8;        ///< [0, 1]
  double specular = 0.2;       ///< [0, 1]
  double specularPower = 16.0; ///< >= 1
};

/// A surface of equal value, for Blend::Isosurface.
struct Isosurface
{
  double value;
  glm::dvec3 rgb;       ///< [0, 1]
  double opacity = 1.0; ///< opacity of the surface, however thick the material behind it, [0, 1]
};

enum class RegionShape
{
  Rectangle,
  Ellipse, ///< that touches the sides of the rectangle
};

/// A part of the plane of value and gradient magnitude that has a colour and an opacity.
struct LookRegion
{
  RegionShape shape = RegionShape::Rectangle;
  std::array<double, 2> values;    ///< first and last value, ascending [units of the look]
  std::array<double, 2> gradients; ///< ascending, >= 0 [units of the look's values per mm]
  glm::dvec3 rgb;                  ///< [0, 1]
  double opacity = 0.5;            ///< over the look's unit distance, [0, 1]
  double softness = 0.25; ///< part of the way from the edge to the middle that fades, [0, 1]
};

/// A component of a volume with several that are independent of each other.
struct LookChannel
{
  std::string name = {};              ///< may be empty
  std::optional<glm::dvec3> rgb = {}; ///< its only colour, [0, 1]; empty: the colours of the look
  bool visible = true;
  double opacity = 1.0; ///< factor of the opacities of the look, [0, 1]
  /// Values that look as the first and the last value of the look's opacities do; the values
  /// between are stretched. Empty: the look's own.
  std::optional<std::array<double, 2>> window = {};
};

/// Components of a voxel are at most these.
constexpr std::size_t MostChannels = 4;

/// Transfer function and light: the appearance of the values.
struct Look
{
  std::string name;        ///< name of the preset it came from; may be empty
  std::string description; ///< one line of text; may be empty
  Domain domain = Domain::Data;
  std::vector<ColorNode> colors;      ///< sorted by value, at least one
  std::vector<OpacityNode> opacities; ///< sorted by value, at least one
  Lengths lengths = Lengths::Millimetres;
  double opacityUnitDistanceMm = 1.0; ///< > 0
  /// Opacity factors by gradient magnitude [units of the value per mm], sorted by it, for
  /// composites. Empty: the gradient does not affect the opacity.
  std::vector<OpacityNode> gradientOpacities;
  /// The components of a volume with several, in their order; further ones look as one without
  /// settings. Empty: InUnitsOfData makes them.
  std::vector<LookChannel> channels;
  /// Regions that replace colours, opacities and opacity factors in composites of one component;
  /// later ones lie over earlier ones. Empty: the curves count.
  std::vector<LookRegion> regions;
  Shading shading;
  /// Gradient magnitude below which diffuse and specular light are reduced in proportion [units of
  /// the value per mm], >= 0; 0 reduces none. See vtkVariationFieldVolumeMapper::DampingGradient.
  double dampingGradient = 0.0;
  Blend blend = Blend::Composite;
  std::vector<Isosurface> isosurfaces; ///< sorted by value; at least one for Blend::Isosurface
  /// First and last value that count in an average. Empty: all values.
  std::optional<std::array<double, 2>> averagedRange;
};

}

#endif
