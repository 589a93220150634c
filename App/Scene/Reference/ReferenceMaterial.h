#ifndef Varimarch_Scene_ReferenceMaterial_h
#define Varimarch_Scene_ReferenceMaterial_h

#include "Core/Reference/LightTransmittance.h"
#include "Core/Reference/ReferenceScene.h"
#include "Scene/Reference/ReferenceRequest.h"

#include <functional>
#include <memory>

namespace varimarch
{

/// The values and the light of a reference image at any point, for the parts of scenes that
/// ReferenceIntegrator has no closed form for. The request must outlive it.
class ReferenceMaterial
{
public:
  /// @param transmittance  of the volume, for shadows and ambient occlusion; null without them
  /// @throws std::invalid_argument for cubic interpolation of voxels that are not finite
  explicit ReferenceMaterial(const ReferenceRequest& request,
    std::shared_ptr<const LightTransmittance> transmittance = nullptr);

  /// The light on values between which interpolation is linear, for ReferenceScene::shade.
  PieceLight LightAlong(const CellPart& part, const Ray& rayGrid) const;

  /// The optical properties of a point, for ReferenceScene::material: by its value, or by value and
  /// gradient if the look has opacities by gradient or regions.
  OpticalProperties At(glm::dvec3 positionGrid, const Ray& rayGrid) const;

private:
  double GradientPerMm(glm::dvec3 gradient) const;
  OpticalProperties Unlit(double value, double gradientPerMm) const;
  glm::dvec3 Emitted(
    glm::dvec3 rgb, glm::dvec3 gradient, glm::dvec3 positionGrid, const Ray& rayGrid) const;
  glm::dvec3 Lit(
    glm::dvec3 rgb, glm::dvec3 gradient, glm::dvec3 positionGrid, const Ray& rayGrid) const;
  double KeptAt(glm::dvec3 gradient, glm::dvec3 positionGrid) const;
  glm::dvec3 MiddleOf(glm::dvec3 positionGrid) const;

  const ReferenceRequest& request;
  std::shared_ptr<const LightTransmittance> transmittance;
  TransferFunction gradientOpacity; ///< over gradient magnitudes [units of the data per mm]
  std::function<double(glm::dvec3 positionGrid)> value;
  std::function<glm::dvec3(glm::dvec3 positionGrid)> gradient; ///< [per voxel]
};

}

#endif
