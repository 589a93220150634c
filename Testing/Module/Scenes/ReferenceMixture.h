#ifndef Varimarch_Testing_ReferenceMixture_h
#define Varimarch_Testing_ReferenceMixture_h

#include "Core/Geometry/ScalarGrid.h"
#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/MapperScene.h"

#include <vector>

/// The material of a composite whose look depends on more than one value, written from VTK's
/// definitions: components, independent or not, gradient opacity and a head light.
class ReferenceMixture
{
public:
  explicit ReferenceMixture(MapperScene& scene);

  varimarch::OpticalProperties At(glm::dvec3 positionGrid, const varimarch::Ray& rayGrid) const;

private:
  struct Component
  {
    std::vector<double> voxels;
    varimarch::TransferFunction function;
    double range; ///< the width of the range of its voxels
  };
  struct Sample
  {
    double value;
    glm::dvec3 gradient; ///< per voxel
  };

  Sample SampleAt(int component, glm::dvec3 positionGrid) const;
  double ExtinctionOf(int component, const Sample& sample) const;
  glm::dvec3 Lit(
    int component, glm::dvec3 rgb, glm::dvec3 gradient, const varimarch::Ray& rayGrid) const;
  varimarch::OpticalProperties OfDependent(glm::dvec3 positionGrid) const;

  vtkVolumeProperty* property;
  varimarch::VolumeGeometry geometry;
  std::vector<Component> components;
  double largestColor; ///< the number that is full red, green or blue
  bool isNearest;
};

#endif
