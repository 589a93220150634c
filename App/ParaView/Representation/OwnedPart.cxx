#include "OwnedPart.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Replaces the flags by those with the bits of a mask; removes them if no bit is left.
void KeepFlags(vtkDataSetAttributes* attributes, unsigned char mask)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  auto* const flags = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(name));
  if (!flags)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> kept;
  kept->SetName(name);
  kept->SetNumberOfTuples(flags->GetNumberOfTuples());
  unsigned char any = 0;
  for (vtkIdType i = 0; i < flags->GetNumberOfTuples(); ++i)
  {
    const auto flag = static_cast<unsigned char>(flags->GetValue(i) & mask);
    kept->SetValue(i, flag);
    any |= flag;
  }
  attributes->RemoveArray(name);
  if (any)
  {
    attributes->AddArray(kept);
  }
}

}

std::vector<vtkDataSet*> GridsIn(vtkDataObject* data)
{
  std::vector<vtkDataSet*> grids = vtkCompositeDataSet::GetDataSets<vtkDataSet>(data);
  const auto isNone = [](vtkDataSet* part)
  {
    return part->GetNumberOfPoints() == 0 ||
      !(part->IsA("vtkImageData") || part->IsA("vtkRectilinearGrid"));
  };
  grids.erase(std::remove_if(grids.begin(), grids.end(), isNone), grids.end());
  return grids;
}

bool IsAxisAligned(vtkImageData* image)
{
  return image->GetDirectionMatrix()->IsIdentity();
}

vtkSmartPointer<vtkImageData> WithoutFlagsOfNeighbours(vtkImageData* image)
{
  vtkSmartPointer<vtkImageData> copy;
  copy.TakeReference(image->NewInstance());
  copy->ShallowCopy(image);
  KeepFlags(copy->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  KeepFlags(copy->GetCellData(), vtkDataSetAttributes::HIDDENCELL);
  return copy;
}

}
