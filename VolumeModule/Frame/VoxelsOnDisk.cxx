#include "Frame/VoxelsOnDisk.h"

#include "Readers/Paging/MappedMemory.h"

#include "vtkDataArray.h"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace varimarch
{

ValueCounts CountsOnDisk(vtkDataArray* scalars)
{
  const auto summary = SummaryOf(scalars);
  if (!summary || summary->counts.empty())
  {
    return {};
  }
  // The counts begin with the smallest value of the type.
  const auto first =
    summary->counts.begin() + std::ptrdiff_t(summary->smallest - scalars->GetDataTypeMin());
  const auto count = std::ptrdiff_t(summary->largest - summary->smallest) + 1;
  return { summary->smallest, { first, first + count } };
}

VoxelsOnDisk::VoxelsOnDisk(const Frame& frame, vtkIdType mostBytes)
{
  const auto take = [&](const Frame& ofVolume)
  {
    const auto voxels = PagedVoxelsOf(ofVolume.voxels.scalars);
    if (voxels && mostBytes > 0)
    {
      SetMostBytes(*voxels, std::uint64_t(mostBytes));
    }
    if (voxels)
    {
      this->all.push_back(voxels);
      for (const PagedLevel& level : voxels->Coarser())
      {
        this->all.push_back(PagedVoxelsOf(level.scalars));
      }
    }
  };
  take(frame);
  for (const Frame& other : frame.others)
  {
    take(other);
  }
}

void VoxelsOnDisk::Check() const
{
  for (const auto& voxels : this->all)
  {
    const std::string problem = voxels->Problem();
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
    }
  }
}

}
