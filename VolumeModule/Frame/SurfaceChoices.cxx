#include "Frame/SurfaceChoices.h"

#include "Frame/MaterialChoices.h"
#include "Frame/NumberCheck.h"

#include "vtkContourValues.h"
#include "vtkImplicitFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

namespace varimarch
{

namespace
{

// The finite isovalues, ascending and without duplicates.
std::vector<double> IsovaluesOf(vtkVolumeProperty* property)
{
  vtkContourValues* const contours = property->GetIsoSurfaceValues();
  const double* const values = contours->GetValues();
  std::set<double> isovalues;
  const int count = contours->GetNumberOfContours();
  std::copy_if(values, values + count, std::inserter(isovalues, isovalues.end()),
    [](double value) { return std::isfinite(value); });
  if (count > 0 && isovalues.empty())
  {
    throw std::invalid_argument("Cannot draw the isovalue " + TextOf(values[0]) +
      ": expected a finite number in vtkVolumeProperty::GetIsoSurfaceValues");
  }
  return { isovalues.begin(), isovalues.end() };
}

}

bool ChooseSurfaces(Frame& frame)
{
  if (frame.settings.blend == Blend::Isosurface)
  {
    ChooseSurfaceComponent(frame);
    if (frame.settings.cubic)
    {
      throw std::runtime_error("Isosurfaces of cubic interpolation are not supported");
    }
    frame.material.isovalues = IsovaluesOf(frame.material.property);
    return !frame.material.isovalues.empty();
  }
  if (frame.settings.blend == Blend::Slice)
  {
    vtkImplicitFunction* const function = frame.material.property->GetSliceFunction();
    frame.material.slice = function ? SliceSurfaceOf(function, frame.geometry) : SliceSurface();
    // A slice in a face of the volume counts as inside despite rounding.
    constexpr double ReachVoxels = 3e-4;
    frame.geometry.boxGrid.lower -= ReachVoxels;
    frame.geometry.boxGrid.upper += ReachVoxels;
    return function != nullptr;
  }
  return true;
}

}
