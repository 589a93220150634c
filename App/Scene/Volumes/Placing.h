#ifndef Varimarch_Scene_Placing_h
#define Varimarch_Scene_Placing_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/mat4x4.hpp>

#include <vector>

namespace varimarch
{

/// A volume over the first one.
struct PlacedVolume
{
  int number; ///< 2 for the first overlay, as the window counts volumes
  const LoadedVolume& volume;
  vtkSmartPointer<vtkImageData> image; ///< at its place
};

/// The rigid motion of a placement: where a point of the volume's patient coordinates is put. World
/// space, LPS.
glm::dmat4 WorldFromPatient(const Placement& placement, vtkImageData* image);

/// Measurements of the world in the patient coordinates of a volume that was put at another place.
std::vector<Measure> InPatientCoordinates(
  std::vector<Measure> measures, const Placement& placement, vtkImageData* image);

/// True if the axes of two images have the same directions, but for the rounding of files.
bool AreTurnedAlike(vtkImageData* first, vtkImageData* second);

/// The placement with this motion. Requires a rotation and a translation.
Placement PlacementOf(const glm::dmat4& worldFromPatient, vtkImageData* image);

/// The same voxels where a placement puts them. The scalars are shared.
vtkSmartPointer<vtkImageData> Placed(vtkImageData* image, const Placement& placement);

class ImageStatistics;

/// Whether two volumes are in the same space, by the frames of reference of their files.
enum class CommonSpace
{
  Same,
  Different,
  Unknown, ///< a file does not say
};

CommonSpace SpaceOf(const LoadedVolume& first, const LoadedVolume& other);

/// A volume to draw over another, with the look that suits it: PET is hot in 3D and in slices, and
/// other volumes have the composite that resembles their suggested preset.
OverlaidVolume OverlayOf(
  const VolumeSource& source, const LoadedVolume& volume, const ImageStatistics& statistics);

}

#endif
