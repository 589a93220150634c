// Shadows of volumes on opaque geometry, compared with integrals in double precision.

#include "Module/MapperScene.h"
#include "Module/UsualSettings.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double OpacityPerMm = 0.15;
constexpr double CubeMm = 8.0;
constexpr double FloorZ = -6.0;

// A cube of the same material everywhere, which is too dark to be seen, from z = 0 up.
vtkSmartPointer<vtkImageData> Cube()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 9, 9);
  image->SetOrigin(-0.5 * CubeMm, -0.5 * CubeMm, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(voxels, voxels + 9 * 9 * 9, static_cast<unsigned char>(100));
  return image;
}

// The length of a ray in the cube.
double LengthInCube(glm::dvec3 from, glm::dvec3 towards, double farMm)
{
  const glm::dvec3 lower(-0.5 * CubeMm, -0.5 * CubeMm, 0.0);
  const glm::dvec3 upper(0.5 * CubeMm, 0.5 * CubeMm, CubeMm);
  double enter = 0.0;
  double exit = farMm;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double one = (lower[axis] - from[axis]) / towards[axis];
    const double other = (upper[axis] - from[axis]) / towards[axis];
    enter = std::max(enter, std::min(one, other));
    exit = std::min(exit, std::max(one, other));
  }
  return std::max(exit - enter, 0.0);
}

double LeftBehindCube(glm::dvec3 from, glm::dvec3 towards, double farMm = 1e9)
{
  return std::pow(1.0 - OpacityPerMm, LengthInCube(from, towards, farMm));
}

// A large floor below the cube, seen from above past the cube or through it.
class CubeAboveFloor
{
public:
  CubeAboveFloor()
    : scene(Cube(), 65)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, OpacityPerMm);
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.mapper->ShadowsOn();
    this->scene.renderer->AutomaticLightCreationOff();
    this->scene.renderer->RemoveAllLights();
    this->scene.LookDown(this->focus, 6.0);

    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-60.0, -60.0, FloorZ);
    plane->SetPoint1(60.0, -60.0, FloorZ);
    plane->SetPoint2(-60.0, 60.0, FloorZ);
    vtkNew<vtkPolyDataMapper> faces;
    faces->SetInputConnection(plane->GetOutputPort());
    this->floor->SetMapper(faces);
    vtkProperty* const property = this->floor->GetProperty();
    property->SetColor(1.0, 1.0, 1.0);
    property->SetAmbient(0.0);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.0);
    this->scene.renderer->AddActor(this->floor);
  }

  vtkLight* AddSun() { return AddLight(this->scene.renderer, 100.0 * towardsSun, glm::dvec3(0.0)); }

  // The place of the floor that a pixel shows.
  glm::dvec3 PlaceAt(int x, int y) const
  {
    const auto offset = [](int pixel) { return 6.0 * (2.0 * (pixel + 0.5) / 65.0 - 1.0); };
    return { this->focus.x + offset(x), this->focus.y + offset(y), FloorZ };
  }

  // Compares red on the floor where the cube does not cover it, drawn by both marchers.
  void ExpectRed(const std::function<double(glm::dvec3 place)>& truth, double tolerance)
  {
    this->ExpectRedIn(this->scene.DrawByProcessor(), truth, tolerance);
    this->ExpectRedIn(this->scene.Draw(), truth, tolerance);
    EXPECT_TRUE(this->scene.UsesShaderPart("Reach/ShadowRays.glsl"));
  }

  void ExpectRedIn(const std::vector<float>& drawn,
    const std::function<double(glm::dvec3 place)>& truth, double tolerance)
  {
    double least = 1.0;
    double most = 0.0;
    for (int y = 2; y < 65; y += 6)
    {
      for (int x = 2; x < 65; x += 6)
      {
        const glm::dvec3 place = this->PlaceAt(x, y);
        if (std::abs(place.x) < 0.5 * CubeMm && std::abs(place.y) < 0.5 * CubeMm)
        {
          continue;
        }
        const double red = drawn[4 * (std::size_t(y) * 65 + std::size_t(x))];
        EXPECT_NEAR(red, truth(place), tolerance) << place.x << ", " << place.y;
        least = std::min(least, red);
        most = std::max(most, red);
      }
    }
    EXPECT_LT(least, 0.75 * most) << "no shadow is seen";
  }

  static const glm::dvec3 towardsSun;
  glm::dvec3 focus = { -7.5, 0.0, 0.0 };
  MapperScene scene;
  vtkNew<vtkActor> floor;
};

const glm::dvec3 CubeAboveFloor::towardsSun(0.6, 0.0, 0.8);

// Eight bits in the framebuffer before and after.
constexpr double OfBytes = 3.0 / 255.0;

}

TEST(Receivers, OfDiffuseLightHaveTheirClosedForm)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.8 * 0.8 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
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

TEST(Receivers, AreNoPropsThatCastNoShadowsAndNoWireframes)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.mapper->ShadowsOff();
  const std::vector<float> lit = cube.scene.DrawByProcessor();
  cube.scene.mapper->ShadowsOn();
  EXPECT_NE(cube.scene.DrawByProcessor(), lit);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
  cube.floor->SetPropertyKeys(keys);
  EXPECT_EQ(cube.scene.DrawByProcessor(), lit);
}

TEST(Receivers, WaitForTheStillImage)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.mapper->SetMaximumImageSampleDistance(1.0);
  const std::vector<float> still = cube.scene.DrawByProcessor();
  cube.scene.window->SetDesiredUpdateRate(20.0);
  EXPECT_NE(cube.scene.DrawByProcessor(), still);
  cube.scene.window->SetDesiredUpdateRate(1e-3);
  EXPECT_EQ(cube.scene.DrawByProcessor(), still);
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
