// The props that receive shadows of volumes.

#include "Module/Light/SecondCube.h"
#include "Module/Scenes/CubeAboveFloor.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkObjectFactory.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

TEST(ReceivingProps, AreNoPropsThatCastNoShadowsAndNoWireframes)
{
  CubeAboveFloor cube;
  cube.AddSun();
  EXPECT_TRUE(cube.ShowsShadows());
  vtkNew<vtkInformation> keys;
  keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
  cube.floor->SetPropertyKeys(keys);
  EXPECT_FALSE(cube.ShowsShadows());
  cube.floor->SetPropertyKeys(nullptr);
  cube.floor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_FALSE(cube.ShowsShadows());
  const std::vector<float> wires = cube.FloorRed(true);
  EXPECT_GT(*std::max_element(wires.begin(), wires.end()), 0.1f) << "no wire is seen";
}

// With two lamps, the product of what volumes leave of each is not that of what they leave of all
// light.
TEST(ReceivingProps, AreInTheShadowsOfAllVolumes)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const glm::dvec3 other = glm::normalize(glm::dvec3(0.3, 0.1, 0.8));
  AddLight(cube.scene.renderer, 100.0 * other, glm::dvec3(0.0))->SetIntensity(0.3);
  const SecondCube second(cube, AboveFirst);
  const auto leftOf = [&](glm::dvec3 lamp, glm::dvec3 place)
  { return lamp.z * LeftBehindCube(place, lamp) * second.Leaves(place, lamp); };
  const auto truth = [&](glm::dvec3 place)
  { return 0.8 * (leftOf(CubeAboveFloor::towardsSun, place) + 0.3 * leftOf(other, place)); };
  cube.ExpectRed(truth, OfBytes);
  second.mapper->ProcessorMarchingOff();
  second.ExpectRedInBothOrders(truth, OfBytes);
}

TEST(ReceivingProps, AreInTheShadowsOfVolumesThatCastSome)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const SecondCube second(cube, AboveFirst);
  second.mapper->ShadowsOff();
  cube.ExpectRed([](glm::dvec3 place)
    { return 0.64 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
  second.mapper->ShadowsOn();
  cube.scene.mapper->ShadowsOff();
  cube.ExpectRedIn(
    cube.scene.DrawByProcessor(),
    [&](glm::dvec3 place) { return 0.64 * second.Leaves(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

// Colours of a volume that another mapper draws when it likes would be dimmed too.
TEST(ReceivingProps, AreLeftOutBesideVolumesThatOthersDraw)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const SecondCube second(cube, AboveFirst);
  EXPECT_TRUE(cube.ShowsShadows());
  vtkNew<vtkFixedPointVolumeRayCastMapper> others;
  others->SetInputData(cube.scene.image);
  second.volume->SetMapper(others);
  EXPECT_FALSE(cube.ShowsShadows());
  second.volume->VisibilityOff();
  EXPECT_TRUE(cube.ShowsShadows());
}

namespace
{

// A mapper that lets another one draw, as one that draws a volume in parts.
class MapperOfParts : public vtkVariationFieldVolumeMapper
{
public:
  static MapperOfParts* New() { VTK_STANDARD_NEW_BODY(MapperOfParts); }
  vtkTypeMacro(MapperOfParts, vtkVariationFieldVolumeMapper);

  vtkNew<vtkVariationFieldVolumeMapper> part;

protected:
  void DrawFrame(vtkRenderer* renderer, vtkVolume* volume) override
  {
    this->part->Render(renderer, volume);
  }
};

}

// A part would dim, behind it, the colours of those that were drawn before.
TEST(ReceivingProps, AreLeftOutBehindPartsOfAVolume)
{
  CubeAboveFloor cube;
  cube.AddSun();
  vtkNew<MapperOfParts> mapper;
  mapper->SetInputData(cube.scene.image);
  mapper->part->SetInputData(cube.scene.image);
  cube.scene.volume->SetMapper(mapper);
  const std::vector<float> lit = cube.scene.Draw();
  mapper->part->ShadowsOn();
  EXPECT_EQ(cube.scene.Draw(), lit);
}

TEST(ReceivingProps, AreDimmedInTheWindowWhereTheVolumeIsDrawnToImages)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.mapper->RenderToImageOn();
  cube.ExpectRedIn(
    cube.scene.DrawByProcessor(),
    [](glm::dvec3 place) { return 0.64 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
    OfBytes);
}

// The later images have shorter steps, so that light is traced for the first two.
TEST(ReceivingProps, KeepTheirLightWhileImagesAreAccumulated)
{
  CubeAboveFloor cube;
  vtkLight* const sun = cube.AddSun();
  vtkVariationFieldVolumeMapper* const mapper = cube.scene.mapper;
  mapper->ProcessorMarchingOn();
  mapper->SetMaximumAccumulatedPictures(6);
  const auto drawAll = [&]
  {
    for (int i = 0; i < 6; ++i)
    {
      cube.ExpectRedIn(
        cube.scene.Draw(),
        [&](glm::dvec3 place)
        {
          const glm::dvec3 towards = glm::normalize(glm::make_vec3(sun->GetPosition()));
          return 0.8 * towards.z * LeftBehindCube(place, towards);
        },
        OfBytes);
    }
  };
  drawAll();
  EXPECT_EQ(mapper->GetAccumulatedPictures(), 6);
  const int builds = mapper->GetGeometryShadowBuilds();
  EXPECT_LE(builds, 2);
  sun->SetPosition(50.0, 0.0, 80.0);
  drawAll();
  EXPECT_GT(mapper->GetGeometryShadowBuilds(), builds);
  EXPECT_LE(mapper->GetGeometryShadowBuilds(), 2 * builds);
}

namespace
{

class AccumulatingCube : public CubeAboveFloor
{
public:
  AccumulatingCube()
  {
    this->AddSun();
    this->scene.mapper->ProcessorMarchingOn();
    this->scene.mapper->SetMaximumAccumulatedPictures(6);
  }

  // The red of a lit floor in the shadow of this cube alone.
  void ExpectOwnShadow()
  {
    this->ExpectRedIn(
      this->scene.Draw(),
      [](glm::dvec3 place) { return 0.64 * LeftBehindCube(place, CubeAboveFloor::towardsSun); },
      OfBytes);
  }
};

}

TEST(ReceivingProps, ForgetTheShadowOfAVolumeThatIsGone)
{
  AccumulatingCube cube;
  cube.ExpectOwnShadow();
  const SecondCube second(cube, AboveFirst);
  cube.scene.Draw();
  second.volume->VisibilityOff();
  cube.ExpectOwnShadow();
}

TEST(ReceivingProps, GetTheirShadowOnceVolumesOfOtherMappersAreGone)
{
  AccumulatingCube cube;
  const SecondCube second(cube, AboveFirst);
  vtkNew<vtkFixedPointVolumeRayCastMapper> others;
  others->SetInputData(cube.scene.image);
  second.volume->SetMapper(others);
  cube.scene.Draw();
  second.volume->VisibilityOff();
  cube.ExpectOwnShadow();
}
