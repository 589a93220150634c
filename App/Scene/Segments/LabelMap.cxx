#include "Scene/Segments/LabelMap.h"

#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkVolumeProperty.h>
#include <vtksys/SystemTools.hxx>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

[[noreturn]] void FailToDraw(const std::string& path, const std::string& reason)
{
  throw std::runtime_error("Cannot draw the labels of " + path + " over the scan: " + reason + ".");
}

vtkSmartPointer<vtkTransform> LabelIndexFromScanIndex(vtkImageData* labels, vtkImageData* scan)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->SetMatrix(labels->GetPhysicalToIndexMatrix());
  transform->Concatenate(scan->GetIndexToPhysicalMatrix());
  return transform;
}

// vtkImageReslice ignores the directions of images, so it gets grids of indices.
vtkSmartPointer<vtkImageData> OnGridOf(vtkImageData* scan, vtkImageData* numbers)
{
  vtkNew<vtkImageData> indices;
  indices->ShallowCopy(numbers);
  indices->SetOrigin(0.0, 0.0, 0.0);
  indices->SetSpacing(1.0, 1.0, 1.0);
  indices->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(indices);
  reslice->SetResliceTransform(LabelIndexFromScanIndex(numbers, scan));
  reslice->SetInterpolationModeToNearestNeighbor();
  reslice->SetOutputExtent(scan->GetExtent());
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->Update();
  vtkSmartPointer<vtkImageData> resliced = reslice->GetOutput();
  resliced->SetOrigin(scan->GetOrigin());
  resliced->SetSpacing(scan->GetSpacing());
  resliced->SetDirectionMatrix(scan->GetDirectionMatrix());
  return resliced;
}

std::string BoxText(vtkImageData* image)
{
  const double* const bounds = image->GetBounds();
  std::ostringstream text;
  text.precision(4);
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis > 0 ? ", " : "") << "xyz"[axis] << ' ' << bounds[2 * axis] << " to "
         << bounds[2 * axis + 1];
  }
  return text.str() + " mm";
}

double VolumeMl(const std::vector<SegmentSize>& sizes)
{
  double sum = 0.0;
  for (const SegmentSize& size : sizes)
  {
    sum += size.volumeMl;
  }
  return sum;
}

// A list such as "liver, spleen and 3 others".
std::string NameList(const std::vector<std::string>& names)
{
  constexpr std::size_t MostNamed = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), MostNamed); ++i)
  {
    list += (i > 0 ? ", " : "") + names[i];
  }
  return names.size() > MostNamed
    ? list + " and " + std::to_string(names.size() - MostNamed) + " more"
    : list;
}

void CheckFrameOfReference(
  const LoadedVolume& labels, const std::string& path, const LoadedVolume& scan)
{
  const std::string& ofLabels = labels.frameOfReference;
  const std::string& ofScan = scan.frameOfReference;
  if (!ofLabels.empty() && !ofScan.empty() && ofLabels != ofScan)
  {
    FailToDraw(path,
      "expected the scan's frame of reference " + ofScan + ", found " + ofLabels +
        "; choose the scan that the labels were drawn on");
  }
}

// Compares the sizes before and after, which differ little unless something was lost.
void WarnOfLosses(const std::vector<SegmentSize>& before, LabelMap& map)
{
  constexpr double SmallestLoss = 0.02;
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < map.segments.size(); ++i)
  {
    if (before[i].voxels > 0 && map.sizes[i].voxels == 0)
    {
      lost.push_back(map.segments[i].name);
    }
  }
  if (!lost.empty())
  {
    map.warnings.push_back("Segments have no voxel of the scan, because they are smaller or lie "
                           "outside: " +
      NameList(lost) + ".");
  }
  const double part = VolumeMl(map.sizes) / VolumeMl(before);
  if (part < 1.0 - SmallestLoss)
  {
    map.warnings.push_back("Only " + std::to_string(std::lround(100.0 * part)) +
      " % of the labels' volume lies inside the scan and is drawn.");
  }
}

std::vector<Segment> SegmentsOfFile(
  const LoadedVolume& labels, const std::string& path, std::vector<std::string>& warnings)
{
  try
  {
    return labels.segments.empty() ? SegmentsOf(labels.image, {}, warnings) : labels.segments;
  }
  catch (const std::invalid_argument& reason)
  {
    FailToDraw(path, reason.what());
  }
}

}

bool AreOnGridOf(vtkImageData* labels, vtkImageData* scan)
{
  constexpr double MostVoxels = 0.1; // that corners may differ by, since files round places
  int size[3];
  int scanSize[3];
  labels->GetDimensions(size);
  scan->GetDimensions(scanSize);
  bool areOn = std::equal(size, size + 3, scanSize);
  const auto transform = LabelIndexFromScanIndex(labels, scan);
  for (int corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = (corner >> axis & 1) * size[axis];
    }
    glm::dvec3 labelIndex;
    transform->TransformPoint(&index.x, &labelIndex.x);
    areOn = areOn && glm::distance(index, labelIndex) < MostVoxels;
  }
  return areOn;
}

LabelMap LabelMapOf(const LoadedVolume& labels, const std::string& path, const LoadedVolume& scan)
{
  CheckFrameOfReference(labels, path, scan);
  LabelMap map;
  map.warnings = labels.warnings;
  if (scan.slices == SliceLayout::Irregular)
  {
    map.warnings.emplace_back(
      "The slices of the scan are tilted or uneven; where they are not drawn "
      "where they were scanned, the labels lie beside them.");
  }
  map.segments = SegmentsOfFile(labels, path, map.warnings);
  const auto numbers = SegmentNumbers(labels.image, map.segments);
  const std::vector<SegmentSize> before = SizesOf(numbers, map.segments.size());
  map.image = OnGridOf(scan.image, numbers);
  map.sizes = SizesOf(map.image, map.segments.size());
  if (VolumeMl(before) == 0.0)
  {
    map.warnings.push_back("No voxel of " + path + " has a label.");
  }
  else if (VolumeMl(map.sizes) == 0.0)
  {
    FailToDraw(path,
      "expected labels within the scan, at " + BoxText(scan.image) + ", found labels within " +
        BoxText(labels.image) + "; choose the scan that the labels were drawn on");
  }
  else
  {
    WarnOfLosses(before, map);
  }
  return map;
}

LabelMap LoadLabels(
  const SceneLabels& labels, const LoadedVolume& scan, const LoadObserver& observer)
{
  LabelMap map = LabelMapOf(LoadLabelVolume(labels, observer), labels.path, scan);
  TakeAppearance(labels.segments, labels.path, map);
  return map;
}

void TakeAppearance(const std::vector<Segment>& ofScene, const std::string& path, LabelMap& map)
{
  for (const Segment& segment : ofScene)
  {
    const auto known = std::find_if(map.segments.begin(), map.segments.end(),
      [&](const Segment& own) { return own.value == segment.value; });
    if (known == map.segments.end())
    {
      map.warnings.push_back("The scene has a segment of the value " +
        std::to_string(segment.value) + ", which " + path + " does not have.");
      continue;
    }
    *known = segment;
  }
}

Look LookOfLabelsOnly()
{
  Look look;
  look.name = "labels";
  look.colors = { { 0.0, glm::dvec3(1.0) } };
  look.opacities = { { 0.0, 0.0 } };
  return look;
}

namespace
{

/// Value in a mask of the voxels that scissors remove. VTK's mapper expects labels without gaps.
int RemovedNumber(const LabelMap& labels)
{
  return int(labels.segments.size()) + 1;
}

vtkSmartPointer<vtkPiecewiseFunction> Constant(double value)
{
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AddPoint(0.0, value);
  return function;
}

// The opacity of a unit distance of a segment whose mean thickness has the given opacity. A voxel
// lets at least a level of 8 bits through: the steps along rays would have to be far shorter in
// front of an edge that is harder than that.
double OpacityOfUnitDistance(
  double opacity, double thicknessMm, vtkImageData* image, double unitDistanceMm)
{
  constexpr double LeastTransmittance = 1.0 / 256.0;
  const double* const spacing = image->GetSpacing();
  const double most = -std::log(LeastTransmittance) / *std::min_element(spacing, spacing + 3);
  const double extinction = thicknessMm > 0.0 ? -std::log1p(-opacity) / thicknessMm : 0.0;
  return -std::expm1(-std::min(extinction, most) * unitDistanceMm);
}

void ApplyOwnFunctions(
  int number, const Segment& segment, double opacity, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, segment.rgb.r, segment.rgb.g, segment.rgb.b);
  property->SetLabelColor(number, color);
  property->SetLabelScalarOpacity(number, Constant(opacity));
  if (property->HasGradientOpacity())
  {
    property->SetLabelGradientOpacity(number, Constant(1.0));
  }
}

// Labels without functions of their own would change the rows of the mask, and so its upload. A
// label cannot have a function of two values.
void ApplyFunctionsOfLook(int number, vtkVolumeProperty* property)
{
  property->SetLabelColor(number, property->GetRGBTransferFunction());
  property->SetLabelScalarOpacity(number, property->GetScalarOpacity());
  if (property->HasGradientOpacity())
  {
    property->SetLabelGradientOpacity(number, property->GetGradientOpacity());
  }
}

// For each voxel along an axis, the voxel of a coarser mask of the same box.
std::vector<vtkIdType> Coarser(int count, int coarseCount)
{
  std::vector<vtkIdType> indices;
  for (int i = 0; i < count; ++i)
  {
    indices.push_back(
      std::min(vtkIdType((i + 0.5) / count * coarseCount), vtkIdType(coarseCount - 1)));
  }
  return indices;
}

}

void ApplySegments(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property)
{
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (segments[i].visible)
    {
      const double opacity = OpacityOfUnitDistance(segments[i].opacity, labels.sizes[i].thicknessMm,
        labels.image, property->GetScalarOpacityUnitDistance());
      ApplyOwnFunctions(int(i + 1), segments[i], opacity, property);
    }
    else if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_2D)
    {
      ApplyFunctionsOfLook(int(i + 1), property);
    }
  }
  ApplyFunctionsOfLook(RemovedNumber(labels), property);
  property->SetLabelScalarOpacity(RemovedNumber(labels), Constant(0.0));
}

void ApplySegmentsByNumber(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property)
{
  constexpr double UnitDistanceMm = 1.0;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(RemovedNumber(labels), 0.0);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment& segment = segments[i];
    const double ofDistance = segment.visible
      ? OpacityOfUnitDistance(
          segment.opacity, labels.sizes[i].thicknessMm, labels.image, UnitDistanceMm)
      : 0.0;
    color->AddRGBPoint(double(i + 1), segment.rgb.r, segment.rgb.g, segment.rgb.b);
    opacity->AddPoint(double(i + 1), ofDistance);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(UnitDistanceMm);
}

vtkSmartPointer<vtkImageData> LabelMask(const LabelMap& labels, vtkImageData* kept)
{
  if (!kept)
  {
    return labels.image;
  }
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->DeepCopy(labels.image);
  const int* const size = mask->GetDimensions();
  const int* const keptSize = kept->GetDimensions();
  std::array<std::vector<vtkIdType>, 3> coarser;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarser[axis] = Coarser(size[axis], keptSize[axis]);
  }
  const auto removed = static_cast<unsigned char>(RemovedNumber(labels));
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  const auto* const isKept = static_cast<const unsigned char*>(kept->GetScalarPointer());
  tbb::parallel_for(0, size[2],
    [&](int z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        unsigned char* const row = voxels + (vtkIdType(z) * size[1] + y) * size[0];
        const unsigned char* const keptRow =
          isKept + (coarser[2][z] * keptSize[1] + coarser[1][y]) * keptSize[0];
        for (int x = 0; x < size[0]; ++x)
        {
          row[x] = keptRow[coarser[0][x]] ? row[x] : removed;
        }
      }
    });
  return mask;
}

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
