#include "Module/Scenes/HomogeneousScene.h"

#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cmath>

vtkSmartPointer<vtkImageData> HomogeneousCube(double sideMm)
{
  constexpr int Voxels = 17;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Voxels, Voxels, Voxels);
  const double spacing = sideMm / (Voxels - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-0.5 * sideMm, -0.5 * sideMm, -0.5 * sideMm);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  return image;
}

void UseOneMaterial(vtkVolumeProperty* property, const std::array<double, 3>& rgb, double opacity)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, rgb[0], rgb[1], rgb[2]);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, opacity);
  opacities->AddPoint(2.0, opacity);
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
}

HomogeneousScene::HomogeneousScene(double opacityPerMm, int size)
  : MapperScene(HomogeneousCube(SideMm), size)
  , opacityPerMm(opacityPerMm)
{
  UseOneMaterial(this->volume->GetProperty(), this->rgb, opacityPerMm);
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 100.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.49 * SideMm);
  camera->SetClippingRange(50.0, 150.0);
}

std::array<double, 4> HomogeneousScene::Piece(double lengthMm) const
{
  const double alpha = 1.0 - std::pow(1.0 - this->opacityPerMm, lengthMm);
  return { alpha * this->rgb[0], alpha * this->rgb[1], alpha * this->rgb[2], alpha };
}

vtkSmartPointer<vtkActor> Plane(double zMm, double fromXMm, const std::array<double, 3>& rgb)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(fromXMm, -1000.0, zMm);
  source->SetPoint1(1000.0, -1000.0, zMm);
  source->SetPoint2(fromXMm, 1000.0, zMm);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(rgb[0], rgb[1], rgb[2]);
  return actor;
}

std::array<double, 4> Over(const std::array<double, 4>& front, const std::array<double, 4>& back)
{
  std::array<double, 4> sum{};
  for (int channel = 0; channel < 4; ++channel)
  {
    sum[channel] = front[channel] + (1.0 - front[3]) * back[channel];
  }
  return sum;
}
