#ifndef Varimarch_Scene_ImageOrientation_h
#define Varimarch_Scene_ImageOrientation_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

class vtkTransform;

namespace varimarch
{

/// What VTK's own mappers need, so that they draw the same picture as ours.

/// The image with its slices in such an order that its axes are right-handed: itself, or a copy.
/// VTK's GPU mapper culls the front of a mirrored image instead of its back.
vtkSmartPointer<vtkImageData> RightHanded(vtkImageData* image);

/// The image with its axes along the world's, and the turn that brings it back to its place. VTK's
/// CPU mapper ignores the direction of an image, and its GPU mapper forgets it when it lights the
/// volume; both heed the matrix of the volume.
vtkSmartPointer<vtkImageData> WithoutDirection(vtkImageData* image, vtkTransform* worldFromImage);

}

#endif
