#include "vtkVarimarchPartsMapper.h"

#include "Core/Blocks/OwnerOrder.h"
#include "Frame/VolumeGeometry.h"
#include "ScalarsOfLook.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <utility>

struct vtkVarimarchPartsMapper::Drawer
{
  vtkNew<vtkVariationFieldVolumeMapper> Mapper;
  varimarch::ScalarsOfLook Scalars;
};

vtkStandardNewMacro(vtkVarimarchPartsMapper);

vtkVarimarchPartsMapper::vtkVarimarchPartsMapper() = default;

vtkVarimarchPartsMapper::~vtkVarimarchPartsMapper() = default;

void vtkVarimarchPartsMapper::SetParts(std::vector<varimarch::OwnedPart> parts)
{
  this->Parts = std::move(parts);
  this->Drawers.resize(std::min(this->Drawers.size(), this->Parts.size()));
  while (this->Drawers.size() < this->Parts.size())
  {
    this->Drawers.push_back(std::make_unique<Drawer>());
  }
  this->Modified();
}

double* vtkVarimarchPartsMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  const varimarch::Box box = varimarch::BoxAround(varimarch::BoxesOf(this->Parts));
  for (int axis = 0; axis < 3 && !this->Parts.empty(); ++axis)
  {
    this->Bounds[2 * axis] = box.lower[axis];
    this->Bounds[2 * axis + 1] = box.upper[axis];
  }
  return this->Bounds;
}

// Crops to the part, and to the box that is set for this mapper.
void vtkVarimarchPartsMapper::CropPart(const varimarch::OwnedPart& part, vtkVolumeMapper* mapper)
{
  double planes[6];
  this->GetCroppingRegionPlanes(planes);
  for (int axis = 0; axis < 3; ++axis)
  {
    double& lower = planes[2 * axis];
    double& upper = planes[2 * axis + 1];
    lower = this->Cropping ? std::max(lower, part.box.lower[axis]) : part.box.lower[axis];
    upper = this->Cropping ? std::min(upper, part.box.upper[axis]) : part.box.upper[axis];
  }
  mapper->SetCropping(this->Cropping || part.hasNeighbours);
  mapper->SetCroppingRegionPlanes(planes);
}

// Selecting an array by its number and then by its name would modify the mapper each time.
// @param added  the name of the array that replaces the selected one; may be empty
void vtkVarimarchPartsMapper::SelectArray(const std::string& added, vtkVolumeMapper* mapper)
{
  if (!added.empty())
  {
    mapper->SelectScalarArray(added.c_str());
  }
  else if (this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME)
  {
    mapper->SelectScalarArray(this->ArrayName);
  }
  else
  {
    mapper->SelectScalarArray(this->ArrayId);
  }
}

void vtkVarimarchPartsMapper::ForwardSettings(vtkVolume* volume)
{
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    vtkVariationFieldVolumeMapper* const mapper = this->Drawers[i]->Mapper;
    varimarch::ScalarsOfLook& scalars = this->Drawers[i]->Scalars;
    scalars.Choose(this->Parts[i].data, this, volume->GetProperty());
    mapper->SetInputDataObject(scalars.Data());
    mapper->SetScalarMode(this->ScalarMode);
    this->SelectArray(scalars.Name(), mapper);
    this->CropPart(this->Parts[i], mapper);
    mapper->SetClippingPlanes(this->ClippingPlanes);
    mapper->SetBlendMode(this->BlendMode);
    mapper->SetErrorTolerance(this->ErrorTolerance);
    mapper->SetAccelerationMode(this->AccelerationMode);
    mapper->SetFinalColorWindow(this->FinalColorWindow);
    mapper->SetShadows(this->Shadows);
    mapper->SetShadowStrength(this->ShadowStrength);
    mapper->SetAmbientOcclusion(this->AmbientOcclusion);
    mapper->SetVolumetricScatteringBlending(this->VolumetricScatteringBlending);
    mapper->SetGlobalIlluminationReach(this->GlobalIlluminationReach);
  }
}

std::vector<int> vtkVarimarchPartsMapper::PartsFrontToBack(vtkRenderer* renderer, vtkVolume* volume)
{
  const glm::dmat4 worldFromData = varimarch::FromVtk(volume->GetMatrix());
  std::vector<varimarch::OwnedBox> boxes;
  for (const varimarch::Box& box : varimarch::BoxesOf(this->Parts))
  {
    boxes.push_back({ box, worldFromData, static_cast<int>(boxes.size()) });
  }
  return varimarch::OwnersFrontToBack(
    boxes, static_cast<int>(boxes.size()), varimarch::ClipFromWorld(renderer))
    .owners;
}

std::optional<varimarch::CommonSteps> vtkVarimarchPartsMapper::FindSteps(
  vtkRenderer* renderer, vtkVolume* volume, const varimarch::SearchingProcesses& processes)
{
  std::vector<vtkVariationFieldVolumeMapper*> mappers;
  if (volume->GetVisibility())
  {
    this->ForwardSettings(volume);
    for (int part : this->PartsFrontToBack(renderer, volume))
    {
      mappers.push_back(this->Drawers[part]->Mapper);
    }
  }
  return this->Search.Find(renderer, volume, mappers, processes);
}

void vtkVarimarchPartsMapper::DrawFrame(vtkRenderer* renderer, vtkVolume* volume)
{
  this->ForwardSettings(volume);
  const std::vector<int> order = this->PartsFrontToBack(renderer, volume);
  for (auto part = order.rbegin(); part != order.rend(); ++part)
  {
    this->Drawers[*part]->Mapper->Render(renderer, volume);
  }
}

void vtkVarimarchPartsMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const std::unique_ptr<Drawer>& drawer : this->Drawers)
  {
    drawer->Mapper->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkVarimarchPartsMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Parts: " << this->Parts.size() << "\n";
}
