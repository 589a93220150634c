#ifndef Varimarch_Scene_ReferenceRequest_h
#define Varimarch_Scene_ReferenceRequest_h

#include "Core/Geometry/Box.h"
#include "Core/Reference/ReferenceIntegrator.h"
#include "Frame/VolumeGeometry.h"
#include "Scene/Model/Scene.h"
#include "Scene/Reference/ReferencePicture.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <functional>
#include <optional>
#include <vector>

class vtkCamera;

namespace varimarch
{

/// The cuts of a reference image.
struct ReferenceCuts
{
  std::vector<glm::dvec4> planesGrid; ///< keep what lies on their positive sides
  vtkSmartPointer<vtkImageData> mask; ///< the mask of scissors, see SceneCuts.h; null without

  bool IsEmpty() const { return this->planesGrid.empty() && !this->mask; }

  /// The parts of a ray that the cuts leave, front to back, for ReferenceScene::uncutParts.
  /// @param dimensions  the number of the volume's voxels along each axis
  std::vector<Interval> PartsOf(const Ray& rayGrid, Interval inside, glm::ivec3 dimensions) const;
};

/// A light of a scene in world space.
struct PlacedLight
{
  LightKind kind;
  glm::dvec3 rgb;   ///< times the intensity
  glm::dvec3 place; ///< positional: its position [mm]; else the unit vector towards it. Head: none
  double softnessDegrees; ///< half the angle of its cone; 0: it is a point
};

/// A point of a volume that light falls on, in world space.
struct LitPoint
{
  glm::dvec3 rgb; ///< colour by the transfer function
  glm::dvec3 positionMm;
  glm::dvec3 normal;    ///< unit vector to the falling values; 0 where there is no gradient
  glm::dvec3 toEye;     ///< unit vector
  double gradientPerMm; ///< magnitude [units of the data per mm]
};

/// The part of a light that reaches a point [0, 1].
/// @param towards  unit vector to the light, world space
/// @param farMm    distance of the light; infinite for far lights
using LightReaching = std::function<double(glm::dvec3 towards, double farMm)>;

/// The light of a scene, for the reference: the model of Blinn, "Models of light reflection for
/// computer synthesized pictures" (SIGGRAPH 1977), in double precision and without any formula of
/// the mapper.
struct ReferenceLighting
{
  Shading shading;
  double dampingGradient; ///< see Look [units of the data per mm]
  std::vector<PlacedLight> lights;
  bool lightsBacks;  ///< true if both sides of a surface are lit
  bool castsShadows; ///< true if the volume dims lights that are not at the eye
  /// The part of that which surfaces lack, [0, 1]; the light that matter scatters lacks all of it.
  double surfacesInShadow;
  double reachMm; ///< distance beyond which it does not dim
  /// The part of the light that matter scatters, [0, 1]; surfaces reflect the rest.
  double scatteredPart;
  double anisotropy; ///< see HenyeyGreenstein

  /// True for one white light at the eye without damping.
  bool IsPlainHeadLight() const;

  /// The colour that a point shows to the eye.
  /// @param reaching  asked for lights that are not at the eye; without it, all light arrives
  glm::dvec3 Lit(const LitPoint& point, const LightReaching& reaching = {}) const;
};

/// @param look  the scene's look in units of the data
ReferenceLighting ReferenceLightingOf(
  const Scene& scene, const Look& look, vtkCamera* camera, const VolumeGeometry& geometry);

/// Everything that a reference image depends on, and nothing else. Values are in units of the data.
struct ReferenceRequest
{
  vtkSmartPointer<vtkDataArray> scalars;
  VolumeGeometry geometry;
  double meanSpacingMm;
  double largestGradientPerMm; ///< see LargestRegionGradient
  Interpolation interpolation; ///< linear except in composites
  TransferFunction transferFunction;
  std::vector<OpacityNode> gradientOpacities; ///< see Look; empty except in composites
  std::vector<LookRegion> regions;            ///< see Look; empty except in composites
  std::optional<ReferenceLighting> lighting;  ///< empty: unshaded
  Occlusion occlusion;                        ///< with its reach; off except in composites
  Blend blend;
  std::vector<double> isovalues;
  std::optional<ValueRange> averagedRange; ///< empty: all values
  ReferenceCuts cuts;
  ReferenceView view;
  double tolerance;
};

/// @throws std::invalid_argument for a volume without scalars or with several components, and for
///         the parts of scenes that the reference does not draw: labels, a first distance, and
///         nearest or cubic interpolation except in composites
ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance);

/// The integrator that draws a request, which must outlive it.
ReferenceIntegrator IntegratorOf(const ReferenceRequest& request);

/// The image as VTK's data; nothing if there is none.
std::optional<ReferencePicture> PictureOf(const std::optional<ReferenceImage>& drawn);

/// @return nothing if `progress` cancelled
std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress);

}

#endif
