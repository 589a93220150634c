#ifndef Varimarch_Testing_CasterTruth_h
#define Varimarch_Testing_CasterTruth_h

#include "Module/Scenes/ReferenceMaterials.h"

#include <vector>

class vtkActor;

/// The volume in the renderer's lights, in its own shadows and in those of actors. All their
/// triangles are tested one by one in double precision.
/// @param tolerance  of the light that the volume lets through
MapperScene::Material MaterialInShadowsOf(
  MapperScene& scene, const std::vector<vtkActor*>& actors, double tolerance);

#endif
