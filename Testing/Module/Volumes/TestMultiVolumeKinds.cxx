// Every kind of volume among overlapping volumes.

#include "Module/Scenes/OverlapScene.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

namespace
{

// A volume that has more than one scalar at each point of an image.
struct Kind
{
  const char* name;
  std::function<vtkSmartPointer<vtkDataSet>(vtkVolumeProperty*)> make;
};

std::ostream& operator<<(std::ostream& stream, const Kind& kind)
{
  return stream << kind.name;
}

vtkSmartPointer<vtkImageData> BallsOf(int components)
{
  const auto image = ImageOf(VTK_SHORT, components, BallValue, { 17, 17, 17 });
  image->SetOrigin(-8.0, -8.0, -8.0);
  return image;
}

vtkSmartPointer<vtkDataSet> TwoMaterials(vtkVolumeProperty* property)
{
  SetLook(property, 1, looks[1]);
  return BallsOf(2);
}

vtkSmartPointer<vtkDataSet> Colored(vtkVolumeProperty* property)
{
  property->IndependentComponentsOff();
  return BallsOf(4);
}

vtkSmartPointer<vtkDataSet> WithGradientOpacity(vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.2);
  factors->AddPoint(15.0, 1.0);
  property->SetGradientOpacity(factors);
  property->ShadeOn();
  return BallsOf(1);
}

vtkSmartPointer<vtkDataSet> OfTwoValues(vtkVolumeProperty* property)
{
  property->SetTransferFunction2D(ImageOf(VTK_FLOAT, 4,
    [](glm::ivec3 place, int component) { return component == 3 ? 0.02 * place.x : 0.1 * place.y; },
    { 9, 8, 1 }));
  return BallsOf(1);
}

vtkSmartPointer<vtkDataSet> OfCells(vtkVolumeProperty*)
{
  const auto balls = BallsOf(1);
  const auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(18, 18, 18);
  cells->SetOrigin(-8.5, -8.5, -8.5);
  cells->GetCellData()->SetScalars(balls->GetPointData()->GetScalars());
  return cells;
}

vtkSmartPointer<vtkDataSet> Uneven(vtkVolumeProperty*)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(17, 17, 17);
  vtkNew<vtkDoubleArray> coordinates;
  for (int i = 0; i < 17; ++i)
  {
    coordinates->InsertNextValue(i * (0.5 + i / 32.0) - 8.0);
  }
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  grid->GetPointData()->SetScalars(BallsOf(1)->GetPointData()->GetScalars());
  return grid;
}

}

class KindOfVolume : public testing::TestWithParam<Kind>
{
};

TEST_P(KindOfVolume, IsUnchangedInsideAnInvisibleVolume)
{
  vtkNew<vtkVolume> volume;
  SetLook(volume->GetProperty(), 0, looks[0]);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  const vtkSmartPointer<vtkDataSet> data = GetParam().make(volume->GetProperty());
  volume->RotateWXYZ(30.0, 1.0, 2.0, 0.0);
  OverlapScene scene;
  scene.mapper->GetVariationFieldMapper()->SetErrorTolerance(0.5 / 255.0);
  scene.mapper->SetInputDataObject(0, data);
  scene.several->SetVolume(volume, 0);
  scene.renderer->AddVolume(scene.several);
  const std::vector<float> alone = scene.Draw();
  for (const int port : { 1, 2 })
  {
    vtkVolume* const cloud =
      scene.Add(port, HomogeneousBox({ 6.0, 30.0, 7.0 }), { { 0.9, 0.2, 0.1 }, 0.0, 1.0, 0.1 });
    vtkNew<vtkPiecewiseFunction> clear;
    clear->AddPoint(0.0, 0.0);
    cloud->GetProperty()->SetScalarOpacity(clear);
    cloud->RotateZ(20.0 * port);
  }
  const std::vector<float> inCloud = scene.Draw();
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  EXPECT_LT(CompareImages(inCloud.data(), alone.data(), alone.size() / 4).largest, 2.0);
  EXPECT_GT(*std::max_element(alone.begin(), alone.end()), 0.3) << "the image is empty";
}

INSTANTIATE_TEST_SUITE_P(Kinds, KindOfVolume,
  testing::Values(Kind{ "TwoMaterials", TwoMaterials }, Kind{ "Colored", Colored },
    Kind{ "WithGradientOpacity", WithGradientOpacity }, Kind{ "OfTwoValues", OfTwoValues },
    Kind{ "OfCells", OfCells }, Kind{ "Uneven", Uneven }));
