#include "CommandLine/ReportedErrors.h"
#include "LightScenes.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Median.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <functional>
#include <memory>

namespace varimarch
{

namespace
{

/// The cost of shadows between a volume and opaque geometry, or another volume that overlaps with
/// it. Times are medians over all frames, drawn in turn with and without it.
struct BesideCost
{
  double firstMs;   ///< the first frame with it
  double withoutMs; ///< a still frame without it
  double withMs;    ///< a frame with it, still unless the name says what moves
  double factor;    ///< median of the factors of frames that follow each other
};

constexpr int FramesOfRound = 9;

/// A view, and what moves in it between frames.
struct MovingView
{
  std::unique_ptr<OffscreenView> view;
  std::function<void()> move = [] {};

  double NextMs()
  {
    this->move();
    return 1000.0 * this->view->Render();
  }
};

struct BesideCase
{
  std::string name;
  std::function<MovingView(bool isWith)> make;
};

/// The places beside a volume in the light of LitScene.
struct Surroundings
{
  glm::dvec3 center;
  double length; ///< the volume's diagonal [mm]
  glm::dvec3 towardsLight;
  glm::dvec3 towardsEye;

  Surroundings(const Scene& scene, OffscreenView& view)
    : center(glm::make_vec3(view.Pipeline().Volume()->GetCenter()))
    , length(view.Pipeline().Volume()->GetLength())
    , towardsLight(glm::normalize(glm::make_vec3(scene.lights.front().direction.data())))
    , towardsEye(
        -glm::make_vec3(view.Pipeline().Renderer()->GetActiveCamera()->GetDirectionOfProjection()))
  {
  }
};

vtkSmartPointer<vtkActor> ActorOf(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(faces);
  return actor;
}

// A ball on the way from the volume to the light, which shades a part of the volume and is out of
// the view.
vtkSmartPointer<vtkActor> BallOf(int triangles, const Surroundings& around)
{
  // A row of triangles around each pole, and two triangles in each of the quadrangles between.
  const int side = int(std::lround(std::sqrt(0.25 * triangles)));
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(2 * side);
  ball->SetPhiResolution(side + 2);
  ball->SetRadius(0.2 * around.length);
  const glm::dvec3 place = around.center + 2.0 * around.length * around.towardsLight;
  ball->SetCenter(place.x, place.y, place.z);
  return ActorOf(ball);
}

// A wall behind the volume, which fills the image.
vtkSmartPointer<vtkActor> WallBehind(const Surroundings& around)
{
  const double side = 20.0 * around.length;
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-0.5 * side, -0.5 * side, 0.0);
  wall->SetPoint1(0.5 * side, -0.5 * side, 0.0);
  wall->SetPoint2(-0.5 * side, 0.5 * side, 0.0);
  const glm::dvec3 place = around.center - around.length * around.towardsEye;
  wall->SetNormal(around.towardsEye.x, around.towardsEye.y, around.towardsEye.z);
  wall->SetCenter(place.x, place.y, place.z);
  return ActorOf(wall);
}

void LeaveOut(vtkActor* actor)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
  actor->SetPropertyKeys(keys);
}

using MakeActors =
  std::function<std::vector<vtkSmartPointer<vtkActor>>(const Surroundings& around)>;

MovingView ViewWith(const Scene& scene, vtkImageData* image, const MakeActors& makeActors,
  bool castsShadows, bool firstMoves)
{
  MovingView made = { std::make_unique<OffscreenView>(scene, image, MapperKind::Varimarch) };
  const Surroundings around(scene, *made.view);
  const auto actors = makeActors(around);
  for (vtkActor* actor : actors)
  {
    if (!castsShadows)
    {
      LeaveOut(actor);
    }
    made.view->Pipeline().Renderer()->AddActor(actor);
  }
  made.view->Pipeline().Renderer()->ResetCameraClippingRange();
  if (firstMoves)
  {
    made.move = [actor = actors.front(), step = 1e-3 * around.length]
    { actor->AddPosition(step, 0.0, 0.0); };
  }
  return made;
}

// Two times the volume, of which the second is a quarter of its size away, along the first axis.
MovingView OverlappingViews(Scene scene, vtkImageData* image, bool isWith)
{
  scene.shadows = isWith ? 1.0 : 0.0;
  OverlaidVolume other = { scene.volume, scene.look };
  const double* const bounds = image->GetBounds();
  other.placement.moveMm[0] = 0.25 * (bounds[1] - bounds[0]);
  scene.overlays = { other };
  MovingView made = { std::make_unique<OffscreenView>(scene, image, MapperKind::Varimarch) };
  made.view->Pipeline().SetOverlays(scene.overlays, { { image } });
  return made;
}

std::vector<BesideCase> CasesOf(const Scene& scene, vtkImageData* image)
{
  constexpr int Few = 200;
  constexpr int Some = 10000;
  constexpr int Many = 1000000;
  const auto casting = [=](int triangles)
  {
    return [=](bool isWith)
    {
      return ViewWith(
        scene, image,
        [=](const Surroundings& around) { return std::vector{ BallOf(triangles, around) }; },
        isWith, false);
    };
  };
  const auto moving = [=](int moved, int other)
  {
    return [=](bool isWith)
    {
      return ViewWith(
        scene, image,
        [=](const Surroundings& around) {
          return std::vector{ BallOf(moved, around), BallOf(other, around) };
        },
        true, isWith);
    };
  };
  const auto wall = [](const Surroundings& around) { return std::vector{ WallBehind(around) }; };
  return { { "10 thousand triangles cast shadows", casting(Some) },
    { "1 million triangles cast shadows", casting(Many) },
    { "a wall behind all receives shadows",
      [=](bool isWith) { return ViewWith(scene, image, wall, isWith, false); } },
    { "200 triangles move beside 1 million", moving(Few, Many) },
    { "1 million triangles move beside 200", moving(Many, Few) },
    { "two volumes overlap, with shadows",
      [=](bool isWith) { return OverlappingViews(scene, image, isWith); } } };
}

// A slow moment of the machine affects two frames that follow each other alike.
BesideCost CostOf(const BesideCase& measured, int rounds)
{
  std::vector<double> firstMs;
  std::vector<double> withoutMs;
  std::vector<double> withMs;
  std::vector<double> factors;
  for (int round = 0; round < rounds; ++round)
  {
    MovingView without = measured.make(false);
    MovingView with = measured.make(true);
    without.NextMs();
    firstMs.push_back(with.NextMs());
    for (int frame = 0; frame < FramesOfRound; ++frame)
    {
      const bool beginsWithout = (round + frame) % 2 == 0;
      const double firstOfTwoMs = beginsWithout ? without.NextMs() : with.NextMs();
      const double secondOfTwoMs = beginsWithout ? with.NextMs() : without.NextMs();
      withoutMs.push_back(beginsWithout ? firstOfTwoMs : secondOfTwoMs);
      withMs.push_back(beginsWithout ? secondOfTwoMs : firstOfTwoMs);
      factors.push_back(withMs.back() / withoutMs.back());
    }
  }
  return { Median(firstMs), Median(withoutMs), Median(withMs), Median(factors) };
}

// Draws frames with and without each of the costs, alternately, in a scene with shadows of one
// light.
nlohmann::ordered_json MeasureBesideCosts(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  const Scene scene = WithFeature(LitScene(loaded, options), options.feature);
  nlohmann::ordered_json costs;
  for (const BesideCase& one : CasesOf(scene, loaded.volume.image))
  {
    onStep(one.name);
    const BesideCost cost = CostOf(one, options.rounds);
    ThrowIfVtkReportedError();
    costs.push_back({ { "name", one.name }, { "withoutMs", cost.withoutMs },
      { "withMs", cost.withMs }, { "factor", cost.factor }, { "firstMs", cost.firstMs } });
  }
  return costs;
}

void RunBesideCost(const LightCostOptions& options, BenchResults& results)
{
  AddLightConditions(options, results);
  MeasureSceneByScene(options.scenes, results,
    [&](const LoadedScene& scene, const OnStep& onStep)
    {
      results.json["scenes"].push_back(
        { { "scene", scene.name }, { "costs", MeasureBesideCosts(scene, options, onStep) } });
    });
}

}

Benchmark BesideBenchmark()
{
  return MakeBenchmark("shadows-beside", "Measure shadows of geometry and of other volumes",
    "Example:\n  varimarch-bench shadows-beside --volumes volumes -o report --side 256",
    AddLightOptions, RunBesideCost);
}

}
