#ifndef Varimarch_Promise_JudgeScene_h
#define Varimarch_Promise_JudgeScene_h

#include <vtkSmartPointer.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <functional>
#include <limits>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;
class vtkVolumeProperty;

namespace varimarch
{

/// The functions of VTK that give a value its colour and opacity.
struct JudgeFunctions
{
  vtkSmartPointer<vtkPiecewiseFunction> opacity;
  vtkSmartPointer<vtkPiecewiseFunction> gradientOpacity; ///< null: does not matter
  std::function<glm::dvec3(double)> color;
  std::vector<double> colorNodes; ///< sorted values where the colour bends or jumps
  double unitDistanceMm;
};

/// The functions of a component.
JudgeFunctions FunctionsOf(vtkVolumeProperty* property, int component);

/// The functions of a label; those without a label stand in for missing ones.
JudgeFunctions LabelFunctionsOf(vtkVolumeProperty* property, int label);

/// The look of a value, for the judge. All numbers are asked of VTK's functions. They are cut at
/// their nodes into bands, and where a function turns out to be straight in a band, its ends are
/// kept, so that not every sample has to search VTK's nodes.
class JudgeLook
{
public:
  explicit JudgeLook(JudgeFunctions functions);

  /// The values between two neighbouring nodes.
  struct Band
  {
    double lower;
    double upper;
    bool opacityIsStraight;
    bool colorIsStraight;
    double opacities[2]; ///< limits at both ends
    glm::dvec3 colors[2];
    bool isInvisible;
  };

  const Band& operator[](int band) const { return this->bands[std::size_t(band)]; }
  int BandOf(double value) const; ///< that above, for a node
  bool MayBeVisible(double lower, double upper) const;

  /// Opacity over the unit distance, [0, 1], and colour of a value within a band.
  double Opacity(const Band& band, double value) const;
  glm::dvec3 Color(const Band& band, double value) const;

  /// The factor by which a gradient changes the opacity; 1 if it does not matter.
  double GradientFactor(double magnitude) const;
  bool HasGradientOpacity() const { return this->functions.gradientOpacity != nullptr; }
  const std::vector<double>& GradientNodes() const { return this->gradientNodes; }

  /// The extinction of an opacity over the unit distance [1/mm].
  double Extinction(double opacity, double mostPerMm) const;

private:
  Band BandBetween(double lower, double upper) const;

  JudgeFunctions functions;
  std::vector<double> nodes; ///< bands.size() - 1
  std::vector<Band> bands;
  std::vector<double> gradientNodes;
};

/// A ray of the world; t is in mm.
struct JudgeRay
{
  glm::dvec3 origin;
  glm::dvec3 direction; ///< unit vector
  glm::dvec3 At(double t) const { return this->origin + t * this->direction; }
};

/// A polynomial of third degree over u in [0, 1].
using JudgeCubic = std::array<double, 4>;

inline double ValueOf(const JudgeCubic& cubic, double u)
{
  return ((cubic[3] * u + cubic[2]) * u + cubic[1]) * u + cubic[0];
}

/// The part of a ray within one cell, and within one label.
struct JudgeSpan
{
  double enter; ///< [mm]
  double exit;
  glm::ivec3 cell;
  int look;
  JudgeCubic value;
  std::array<JudgeCubic, 3> gradient; ///< per voxel, in the grid; only if the volume needs it

  double PartOf(double t) const { return (t - this->enter) / (this->exit - this->enter); }
  double PlaceOf(double u) const { return this->enter + u * (this->exit - this->enter); }
};

/// The part of a span within one band of the look, over [from, to] of the span's u.
struct JudgePiece
{
  double from;
  double to;
  const JudgeLook::Band* band;
};

/// One component of a volume as the judge sees it: numbers in double precision, in the grid whose
/// whole numbers are voxels. It shares no code with the mapper.
struct JudgeVolume
{
  glm::ivec3 size;
  std::vector<double> voxels;
  double leastValue;                 ///< smallest of the voxels
  double mostValue;                  ///< largest of them
  std::vector<glm::dvec3> gradients; ///< central differences per voxel; empty if not needed
  bool isNearest;
  glm::dmat4 worldFromGrid;
  glm::dmat4 gridFromWorld;
  glm::dvec3 boxLower; ///< [grid]
  glm::dvec3 boxUpper;
  glm::dvec3 magnitudeFactors; ///< by which the parts of a gradient give VTK's magnitude
  double smallestSpacingMm;
  double diagonalMm;
  double unitDistanceMm; ///< unit distance without a label
  double mostExtinction; ///< an extinction that is as good as opaque [1/mm]

  std::vector<JudgeLook> looks; ///< that of no label first
  std::vector<int> lookOfVoxel; ///< -1: not drawn; empty: no mask
  std::vector<char> cellIsVisible;

  bool isShaded;
  double ambient;
  double diffuse;
  double specular;
  double specularPower;

  std::vector<glm::dvec4> clippingPlanes; ///< planes of the world; drawn where not negative
  bool isCropped;
  std::array<double, 6> croppingPlanes; ///< in the data's coordinates
  int croppingFlags;
  glm::dmat4 dataFromGrid;

  /// Fills what follows from the rest.
  void Prepare(bool needsGradients);

  /// Calls visit(span) for the spans of a ray between two places that may be visible, front to
  /// back, until it returns false.
  void WalkVisible(const JudgeRay& ray, double from, double to,
    const std::function<bool(const JudgeSpan&)>& visit) const;

  /// The same for all spans, visible or not, within the cuts.
  void WalkAll(const JudgeRay& ray, double from, double to,
    const std::function<bool(const JudgeSpan&)>& visit) const;

  /// The pieces of a span that may be visible, in order.
  void FindPieces(const JudgeSpan& span, std::vector<JudgePiece>& pieces) const;

  double ExtinctionAt(const JudgeSpan& span, const JudgeLook::Band& band, double u) const;
  glm::dvec3 GradientAt(const JudgeSpan& span, double u) const;
  double MagnitudeOf(glm::dvec3 gradient) const; ///< as VTK counts it

  /// The parts of a ray that are in the box and that cuts leave.
  std::vector<std::array<double, 2>> PartsLeft(const JudgeRay& ray, double from, double to) const;

private:
  double Voxel(glm::ivec3 index) const;
  glm::dvec3 Gradient(glm::ivec3 index) const;
  std::size_t IndexOf(glm::ivec3 index) const;
  bool MayBeVisible(glm::ivec3 cell) const;
  bool IsLeft(glm::dvec3 world) const;
  std::array<double, 2> PartInBox(const JudgeRay& rayGrid, double from, double to) const;
  void Walk(const JudgeRay& ray, double from, double to, bool onlyVisible,
    const std::function<bool(const JudgeSpan&)>& visit) const;
  bool WalkCells(const JudgeRay& ray, std::array<double, 2> part, bool onlyVisible,
    const std::function<bool(const JudgeSpan&)>& visit) const;
  bool VisitCell(const JudgeRay& rayGrid, glm::ivec3 cell, std::array<double, 2> part,
    const std::function<bool(const JudgeSpan&)>& visit) const;
  void Fill(const JudgeRay& rayGrid, JudgeSpan& span) const;
};

/// The place in [from, to] at which a polynomial that is monotone there has a value.
double JudgeCrossing(const JudgeCubic& cubic, double value, double from, double to);

/// The ends of the parts of [0, 1] in which a polynomial is monotone, in order.
std::vector<double> JudgeTurns(const JudgeCubic& cubic);

/// A light that is on.
struct JudgeLamp
{
  bool isAtEye; ///< a distant head light: it casts no shadow
  bool isNear;  ///< it has a position, else only a direction
  glm::dvec3 position;
  glm::dvec3 shinesAlong; ///< unit vector
  glm::dvec3 diffuse;
  glm::dvec3 specular;
  glm::dvec3 attenuation; ///< constant, per mm, per mm^2
  double coneDegrees;
  double exponent;
  double softnessDegrees;
};

using JudgeTriangle = std::array<glm::dvec3, 3>;

/// Everything that a picture shows, in plain numbers.
struct JudgeScene
{
  std::vector<JudgeVolume> volumes; ///< at least one
  int blendMode;                    ///< as in vtkVolumeMapper
  double errorTolerance;

  std::vector<JudgeLamp> lamps;
  glm::dvec3 ambientLight;
  bool isTwoSided;
  bool hasShadows;
  double shadowStrength;
  double scatteredPart; ///< [0, 1]
  double anisotropy;
  double scatterReachMm; ///< reach of light that is scattered, without shadows
  double occlusion;
  double occlusionReachMm;

  std::vector<JudgeTriangle> seen;    ///< opaque geometry
  std::vector<JudgeTriangle> casting; ///< the part of it that casts shadows

  std::vector<double> isovalues; ///< sorted
  double averagedRange[2];
  double grayRange[2];

  glm::dmat4 worldFromClip;
  bool isParallel;
  int width; ///< [pixels]
  int height;

  bool IsLit() const { return this->hasShadows || this->occlusion > 0.0 || this->Scatters(); }
  bool Scatters() const { return this->scatteredPart > 0.0; }
};

/// The objects of VTK that make a picture.
struct JudgedObjects
{
  vtkRenderer* renderer;
  vtkVariationFieldVolumeMapper* mapper; ///< the settings of light, cuts and blending
  std::vector<vtkImageData*> images;
  std::vector<vtkVolume*> volumes; ///< one for each image
  std::vector<vtkActor*> actors;   ///< opaque geometry
};

/// Reads the scene of the last Render by VTK's own interface. Images have one component of point
/// data.
JudgeScene ReadJudgeScene(const JudgedObjects& objects);

}

#endif
