#ifndef Varimarch_Readers_DicomStack_h
#define Varimarch_Readers_DicomStack_h

#include "Readers/ImageGeometry.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkDICOMReader;

namespace varimarch
{

/// How the slices of a series lie: whether right above each other, and at which distances. A volume
/// has its slices at even distances, whatever the series has.
class DicomStack
{
public:
  /// @param reader    that has put its slices in order
  /// @param geometry  of the volume
  DicomStack(vtkDICOMReader* reader, const ImageGeometry& geometry);

  /// Where the first voxels of the slices lie, if those were tilted or lie at uneven distances
  /// [mm]; otherwise none.
  std::vector<glm::dvec3> IrregularSlicesMm() const;

  /// Gantry tilt, missing slices and uneven distances.
  /// @param isRectified  whether the volume is resampled, so that it is as true as can be
  void Warn(bool isRectified, std::vector<std::string>& warnings) const;

private:
  /// The way from a slice to the next along their normal.
  struct Gap
  {
    double widthMm;
    std::string between; ///< "a.dcm" and "b.dcm"
  };

  bool IsTilted() const;
  bool IsUneven() const;
  void WarnOfMissingSlices(std::vector<std::string>& warnings) const;
  std::string UnevenDistances() const;

  bool isPlaced; ///< whether the files say where the slices lie
  double tiltDegrees = 0.0;
  double drawnMm = 0.0; ///< distance of the volume's slices
  std::vector<glm::dvec3> positionsMm;
  std::vector<Gap> gaps; ///< between a slice and the next
  double narrowestMm = 0.0;
  double widestMm = 0.0;
};

}

#endif
