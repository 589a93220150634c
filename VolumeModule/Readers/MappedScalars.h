#ifndef Varimarch_Readers_MappedScalars_h
#define Varimarch_Readers_MappedScalars_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/MappedFile.h"

#include <memory>

class vtkDataArray;

namespace varimarch
{

/// The file whose mapped voxels are these scalars; null for scalars in memory.
std::shared_ptr<MappedFile> MappedFileOf(vtkDataArray* scalars);

/// The summary of scalars that stayed in their file; null for others, and once they are modified.
std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars);

}

#endif
