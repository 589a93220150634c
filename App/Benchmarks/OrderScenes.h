#ifndef Varimarch_Benchmarks_OrderScenes_h
#define Varimarch_Benchmarks_OrderScenes_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// A scene of a ramp or a checkerboard, without early termination and field, so that nothing but
/// the steps makes errors.
Scene OrderScene(ProceduralKind kind, int side);

/// The same of the smooth field.
Scene SmoothScene(int side);

/// The field of the refinement of grids: smooth, from 0 to 255, in a cube of 100 mm at the world's
/// origin.
double SmoothField(const glm::dvec3& positionMm);

/// Samples of the smooth field, as floats.
/// @param side  number of voxels along each axis
vtkSmartPointer<vtkImageData> SmoothVolume(int side);

/// The image of the smooth field itself, as if of infinitely many voxels.
/// @param image  any of its volumes, which tells the rays
vtkSmartPointer<vtkImageData> SmoothTruth(const Scene& scene, vtkImageData* image);

}

#endif
