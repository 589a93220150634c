// Shadows of volumes on opaque geometry in images in which VTK draws geometry and volumes in other
// orders, or not at all.

#include "Module/Light/SecondCube.h"
#include "Module/Scenes/CubeAboveFloor.h"

#include <vtkCullerCollection.h>
#include <vtkRenderStepsPass.h>

#include <algorithm>
#include <functional>

namespace
{

double LitFloor(glm::dvec3 place)
{
  return 0.64 * LeftBehindCube(place, CubeAboveFloor::towardsSun);
}

/// A translucent pane above the floor, which sends a tenth of white light and lets through half.
class CubeAndPane : public CubeAboveFloor
{
public:
  CubeAndPane()
  {
    this->AddSun();
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-60.0, -60.0, FloorZ + 1.0);
    plane->SetPoint1(60.0, -60.0, FloorZ + 1.0);
    plane->SetPoint2(-60.0, 60.0, FloorZ + 1.0);
    vtkNew<vtkPolyDataMapper> faces;
    faces->SetInputConnection(plane->GetOutputPort());
    this->pane->SetMapper(faces);
    vtkProperty* const property = this->pane->GetProperty();
    property->SetOpacity(0.5);
    property->SetAmbient(0.2);
    property->SetDiffuse(0.0);
    property->SetSpecular(0.0);
    this->scene.renderer->AddActor(this->pane);
  }

  static double Seen(glm::dvec3 place) { return 0.1 + 0.5 * LitFloor(place); }

  vtkNew<vtkActor> pane;
};

}

TEST(ReceivingMoments, BehindTranslucentGeometryKeepItsOwnLight)
{
  CubeAndPane cube;
  cube.ExpectRed(CubeAndPane::Seen, OfBytes);
}

TEST(ReceivingMoments, BehindPeeledGeometryKeepItsOwnLight)
{
  CubeAndPane cube;
  UseDepthPeeling(cube.scene.renderer);
  cube.scene.renderer->UseDepthPeelingForVolumesOff();
  cube.ExpectRed(CubeAndPane::Seen, OfBytes);
}

TEST(ReceivingMoments, BehindLayersBetweenVolumesKeepTheirOwnLight)
{
  CubeAndPane cube;
  UseDepthPeeling(cube.scene.renderer);
  cube.ExpectRed(CubeAndPane::Seen, OfBytes);
}

TEST(ReceivingMoments, BehindLayersAreInTheShadowsOfAllVolumes)
{
  CubeAndPane cube;
  UseDepthPeeling(cube.scene.renderer);
  const SecondCube second(cube, AboveFirst);
  const auto truth = [&](glm::dvec3 place)
  { return 0.1 + 0.5 * LitFloor(place) * second.Leaves(place, CubeAboveFloor::towardsSun); };
  second.ExpectRedInBothOrders(truth, OfBytes);
}

// A part of the window, which does not begin at its corner.
TEST(ReceivingMoments, BehindTranslucentGeometryMayBeInAnyPartOfTheWindow)
{
  CubeAndPane whole;
  const std::vector<float> all = whole.scene.DrawByProcessor();
  CubeAndPane part;
  part.scene.size = 130;
  part.scene.window->SetSize(130, 130);
  part.scene.renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  part.scene.mapper->ProcessorMarchingOn();
  const auto drawn = part.scene.Draw();
  for (int y = 2; y < 65; y += 6)
  {
    for (int x = 2; x < 65; x += 6)
    {
      EXPECT_NEAR(drawn[4 * (std::size_t(65 + y) * 130 + std::size_t(65 + x))],
        all[4 * (std::size_t(y) * 65 + std::size_t(x))], OfBytes);
    }
  }
}

// Light of translucent geometry is drawn again for each of the images, factors are kept.
TEST(ReceivingMoments, BehindTranslucentGeometryKeepTheirLightWhileImagesAreAccumulated)
{
  CubeAndPane cube;
  cube.scene.mapper->ProcessorMarchingOn();
  cube.scene.mapper->SetMaximumAccumulatedPictures(6);
  for (int i = 0; i < 6; ++i)
  {
    cube.ExpectRedIn(cube.scene.Draw(), CubeAndPane::Seen, OfBytes);
  }
  EXPECT_LE(cube.scene.mapper->GetGeometryShadowBuilds(), 2);
}

// A render pass of the caller may blend translucent geometry in any way.
TEST(ReceivingMoments, BehindTranslucentGeometryOfOtherPassesAreLeftOut)
{
  CubeAndPane cube;
  vtkNew<vtkRenderStepsPass> steps;
  cube.scene.renderer->SetPass(steps);
  EXPECT_FALSE(cube.ShowsShadows());
  cube.pane->VisibilityOff();
  EXPECT_TRUE(cube.ShowsShadows());
}

namespace
{

using Truth = std::function<double(glm::dvec3 place)>;

// A cube in images with which somebody interacts, with rays some pixels apart.
class MovingCube : public CubeAboveFloor
{
public:
  MovingCube() { this->AddSun(); }

  // Expects light on the floor between the least and the most within the distance of rays.
  void ExpectRedOfRays(const Truth& truth, double distancePixels)
  {
    this->scene.mapper->SetMinimumImageSampleDistance(float(distancePixels));
    this->scene.mapper->SetMaximumImageSampleDistance(float(distancePixels));
    this->scene.window->SetDesiredUpdateRate(20.0);
    this->ExpectBetween(this->scene.DrawByProcessor(), truth, distancePixels);
    this->ExpectBetween(this->scene.Draw(), truth, distancePixels);
    EXPECT_TRUE(this->scene.UsesShaderPart("Reach/ShadowRays.glsl"));
  }

private:
  void ExpectBetween(const std::vector<float>& drawn, const Truth& truth, double distancePixels)
  {
    const double reachMm = (distancePixels - 1.0) * 2.0 * this->halfMm / 65.0;
    for (int y = 1; y < 65; y += 3)
    {
      for (int x = 1; x < 65; x += 3)
      {
        const glm::dvec3 place = this->PlaceAt(x, y);
        if (this->CoversFloorAt(place))
        {
          continue;
        }
        double least = truth(place);
        double most = least;
        for (int i = 0; i < 25; ++i)
        {
          const glm::dvec3 away(0.5 * (i % 5) - 1.0, 0.5 * (i / 5) - 1.0, 0.0);
          const double near = truth(place + reachMm * away);
          least = std::min(least, near);
          most = std::max(most, near);
        }
        const double red = drawn[4 * (std::size_t(y) * 65 + std::size_t(x))];
        EXPECT_GT(red, least - OfBytes) << place.x << ", " << place.y;
        EXPECT_LT(red, most + OfBytes) << place.x << ", " << place.y;
      }
    }
  }
};

}

TEST(ReceivingMoments, InMovingImagesAreThoseOfTheStillImageByFewerPlaces)
{
  MovingCube cube;
  cube.ExpectRedOfRays(LitFloor, 1.0);
  cube.ExpectRedOfRays(LitFloor, 2.0);
  cube.ExpectRedOfRays(LitFloor, 4.0);
  cube.scene.window->SetDesiredUpdateRate(1e-3);
  cube.ExpectRed(LitFloor, OfBytes);
}

TEST(ReceivingMoments, InMovingImagesAreInTheShadowsOfAllVolumes)
{
  MovingCube cube;
  const SecondCube second(cube, AboveFirst);
  second.mapper->SetMinimumImageSampleDistance(3.0);
  cube.ExpectRedOfRays([&](glm::dvec3 place)
    { return LitFloor(place) * second.Leaves(place, CubeAboveFloor::towardsSun); },
    3.0);
}

// A lit plate above the floor divides squares of pixels.
TEST(ReceivingMoments, InMovingImagesTakeNoShadowFromWhatLiesFarBehind)
{
  MovingCube cube;
  constexpr double Edge = -8.0;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-60.0, -60.0, 12.0);
  plane->SetPoint1(Edge, -60.0, 12.0);
  plane->SetPoint2(-60.0, 60.0, 12.0);
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> above;
  above->SetMapper(faces);
  above->SetProperty(cube.floor->GetProperty());
  cube.scene.renderer->AddActor(above);
  cube.scene.mapper->SetMinimumImageSampleDistance(4.0);
  cube.scene.mapper->SetMaximumImageSampleDistance(4.0);
  cube.scene.window->SetDesiredUpdateRate(20.0);
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  double darkest = 1.0;
  for (int x = 0; x < 65; ++x)
  {
    const float red = drawn[4 * (std::size_t(32) * 65 + std::size_t(x))];
    const glm::dvec3 place = cube.PlaceAt(x, 32);
    if (place.x < Edge - 0.1)
    {
      EXPECT_NEAR(red, 0.64, OfBytes) << place.x;
    }
    else if (place.x > Edge + 0.1)
    {
      darkest = std::min<double>(darkest, red);
    }
  }
  EXPECT_LT(darkest, 0.4);
}

TEST(ReceivingMoments, OfVolumesThatAreDrawnToImagesAreThoseOfAll)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const SecondCube second(cube, AboveFirst);
  const auto truth = [&](glm::dvec3 place)
  { return LitFloor(place) * second.Leaves(place, CubeAboveFloor::towardsSun); };
  second.mapper->RenderToImageOn();
  cube.ExpectRedIn(cube.scene.DrawByProcessor(), truth, OfBytes);
  cube.scene.mapper->RenderToImageOn();
  cube.ExpectRedIn(cube.scene.DrawByProcessor(), truth, OfBytes);
  second.mapper->RenderToImageOff();
  cube.ExpectRedIn(cube.scene.DrawByProcessor(), truth, OfBytes);
}

// VTK culls what is out of the view, but not what it has once been told to keep.
TEST(ReceivingMoments, AreInTheShadowOfAVolumeThatHasLeftTheView)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.ExpectRed(LitFloor, OfBytes);
  cube.LookDown({ -10.0, 0.0, 0.0 }, 2.5);
  cube.ExpectRed(LitFloor, OfBytes);
  cube.scene.renderer->RemoveActor(cube.floor);
  cube.scene.mapper->ProcessorMarchingOn();
  EXPECT_EQ(cube.scene.Draw()[0], 0.0f);
}

// Uneven matter needs short steps, which are found where no ray of the eye meets it.
TEST(ReceivingMoments, KeepTheErrorToleranceOutOfTheView)
{
  CubeAboveFloor cube;
  cube.AddSun();
  auto* const voxels = static_cast<unsigned char*>(cube.scene.image->GetScalarPointer());
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    voxels[i] = static_cast<unsigned char>(i * 37 % 11 * 10);
  }
  cube.scene.opacities->RemoveAllPoints();
  cube.scene.opacities->AddPoint(20.0, 0.0);
  cube.scene.opacities->AddPoint(100.0, 0.5);
  cube.scene.DrawByProcessor(); // from now on the volume is not culled
  cube.LookDown({ -10.0, 0.0, 0.0 }, 2.5);
  cube.scene.mapper->AutoAdjustSampleDistancesOff();
  cube.scene.mapper->SetSampleDistance(0.02);
  const std::vector<float> exact = cube.scene.DrawByProcessor();
  EXPECT_LT(*std::min_element(exact.begin(), exact.end()), 0.3f) << "no shadow is seen";
  cube.scene.mapper->AutoAdjustSampleDistancesOn();
  constexpr double Tolerance = 1.0 / 128.0;
  cube.scene.mapper->SetErrorTolerance(Tolerance);
  const std::vector<float> drawn = cube.scene.DrawByProcessor();
  for (std::size_t i = 0; i < exact.size(); i += 4)
  {
    EXPECT_NEAR(drawn[i], exact[i], Tolerance + OfBytes) << i / 4;
  }
}

TEST(ReceivingMoments, NeedNoCullerOfTheRenderer)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.renderer->GetCullers()->RemoveAllItems();
  cube.LookDown({ -10.0, 0.0, 0.0 }, 2.5);
  cube.ExpectRed(LitFloor, OfBytes);
  EXPECT_EQ(cube.scene.renderer->GetCullers()->GetNumberOfItems(), 0);
}
