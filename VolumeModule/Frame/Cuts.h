#ifndef Varimarch_Frame_Cuts_h
#define Varimarch_Frame_Cuts_h

#include "Frame/VolumeGeometry.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <tuple>
#include <vector>

class vtkVolumeMapper;

namespace varimarch
{

class NumberCheck;

/// Cropping by flags: six planes divide the volume into 27 regions, some of which are drawn.
struct CroppingRegions
{
  /// The lower and upper planes along x, y and z of the data. Positions above a plane have
  /// dot(plane, (position, 1)) >= 0.
  std::array<glm::dvec4, 6> planesGrid;
  /// Bit x + 3 y + 9 z is set for a drawn region: 0 is below, 1 between and 2 above the planes.
  int drawn;
};

inline auto FieldsOf(const CroppingRegions& regions)
{
  const auto& [planesGrid, drawn] = regions;
  return std::tie(planesGrid, drawn);
}

/// The part of a volume's box that clipping planes and cropping leave [grid space]. It is exact,
/// because rays are cut at the planes; samples are not tested one by one.
struct Cuts
{
  Box boxGrid;                            ///< The box, reduced by cuts along the grid's axes.
  std::vector<glm::dvec4> planesGrid;     ///< Other cuts, which keep dot(plane, (p, 1)) >= 0.
  std::optional<CroppingRegions> regions; ///< Empty if the regions form one box.
};

inline auto FieldsOf(const Cuts& cuts)
{
  const auto& [box, planesGrid, regions] = cuts;
  const auto& [lower, upper] = box;
  return std::tie(lower, upper, planesGrid, regions);
}

/// The cuts of a mapper. Clipping planes are in world space, cropping planes in data coordinates:
/// these have the image's origin, spacing and direction, but not the volume's matrix.
/// Planes without a place cut nothing.
/// @param keepPlanes  true if clipping planes along the axes of the grid stay planes
Cuts CutsOf(
  vtkVolumeMapper* mapper, const VolumeGeometry& geometry, bool keepPlanes, NumberCheck& check);

}

#endif
