#ifndef Varimarch_Core_Reference_MaterialIntegral_h
#define Varimarch_Core_Reference_MaterialIntegral_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// The volume rendering integral of any material: of the scene only its box and its material count.
///
/// The ray is cut at the faces of cells and half way between, where labels of voxels change; the
/// pieces are bisected until the quadrature finds each smooth enough. So it needs no knowledge of
/// where a material has kinks, and takes its time.
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
