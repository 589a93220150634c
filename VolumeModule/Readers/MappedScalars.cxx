#include "Readers/MappedScalars.h"

#include <vtkDataArray.h>

namespace varimarch
{

std::shared_ptr<PagedVoxels> PagedVoxelsOf(vtkDataArray* scalars)
{
  return PagedVoxelsAt(scalars->GetVoidPointer(0));
}

std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars)
{
  const auto voxels = PagedVoxelsOf(scalars);
  return voxels ? voxels->Summary(scalars->GetMTime()) : nullptr;
}

}
