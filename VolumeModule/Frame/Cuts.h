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
  /// Those of x, y and z of the data, lower and upper; dot(plane, (position, 1)) >= 0 beyond it.
  std::array<glm::dvec4, 6> planesGrid;
  int drawn; ///< bit x + 3 y + 9 z: 0 below, 1 between, 2 above the planes of an axis
};

/// What clipping planes and cropping leave of a volume's box [grid space]. Exact: rays are cut, and
/// no sample is ever tested.
struct Cuts
{
  Box boxGrid;                            ///< cuts along the axes of the grid only make it smaller
  std::vector<glm::dvec4> planesGrid;     ///< the others; dot(plane, (position, 1)) >= 0 is left
  std::optional<CroppingRegions> regions; ///< none where they are one box

  /// All that a picture depends on.
  std::vector<double> Numbers() const;
};

/// Clipping planes are in the world, cropping planes in coordinates of the data: with the image's
/// origin, spacing and direction, without the volume's matrix.
/// @param keepPlanes  whether clipping planes along the axes of the grid stay planes
Cuts CutsOf(vtkVolumeMapper* mapper, const VolumeGeometry& geometry, bool keepPlanes);

}

#endif
