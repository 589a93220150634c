// Opaque geometry beside a volume in light that casts shadows.

#include "Regression/RegressionCase.h"

#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/CasterTruth.h"
#include "Module/Scenes/HomogeneousScene.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <functional>
#include <limits>

using namespace varimarch;

namespace
{

constexpr double Tolerance = 1e-3;

// The small torso in the light of a sun and a lamp, seen from above in perspective. The reference
// needs a ray to each light for each of its samples, so that the image is small.
std::shared_ptr<MapperScene> LitTorsoFromAbove()
{
  const auto scene = NewScene(SmallTorso(), RegressionSide / 2);
  CastShadowsOfSunAndLamp(*scene);
  vtkCamera* const camera = scene->renderer->GetActiveCamera();
  camera->SetPosition(0.2, -0.6, 1.0);
  scene->renderer->ResetCamera(scene->volume->GetBounds());
  return scene;
}

// The image of a level surface that covers all that is behind it: opaque colours where the place on
// the level has one, black otherwise.
// @param colorAt  (place) -> RGB, or a number below 0 where nothing is
std::vector<float> ImageOfLevel(
  const MapperScene& scene, double zMm, const std::function<glm::dvec3(glm::dvec3)>& colorAt)
{
  const glm::dmat4 worldFromClip = glm::inverse(ClipFromWorld(scene.renderer));
  const auto placeAt = [&](double x, double y, double depth)
  {
    const glm::dvec4 place = worldFromClip * glm::dvec4(x, y, depth, 1.0);
    return glm::dvec3(place) / place.w;
  };
  const auto centerOf = [&](int pixel) { return 2.0 * (pixel + 0.5) / scene.size - 1.0; };
  std::vector<float> image;
  for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
  {
    const double x = centerOf(pixel % scene.size);
    const double y = centerOf(pixel / scene.size);
    const glm::dvec3 from = placeAt(x, y, -1.0);
    const glm::dvec3 along = placeAt(x, y, 1.0) - from;
    const glm::dvec3 rgb = colorAt(from + (zMm - from.z) / along.z * along);
    const bool isCovered = rgb.x >= 0.0;
    for (int channel = 0; channel < 3; ++channel)
    {
      image.push_back(isCovered ? float(rgb[channel]) : 0.0f);
    }
    image.push_back(isCovered ? 1.0f : 0.0f);
  }
  return image;
}

// A sheet above a half of the torso, flat and unlit, casts its shadow on the other half too.
RegressionScene ShadowOfGeometry()
{
  constexpr double FromXMm = 60.0;
  constexpr glm::dvec3 Rgb(0.1, 0.5, 0.3);
  const auto scene = LitTorsoFromAbove();
  const double heightMm = scene->volume->GetBounds()[5] + 60.0;
  const vtkSmartPointer<vtkActor> sheet = Plane(heightMm, FromXMm, { Rgb.x, Rgb.y, Rgb.z });
  scene->renderer->AddActor(sheet);
  scene->renderer->ResetCameraClippingRange();
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, sheet, heightMm, Rgb]
  {
    const std::vector<float> ofSheet = ImageOfLevel(*scene, heightMm,
      [&](glm::dvec3 place) { return place.x > FromXMm ? Rgb : glm::dvec3(-1.0); });
    return ImageOver(
      ofSheet, scene->TruthOf(MaterialInShadowsOf(*scene, { sheet }, Tolerance), Tolerance));
  };
  return regression;
}

constexpr double FloorAmbient = 0.1;
constexpr double FloorDiffuse = 0.4; ///< so that no colour exceeds 1, where the framebuffer ends

vtkSmartPointer<vtkActor> Floor(double zMm)
{
  constexpr double HalfMm = 2000.0;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-HalfMm, -HalfMm, zMm);
  plane->SetPoint1(HalfMm, -HalfMm, zMm);
  plane->SetPoint2(-HalfMm, HalfMm, zMm);
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(plane->GetOutputPort());
  const auto floor = vtkSmartPointer<vtkActor>::New();
  floor->SetMapper(faces);
  floor->GetProperty()->SetAmbient(FloorAmbient);
  floor->GetProperty()->SetDiffuse(FloorDiffuse);
  floor->GetProperty()->SetSpecular(0.0);
  return floor;
}

// The colour of the floor in the light that the volume leaves.
glm::dvec3 FloorColorAt(
  glm::dvec3 place, MapperScene& scene, const glm::dmat4& gridFromWorld, const LightReaching& left)
{
  glm::dvec3 rgb(FloorAmbient);
  vtkCollectionSimpleIterator iterator;
  scene.renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* const light = scene.renderer->GetLights()->GetNextLight(iterator))
  {
    const glm::dvec3 from = glm::make_vec3(light->GetPosition());
    const bool isNear = light->GetPositional() != 0;
    const glm::dvec3 way = isNear ? from - place : from - glm::make_vec3(light->GetFocalPoint());
    const glm::dvec3 towards = glm::normalize(way);
    const double farMm = isNear ? glm::length(way) : std::numeric_limits<double>::infinity();
    const glm::dvec3 placeGrid(gridFromWorld * glm::dvec4(place, 1.0));
    rgb += FloorDiffuse * std::max(towards.z, 0.0) * left(placeGrid, towards, farMm) *
      glm::make_vec3(light->GetDiffuseColor());
  }
  return rgb;
}

// A floor below the torso.
// @param seen  the colour of a lit floor as it is seen
RegressionScene TorsoAbove(const std::shared_ptr<MapperScene>& scene, double floorZ,
  const std::function<glm::dvec3(glm::dvec3 rgb)>& seen)
{
  scene->renderer->AddActor(Floor(floorZ));
  scene->renderer->ResetCameraClippingRange();
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, floorZ, seen]
  {
    const LightReaching left = LightThroughVolume(*scene, Tolerance);
    const glm::dmat4 gridFromWorld = glm::inverse(SceneSamples(*scene).Geometry().worldFromGrid);
    const std::vector<float> ofFloor = ImageOfLevel(*scene, floorZ,
      [&](glm::dvec3 place) { return seen(FloorColorAt(place, *scene, gridFromWorld, left)); });
    return ImageOver(scene->TruthOf(MaterialInOwnShadows(*scene, Tolerance), Tolerance), ofFloor);
  };
  return regression;
}

RegressionScene ShadowOnGeometry()
{
  const auto scene = LitTorsoFromAbove();
  return TorsoAbove(
    scene, scene->volume->GetBounds()[4] - 20.0, [](glm::dvec3 rgb) { return rgb; });
}

// A pane between the torso and the floor sends the light of its ambient colour.
RegressionScene ShadowBehindGlass()
{
  constexpr double Opacity = 0.4;
  constexpr double Farthest = -2000.0;
  constexpr glm::dvec3 Rgb(0.1, 0.3, 0.9);
  const auto scene = LitTorsoFromAbove();
  const double floorZ = scene->volume->GetBounds()[4] - 20.0;
  const vtkSmartPointer<vtkActor> pane = Plane(floorZ + 10.0, Farthest, { Rgb.x, Rgb.y, Rgb.z });
  pane->GetProperty()->SetOpacity(Opacity);
  scene->renderer->AddActor(pane);
  return TorsoAbove(scene, floorZ, [Rgb](glm::dvec3 rgb) { return glm::mix(rgb, Rgb, Opacity); });
}

}

std::vector<RegressionCase> ShadowCases()
{
  return {
    { "ShadowOfGeometry", ShadowOfGeometry, 5.0, TooManySegments },
    { "ShadowOnGeometry", ShadowOnGeometry, 5.0, TooManySegments },
    { "ShadowBehindGlass", ShadowBehindGlass, 5.0, TooManySegments },
  };
}
