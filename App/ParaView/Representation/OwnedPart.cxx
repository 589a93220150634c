#include "OwnedPart.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <limits>

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

using Extent = std::array<int, 6>;

// The smallest extent of points with all cells that this process owns.
Extent OwnExtent(const Extent& extent, vtkUnsignedCharArray* cellFlags)
{
  Extent own{ extent[1], extent[0], extent[3], extent[2], extent[5], extent[4] };
  for (vtkIdType cell = 0; cell < cellFlags->GetNumberOfTuples(); ++cell)
  {
    if (cellFlags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL)
    {
      continue;
    }
    int place[3];
    vtkStructuredData::ComputeCellStructuredCoordsForExtent(
      cell, const_cast<int*>(extent.data()), place);
    for (int axis = 0; axis < 3; ++axis)
    {
      own[2 * axis] = std::min(own[2 * axis], place[axis]);
      own[2 * axis + 1] =
        std::max(own[2 * axis + 1], std::min(place[axis] + 1, extent[2 * axis + 1]));
    }
  }
  return own;
}

Box BoxOf(const double bounds[6])
{
  return { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
}

// The box between two points of an extent.
Box BoxOf(vtkDataSet* grid, const Extent& whole, const Extent& extent)
{
  const auto pointAt = [&](int end)
  {
    int place[3] = { extent[end], extent[2 + end], extent[4 + end] };
    glm::dvec3 point;
    grid->GetPoint(
      vtkStructuredData::ComputePointIdForExtent(const_cast<int*>(whole.data()), place), &point.x);
    return point;
  };
  return { pointAt(0), pointAt(1) };
}

Extent ExtentOf(vtkDataSet* grid)
{
  Extent extent{};
  if (auto* const image = vtkImageData::SafeDownCast(grid))
  {
    image->GetExtent(extent.data());
  }
  else if (auto* const rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetExtent(extent.data());
  }
  return extent;
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

OwnedPart PartOf(vtkDataSet* grid)
{
  OwnedPart part;
  part.data.TakeReference(grid->NewInstance());
  part.data->ShallowCopy(grid);
  if (grid->HasAnyGhostCells())
  {
    const Extent whole = ExtentOf(grid);
    const Extent own = OwnExtent(whole, grid->GetCellGhostArray());
    KeepFlags(part.data->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
    KeepFlags(part.data->GetCellData(), vtkDataSetAttributes::HIDDENCELL);
    // Cells of a turned image are no box along the axes of the data.
    auto* const image = vtkImageData::SafeDownCast(part.data);
    part.hasNeighbours = !image || image->GetDirectionMatrix()->IsIdentity();
    if (part.hasNeighbours)
    {
      part.box = BoxOf(grid, whole, own);
      return part;
    }
    image->Crop(own.data());
  }
  part.box = BoxOf(part.data->GetBounds());
  return part;
}

std::vector<Box> BoxesOf(const std::vector<OwnedPart>& parts)
{
  std::vector<Box> boxes(parts.size());
  std::transform(
    parts.begin(), parts.end(), boxes.begin(), [](const auto& part) { return part.box; });
  return boxes;
}

Box BoxAround(const std::vector<Box>& boxes)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Box around{ glm::dvec3(Infinity), glm::dvec3(-Infinity) };
  for (const Box& box : boxes)
  {
    around.lower = glm::min(around.lower, box.lower);
    around.upper = glm::max(around.upper, box.upper);
  }
  return around;
}

vtkSmartPointer<vtkInformation> InformationOf(vtkDataSet* grid)
{
  auto information = vtkSmartPointer<vtkInformation>::New();
  information->Set(vtkDataObject::DATA_OBJECT(), grid);
  if (auto* const image = vtkImageData::SafeDownCast(grid))
  {
    information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  }
  return information;
}

}
