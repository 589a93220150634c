#include "Readers/MappedScalars.h"

#include <vtkDataArray.h>

namespace varimarch
{

std::shared_ptr<MappedFile> MappedFileOf(vtkDataArray* scalars)
{
  return MappedFileAt(scalars->GetVoidPointer(0));
}

std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars)
{
  const auto file = MappedFileOf(scalars);
  return file ? file->Summary(scalars->GetMTime()) : nullptr;
}

}
