#include "TaskScans.h"

#include "Module/Files/PhantomDicom.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

using namespace phantom_dicom;

namespace
{

constexpr int Columns = 112;
constexpr int Rows = 96;
constexpr int Slices = 72;
constexpr double LungHu = -850.0;
constexpr double TissueHu = 40.0;
constexpr double TableHu = 250.0;

glm::dvec3 PlaceOf(const StoredVolume& volume, int x, int y, int z)
{
  return volume.originMm + volume.axesMm * glm::dvec3(x, y, z);
}

/// Sets the values of the voxels that fulfil a condition on their place.
template <class Condition>
void Set(StoredVolume& volume, double value, const Condition& isThere)
{
  std::size_t i = 0;
  for (int z = 0; z < volume.dimensions[2]; ++z)
  {
    for (int y = 0; y < volume.dimensions[1]; ++y)
    {
      for (int x = 0; x < volume.dimensions[0]; ++x, ++i)
      {
        if (isThere(PlaceOf(volume, x, y, z)))
        {
          volume.values[i] = value;
        }
      }
    }
  }
}

void SetBall(StoredVolume& volume, double value, const glm::dvec3& middle, double radiusMm)
{
  Set(volume, value,
    [&](const glm::dvec3& place) { return glm::distance(place, middle) <= radiusMm; });
}

StoredVolume Chest(double noduleRadiusMm)
{
  const auto torso =
    varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { Columns, Rows, Slices }, 1 });
  StoredVolume volume;
  volume.dimensions = { Columns, Rows, Slices };
  for (int axis = 0; axis < 3; ++axis)
  {
    volume.originMm[axis] = torso->GetOrigin()[axis];
    volume.axesMm[axis][axis] = torso->GetSpacing()[axis];
  }
  vtkDataArray* const values = torso->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    volume.values.push_back(std::round(values->GetComponent(i, 0)));
  }
  // No vessel leads to it.
  SetBall(volume, LungHu, TaskScans::Nodule(), 20.0);
  SetBall(volume, TissueHu, TaskScans::Nodule(), noduleRadiusMm);
  const double back = PlaceOf(volume, 0, Rows - 1, 0).y;
  Set(volume, TableHu,
    [&](const glm::dvec3& place)
    { return place.y > back - 8.0 && place.y < back - 3.0 && std::abs(place.x) < 120.0; });
  return volume;
}

/// Tracer in Bq/ml, in voxels of 8 mm around the middle of the chest: the body, the heart, and the
/// nodule.
StoredVolume Tracer()
{
  StoredVolume volume;
  volume.dimensions = { 40, 32, 32 };
  volume.values.assign(40 * 32 * 32, 0.0);
  volume.axesMm = glm::dmat3(8.0);
  volume.originMm = { -156.0, -124.0, -124.0 };
  Set(volume, 1000.0,
    [](const glm::dvec3& place)
    { return glm::length(glm::dvec2(place.x / 165.0, place.y / 105.0)) <= 1.0; });
  SetBall(volume, 12000.0, { 26.0, -38.0, -28.0 }, 40.0);
  SetBall(volume, 20000.0, TaskScans::Nodule(), 16.0);
  return volume;
}

/// 400 MBq, half of which are left at the start of the scan, and 80 kg: see TestDicomUptake.cxx.
Elements Uptake()
{
  return { { 0x00080021, Text("DA", "20260102") }, { 0x00080022, Text("DA", "20260102") },
    { 0x00080031, Text("TM", "100000") }, { 0x00080032, Text("TM", "100130") },
    { 0x00101030, Decimals({ 80 }) }, { 0x00281050, Text("DS", "7500") },
    { 0x00281051, Text("DS", "15000") }, { 0x00541001, Text("CS", "BQML") },
    { 0x00541102, Text("CS", "START") }, { 0x00280051, Text("CS", "DECY\\ATTN") },
    { 0x00540016,
      Sequence({ { { 0x00181072, Text("TM", "090000") }, { 0x00181074, Decimals({ 4e8 }) },
        { 0x00181075, Decimals({ 3600 }) } } }) } };
}

void Write(const TemporaryFolder& folder, const StoredVolume& volume, const std::string& name,
  const DicomOptions& options, const Elements& more = {})
{
  for (int slice = 0; slice < volume.dimensions[2]; ++slice)
  {
    Elements elements = more;
    elements[0x00200052] = Text("UI", "1.2.52");
    elements.merge(SliceElements(volume, slice, options));
    folder.Write(name + "/" + std::to_string(slice) + ".dcm", FileBytes(elements));
  }
}

}

glm::dvec3 TaskScans::Nodule()
{
  return { 100.0, 5.0, 10.0 };
}

std::vector<glm::dvec3> TaskScans::Aorta()
{
  return { { 28.0, 31.0, 55.0 }, { 26.0, 31.0, -60.0 }, { 18.0, 31.0, -140.0 } };
}

TaskScans::TaskScans()
{
  DicomOptions options;
  options.description = "Chest";
  options.bodyPart = "CHEST";
  options.contrastAgent = "iodine";
  Write(this->folder, Chest(9.0), "ct", options);
  options.seriesUid = "1.2.4";
  options.description = "Chest, half a year later";
  Write(this->folder, Chest(14.0), "later", options);
  DicomOptions pet;
  pet.seriesUid = "1.2.5";
  pet.modality = "PT";
  pet.description = "FDG";
  Write(this->folder, Tracer(), "pet", pet, Uptake());
}
