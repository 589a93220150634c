#ifndef Varimarch_Readers_Dicom_DicomStack_h
#define Varimarch_Readers_Dicom_DicomStack_h

#include "Readers/Dicom/Grouping.h"
#include "Readers/ImageGeometry.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// Arrangement of the slices of a series: their positions, tilt and distances. The volume itself
/// always has even distances: the usual one of the slices.
class DicomStack
{
public:
  /// @param slices  at least one; must outlive this object
  explicit DicomStack(const DicomSlices& slices);

  /// Geometry of the volume with even distances.
  const ImageGeometry& Geometry() const { return this->geometry; }

  /// Positions of the first voxels of the slices [mm] if the slices were tilted, are unevenly
  /// spaced, or do not lie on a straight line; otherwise empty.
  std::vector<glm::dvec3> IrregularSlicesMm() const;

  /// True if slices are drawn elsewhere than they were scanned, and no gap is so large that
  /// interpolation would make up what lies in it.
  bool IsMisplaced() const;

  /// Warns of unknown sides and sizes, gantry tilt, missing slices and uneven distances.
  /// @param isRectified  true if the volume is resampled, which corrects tilt and distances
  void Warn(bool isRectified, std::vector<std::string>& warnings) const;

private:
  bool IsTilted() const;
  bool IsUneven() const;
  bool IsCrooked() const;
  void MeasureDistances();
  void PlaceSlices();
  void WarnOfMissingSlices(std::vector<std::string>& warnings) const;
  std::string UnevenDistances() const;
  /// A text such as "a.dcm" and "b.dcm".
  std::string NamesOfGap(std::size_t gap) const;

  const DicomSlices& slices;
  ImageGeometry geometry;
  glm::dvec3 normal = glm::dvec3(0.0, 0.0, 1.0);
  std::vector<glm::dvec3> positionsMm;
  std::vector<double> gapsMm; ///< distances of consecutive slices along the normal
  double drawnMm = 1.0;       ///< distance between the volume's slices along the normal
  double tiltDegrees = 0.0;
  double crookedMm = 0.0; ///< largest distance of a slice from its place along a straight line
};

}

#endif
