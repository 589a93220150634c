#ifndef Varimarch_Readers_DicomStack_h
#define Varimarch_Readers_DicomStack_h

#include "Readers/ImageGeometry.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkDICOMReader;

namespace varimarch
{

/// Arrangement of the slices of a series: their tilt and their distances. The volume itself always
/// has even distances.
class DicomStack
{
public:
  /// @param reader  a reader that has sorted its slices
  /// @param geometry  geometry of the volume
  DicomStack(vtkDICOMReader* reader, const ImageGeometry& geometry);

  /// Positions of the first voxels of the slices [mm] if the slices were tilted or are unevenly
  /// spaced; otherwise empty.
  std::vector<glm::dvec3> IrregularSlicesMm() const;

  /// Warns of gantry tilt, missing slices and uneven distances.
  /// @param isRectified  true if the volume is resampled, which corrects tilt and distances
  void Warn(bool isRectified, std::vector<std::string>& warnings) const;

private:
  /// Distance from a slice to the next along their normal.
  struct Gap
  {
    double widthMm;
    std::string between; ///< such as "a.dcm" and "b.dcm"
  };

  bool IsTilted() const;
  bool IsUneven() const;
  void WarnOfMissingSlices(std::vector<std::string>& warnings) const;
  std::string UnevenDistances() const;

  bool isPlaced; ///< true if the files state the positions of the slices
  double tiltDegrees = 0.0;
  double drawnMm = 0.0; ///< distance between the volume's slices
  std::vector<glm::dvec3> positionsMm;
  std::vector<Gap> gaps; ///< gaps between consecutive slices
  double narrowestMm = 0.0;
  double widestMm = 0.0;
};

}

#endif
