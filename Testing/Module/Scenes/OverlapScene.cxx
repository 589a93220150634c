#include "Module/Scenes/OverlapScene.h"

#include "Core/Reference/ReferenceIntegrator.h"
#include "Scene/Images/FloatCapture.h"

#include <vtkObjectFactory.h>
#include <vtkStringArray.h>

#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr double HalfViewMm = 12.0;
const Box viewWorld{ glm::dvec3(-2.0 * HalfViewMm), glm::dvec3(2.0 * HalfViewMm) };

// VTK's class takes its bounds from a vtkGPUVolumeRayCastMapper.
class vtkVolumesInView : public vtkMultiVolume
{
public:
  static vtkVolumesInView* New();
  vtkTypeMacro(vtkVolumesInView, vtkMultiVolume);

  double* GetBounds() override
  {
    for (int i = 0; i < 6; ++i)
    {
      this->Bounds[i] = (i % 2 == 0 ? -2.0 : 2.0) * HalfViewMm;
    }
    return this->Bounds;
  }
};

vtkStandardNewMacro(vtkVolumesInView);

}

std::optional<glm::dvec3> WorldMaterial::PlaceOf(glm::dvec3 positionWorld) const
{
  const glm::dvec3 place(
    glm::inverse(this->geometry.worldFromGrid) * glm::dvec4(positionWorld, 1.0));
  const Box& box = this->geometry.boxGrid;
  const bool isOutside =
    glm::any(glm::lessThan(place, box.lower)) || glm::any(glm::greaterThan(place, box.upper));
  return isOutside ? std::nullopt : std::optional(this->nearest ? glm::floor(place + 0.5) : place);
}

double WorldMaterial::ValueAt(glm::dvec3 placeGrid) const
{
  return this->Grid().Value(placeGrid);
}

glm::dvec3 WorldMaterial::NormalAt(glm::dvec3 placeGrid) const
{
  return glm::normalize(this->geometry.WorldFromGridNormal() * this->Grid().Gradient(placeGrid));
}

double WorldMaterial::ExtinctionOf(double value) const
{
  return -std::log1p(-OpacityOf(this->look, value));
}

OpticalProperties WorldMaterial::At(glm::dvec3 positionWorld, glm::dvec3 toEye) const
{
  const std::optional<glm::dvec3> place = this->PlaceOf(positionWorld);
  if (!place)
  {
    return { glm::dvec3(0.0), 0.0 };
  }
  const double facing = std::abs(glm::dot(this->NormalAt(*place), glm::normalize(toEye)));
  const glm::dvec3 color = this->look.color;
  return { this->shaded ? color * (0.1 + 0.7 * facing) + 0.2 * std::pow(facing, 10.0) : color,
    this->ExtinctionOf(this->ValueAt(*place)) };
}

OverlapScene::OverlapScene(int size)
  : size(size)
{
  this->window->SetSize(size, size);
  this->window->AddRenderer(this->renderer);
  this->several->SetMapper(this->mapper);
  this->mapper->GetVariationFieldMapper()->SetErrorTolerance(0.0);
  this->mapper->GetVariationFieldMapper()->ProcessorMarchingOff();
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(HalfViewMm);
  camera->SetPosition(0.0, 0.0, 100.0);
  camera->SetClippingRange(50.0, 150.0);
}

vtkVolume* OverlapScene::Add(int port, vtkImageData* image, const ComponentLook& look)
{
  Part part{ image, vtkSmartPointer<vtkVolume>::New(), look };
  SetLook(part.volume->GetProperty(), 0, look);
  part.volume->GetProperty()->SetInterpolationTypeToLinear();
  this->mapper->SetInputDataObject(port, image);
  this->several->SetVolume(part.volume, port);
  this->renderer->AddVolume(this->several);
  this->parts[port] = part;
  return part.volume;
}

void OverlapScene::Remove(int port)
{
  this->mapper->RemoveInputConnection(port, 0);
  this->several->RemoveVolume(port);
  this->parts.erase(port);
}

void OverlapScene::UseMapperItself()
{
  vtkVariationFieldVolumeMapper* const itself = MapperOf(*this);
  this->renderer->RemoveVolume(this->several);
  this->several = vtkSmartPointer<vtkVolumesInView>::New();
  this->several->SetMapper(itself);
  for (const auto& [port, part] : this->parts)
  {
    itself->SetInputDataObject(port, part.image);
    this->several->SetVolume(part.volume, port);
  }
  this->renderer->AddVolume(this->several);
}

std::vector<float> OverlapScene::Draw()
{
  const auto captured = CaptureFloatImage(this->window, this->renderer);
  const auto* pixels = static_cast<const float*>(captured->GetScalarPointer());
  return std::vector<float>(pixels, pixels + 4 * this->size * this->size);
}

std::vector<float> OverlapScene::DrawByProcessor()
{
  this->mapper->GetVariationFieldMapper()->ProcessorMarchingOn();
  const std::vector<float> drawn = this->Draw();
  this->mapper->GetVariationFieldMapper()->ProcessorMarchingOff();
  return drawn;
}

PixelRays OverlapScene::RaysWorld()
{
  return ComputePixelRays(ClipFromWorld(this->renderer), viewWorld);
}

std::vector<vtkVolume*> OverlapScene::Volumes() const
{
  std::vector<vtkVolume*> volumes;
  for (const auto& [port, part] : this->parts)
  {
    volumes.push_back(part.volume);
  }
  return volumes;
}

std::vector<WorldMaterial> OverlapScene::Materials() const
{
  std::vector<WorldMaterial> materials;
  for (const auto& [port, part] : this->parts)
  {
    vtkVolumeProperty* const property = part.volume->GetProperty();
    const auto* voxels = static_cast<const double*>(part.image->GetScalarPointer());
    materials.push_back({ VolumeGeometryOf(part.image, part.volume),
      { voxels, voxels + part.image->GetNumberOfPoints() }, part.look,
      property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION, property->GetShade() != 0 });
  }
  return materials;
}

std::vector<float> OverlapScene::TruthOf(
  const std::vector<MaterialInWorld>& materials, double tolerance)
{
  ReferenceScene scene{ {}, viewWorld, TransferFunction({}, {}, 1.0) };
  scene.material = [&](glm::dvec3 position, const Ray& ray)
  {
    OpticalProperties sum{ glm::dvec3(0.0), 0.0 };
    for (const MaterialInWorld& material : materials)
    {
      const OpticalProperties one = material(position, -ray.direction);
      sum.rgb += one.extinction * one.rgb;
      sum.extinction += one.extinction;
    }
    return OpticalProperties{ sum.rgb / std::max(sum.extinction, 1e-300), sum.extinction };
  };
  const ReferenceView view{ this->RaysWorld(), glm::dmat3(1.0), this->size, this->size };
  return DrawReference(ReferenceIntegrator(scene, tolerance), view)->rgba;
}

std::vector<float> OverlapScene::Truth()
{
  std::vector<MaterialInWorld> materials;
  for (const WorldMaterial& material : this->Materials())
  {
    materials.emplace_back(
      [material](glm::dvec3 position, glm::dvec3 toEye) { return material.At(position, toEye); });
  }
  return this->TruthOf(materials, 1e-4);
}

ImageError OverlapScene::Error()
{
  const std::vector<float> truth = this->Truth();
  const std::vector<float> marched = this->DrawByProcessor();
  return LargerError(marched, this->Draw(), truth);
}

std::vector<std::string> OverlapScene::ShaderParts()
{
  vtkNew<vtkStringArray> parts;
  this->mapper->GetVariationFieldMapper()->GetShaderParts(parts);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < parts->GetNumberOfValues(); ++i)
  {
    names.push_back(parts->GetValue(i));
  }
  return names;
}

bool UsesPart(OverlapScene& scene, const std::string& folder)
{
  const std::vector<std::string> parts = scene.ShaderParts();
  return std::any_of(parts.begin(), parts.end(),
    [&](const std::string& part) { return part.rfind(folder, 0) == 0; });
}

vtkSmartPointer<vtkImageData> CenteredImage(
  glm::ivec3 dimensions, glm::dvec3 sizeMm, const std::function<double(glm::dvec3 voxel)>& value)
{
  auto image = ImageOf(
    VTK_DOUBLE, 1, [&](glm::ivec3 voxel, int) { return value(glm::dvec3(voxel)); }, dimensions);
  const glm::dvec3 spacing = sizeMm / glm::dvec3(dimensions - 1);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(-0.5 * sizeMm.x, -0.5 * sizeMm.y, -0.5 * sizeMm.z);
  return image;
}

vtkSmartPointer<vtkImageData> HomogeneousBox(glm::dvec3 sizeMm)
{
  return CenteredImage({ 5, 4, 6 }, sizeMm, [](glm::dvec3) { return 1.0; });
}

double BallField(glm::dvec3 place, glm::dvec3 center)
{
  return 130.0 - 16.0 * glm::length(place - center);
}

void AddBalls(OverlapScene& scene, const BallLooks& looks, const int (&ports)[2])
{
  const auto first = CenteredImage({ 14, 15, 13 }, { 18.0, 16.0, 17.0 },
    [](glm::dvec3 voxel) {
      return BallField(voxel, { 6.0, 7.0, 6.0 });
    });
  const auto second = CenteredImage({ 15, 12, 16 }, { 16.0, 18.0, 15.0 },
    [](glm::dvec3 voxel) {
      return BallField(voxel * glm::dvec3(1.0, 1.3, 0.9), { 7.0, 7.0, 7.0 });
    });
  vtkVolume* const one = scene.Add(ports[0], first, ballLooks[0]);
  one->RotateWXYZ(25.0, 1.0, 1.0, 0.0);
  one->GetProperty()->SetShade(looks.firstShaded);
  vtkVolume* const other = scene.Add(ports[1], second, ballLooks[1]);
  other->SetPosition(3.0, 2.0, -1.0);
  other->RotateWXYZ(50.0, 0.0, 1.0, 1.0);
  other->GetProperty()->SetShade(looks.secondShaded);
  if (looks.firstNearest)
  {
    one->GetProperty()->SetInterpolationTypeToNearest();
  }
  if (looks.secondNearest)
  {
    other->GetProperty()->SetInterpolationTypeToNearest();
  }
}
