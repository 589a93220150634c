#ifndef Varimarch_Scene_Scissors_h
#define Varimarch_Scene_Scissors_h

#include "Scene/Scene.h"

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <vector>

class vtkImageData;

namespace varimarch
{

/// Binary mask for a mapper: 1 where the volume stays, 0 where a cut removes it. It covers the
/// volume's box at the volume's resolution, or coarser by a whole factor beyond about 16 million
/// voxels. Null without cuts and a body.
/// @param body  the part that stays before the cuts, see BodyMask.h; null for all
vtkSmartPointer<vtkImageData> MaskOf(
  const std::vector<ScissorsCut>& cuts, vtkImageData* image, vtkImageData* body = nullptr);

/// True if a mask keeps a point of the volume. A null mask keeps everything.
/// @param index  continuous index of the point, within the image
bool Keeps(vtkImageData* mask, vtkImageData* image, const glm::dvec3& index);

/// The mask of what two masks of an image keep, on the grid of the first; the other mask if one is
/// null.
vtkSmartPointer<vtkImageData> Both(vtkImageData* fine, vtkImageData* other, vtkImageData* image);

/// A copy of a volume whose voxels have the smallest value wherever a mask keeps nothing.
vtkSmartPointer<vtkImageData> WithoutRemoved(vtkImageData* image, vtkImageData* mask);

bool operator==(const ScissorsCut& a, const ScissorsCut& b);

}

#endif
