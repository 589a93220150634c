#include "PromiseScene.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace varimarch
{

void PromiseScene::Shade(double specular)
{
  for (const vtkSmartPointer<vtkVolume>& volume : this->volumes)
  {
    vtkVolumeProperty* const property = volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(this->dice.Between(0.05, 0.4));
    property->SetDiffuse(this->dice.Between(0.5, 0.9));
    property->SetSpecular(specular);
    property->SetSpecularPower(this->dice.Between(3.0, 30.0));
  }
}

vtkLight* PromiseScene::AddHeadLight()
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  this->renderer->AddLight(light);
  return light;
}

vtkLight* PromiseScene::AddDistantLight()
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  const glm::dvec3 from = 100.0 * this->DiagonalMm() * this->Direction();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(
    this->dice.Between(0.6, 1.0), this->dice.Between(0.6, 1.0), this->dice.Between(0.6, 1.0));
  light->SetAmbientColor(1.0, 1.0, 1.0);
  this->renderer->AddLight(light);
  return light;
}

vtkLight* PromiseScene::AddLamp(bool outside)
{
  vtkLight* const light = this->AddDistantLight();
  const double far = outside ? this->dice.Between(0.7, 2.0) : this->dice.Between(0.1, 0.4);
  const glm::dvec3 from = this->MiddleMm() + far * this->DiagonalMm() * this->Direction();
  const glm::dvec3 to = this->MiddleMm();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(to.x, to.y, to.z);
  light->PositionalOn();
  light->SetConeAngle(this->dice.OneOf<double>({ 180.0, this->dice.Between(15.0, 60.0) }));
  light->SetExponent(this->dice.OneOf<double>({ 0.0, 1.0, 4.0 }));
  light->SetAttenuationValues(1.0, this->dice.Between(0.0, 0.02), this->dice.Between(0.0, 0.001));
  return light;
}

void PromiseScene::AddClippingPlane()
{
  vtkNew<vtkPlane> plane;
  const glm::dvec3 normal = this->Direction();
  const glm::dvec3 origin =
    this->MiddleMm() + this->dice.Between(-0.2, 0.1) * this->DiagonalMm() * normal;
  plane->SetNormal(normal.x, normal.y, normal.z);
  plane->SetOrigin(origin.x, origin.y, origin.z);
  this->mapper->AddClippingPlane(plane);
}

void PromiseScene::Crop()
{
  double bounds[6];
  this->Image()->GetBounds(bounds);
  double planes[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double width = bounds[2 * axis + 1] - bounds[2 * axis];
    planes[2 * axis] = bounds[2 * axis] + this->dice.Between(-0.1, 0.4) * width;
    planes[2 * axis + 1] = planes[2 * axis] + this->dice.Between(0.15, 0.6) * width;
  }
  this->mapper->CroppingOn();
  this->mapper->SetCroppingRegionPlanes(planes);
  this->mapper->SetCroppingRegionFlags(this->dice.OneOf<int>({ VTK_CROP_SUBVOLUME, VTK_CROP_FENCE,
    VTK_CROP_CROSS, VTK_CROP_INVERTED_CROSS, this->dice.Whole(1, 0x7ffffff) }));
}

void PromiseScene::SetMask(bool isBinary)
{
  const auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(this->Image());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const glm::dvec3 normal = this->Direction();
  const int* const size = mask->GetDimensions();
  const double wave = this->dice.Between(0.4, 1.5);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    const glm::ivec3 voxel(
      int(i) % size[0], int(i) / size[0] % size[1], int(i) / size[0] / size[1]);
    const double way =
      glm::dot(normal, glm::dvec3(voxel) - 0.5 * glm::dvec3(size[0], size[1], size[2]));
    mask->GetPointData()->GetScalars()->SetComponent(
      i, 0, std::floor(1.49 + 1.4 * std::sin(wave * way)));
  }
  this->mapper->SetMaskInput(mask);
  isBinary ? this->mapper->SetMaskTypeToBinary() : this->mapper->SetMaskTypeToLabelMap();
  for (int label = 1; label <= 2 && !isBinary; ++label)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(this->ValueOf(this->dice.Between(0.0, 0.4)), 0.0);
    opacity->AddPoint(this->ValueOf(this->dice.Between(0.5, 0.9)), this->dice.Between(0.05, 0.8));
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(
      this->ValueOf(0.0), this->dice.Between(0.2, 1.0), this->dice.Between(0.2, 1.0), 0.5);
    color->AddRGBPoint(this->ValueOf(1.0), 0.4, this->dice.Between(0.2, 1.0), 1.0);
    this->Property()->SetLabelScalarOpacity(label, opacity);
    this->Property()->SetLabelColor(label, color);
  }
}

vtkActor* PromiseScene::AddGeometry(glm::dvec3 atDiagonals, double sizeDiagonals, bool isSeen)
{
  vtkNew<vtkCubeSource> cube;
  const glm::dvec3 center = this->MiddleMm() + this->DiagonalMm() * atDiagonals;
  cube->SetCenter(center.x, center.y, center.z);
  cube->SetXLength(sizeDiagonals * this->DiagonalMm() * this->dice.Between(0.3, 1.0));
  cube->SetYLength(sizeDiagonals * this->DiagonalMm() * this->dice.Between(0.3, 1.0));
  cube->SetZLength(sizeDiagonals * this->DiagonalMm() * this->dice.Between(0.3, 1.0));
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(cube->GetOutputPort());
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(faces);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.3, 0.7, this->dice.Between(0.2, 0.9));
  if (isSeen)
  {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
    actor->SetPropertyKeys(keys);
  }
  this->actors.push_back(actor);
  this->renderer->AddActor(actor);
  return actor;
}

}
