#ifndef Varimarch_Frame_Cuts_h
#define Varimarch_Frame_Cuts_h

#include "Frame/VolumeGeometry.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <vector>

class vtkVolumeMapper;

namespace varimarch
{

/// Cropping by flags: six planes make 27 regions, of which some are drawn.
struct CroppingRegions
{
  /// The lower and upper planes of x, y and z of the data; dot(plane, (position, 1)) >= 0 beyond
  /// one.
  std::array<glm::dvec4, 6> planesGrid;
  int drawn; ///< Bit x + 3 y + 9 z; 0 below, 1 between, 2 above the planes of an axis.
};

/// The part of a volume's box that clipping planes and cropping leave [grid space]. It is exact:
/// rays are cut, and no sample is ever tested.
struct Cuts
{
  Box boxGrid;                            ///< Cuts along the axes of the grid make it smaller.
  std::vector<glm::dvec4> planesGrid;     ///< Other cuts; dot(plane, (position, 1)) >= 0 is left.
  std::optional<CroppingRegions> regions; ///< Nothing if the regions are one box.

  /// Everything that an image depends on.
  std::vector<double> Numbers() const;
};

/// Clipping planes are in the world, cropping planes in coordinates of the data: with the image's
/// origin, spacing and direction, without the volume's matrix.
/// @param keepPlanes  true if clipping planes along the axes of the grid stay planes
Cuts CutsOf(vtkVolumeMapper* mapper, const VolumeGeometry& geometry, bool keepPlanes);

}

#endif
