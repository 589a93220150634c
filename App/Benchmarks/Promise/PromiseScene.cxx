#include "PromiseScene.h"

#include "Scene/Images/FloatCapture.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiVolume.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTrivialProducer.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

PromiseScene::PromiseScene(std::uint64_t seed, vtkOpenGLRenderWindow* window)
  : dice(seed, 1)
  , window(window)
  , mapper(vtkSmartPointer<vtkVariationFieldVolumeMapper>::New())
{
  this->renderer->SetBackground(0.0, 0.0, 0.0);
  this->renderer->SetBackgroundAlpha(0.0);
  this->renderer->AutomaticLightCreationOff();
  this->mapper->SetErrorTolerance(
    1.0 / this->dice.OneOf<double>({ 16.0, 32.0, 64.0, 64.0, 64.0, 100.0 }));
}

PromiseScene::~PromiseScene()
{
  this->window->RemoveRenderer(this->renderer);
}

namespace
{

void Fill(vtkImageData* image, const PromiseContent& content, std::array<double, 2> scale)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int type = scalars->GetDataType();
  const bool isWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  const int* const size = image->GetDimensions();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const int index = int(i);
    const double value = scale[0] +
      scale[1] * content({ index % size[0], index / size[0] % size[1], index / size[0] / size[1] });
    scalars->SetComponent(i, 0, isWhole ? std::round(value) : value);
  }
  scalars->Modified();
  image->Modified();
}

// The values that stand for contents of 0 and 1 in a type.
std::array<double, 2> ScaleOf(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return { 0.0, 255.0 };
    case VTK_SHORT:
      return { -1024.0, 3000.0 };
    case VTK_UNSIGNED_SHORT:
      return { 100.0, 4000.0 };
    case VTK_INT:
      return { -5000.0, 20000.0 };
    default:
      return { 0.0, 1.0 };
  }
}

}

void PromiseScene::AddVolume(
  glm::ivec3 size, glm::dvec3 spacingMm, const PromiseContent& content, int type)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, size.z);
  image->SetSpacing(spacingMm.x, spacingMm.y, spacingMm.z);
  const glm::dvec3 origin = -0.5 * spacingMm * glm::dvec3(size - 1);
  image->SetOrigin(origin.x, origin.y, origin.z);
  image->AllocateScalars(type, 1);
  Fill(image, content, ScaleOf(type));
  const auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->GetProperty()->SetInterpolationTypeToLinear();
  this->images.push_back(image);
  this->volumes.push_back(volume);
  if (this->images.size() == 2)
  {
    this->adapter = vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New();
    this->adapter->GetVariationFieldMapper()->SetErrorTolerance(this->mapper->GetErrorTolerance());
    this->mapper = this->adapter->GetVariationFieldMapper();
  }
  this->valueScales.push_back(ScaleOf(type));
}

void PromiseScene::Replace(int volume, const PromiseContent& content)
{
  Fill(this->Image(volume), content, this->valueScales[std::size_t(volume)]);
}

void PromiseScene::SetLook(const PromiseNodes& opacities, double unitVoxels, int volume)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AllowDuplicateScalarsOn();
  for (const auto& [value, alpha] : opacities)
  {
    opacity->AddPoint(this->ValueOf(value, volume), alpha);
  }
  vtkNew<vtkColorTransferFunction> color;
  const int colors = this->dice.Whole(2, 4);
  for (int i = 0; i < colors; ++i)
  {
    color->AddRGBPoint(this->ValueOf(i / (colors - 1.0), volume), this->dice.Between(0.2, 1.0),
      this->dice.Between(0.2, 1.0), this->dice.Between(0.2, 1.0));
  }
  const double* const spacing = this->Image(volume)->GetSpacing();
  this->Property(volume)->SetScalarOpacity(opacity);
  this->Property(volume)->SetColor(color);
  this->Property(volume)->SetScalarOpacityUnitDistance(
    unitVoxels * std::min({ spacing[0], spacing[1], spacing[2] }));
}

void PromiseScene::Turn(int volume)
{
  const glm::dvec3 axis = this->Direction();
  this->Volume(volume)->RotateWXYZ(this->dice.Between(0.0, 360.0), axis.x, axis.y, axis.z);
  const double shift = 0.1 * this->DiagonalMm();
  this->Volume(volume)->SetPosition(this->dice.Between(-shift, shift),
    this->dice.Between(-shift, shift), this->dice.Between(-shift, shift));
}

void PromiseScene::Shear(int volume)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 9; ++i)
  {
    const double element = this->dice.Between(-0.35, 0.35);
    matrix->SetElement(i / 3, i % 3, i % 4 == 0 ? 1.0 + element : element);
  }
  this->Volume(volume)->SetUserMatrix(matrix);
}

void PromiseScene::LookFrom(glm::dvec3 direction, double distanceDiagonals)
{
  vtkCamera* const camera = this->renderer->GetActiveCamera();
  const glm::dvec3 middle = this->MiddleMm();
  const glm::dvec3 eye =
    middle + distanceDiagonals * this->DiagonalMm() * glm::normalize(direction);
  const bool isSteep = std::abs(glm::normalize(direction).z) > 0.9;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(middle.x, middle.y, middle.z);
  camera->SetViewUp(0.0, isSteep ? 1.0 : 0.0, isSteep ? 0.0 : 1.0);
}

void PromiseScene::LookFromAnywhere()
{
  if (this->dice.Chance(0.35))
  {
    this->LookInParallel(this->Direction(), this->dice.Between(0.2, 0.5));
    return;
  }
  this->LookFrom(this->Direction(), this->dice.Between(0.8, 2.2));
}

void PromiseScene::LookInParallel(glm::dvec3 direction, double halfDiagonals)
{
  this->LookFrom(direction, 2.0);
  this->renderer->GetActiveCamera()->ParallelProjectionOn();
  this->renderer->GetActiveCamera()->SetParallelScale(halfDiagonals * this->DiagonalMm());
}

double PromiseScene::DiagonalMm()
{
  double bounds[6];
  this->Image(int(this->images.size()) - 1)->GetBounds(bounds);
  const double length =
    glm::length(glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]));
  return std::max(length, 1.0);
}

glm::dvec3 PromiseScene::MiddleMm()
{
  double middle[4];
  this->Image()->GetCenter(middle);
  middle[3] = 1.0;
  this->Volume()->GetMatrix()->MultiplyPoint(middle, middle);
  return { middle[0], middle[1], middle[2] };
}

glm::dvec3 PromiseScene::Direction()
{
  glm::dvec3 direction(0.0);
  while (glm::length(direction) < 0.1 || glm::length(direction) > 1.0)
  {
    direction = glm::dvec3(
      this->dice.Between(-1.0, 1.0), this->dice.Between(-1.0, 1.0), this->dice.Between(-1.0, 1.0));
  }
  return glm::normalize(direction);
}

// Adds the volumes to the renderer, the first time.
void PromiseScene::Show()
{
  if (this->window->HasRenderer(this->renderer))
  {
    return;
  }
  this->window->SetSize(this->side, this->side);
  this->window->AddRenderer(this->renderer);
  if (this->images.size() == 1)
  {
    this->mapper->SetInputData(this->Image());
    this->Volume()->SetMapper(this->mapper);
    this->renderer->AddVolume(this->Volume());
    return;
  }
  this->several = vtkSmartPointer<vtkMultiVolume>::New();
  this->several->SetMapper(this->adapter);
  for (int i = 0; i < int(this->images.size()); ++i)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(this->Image(i));
    this->adapter->SetInputConnection(i, producer->GetOutputPort());
    this->several->SetVolume(this->Volume(i), i);
  }
  this->renderer->AddVolume(this->several);
}

std::vector<float> PromiseScene::Draw()
{
  this->Show();
  this->renderer->ResetCameraClippingRange();
  const auto captured = CaptureFloatImage(this->window, this->renderer);
  const auto* const pixels = static_cast<const float*>(captured->GetScalarPointer());
  return { pixels, pixels + 4 * this->side * this->side };
}

std::vector<float> PromiseScene::DrawBehind()
{
  const bool isSomething = std::any_of(this->actors.begin(), this->actors.end(),
    [](const vtkSmartPointer<vtkActor>& actor) { return actor->GetVisibility() != 0; });
  if (!isSomething)
  {
    return std::vector<float>(std::size_t(4 * this->side * this->side));
  }
  vtkProp* const drawn = this->several ? static_cast<vtkProp*>(this->several) : this->Volume();
  drawn->VisibilityOff();
  const auto captured = CaptureFloatImage(this->window, this->renderer);
  drawn->VisibilityOn();
  const auto* const pixels = static_cast<const float*>(captured->GetScalarPointer());
  return { pixels, pixels + 4 * this->side * this->side };
}

JudgedObjects PromiseScene::Objects()
{
  JudgedObjects objects{ this->renderer, this->mapper, {}, {}, {} };
  objects.images.assign(this->images.begin(), this->images.end());
  objects.volumes.assign(this->volumes.begin(), this->volumes.end());
  objects.actors.assign(this->actors.begin(), this->actors.end());
  return objects;
}

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
