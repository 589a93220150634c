#ifndef Varimarch_Testing_CubeAboveFloor_h
#define Varimarch_Testing_CubeAboveFloor_h

#include "Module/Scenes/MapperScene.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

inline constexpr double OpacityPerMm = 0.15;
inline constexpr double CubeMm = 8.0;
inline constexpr double FloorZ = -6.0;

/// Eight bits in the framebuffer before and after.
inline constexpr double OfBytes = 3.0 / 255.0;

/// A cube of the same material everywhere, which is too dark to be seen, from z = 0 up.
inline vtkSmartPointer<vtkImageData> DarkCube()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 9, 9);
  image->SetOrigin(-0.5 * CubeMm, -0.5 * CubeMm, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(voxels, voxels + 9 * 9 * 9, static_cast<unsigned char>(100));
  return image;
}

/// The length of a ray in the cube.
inline double LengthInCube(glm::dvec3 from, glm::dvec3 towards, double farMm)
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

/// The part of a light that the cube leaves.
inline double LeftBehindCube(glm::dvec3 from, glm::dvec3 towards, double farMm = 1e9)
{
  return std::pow(1.0 - OpacityPerMm, LengthInCube(from, towards, farMm));
}

/// A large floor below the cube, seen from above past the cube or through it.
class CubeAboveFloor
{
public:
  CubeAboveFloor()
    : scene(DarkCube(), 65)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, OpacityPerMm);
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.mapper->ShadowsOn();
    this->scene.renderer->AutomaticLightCreationOff();
    this->scene.renderer->RemoveAllLights();
    this->LookDown(this->focus, 6.0);

    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-60.0, -60.0, FloorZ);
    plane->SetPoint1(60.0, -60.0, FloorZ);
    plane->SetPoint2(-60.0, 60.0, FloorZ);
    plane->SetResolution(20, 20);
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

  /// Looks down on a square of the floor in parallel projection.
  void LookDown(glm::dvec3 newFocus, double newHalfMm)
  {
    this->focus = newFocus;
    this->halfMm = newHalfMm;
    this->scene.LookDown(newFocus, newHalfMm);
  }

  /// Shows the same square of the floor in perspective.
  void UsePerspective()
  {
    vtkCamera* const camera = this->scene.renderer->GetActiveCamera();
    const double distanceMm = camera->GetPosition()[2] - FloorZ;
    camera->ParallelProjectionOff();
    camera->SetViewAngle(2.0 * glm::degrees(std::atan(this->halfMm / distanceMm)));
  }

  /// The place of the floor that a pixel shows.
  glm::dvec3 PlaceAt(int x, int y) const
  {
    const auto offset = [this](int pixel)
    { return this->halfMm * (2.0 * (pixel + 0.5) / 65.0 - 1.0); };
    return { this->focus.x + offset(x), this->focus.y + offset(y), FloorZ };
  }

  bool CoversFloorAt(glm::dvec3 place) const
  {
    vtkCamera* const camera = this->scene.renderer->GetActiveCamera();
    const glm::dvec3 toEye = glm::make_vec3(camera->GetPosition()) - place;
    const glm::dvec3 up(0.0, 0.0, 1.0);
    return LengthInCube(place, camera->GetParallelProjection() ? up : toEye, 1e9) > 0.0;
  }

  /// Red on the floor where the cube does not cover it, drawn by packets with or without shadows.
  std::vector<float> FloorRed(bool hasShadows)
  {
    this->scene.mapper->SetShadows(hasShadows);
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    std::vector<float> red;
    for (int pixel = 0; pixel < 65 * 65; ++pixel)
    {
      if (!this->CoversFloorAt(this->PlaceAt(pixel % 65, pixel / 65)))
      {
        red.push_back(drawn[4 * std::size_t(pixel)]);
      }
    }
    return red;
  }

  bool ShowsShadows() { return this->FloorRed(true) != this->FloorRed(false); }

  /// Compares red on the floor where the cube does not cover it, drawn by both marchers.
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
        if (this->CoversFloorAt(place))
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

  static inline const glm::dvec3 towardsSun = glm::dvec3(0.6, 0.0, 0.8);
  glm::dvec3 focus = { -7.5, 0.0, 0.0 };
  double halfMm = 6.0;
  MapperScene scene;
  vtkNew<vtkActor> floor;
};

#endif
