// Shadows of volumes on opaque geometry, compared with integrals in double precision.

#include "Module/Scenes/CubeAboveFloor.h"

#include <vtkElevationFilter.h>
#include <vtkImageData.h>
#include <vtkTexture.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <random>

TEST(Receivers, OfDiffuseLightHaveTheirClosedForm)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

TEST(Receivers, InPerspectiveHaveTheirClosedForm)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.UsePerspective();
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

TEST(Receivers, BehindVoxelsWithoutInterpolationHaveTheirClosedForm)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  cube.ExpectRedIn(
    cube.scene.DrawByProcessor(),
    [](glm::dvec3 place) { return 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

// Squares of half and full brightness.
TEST(Receivers, MayHaveATexture)
{
  CubeAboveFloor cube;
  cube.AddSun();
  vtkNew<vtkImageData> squares;
  squares->SetDimensions(64, 64, 1);
  squares->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 64 * 64; ++i)
  {
    squares->SetScalarComponentFromDouble(
      i % 64, i / 64, 0, 0, (i / 64 + i) % 2 == 0 ? 255.0 : 127.0);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(squares);
  cube.floor->SetTexture(texture);
  const std::vector<float> lit = cube.FloorRed(false);
  EXPECT_LT(*std::min_element(lit.begin(), lit.end()), 0.4f) << "a dark square";
  EXPECT_GT(*std::max_element(lit.begin(), lit.end()), 0.6f) << "a bright square";
  const std::vector<float> bright = cube.scene.DrawByProcessor();
  cube.scene.mapper->ShadowsOn();
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  for (int x = 2; x < 35; x += 3)
  {
    const std::size_t pixel = 4 * (std::size_t(32) * 65 + std::size_t(x));
    const double left = LeftBehindCube(cube.PlaceAt(x, 32), CubeAboveFloor::towardsSun);
    EXPECT_NEAR(drawn[pixel], bright[pixel] * left, OfBytes) << x;
  }
}

TEST(Receivers, KeepAmbientLightAndTheLightOfOtherLamps)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const glm::dvec3 other = glm::normalize(glm::dvec3(-0.3, 0.5, 0.8));
  AddLight(cube.scene.renderer, 100.0 * other, glm::dvec3(0.0))->SetIntensity(0.2);
  cube.floor->GetProperty()->SetAmbient(0.1);
  cube.ExpectRed(
    [&](glm::dvec3 place)
    {
      return 0.1 + 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun) +
        0.2 * 0.8 * other.z * LeftBehindCube(place, other);
    },
    OfBytes);
}

TEST(Receivers, OfALampEndAtIt)
{
  CubeAboveFloor cube;
  const glm::dvec3 lampWorld(5.0, 0.5, 12.0);
  vtkLight* const lamp = AddLight(cube.scene.renderer, lampWorld, { -7.0, 0.0, -6.0 });
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  cube.ExpectRed(
    [&](glm::dvec3 place)
    {
      const glm::dvec3 way = lampWorld - place;
      const glm::dvec3 towards = glm::normalize(way);
      return 0.8 * towards.z * LeftBehindCube(place, towards, glm::length(way));
    },
    OfBytes);
}

TEST(Receivers, AreAsDarkAsShadowsAreStrong)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.mapper->SetShadowStrength(0.5);
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.8 * 0.8 * (0.5 + 0.5 * LeftBehindCube(place, CubeAboveFloor::towardsSun)); },
    OfBytes);
}

// Specular light is VTK's own: what it draws without shadows, times what is left of all light.
TEST(Receivers, OfOneLampKeepTheSamePartOfHighlights)
{
  CubeAboveFloor cube;
  cube.AddSun();
  vtkProperty* const property = cube.floor->GetProperty();
  property->SetDiffuse(0.5);
  property->SetSpecular(0.4);
  property->SetSpecularPower(3.0);
  cube.scene.mapper->ShadowsOff();
  const std::vector<float> lit = cube.scene.DrawByProcessor();
  cube.scene.mapper->ShadowsOn();
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  for (int x = 2; x < 40; x += 3)
  {
    const std::size_t pixel = 4 * (std::size_t(32) * 65 + std::size_t(x));
    const glm::dvec3 place = cube.PlaceAt(x, 32);
    if (place.x < -0.5 * CubeMm)
    {
      EXPECT_NEAR(
        drawn[pixel], lit[pixel] * LeftBehindCube(place, CubeAboveFloor::towardsSun), OfBytes)
        << place.x;
    }
  }
}

// Two colours of lamps, of which one is in the shadow, keep the colour of the other.
TEST(Receivers, AreDimmedColourByColour)
{
  CubeAboveFloor cube;
  cube.AddSun()->SetDiffuseColor(1.0, 0.0, 0.0);
  const glm::dvec3 other(-0.6, 0.0, 0.8);
  AddLight(cube.scene.renderer, 100.0 * other, glm::dvec3(0.0))->SetDiffuseColor(0.0, 1.0, 0.0);
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  const std::size_t pixel = 4 * (std::size_t(32) * 65 + std::size_t(26));
  const glm::dvec3 place = cube.PlaceAt(26, 32);
  EXPECT_NEAR(drawn[pixel], 0.64 * LeftBehindCube(place, CubeAboveFloor::towardsSun), OfBytes);
  EXPECT_LT(drawn[pixel], 0.5);
  EXPECT_NEAR(drawn[pixel + 1], 0.64 * LeftBehindCube(place, other), OfBytes);
  EXPECT_GT(drawn[pixel + 1], 0.6);
}

// VTK multiplies the diffuse colour of a lamp with highlights too, and places the eye at the camera
// in a parallel projection.
TEST(Receivers, ThatAreDarkKeepTheHighlightsOfLampsOutOfTheShadow)
{
  CubeAboveFloor cube;
  cube.AddSun()->SetSpecularColor(0.0, 0.0, 0.0);
  const glm::dvec3 low = glm::normalize(glm::dvec3(0.01, 0.95, 0.3));
  AddLight(cube.scene.renderer, 100.0 * low, glm::dvec3(0.0))->SetIntensity(2.0);
  vtkProperty* const property = cube.floor->GetProperty();
  property->SetDiffuseColor(0.1, 0.1, 0.1);
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetSpecular(0.5);
  property->SetSpecularPower(4.0);
  const glm::dvec3 eye(cube.focus.x, cube.focus.y, 30.0);
  const auto sentBy = [&](glm::dvec3 lamp, glm::dvec3 place)
  {
    const glm::dvec3 mirrored(-lamp.x, -lamp.y, lamp.z);
    const double highlight = std::max(glm::dot(mirrored, glm::normalize(eye - place)), 0.0);
    return (0.08 * lamp.z + 0.5 * std::pow(highlight, 4.0)) * LeftBehindCube(place, lamp);
  };
  cube.ExpectRed([&](glm::dvec3 place)
    { return sentBy(CubeAboveFloor::towardsSun, place) + 2.0 * sentBy(low, place); },
    OfBytes);
}

// Colours of the data replace the diffuse colour; without highlights they are dimmed exactly.
TEST(Receivers, MayHaveTheColorsOfTheirData)
{
  CubeAboveFloor cube;
  cube.AddSun();
  vtkNew<vtkElevationFilter> heights;
  heights->SetInputConnection(cube.floor->GetMapper()->GetInputConnection(0, 0));
  heights->SetLowPoint(0.0, 0.0, FloorZ);
  heights->SetHighPoint(0.0, 0.0, FloorZ + 1.0);
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(heights->GetOutputPort());
  cube.floor->SetMapper(faces);
  cube.floor->GetProperty()->SetDiffuseColor(0.0, 0.0, 0.0);
  cube.floor->GetProperty()->SetAmbientColor(0.0, 0.0, 0.0);
  cube.floor->GetProperty()->SetAmbient(0.1);
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.1 + 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

// A smooth ball beside the cube has the normals of its points, which differ from those of faces.
TEST(Receivers, OfSmoothSurfacesAreLitByTheirNormals)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const glm::dvec3 second = glm::normalize(glm::dvec3(-0.8, 0.0, 0.5));
  AddLight(cube.scene.renderer, 100.0 * second, glm::dvec3(0.0));
  const glm::dvec3 center(-7.0, 0.0, -3.0);
  const auto ball = Ball(glm::value_ptr(center), 2.5);
  ball->GetProperty()->SetDiffuse(0.45);
  cube.scene.renderer->AddActor(ball);
  cube.scene.mapper->ShadowsOff();
  const std::vector<float> lit = cube.scene.DrawByProcessor();
  cube.scene.mapper->ShadowsOn();
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  double largest = 0.0;
  for (int x = 24; x < 46; ++x)
  {
    const glm::dvec3 below = cube.PlaceAt(x, 32) - center;
    const double height = 2.5 * 2.5 - below.x * below.x - below.y * below.y;
    if (height < 2.0)
    {
      continue;
    }
    const glm::dvec3 normal = glm::normalize(glm::dvec3(below.x, below.y, std::sqrt(height)));
    const glm::dvec3 place = center + 2.45 * normal; // the faces lie a little below the sphere
    const double sun = std::max(glm::dot(normal, CubeAboveFloor::towardsSun), 0.0);
    const double other = std::max(glm::dot(normal, second), 0.0);
    const double factor = (sun * LeftBehindCube(place, CubeAboveFloor::towardsSun) +
                            other * LeftBehindCube(place, second)) /
      (sun + other);
    const std::size_t pixel = 4 * (std::size_t(32) * 65 + std::size_t(x));
    EXPECT_NEAR(drawn[pixel], lit[pixel] * factor, 0.03) << x;
    largest = std::max(largest, double(lit[pixel] - drawn[pixel]));
  }
  EXPECT_GT(largest, 0.1);
}

namespace
{

// Voxels as large as the pixels of an image from above, with noise in each second row along x.
vtkSmartPointer<vtkImageData> NoiseInEachSecondRow(int size, double pixelMm)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size / 2, size, size / 4);
  image->SetSpacing(pixelMm, pixelMm, pixelMm);
  image->SetOrigin(0.0, 0.5 * pixelMm * (1 - size), 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::mt19937 random(5);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const bool isNoise = i / (size / 2) % 2 == 0;
    voxels[i] = isNoise ? static_cast<unsigned char>(random() % 201) : 100;
  }
  return image;
}

}

// Only every second row of pixels shows a shadow.
TEST(Receivers, InShadowsBetweenRowsKeepTheTolerance)
{
  constexpr int Size = 96;
  constexpr double HalfMm = 12.0;
  MapperScene scene(NoiseInEachSecondRow(Size, 2.0 * HalfMm / Size), Size);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(40.0, 0.0);
  scene.opacities->AddPoint(50.0, 0.6);
  scene.opacities->AddPoint(60.0, 0.0);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->ShadowsOn();
  scene.renderer->AutomaticLightCreationOff();
  AddLight(scene.renderer, { 100.0, 0.0, 100.0 }, glm::dvec3(0.0));
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-40.0, -40.0, FloorZ);
  plane->SetPoint1(40.0, -40.0, FloorZ);
  plane->SetPoint2(-40.0, 40.0, FloorZ);
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> floor;
  floor->SetMapper(faces);
  scene.renderer->AddActor(floor);
  scene.LookDown(glm::dvec3(-HalfMm - 1.0, 0.0, 0.0), HalfMm);

  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const std::vector<float> drawn = scene.DrawByProcessor();
  scene.mapper->SetErrorTolerance(0.0);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.01 * HalfMm / Size);
  const std::vector<float> fine = scene.DrawByProcessor();
  const varimarch::ImageError error =
    varimarch::CompareImages(drawn.data(), fine.data(), fine.size() / 4);
  EXPECT_LE(error.percentile999, 255.0 / 64.0 + 255.0 * OfBytes);
}
