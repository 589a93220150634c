// Rectilinear grids: values are interpolated between their coordinates, and lengths are measured in
// the world.

#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/UnevenGrid.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

const Places Uneven = { UnevenPlaces(10, 18.0, 2.0), UnevenPlaces(9, 15.0, 0.6),
  UnevenPlaces(11, 20.0, 1.0) };

void UseGentleMaterials(MapperScene& scene)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 0.9, 0.3, 0.2);
  scene.colors->AddRGBPoint(1.0, 0.2, 0.6, 0.9);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(1.0, 0.2);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.05);
  scene.mapper->SetEarlyTerminationTransmittance(1e-4);
}

}

TEST(Rectilinear, ValuesAreBetweenTheirCoordinatesWhateverTheVolumesMatrix)
{
  MapperScene scene(EvenImage(Uneven), 48);
  UseGentleMaterials(scene);
  scene.volume->SetScale(1.2, 0.8, 1.0);
  scene.volume->RotateZ(20.0);
  scene.mapper->SetInputData(WaveGrid(Uneven));
  scene.renderer->ResetCamera();
  const ImageError error = scene.ErrorOf(UnevenMaterial(scene, Uneven));
  EXPECT_LT(error.rootMeanSquare, 0.1);
  EXPECT_LT(error.largest, 1.0);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.3f) << "nothing is visible";
}

TEST(Rectilinear, AnEvenGridIsDrawnAsTheImageItIs)
{
  const Places even = { UnevenPlaces(10, 18.0, 1.0), UnevenPlaces(9, 15.0, 1.0),
    UnevenPlaces(11, 20.0, 1.0) };
  const auto grid = WaveGrid(even);
  const auto image = EvenImage(even);
  image->GetPointData()->SetScalars(grid->GetPointData()->GetScalars());
  MapperScene scene(image, 48);
  UseGentleMaterials(scene);
  scene.mapper->SetAccelerationModeToOff();
  for (const bool shade : { false, true })
  {
    scene.volume->GetProperty()->SetShade(shade);
    scene.mapper->SetInputData(image);
    const std::vector<float> ofImage = scene.Draw();
    scene.mapper->SetInputData(grid);
    const std::vector<float> ofGrid = scene.Draw();
    EXPECT_LT(CompareImages(ofGrid.data(), ofImage.data(), 48 * 48).largest, 0.3);
  }
}

// Other coordinates move a ball of voxels, and with it the bricks that must not be skipped.
TEST(Rectilinear, BricksAreWhereTheCoordinatesPutThem)
{
  const Places places = { UnevenPlaces(40, 18.0, 2.0), UnevenPlaces(36, 15.0, 0.6),
    UnevenPlaces(44, 20.0, 1.5) };
  const auto grid = WaveGrid(places);
  vtkDataArray* const values = grid->GetPointData()->GetScalars();
  for (int i = 0; i < int(values->GetNumberOfTuples()); ++i)
  {
    const glm::dvec3 fromMiddle(i % 40 - 12.0, i / 40 % 36 - 9.0, i / (40 * 36) - 24.0);
    values->SetComponent(i, 0, glm::dot(fromMiddle, fromMiddle) < 36.0 ? 1.0 : 0.0);
  }
  MapperScene scene(EvenImage(places), 48);
  MapperScene withoutField(scene.image, 48);
  withoutField.mapper->SetAccelerationModeToOff();
  for (MapperScene* one : { &scene, &withoutField })
  {
    UseGentleMaterials(*one);
    one->mapper->SetInputData(grid);
    one->mapper->SetSampleDistance(0.01);
    one->opacities->RemoveAllPoints();
    one->opacities->AddPoint(0.75, 0.0); // shows only the ball
    one->opacities->AddPoint(1.0, 0.9);
  }
  std::vector<float> last(4 * 48 * 48);
  for (const double power : { 2.0, 1.0, 0.7 })
  {
    vtkDataArray* const xs = grid->GetXCoordinates();
    const std::vector<double> moved = UnevenPlaces(40, 18.0, power);
    std::copy(moved.begin(), moved.end(), static_cast<double*>(xs->GetVoidPointer(0)));
    xs->Modified(); // the grid does not report changes of its coordinates
    const std::vector<float> marched = scene.DrawByProcessor();
    const std::vector<float> drawn = scene.Draw();
    EXPECT_TRUE(scene.UsesShaderPart("Step/OpticalField.glsl"));
    EXPECT_GT(CompareImages(drawn.data(), last.data(), 48 * 48).largest, 20.0);
    const std::vector<float> truth = withoutField.Draw();
    EXPECT_LT(CompareImages(drawn.data(), truth.data(), 48 * 48).largest, 1.0);
    EXPECT_LT(CompareImages(marched.data(), truth.data(), 48 * 48).largest, 1.0);
    last = drawn;
  }
}

class ProcessorMarchingOfUnevenPlaces
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingOfUnevenPlaces, IsThePictureOfTheShader)
{
  MapperScene scene(EvenImage(Uneven), 48);
  UseGentleMaterials(scene);
  scene.mapper->SetInputData(WaveGrid(Uneven));
  scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  GetParam().make(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, ProcessorMarchingOfUnevenPlaces,
  testing::Values(Change{ "Plain", [](MapperScene&) {} },
    Change{ "WithoutField", [](MapperScene& s) { s.mapper->SetAccelerationModeToOff(); } },
    Change{ "InLight",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.mapper->SetSampleDistance(0.02f);
      } },
    Change{ "WithOpacityOfGradientsAndClipped",
      [](MapperScene& s)
      {
        vtkNew<vtkPiecewiseFunction> factors;
        factors->AddPoint(0.0, 0.1);
        factors->AddPoint(0.2, 1.0);
        s.volume->GetProperty()->SetGradientOpacity(factors);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(9.0, 7.0, 10.0);
        plane->SetNormal(1.0, 0.3, 0.5);
        s.mapper->AddClippingPlane(plane);
      } }),
  NameOf);

TEST_F(ProcessorMarching, KeepsTablesOfUnevenGridsOffTheDevice)
{
  MapperScene scene(EvenImage(Uneven), 48);
  UseGentleMaterials(scene);
  scene.mapper->SetInputData(WaveGrid(Uneven));
  scene.Draw();
  const vtkIdType bytesOfShader = scene.mapper->GetGraphicsMemoryBytes();
  ASSERT_TRUE(ByProcessor(scene));
  const vtkIdType bytesOfPixels = 4 * sizeof(float) * 48 * 48;
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), bytesOfPixels);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytesOfShader);
}

// One axis has cells of 1, 2, 4 and 8 mm; it is seen along another axis in parallel projection, 1
// mm per pixel.
TEST(Rectilinear, CellsWithoutInterpolationGoFromFaceToFace)
{
  const Places places = { std::vector<double>{ 0.0, 1.0, 3.0, 7.0, 15.0 },
    std::vector<double>{ 0.0, 15.0 }, std::vector<double>{ 0.0, 1.0 } };
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(5, 2, 2);
  grid->SetXCoordinates(ArrayOf(places[0]));
  grid->SetYCoordinates(ArrayOf(places[1]));
  grid->SetZCoordinates(ArrayOf(places[2]));
  vtkNew<vtkFloatArray> values;
  for (float value : { 1.0f, 2.0f, 3.0f, 4.0f })
  {
    values->InsertNextValue(value);
  }
  grid->GetCellData()->SetScalars(values);
  MapperScene scene(EvenImage(places), 16);
  scene.mapper->SetInputData(grid);
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(10.0, 1.0);
  scene.LookDown({ 8.0, 8.0, 0.0 }, 8.0);
  const std::vector<float> drawn = scene.Draw();
  for (int column = 0; column < 15; ++column)
  {
    const double expected = column < 1 ? 0.1 : column < 3 ? 0.2 : column < 7 ? 0.3 : 0.4;
    EXPECT_NEAR(drawn[4 * (8 * 16 + column) + 3], expected, 1e-4) << column;
  }
  EXPECT_EQ(drawn[4 * (8 * 16 + 15) + 3], 0.0f) << "beyond the last cell";
}
