// Accumulated frames of a scene that does not change.

#include "Module/Scenes/SupersampledTruth.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <functional>

using namespace varimarch;

namespace
{

constexpr int AccumulatedSize = 24;

// Makes bone opaque at once, so that its outline is sharp.
void ShowAnEdge(MapperScene& scene)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(150.0, 0.0);
  scene.opacities->AddPoint(160.0, 0.9);
  scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  scene.mapper->SetErrorTolerance(1.0 / 16.0);
}

double ErrorOf(const std::vector<float>& drawn, const std::vector<float>& truth)
{
  return CompareImages(drawn.data(), truth.data(), truth.size() / 4).rootMeanSquare;
}

std::vector<float> MeanOfAll(MapperScene& scene)
{
  std::vector<float> mean;
  do
  {
    mean = scene.Draw();
  } while (scene.mapper->GetAccumulatedPictures() < scene.mapper->GetMaximumAccumulatedPictures());
  return mean;
}

int PicturesAfter(MapperScene& scene, const std::function<void()>& change)
{
  scene.window->Render();
  scene.window->Render();
  EXPECT_GE(scene.mapper->GetAccumulatedPictures(), 2);
  change();
  scene.window->Render();
  return scene.mapper->GetAccumulatedPictures();
}

}

TEST(AccumulatedPictures, TendToThePictureOfManyRaysPerPixel)
{
  const std::vector<float> truth = SupersampledTruth(AccumulatedSize, ShowAnEdge);
  MapperScene scene(SmallTorso(), AccumulatedSize);
  ShowAnEdge(scene);
  const std::vector<float> alone = scene.Draw();
  scene.mapper->SetMaximumAccumulatedPictures(32);
  EXPECT_EQ(scene.Draw(), alone) << "the first frame equals a single one";
  const std::vector<float> mean = MeanOfAll(scene);
  const double errorAlone = ErrorOf(alone, truth);
  EXPECT_GT(errorAlone, 5.0);
  EXPECT_LT(ErrorOf(mean, truth), errorAlone / 5.0);
  EXPECT_EQ(scene.Draw(), mean) << "no more frames than requested";
}

TEST(AccumulatedPictures, SmoothTheFacesOfTheVolumeItself)
{
  const auto prepare = [](MapperScene& scene)
  {
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(0.0, 0.3);
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
    scene.renderer->GetActiveCamera()->Zoom(0.6);
  };
  const std::vector<float> truth = SupersampledTruth(AccumulatedSize, prepare);
  MapperScene scene(SmallTorso(), AccumulatedSize);
  prepare(scene);
  const std::vector<float> alone = scene.Draw();
  scene.mapper->SetMaximumAccumulatedPictures(32);
  const std::vector<float> mean = MeanOfAll(scene);
  EXPECT_LT(ErrorOf(mean, truth), ErrorOf(alone, truth) / 5.0);
}

TEST(AccumulatedPictures, BeginAnewWithAllThatChangesWhatIsSeen)
{
  MapperScene scene(SmallTorso(), AccumulatedSize);
  scene.volume->GetProperty()->ShadeOn();
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  scene.renderer->AddActor(actor);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(scene.volume->GetCenter());
  scene.mapper->AddClippingPlane(plane);
  scene.mapper->SetMaximumAccumulatedPictures(9);
  const std::vector<std::function<void()>> changes = {
    [&] { scene.renderer->GetActiveCamera()->Azimuth(1.0); },
    [&] { scene.volume->RotateZ(1.0); },
    [&] { scene.opacities->AddPoint(300.0, 0.11); },
    [&] { scene.volume->GetProperty()->SetAmbient(0.3); },
    [&] { scene.image->GetPointData()->GetScalars()->Modified(); },
    [&] { scene.image->Modified(); },
    [&] { scene.mapper->SetBlendModeToMaximumIntensity(); },
    [&] { scene.mapper->SetBlendModeToComposite(); },
    [&] { scene.mapper->SetErrorTolerance(0.05); },
    [&] { plane->SetNormal(0.2, 0.3, 1.0); },
    [&] { actor->SetPosition(3.0, 0.0, 0.0); },
    [&] { sphere->SetRadius(3.0); },
    [&] { actor->VisibilityOff(); },
    [&]
    { vtkLight::SafeDownCast(scene.renderer->GetLights()->GetItemAsObject(0))->SetIntensity(0.7); },
    [&] { scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0); },
    [&] { scene.window->SetSize(20, 30); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    EXPECT_EQ(PicturesAfter(scene, changes[i]), 1) << "change " << i;
  }
}

TEST(AccumulatedPictures, GoOnWhereNothingIsChanged)
{
  MapperScene scene(SmallTorso(), AccumulatedSize);
  scene.mapper->SetMaximumAccumulatedPictures(4);
  EXPECT_EQ(PicturesAfter(scene, [&] { scene.renderer->ResetCameraClippingRange(); }), 3);
  scene.window->Render();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 4);
}

TEST(AccumulatedPictures, StandAloneWhileSomebodyInteracts)
{
  MapperScene scene(SmallTorso(), AccumulatedSize);
  scene.mapper->SetMaximumAccumulatedPictures(4);
  scene.window->SetDesiredUpdateRate(20.0);
  scene.window->Render();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 1);
}

TEST(AccumulatedPictures, TakeNothingWhenOff)
{
  MapperScene scene(SmallTorso(), AccumulatedSize);
  const std::vector<float> picture = scene.Draw();
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  const int shaders = scene.mapper->GetShaderBuilds();
  EXPECT_EQ(scene.Draw(), picture);
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 1);
  scene.mapper->SetMaximumAccumulatedPictures(2);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes + 16 * AccumulatedSize * AccumulatedSize);
  EXPECT_EQ(scene.mapper->GetShaderBuilds(), shaders + 1) << "the shader that averages frames";
  scene.mapper->SetMaximumAccumulatedPictures(1);
  EXPECT_EQ(scene.Draw(), picture);
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
}

// Even on a slow machine, each part of a frame is as short as possible.
TEST(AccumulatedPictures, InPartsAreThePictureInTheEnd)
{
  MapperScene scene(SmallTorso(), 2 * AccumulatedSize);
  scene.volume->GetProperty()->ShadeOn();
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetLongestPartSeconds(1e-9);
  const std::vector<float> coarse = scene.Draw();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 0);
  EXPECT_NE(coarse, whole);
  EXPECT_LT(ErrorOf(coarse, whole), 0.5 * ErrorOf(std::vector<float>(whole.size()), whole))
    << "missing parts are shown coarsely";
  double part = scene.mapper->GetDrawnPart();
  std::vector<float> last;
  while (scene.mapper->GetDrawnPart() < 1.0)
  {
    last = scene.Draw();
    ASSERT_GT(scene.mapper->GetDrawnPart(), part);
    part = scene.mapper->GetDrawnPart();
  }
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 1);
  EXPECT_EQ(last, whole);
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 0) << "another view begins anew";
}

TEST(AccumulatedPictures, InPartsHaveTheSameMean)
{
  const auto meanOf = [](double longestPartSeconds)
  {
    MapperScene scene(SmallTorso(), 2 * AccumulatedSize);
    ShowAnEdge(scene);
    scene.mapper->SetMaximumAccumulatedPictures(3);
    scene.mapper->SetLongestPartSeconds(longestPartSeconds);
    return MeanOfAll(scene);
  };
  EXPECT_EQ(meanOf(1e-9), meanOf(0.0));
}

TEST(AccumulatedPictures, InPartsAreDrawnAtOnceWhileSomebodyInteracts)
{
  MapperScene scene(SmallTorso(), 2 * AccumulatedSize);
  scene.mapper->SetLongestPartSeconds(1e-9);
  scene.window->SetDesiredUpdateRate(15.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 1);
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0);
}
