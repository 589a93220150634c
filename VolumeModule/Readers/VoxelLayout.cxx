#include "Readers/VoxelLayout.h"

#include "Readers/FileError.h"
#include "Readers/VolumeFile.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkType.h>
#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

namespace varimarch
{

bool IsSame(const VoxelLayout& one, const VoxelLayout& other)
{
  return one.dimensions == other.dimensions && one.scalarType == other.scalarType &&
    one.componentCount == other.componentCount;
}

std::size_t MostFrequent(const std::vector<VoxelLayout>& layouts)
{
  std::map<std::tuple<std::array<std::int64_t, 3>, int, std::int64_t>, std::size_t> counts;
  const auto countOf = [&](const VoxelLayout& layout) -> std::size_t& {
    return counts[{ layout.dimensions, layout.scalarType, layout.componentCount }];
  };
  for (const VoxelLayout& layout : layouts)
  {
    ++countOf(layout);
  }
  const auto most = std::max_element(layouts.begin(), layouts.end(),
    [&](const VoxelLayout& one, const VoxelLayout& other)
    { return countOf(one) < countOf(other); });
  return std::size_t(most - layouts.begin());
}

int ScalarTypeOf(NumberKind kind, std::int64_t byteCount)
{
  static const std::map<std::pair<NumberKind, std::int64_t>, int> types = {
    { { NumberKind::Signed, 1 }, VTK_SIGNED_CHAR },
    { { NumberKind::Unsigned, 1 }, VTK_UNSIGNED_CHAR },
    { { NumberKind::Signed, 2 }, VTK_SHORT },
    { { NumberKind::Unsigned, 2 }, VTK_UNSIGNED_SHORT },
    { { NumberKind::Signed, 4 }, VTK_INT },
    { { NumberKind::Unsigned, 4 }, VTK_UNSIGNED_INT },
    { { NumberKind::Float, 4 }, VTK_FLOAT },
    { { NumberKind::Signed, 8 }, VTK_TYPE_INT64 },
    { { NumberKind::Unsigned, 8 }, VTK_TYPE_UINT64 },
    { { NumberKind::Float, 8 }, VTK_DOUBLE },
  };
  const auto type = types.find({ kind, byteCount });
  return type == types.end() ? VTK_VOID : type->second;
}

bool IsNumberType(int scalarType)
{
  return (scalarType >= VTK_CHAR && scalarType <= VTK_DOUBLE) ||
    (scalarType > VTK_STRING && scalarType <= VTK_TYPE_UINT64);
}

std::optional<VoxelType> VoxelTypeOf(int scalarType)
{
  switch (scalarType)
  {
    case VTK_CHAR: // has a sign on x86, and none on ARM
      return std::is_signed_v<char> ? VoxelType::Int8 : VoxelType::UInt8;
    case VTK_SIGNED_CHAR:
      return VoxelType::Int8;
    case VTK_UNSIGNED_CHAR:
      return VoxelType::UInt8;
    case VTK_SHORT:
      return VoxelType::Int16;
    case VTK_UNSIGNED_SHORT:
      return VoxelType::UInt16;
    case VTK_FLOAT:
      return VoxelType::Float32;
  }
  return std::nullopt;
}

std::uint64_t ByteCountOf(const std::string& path, const VoxelLayout& layout)
{
  // A product of doubles cannot overflow, and is exact for all volumes that fit on a disk.
  double bytes = double(vtkDataArray::GetDataTypeSize(layout.scalarType)) * layout.componentCount;
  for (std::int64_t dimension : layout.dimensions)
  {
    if (dimension < 1 || dimension > std::numeric_limits<int>::max())
    {
      FailToRead(path, "1 to 2147483647 voxels along each axis", Text(layout));
    }
    bytes *= double(dimension);
  }
  if (layout.componentCount < 1 || layout.componentCount > std::numeric_limits<int>::max())
  {
    FailToRead(path, "at least 1 value per voxel", std::to_string(layout.componentCount));
  }
  constexpr double LargestFile = 9e18;
  if (bytes > LargestFile)
  {
    FailToRead(path, "a volume that fits in a file", Text(layout) + " (" + ByteText(bytes) + ")");
  }
  return std::uint64_t(bytes);
}

std::uint64_t CheckedByteCount(const std::string& path, const VoxelLayout& layout)
{
  const std::uint64_t bytes = ByteCountOf(path, layout);
  const double memoryBytes = PhysicalMemoryBytes();
  if (double(bytes) > memoryBytes)
  {
    FailToRead(path, "a volume that fits in the memory of " + ByteText(memoryBytes),
      Text(layout) + " (" + ByteText(double(bytes)) + ")");
  }
  return bytes;
}

vtkSmartPointer<vtkImageData> AllocatedImage(const VoxelLayout& layout)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(
    int(layout.dimensions[0]), int(layout.dimensions[1]), int(layout.dimensions[2]));
  image->AllocateScalars(layout.scalarType, int(layout.componentCount));
  image->GetPointData()->GetScalars()->SetName("scalars");
  return image;
}

std::string Text(const VoxelLayout& layout)
{
  std::string text;
  for (std::int64_t dimension : layout.dimensions)
  {
    text += (text.empty() ? "" : " x ") + std::to_string(dimension);
  }
  return text + " voxels of " + vtkImageScalarTypeNameMacro(layout.scalarType);
}

std::string ByteText(double bytes)
{
  const char* const units[] = { "bytes", "kB", "MB", "GB", "TB" };
  int unit = 0;
  while (bytes >= 1000.0 && unit < 4)
  {
    bytes /= 1000.0;
    ++unit;
  }
  char text[40];
  std::snprintf(text, sizeof(text), "%.4g %s", bytes, units[unit]);
  return text;
}

double PhysicalMemoryBytes()
{
  static const double bytes =
    1024.0 * double(vtksys::SystemInformation().GetHostMemoryTotal()); // in KiB
  return bytes;
}

std::uint64_t MostMemoryBytes(const ReadOptions& options)
{
  return options.mostMemoryBytes > 0 ? options.mostMemoryBytes
                                     : std::uint64_t(PhysicalMemoryBytes());
}

double FreeMemoryBytes()
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  return 1024.0 * 1024.0 * double(machine.GetAvailablePhysicalMemory()); // in MiB
}

}
