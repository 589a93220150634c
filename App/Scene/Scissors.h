#ifndef Varimarch_Scene_Scissors_h
#define Varimarch_Scene_Scissors_h

#include "Scene/Scene.h"

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <vector>

class vtkImageData;

namespace varimarch
{

/// For a mapper's binary mask: 1 where all of the cuts leave the volume, 0 where one takes it away.
/// Over the same box as the volume; of its resolution up to some 16 million voxels, else coarser by
/// a whole number. None without cuts.
vtkSmartPointer<vtkImageData> MaskOf(const std::vector<ScissorsCut>& cuts, vtkImageData* image);

/// Whether a mask leaves a point of the volume. No mask leaves all.
/// @param index  of the point in the image, which it is within
bool Leaves(vtkImageData* mask, vtkImageData* image, const glm::dvec3& index);

bool operator==(const ScissorsCut& a, const ScissorsCut& b);

}

#endif
