#ifndef Varimarch_Readers_MappedScalars_h
#define Varimarch_Readers_MappedScalars_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/PagedVoxels.h"

#include <memory>

class vtkDataArray;

namespace varimarch
{

/// The paged voxels that are these scalars; null for scalars in memory.
std::shared_ptr<PagedVoxels> PagedVoxelsOf(vtkDataArray* scalars);

/// The summary of scalars that stayed on disk; null for others, and once they are modified.
std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars);

}

#endif
