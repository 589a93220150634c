#ifndef Varimarch_Core_Reference_MaterialIntegral_h
#define Varimarch_Core_Reference_MaterialIntegral_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// The volume rendering integral of any material. Uses only the scene's box and its material.
///
/// The ray is divided at the faces of cells and halfway between, where labels of voxels change.
/// Pieces are bisected until the quadrature finds them smooth enough. This needs no knowledge of a
/// material's kinks, but is slow.
class MaterialIntegral : public RayIntegral
{
public:
  MaterialIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene;
  double tolerance;
  SlabQuadrature quadrature;
};

}

#endif
