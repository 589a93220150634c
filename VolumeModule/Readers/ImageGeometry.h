#ifndef Varimarch_Readers_ImageGeometry_h
#define Varimarch_Readers_ImageGeometry_h

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Positions of a file's voxels in DICOM's LPS space (x to the patient's left, y to the back, z to
/// the head) [mm]. The centre of voxel (i, j, k) is at originMm + axesMm * (i, j, k).
struct ImageGeometry
{
  glm::dvec3 originMm = glm::dvec3(0.0);
  /// Column a is the vector from a voxel to its neighbour along axis a. The columns need not be
  /// orthogonal (a tilted gantry shears them) nor right-handed.
  glm::dmat3 axesMm = glm::dmat3(1.0);
};

/// The signs for InLps of a geometry in RAS space (x to the right, y to the front, z to the head).
constexpr glm::dvec3 LpsFromRas(-1.0, -1.0, 1.0);

/// Converts a geometry to LPS space.
/// @param signs  -1 for each axis of the file's space that points the other way, such as (-1,-1,1)
/// for RAS
/// @param mmPerUnit  length of the file's unit [mm]
ImageGeometry InLps(const ImageGeometry& geometry, const glm::dvec3& signs, double mmPerUnit);

/// Sets the origin, spacing (> 0) and direction matrix of an image. Voxels stay where they are in
/// memory; a mirrored axis becomes a negative direction.
/// @param path  path for the error message
/// @throws std::runtime_error if a number is not finite, or the axes are linearly dependent
void PlaceImage(const std::string& path, const ImageGeometry& geometry, vtkImageData* image);

/// Geometry of a stack of pictures: x runs to the right of the first, y down, z through the stack.
/// Adds warnings about what the files do not say.
/// @param spacingMm  distances of voxels along x, y and z; 0 if unknown
/// @param orientation  TIFF's tag Orientation, 1 to 8: where the first row and column are
ImageGeometry StackGeometry(
  const std::array<double, 3>& spacingMm, int orientation, std::vector<std::string>& warnings);

}

#endif
