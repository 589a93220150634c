// Steps that keep an error tolerance while geometry moves that casts shadows on a volume.

#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace
{

// A torso under a sun and a lamp, and a ball between them that moves.
class TorsoAndBall
{
public:
  TorsoAndBall()
    : scene(SmallTorso(), 64)
  {
    CastShadowsOfSunAndLamp(this->scene);
    this->scene.mapper->SetErrorTolerance(1.0 / 64.0);
    this->scene.mapper->ProcessorMarchingOn();
    double center[3];
    this->scene.image->GetCenter(center);
    center[0] += 60.0;
    center[1] -= 60.0;
    center[2] += 60.0;
    this->ball = Ball(center, 20.0);
    this->scene.renderer->AddActor(this->ball);
  }

  // The bytes of one image; another would be one at rest.
  std::vector<int> Draw()
  {
    this->scene.window->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    this->scene.window->GetPixelData(0, 0, 63, 63, 0, rgb.Get(), 0);
    return std::vector<int>(rgb->Begin(), rgb->End());
  }

  void TurnFirstLight(double degrees)
  {
    vtkLight* const light =
      vtkLight::SafeDownCast(this->scene.renderer->GetLights()->GetItemAsObject(0));
    vtkNew<vtkTransform> turn;
    turn->Translate(light->GetFocalPoint());
    turn->RotateY(degrees);
    turn->Translate(
      -light->GetFocalPoint()[0], -light->GetFocalPoint()[1], -light->GetFocalPoint()[2]);
    light->SetPosition(turn->TransformDoublePoint(light->GetPosition()));
  }

  int Searches() { return this->scene.mapper->GetToleranceSearches(); }

  MapperScene scene;
  vtkSmartPointer<vtkActor> ball;
};

// The number of pixels that differ by more than a number of bytes.
int PixelsBeyond(const std::vector<int>& one, const std::vector<int>& other, int most)
{
  int count = 0;
  for (std::size_t i = 0; i < one.size(); i += 3)
  {
    const int largest = std::max({ std::abs(one[i] - other[i]), std::abs(one[i + 1] - other[i + 1]),
      std::abs(one[i + 2] - other[i + 2]) });
    count += largest > most ? 1 : 0;
  }
  return count;
}

}

TEST(StepsBesideCasters, AreKeptWhileGeometryMovesAndFoundAtRest)
{
  TorsoAndBall torso;
  torso.Draw();
  const int searches = torso.Searches();
  for (int i = 0; i < 5; ++i)
  {
    torso.ball->AddPosition(-4.0, 3.0, 0.0);
    torso.Draw();
    EXPECT_TRUE(torso.scene.mapper->GetErrorToleranceIsKept());
  }
  EXPECT_EQ(torso.Searches(), searches);
  torso.Draw();
  EXPECT_EQ(torso.Searches(), searches + 1) << "the ball rests";
  torso.Draw();
  EXPECT_EQ(torso.Searches(), searches + 1);
}

TEST(StepsBesideCasters, KeepTheErrorToleranceInMotion)
{
  TorsoAndBall torso;
  const std::vector<int> first = torso.Draw();
  torso.ball->AddPosition(-15.0, 12.0, 0.0);
  const std::vector<int> moved = torso.Draw();
  EXPECT_GT(PixelsBeyond(moved, first, 20), 20) << "the shadow is not seen";
  torso.scene.mapper->SetErrorTolerance(1.0 / 512.0);
  constexpr int ThousandthOfPixels = 4;
  EXPECT_LE(PixelsBeyond(moved, torso.Draw(), 255 / 64 + 1), ThousandthOfPixels);
}

TEST(StepsBesideCasters, AreKeptWhileALightMovesAndFoundAtRest)
{
  TorsoAndBall torso;
  torso.ball->VisibilityOff();
  const std::vector<int> first = torso.Draw();
  const int searches = torso.Searches();
  std::vector<int> moved;
  for (int i = 0; i < 3; ++i)
  {
    torso.TurnFirstLight(3.0);
    moved = torso.Draw();
    EXPECT_TRUE(torso.scene.mapper->GetErrorToleranceIsKept());
  }
  EXPECT_EQ(torso.Searches(), searches);
  EXPECT_GT(PixelsBeyond(moved, first, 10), 20) << "the light does not move";
  torso.Draw();
  EXPECT_EQ(torso.Searches(), searches + 1) << "the light rests";
  torso.scene.mapper->SetErrorTolerance(1.0 / 512.0);
  constexpr int ThousandthOfPixels = 4;
  EXPECT_LE(PixelsBeyond(moved, torso.Draw(), 255 / 64 + 1), ThousandthOfPixels);
}

// A change of the volume's look, or a move of its own, is more than a move of geometry.
TEST(StepsBesideCasters, AreFoundForAnyOtherChange)
{
  TorsoAndBall torso;
  torso.Draw();
  int searches = torso.Searches();
  torso.ball->AddPosition(-4.0, 3.0, 0.0);
  torso.scene.mapper->SetErrorTolerance(1.0 / 100.0);
  torso.Draw();
  EXPECT_EQ(torso.Searches(), ++searches);
  torso.ball->AddPosition(-4.0, 3.0, 0.0);
  torso.scene.volume->AddPosition(1.0, 0.0, 0.0);
  torso.Draw();
  EXPECT_EQ(torso.Searches(), ++searches);
  torso.ball->VisibilityOff();
  torso.Draw();
  EXPECT_EQ(torso.Searches(), ++searches) << "no shader for geometry is needed";
}
