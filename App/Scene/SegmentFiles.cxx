#include "Scene/SegmentFiles.h"

#include "Scene/VolumeWriters/VolumeWriters.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

void RequireKnownEnding(const std::string& path)
{
  const auto endings = { ".seg.nrrd", ".nii", ".nii.gz" };
  const bool isKnown = std::any_of(endings.begin(), endings.end(),
    [&](const char* ending) { return vtksys::SystemTools::StringEndsWith(path, ending); });
  if (!isKnown)
  {
    throw std::runtime_error(
      path + ": expected a name that ends with .seg.nrrd, .nii or .nii.gz; choose one");
  }
}

// The values of the segments instead of their numbers.
vtkSmartPointer<vtkImageData> ValuesOf(vtkImageData* numbers, const std::vector<Segment>& segments)
{
  const bool areBytes = std::all_of(segments.begin(), segments.end(),
    [](const Segment& segment) { return segment.value > 0 && segment.value <= 255; });
  auto values = vtkSmartPointer<vtkImageData>::New();
  values->CopyStructure(numbers);
  values->AllocateScalars(areBytes ? VTK_UNSIGNED_CHAR : VTK_INT, 1);
  vtkDataArray* const scalars = values->GetPointData()->GetScalars();
  const auto* const number = static_cast<const unsigned char*>(numbers->GetScalarPointer());
  for (vtkIdType voxel = 0; voxel < numbers->GetNumberOfPoints(); ++voxel)
  {
    scalars->SetComponent(voxel, 0, number[voxel] > 0 ? segments[number[voxel] - 1].value : 0);
  }
  return values;
}

}

void RequireNoFileOf(const std::vector<VolumeSource>& scans, const std::string& path)
{
  std::error_code unknown;
  const auto file = std::filesystem::weakly_canonical(path, unknown);
  for (const VolumeSource& scan : scans)
  {
    const auto* const source = std::get_if<FileSource>(&scan);
    if (!source || !std::filesystem::exists(file, unknown))
    {
      continue;
    }
    auto place = std::filesystem::weakly_canonical(source->path, unknown);
    place = place.has_filename() ? place : place.parent_path(); // "folder/"
    // All of the path of the scan is the beginning of the path of one of its files.
    if (std::mismatch(place.begin(), place.end(), file.begin(), file.end()).first == place.end())
    {
      throw std::runtime_error(
        path + ": this is a file of the scan, which is not replaced; choose another name");
    }
  }
}

std::vector<std::string> WriteSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const std::vector<VolumeSource>& scans, const std::string& path)
{
  RequireKnownEnding(path);
  RequireNoFileOf(scans, path);
  LoadedVolume volume;
  volume.image = ValuesOf(labels.image, segments);
  volume.segments = segments;
  return WriteVolume(volume, path);
}

}
