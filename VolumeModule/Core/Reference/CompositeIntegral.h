#ifndef Varimarch_Core_Reference_CompositeIntegral_h
#define Varimarch_Core_Reference_CompositeIntegral_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// The volume rendering integral of emission and absorption.
///
/// The ray is divided at all cell faces and, inside a cell, wherever its cubic crosses a node of
/// the transfer function. The pieces are smooth and are integrated adaptively (SlabQuadrature);
/// invisible, constant and opaque pieces are exact. See Documentation/Mathematics.md.
class CompositeIntegral : public RayIntegral
{
public:
  CompositeIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  class Cells;

  ReferenceScene scene;
  double tolerance;
  TransferBands bands;
  SlabQuadrature quadrature;
};

}

#endif
