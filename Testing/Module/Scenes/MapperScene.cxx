#include "Module/Scenes/MapperScene.h"

#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

vtkSmartPointer<vtkImageData> SmallTorso()
{
  return ProceduralVolume({ ProceduralKind::Torso, { 40, 36, 24 }, 7 });
}

vtkSmartPointer<vtkImageData> TorsoOfCells()
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 37, 25);
  image->SetSpacing(torso->GetSpacing());
  image->SetOrigin(torso->GetOrigin());
  image->GetCellData()->SetScalars(torso->GetPointData()->GetScalars());
  return image;
}

vtkSmartPointer<vtkActor> Ball(const double centerWorld[3], double radiusMm)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centerWorld[0], centerWorld[1], centerWorld[2]);
  sphere->SetRadius(radiusMm);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(surface);
  return actor;
}

void UseDepthPeeling(vtkRenderer* renderer)
{
  renderer->UseDepthPeelingOn();
  renderer->UseDepthPeelingForVolumesOn();
  renderer->SetOcclusionRatio(0.0);
  renderer->SetMaximumNumberOfPeels(20);
}

ImageError LargerError(
  const std::vector<float>& one, const std::vector<float>& other, const std::vector<float>& truth)
{
  const ImageError a = CompareImages(one.data(), truth.data(), truth.size() / 4);
  const ImageError b = CompareImages(other.data(), truth.data(), truth.size() / 4);
  return { std::max(a.rootMeanSquare, b.rootMeanSquare), std::max(a.percentile999, b.percentile999),
    std::max(a.largest, b.largest) };
}

MapperScene::MapperScene(vtkImageData* image, int size, vtkHeadlessRenderWindow* window)
  : VolumeStage(image, size, window)
{
  this->mapper->SetErrorTolerance(0.0); // tests of the tolerance set their own
  this->mapper->ProcessorMarchingOff(); // most tests are about shaders

  // Soft tissue is a veil, bone nearly opaque: visible, invisible and homogeneous regions.
  this->colors->AddRGBPoint(-200.0, 0.8, 0.5, 0.4);
  this->colors->AddRGBPoint(150.0, 0.9, 0.3, 0.2);
  this->colors->AddRGBPoint(400.0, 1.0, 0.95, 0.85);
  this->opacities->AddPoint(-200.0, 0.0);
  this->opacities->AddPoint(0.0, 0.01);
  this->opacities->AddPoint(150.0, 0.01);
  this->opacities->AddPoint(400.0, 0.2);
}

void MapperScene::LookDown(glm::dvec3 focusWorld, double halfMm)
{
  vtkCamera* const camera = this->renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(halfMm);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetFocalPoint(focusWorld.x, focusWorld.y, focusWorld.z);
  camera->SetPosition(focusWorld.x, focusWorld.y, 30.0);
  camera->SetClippingRange(1.0, 100.0);
}

ImageError MapperScene::ErrorOf(const Material& material, double tolerance)
{
  return this->ErrorTo(this->TruthOf(material, tolerance));
}

std::array<float, 4> MapperScene::MiddlePixel()
{
  const std::vector<float> marched = this->DrawByProcessor();
  const std::vector<float> drawn = this->Draw();
  const std::size_t middle = 4 * (std::size_t(this->size / 2) * this->size + this->size / 2);
  for (std::size_t i = middle; i < middle + 4; ++i)
  {
    EXPECT_NEAR(marched[i], drawn[i], 1e-3) << "the processor's and the shader's";
  }
  return { drawn[middle], drawn[middle + 1], drawn[middle + 2], drawn[middle + 3] };
}

std::vector<float> MapperScene::DrawByProcessor()
{
  this->mapper->ProcessorMarchingOn();
  const std::vector<float> drawn = this->Draw();
  this->mapper->ProcessorMarchingOff();
  return drawn;
}

ImageError MapperScene::Error()
{
  return this->ErrorTo(this->Truth());
}

ImageError MapperScene::ErrorTo(const std::vector<float>& truth)
{
  const std::vector<float> marched = this->DrawByProcessor();
  return LargerError(marched, this->Draw(), truth);
}

std::vector<std::string> MapperScene::ShaderParts()
{
  vtkNew<vtkStringArray> parts;
  this->mapper->GetShaderParts(parts);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < parts->GetNumberOfValues(); ++i)
  {
    names.push_back(parts->GetValue(i));
  }
  return names;
}

bool MapperScene::UsesShaderPart(const std::string& part)
{
  const std::vector<std::string> parts = this->ShaderParts();
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}
