#ifndef Varimarch_Scene_ImageOrientation_h
#define Varimarch_Scene_ImageOrientation_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

class vtkTransform;

namespace varimarch
{

/// Workarounds for VTK's own mappers, so that they render the same image as ours.

/// Returns the volume with its slice order reversed if its axes are left-handed, and the volume
/// itself otherwise. VTK's GPU mapper culls the front faces of a mirrored volume instead of its
/// back faces.
vtkSmartPointer<vtkImageData> RightHanded(vtkImageData* image);

/// Returns the volume without its direction matrix, and that matrix as a transform for the
/// vtkVolume. VTK's CPU mapper ignores the direction of an image, and its GPU mapper forgets it in
/// the lighting; both respect the matrix of the vtkVolume.
vtkSmartPointer<vtkImageData> WithoutDirection(vtkImageData* image, vtkTransform* worldFromImage);

}

#endif
