#include "Readers/MappedVoxels.h"

#include "Readers/MappedFile.h"
#include "Readers/MappedMemory.h"
#include "Readers/Preview.h"
#include "Readers/RawVoxelSource.h"
#include "Readers/SummaryFile.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <utility>

namespace varimarch
{

std::string ObstacleToMapping(
  const VoxelFile& file, const VoxelLayout& layout, std::uint64_t offset)
{
  const auto valueBytes = std::uint64_t(vtkDataArray::GetDataTypeSize(layout.scalarType));
  if (file.compression != Compression::None)
  {
    return "are compressed";
  }
  if (file.encoding == VoxelEncoding::Text)
  {
    return "are written as text";
  }
  if (layout.componentCount != 1 || !VoxelTypeOf(layout.scalarType))
  {
    return "are not single numbers of 8 bits, 16 bits or type float";
  }
  if (valueBytes > 1 && file.bigEndian != HostIsBigEndian)
  {
    return "are in another byte order than this machine's";
  }
  if (file.paths.size() > 1 || file.alternation > 0)
  {
    return "are in several pieces";
  }
  if (!file.conversion.empty())
  {
    return "are " + file.conversion;
  }
  return offset % valueBytes != 0 ? "begin at byte " + std::to_string(offset) +
      ", which is no multiple of their " + std::to_string(valueBytes) + " bytes"
                                  : "";
}

vtkSmartPointer<vtkImageData> MappedImage(const VoxelsInFile& voxels, ReadProgress& progress)
{
  const VoxelLayout& layout = voxels.layout;
  auto file =
    std::make_unique<MappedFile>(voxels.path, voxels.offset, ByteCountOf(voxels.path, layout));
  const RawVoxelSource source(voxels.path, layout, voxels.offset);
  const std::uint64_t mostBytes = voxels.mapping.mostMemoryBytes;
  const SummarizedVoxels summarized = { source, layout.scalarType, voxels.path, voxels.path,
    StampOfFile(voxels.path, voxels.offset), mostBytes,
    SideOfBricks(source.Levels().front(), source.Type(), mostBytes / 2) };
  std::shared_ptr<const VolumeSummary> summary = KeptSummary(summarized);
  if (!summary && voxels.mapping.preview && NeedsMuchReading(summarized))
  {
    return CoarseCopy(source, layout, voxels.mapping, progress);
  }
  summary = summary ? summary : MadeSummary(summarized, progress);
  return PagedImage(std::move(file), layout, summary, mostBytes);
}

vtkSmartPointer<vtkImageData> PagedImage(std::unique_ptr<PagedVoxels> voxels,
  const VoxelLayout& layout, std::shared_ptr<const VolumeSummary> summary, std::uint64_t mostBytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(
    int(layout.dimensions[0]), int(layout.dimensions[1]), int(layout.dimensions[2]));
  const auto scalars =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layout.scalarType));
  void* const bytes = KeepPaged(std::move(voxels), mostBytes);
  scalars->SetVoidArray(
    bytes, image->GetNumberOfPoints(), 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  scalars->SetArrayFreeFunction(ReleasePaged);
  scalars->SetName("scalars");
  PagedVoxelsAt(bytes)->Describe(std::move(summary), scalars->GetMTime());
  image->GetPointData()->SetScalars(scalars);
  return image;
}

}
