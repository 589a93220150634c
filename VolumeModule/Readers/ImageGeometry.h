#ifndef Varimarch_Readers_ImageGeometry_h
#define Varimarch_Readers_ImageGeometry_h

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <string>

class vtkImageData;

namespace varimarch
{

/// Where the voxels of a file lie in LPS space (DICOM's: x to the patient's left, y to the back,
/// z to the head) [mm]: voxel (i,j,k) has its centre at originMm + axesMm * (i,j,k).
struct ImageGeometry
{
  glm::dvec3 originMm = glm::dvec3(0.0);
  /// Column a is the way from a voxel to its neighbour along axis a. The columns need be neither
  /// orthogonal (a tilted gantry shears them) nor right-handed.
  glm::dmat3 axesMm = glm::dmat3(1.0);
};

/// The geometry of a file in LPS space.
/// @param signs  -1 for each axis of the file's space that points the other way: (-1,-1,1) for RAS
/// @param mmPerUnit  of the file's space
ImageGeometry InLps(const ImageGeometry& geometry, const glm::dvec3& signs, double mmPerUnit);

/// Gives the image the origin, spacing (> 0) and direction matrix of a geometry. Voxels stay where
/// they are in memory: a mirrored axis is a negative direction.
/// @param path  for the error message
/// @throws std::runtime_error when a number is not finite, or the axes do not span space
void PlaceImage(const std::string& path, const ImageGeometry& geometry, vtkImageData* image);

}

#endif
