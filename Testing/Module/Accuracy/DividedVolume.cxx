#include "Module/Accuracy/DividedVolume.h"

#include "Core/Blocks/OwnerOrder.h"
#include "Frame/VolumeGeometry.h"

#include <algorithm>

using namespace varimarch;

namespace
{

// Layers of voxels around a part, as many as the plugin for ParaView asks for.
constexpr int Layers = 2;

// The ends of the parts into which the cells between two points are divided.
std::vector<int> EndsOfParts(int first, int last, int parts)
{
  std::vector<int> ends;
  for (int part = 0; part <= parts; ++part)
  {
    ends.push_back(first + (last - first) * part / parts);
  }
  return ends;
}

}

DividedVolume::DividedVolume(MapperScene& scene, std::array<int, 3> parts)
  : scene(scene)
{
  const int* const extent = scene.image->GetExtent();
  const std::vector<int> x = EndsOfParts(extent[0], extent[1], parts[0]);
  const std::vector<int> y = EndsOfParts(extent[2], extent[3], parts[1]);
  const std::vector<int> z = EndsOfParts(extent[4], extent[5], parts[2]);
  for (int k = 0; k < parts[2]; ++k)
  {
    for (int j = 0; j < parts[1]; ++j)
    {
      for (int i = 0; i < parts[0]; ++i)
      {
        this->AddPart({ x[i], x[i + 1], y[j], y[j + 1], z[k], z[k + 1] });
      }
    }
  }
}

void DividedVolume::AddPart(const std::array<int, 6>& extent)
{
  const int* const whole = this->scene.image->GetExtent();
  std::array<int, 6> withNeighbours{};
  std::array<int, 3> lower{};
  std::array<int, 3> upper{};
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = extent[2 * axis];
    upper[axis] = extent[2 * axis + 1];
    withNeighbours[2 * axis] = std::max(lower[axis] - Layers, whole[2 * axis]);
    withNeighbours[2 * axis + 1] = std::min(upper[axis] + Layers, whole[2 * axis + 1]);
  }
  auto part = std::make_unique<Part>();
  this->scene.image->TransformIndexToPhysicalPoint(lower.data(), &part->box.lower.x);
  this->scene.image->TransformIndexToPhysicalPoint(upper.data(), &part->box.upper.x);
  vtkNew<vtkImageData> image;
  image->ShallowCopy(this->scene.image);
  image->Crop(withNeighbours.data());
  part->mapper->SetInputData(image);
  this->parts.push_back(std::move(part));
}

// Crops to the part, and to the box that is set for the mapper of the whole.
void DividedVolume::TakeSettings(Part& part)
{
  vtkVariationFieldVolumeMapper* const whole = this->scene.mapper;
  const double* const cropped = whole->GetCroppingRegionPlanes();
  double planes[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lower = part.box.lower[axis];
    const double upper = part.box.upper[axis];
    planes[2 * axis] = whole->GetCropping() ? std::max(lower, cropped[2 * axis]) : lower;
    planes[2 * axis + 1] = whole->GetCropping() ? std::min(upper, cropped[2 * axis + 1]) : upper;
  }
  part.mapper->CroppingOn();
  part.mapper->SetCroppingRegionPlanes(planes);
  part.mapper->SetProcessorMarching(whole->GetProcessorMarching());
  part.mapper->SetErrorTolerance(whole->GetErrorTolerance());
  part.mapper->SetIntegrationRule(whole->GetIntegrationRule());
  part.mapper->SetUseJittering(whole->GetUseJittering());
  part.mapper->SetAccelerationMode(whole->GetAccelerationMode());
}

std::vector<DividedVolume::Part*> DividedVolume::FrontToBack()
{
  const glm::dmat4 worldFromData = FromVtk(this->scene.volume->GetMatrix());
  std::vector<OwnedBox> boxes;
  for (const std::unique_ptr<Part>& part : this->parts)
  {
    boxes.push_back({ part->box, worldFromData, int(boxes.size()) });
  }
  std::vector<Part*> ordered;
  for (const int owner :
    OwnersFrontToBack(boxes, int(boxes.size()), ClipFromWorld(this->scene.renderer)).owners)
  {
    ordered.push_back(this->parts[owner].get());
  }
  return ordered;
}

std::vector<float> DividedVolume::Draw()
{
  const std::vector<Part*> ordered = this->FrontToBack();
  std::vector<vtkVariationFieldVolumeMapper*> mappers;
  for (Part* part : ordered)
  {
    this->TakeSettings(*part);
    mappers.push_back(part->mapper);
  }
  this->steps = this->search.Find(
    this->scene.renderer, this->scene.volume, mappers, SearchingProcesses::Single());
  std::vector<float> whole;
  for (vtkVariationFieldVolumeMapper* mapper : mappers)
  {
    this->scene.volume->SetMapper(mapper);
    whole = LaidOver(std::move(whole), this->scene.Draw());
  }
  this->scene.volume->SetMapper(this->scene.mapper);
  return whole;
}
