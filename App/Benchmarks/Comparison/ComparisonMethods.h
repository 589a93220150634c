#ifndef Varimarch_Benchmarks_Comparison_ComparisonMethods_h
#define Varimarch_Benchmarks_Comparison_ComparisonMethods_h

#include "ComparisonProgram.h"
#include "ComparisonVolume.h"

#include <vtkNew.h>
#include <vtkTextureObject.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace varimarch
{

/// The proxy geometry that is drawn with the volume's look.
enum class Slices
{
  Object,   ///< across the axis of the grid that is nearest to the view, from a 3D texture
  Object2D, ///< the slices of the volume themselves, as 2D textures: three stacks of them
  View,     ///< parallel to the image
  Shells,   ///< spheres around the eye; parallel to the image in a parallel projection
};

/// Slice-based volume rendering: T. Gorkin, "Volume rendering using graphics hardware" (2009),
/// slides 14 to 26. A slice stands for the layer around it, of the same thickness wherever a ray
/// crosses it, as it does there; so slices across an axis of the volume look thinner from aside.
///
/// Draws into the bound image, whose blending is "over" for slices from the back to the front, and
/// "under" for slices from the front to the back.
void DrawSlices(const ComparisonFrame& frame, Slices slices, bool fromBehind);

/// The same with slices parallel to the image, whose colours are multiplied by the light at their
/// places.
/// @param light  parts of a light that arrive, at points from corner to corner of the volume's box
void DrawLitSlices(const ComparisonFrame& frame, vtkTextureObject* light, bool fromBehind);

/// Shadows from a volume of light that is made before the picture: T. Gorkin, "Volume rendering
/// using graphics hardware" (2009), slides 12 and 32, "Precomputed Light Transmissivity". A second
/// march leads from each point of a grid to a distant light; samples get what the grid says, by
/// trilinear interpolation. It depends on the volume, its look and the light, not on the view.
class LightVolumeMethod
{
public:
  /// Draws slices parallel to the image into the bound image, whose blending is "over" for slices
  /// from the back to the front, and "under" for the opposite order.
  /// @param mostPoints  points of the grid along the longest axis of the volume, >= 2; an axis has
  ///                    no more points than voxels
  void Draw(const ComparisonFrame& frame, int mostPoints, bool fromBehind);

  std::size_t Bytes() const; ///< texture of the light
  void Release(vtkWindow* window);

private:
  void Update(const ComparisonFrame& frame, int mostPoints);

  vtkNew<vtkTextureObject> light;
  glm::dvec3 builtFor = glm::dvec3(0.0); ///< direction towards the light
  int builtVersion = -1;                 ///< version of the volume; -1: there is no texture
  int builtMostPoints = 0;
};

/// Slices halfway between the view and a distant light, each drawn twice: for the eye, lit by what
/// the slices before it have let through, and for the light, whose buffer it dims. A blur of the
/// buffer from slice to slice scatters light forwards, as in a translucent material: T. Gorkin,
/// "Volume rendering using graphics hardware" (2009), slides 32 to 38, after J. Kniss and others,
/// GPU Gems (2004), chapter 39.
class HalfAngleMethod
{
public:
  /// Draws into `image`, which is bound afterwards.
  /// @param spreadDegrees  half the angle of the cone of scattered light, [0, 90); 0: shadows only
  void Draw(const ComparisonFrame& frame, ComparisonImage& image, double spreadDegrees);

  std::size_t Bytes() const; ///< both buffers of light
  void Release(vtkWindow* window);

private:
  /// Where the light shines, for one picture.
  struct Light
  {
    glm::dmat4 lightFromGrid; ///< to the square [-1, 1] that the light's buffer covers
    glm::vec2 blurTexture;    ///< radius of the blur between two slices [texture coordinates]
  };

  void DimLight(
    const ComparisonFrame& frame, const Light& light, const std::vector<glm::vec3>& slice);

  std::array<ComparisonImage, 2> buffers; ///< light before the present slice, and a copy to blur
  int present = 0;
};

/// The settings of a march in passes.
struct PassSettings
{
  int stepsPerPass;          ///< > 0
  double leastTransmittance; ///< a ray ends when less light than this passes, [0, 1)
  std::string shadow;        ///< file of the slot Shadow, which may have rays of its own
};

/// Ray marching in several passes: J. Krueger, R. Westermann, "Acceleration techniques for
/// GPU-based volume rendering" (IEEE Visualization 2003), as in T. Gorkin's slides 40 to 46. The
/// front faces of the box give the positions at which rays enter; the back faces turn these into a
/// texture of directions and lengths; each pass marches some steps. After each, the rays that have
/// left the volume or met enough opacity get a depth that the depth test rejects. The eye must be
/// outside the volume.
class PassMethod
{
public:
  /// Leaves the picture in `image`, which is bound afterwards.
  void Draw(const ComparisonFrame& frame, ComparisonImage& image, const PassSettings& settings);

  int Passes() const { return this->passes; } ///< passes of the last picture
  void Release(vtkWindow* window);

private:
  void SetUpRays(const ComparisonFrame& frame);
  void March(const ComparisonFrame& frame, const PassSettings& settings, int firstStep);
  void EndRays(const ComparisonFrame& frame, ComparisonImage& image, double marchedMm,
    double leastTransmittance);

  ComparisonImage fronts;
  ComparisonImage directions;
  ComparisonImage ended; ///< a colour without use, for the framebuffer that writes depths
  vtkNew<vtkTextureObject> depth;
  int passes = 0;
};

}

#endif
