#ifndef Varimarch_Promise_JudgeLook_h
#define Varimarch_Promise_JudgeLook_h

#include <glm/vec3.hpp>

#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

class vtkPiecewiseFunction;
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

}

#endif
