// Overlapping volumes, which packets of rays march together: images match those of the shaders to a
// twentieth of a grey level (RMSE).

#include "Module/Scenes/OverlapScene.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkProperty.h>

using namespace varimarch;

namespace
{

constexpr int PictureSize = 64;

// A ball with a soft rim and ridges on it.
vtkSmartPointer<vtkImageData> RidgedBall(int type, glm::ivec3 size)
{
  const auto value = [&](glm::ivec3 voxel, int)
  {
    const glm::dvec3 place = (glm::dvec3(voxel) + 0.5) / glm::dvec3(size) - 0.5;
    const double ridges = 8.0 * std::sin(15.0 * place.x) * std::cos(12.0 * place.y);
    return std::max(200.0 - 400.0 * glm::length(place) + ridges, 0.0);
  };
  const auto image = ImageOf(type, 1, value, size);
  const glm::dvec3 spacing = 16.0 / glm::dvec3(size);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(-8.0, -8.0, -8.0);
  return image;
}

struct ThreeBalls
{
  explicit ThreeBalls(OverlapScene& scene)
    : ct(scene.Add(0, RidgedBall(VTK_SHORT, { 40, 44, 36 }), { { 0.9, 0.8, 0.7 }, 30, 110, 0.1 }))
    , pet(scene.Add(1, RidgedBall(VTK_FLOAT, { 17, 15, 19 }), { { 1.0, 0.3, 0.0 }, 20, 100, 0.2 }))
    , dose(scene.Add(
        2, RidgedBall(VTK_UNSIGNED_CHAR, { 9, 11, 8 }), { { 0.2, 0.4, 1 }, 60, 120, 0.3 }))
  {
    this->ct->RotateWXYZ(25.0, 1.0, 1.0, 0.0);
    this->pet->SetPosition(3.0, 2.0, -1.0);
    this->pet->SetScale(1.0, 0.8, 1.1);
    this->dose->SetPosition(-3.0, 3.0, 2.0);
    this->dose->RotateX(40.0);
  }

  vtkVolume* ct;
  vtkVolume* pet;
  vtkVolume* dose;
};

struct VolumesChange
{
  const char* name;
  std::function<void(OverlapScene&, const ThreeBalls&)> make;
};

void PrintTo(const VolumesChange& change, std::ostream* os)
{
  *os << change.name;
}

void UseGradientOpacity(vtkVolume* volume)
{
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.1);
  factors->AddPoint(20.0, 1.0);
  volume->GetProperty()->SetGradientOpacity(factors);
}

void PutGlassIn(OverlapScene& scene)
{
  UseDepthPeeling(scene.renderer);
  for (const double radius : { 3.0, 5.0, 7.0 })
  {
    const double center[3] = { 1.0, 0.5, 0.0 };
    const vtkSmartPointer<vtkActor> ball = Ball(center, radius);
    ball->GetProperty()->SetOpacity(radius == 3.0 ? 1.0 : 0.3);
    scene.renderer->AddActor(ball);
  }
}

void ExpectTheImageOfTheShader(OverlapScene& scene)
{
  // Packets integrate at midpoints, shaders linearly between two samples; short steps agree.
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.025f);
  const std::vector<float> marched = scene.DrawByProcessor();
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  ASSERT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
  const std::vector<float> drawn = scene.Draw();
  ASSERT_FALSE(scene.ShaderParts().empty());
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.3) << "the image is empty";
  const ImageError difference = CompareImages(marched.data(), drawn.data(), drawn.size() / 4);
  EXPECT_LT(difference.rootMeanSquare, 0.05);
  EXPECT_LT(difference.percentile999, 0.5);
}

}

class ProcessorMarchingOfVolumes
  : public ProcessorMarching
  , public testing::WithParamInterface<VolumesChange>
{
};

TEST_P(ProcessorMarchingOfVolumes, IsThePictureOfTheShader)
{
  OverlapScene scene(PictureSize);
  const ThreeBalls balls(scene);
  GetParam().make(scene, balls);
  ExpectTheImageOfTheShader(scene);
}

// The second volume has bricks that rays skip, and its visible parts lie elsewhere among the rays
// than among the pixels.
TEST_F(ProcessorMarching, FindsTheVisiblePartsOfVolumesWhereRaysAreFewerThanPixels)
{
  OverlapScene scene(PictureSize);
  scene.Add(0, RidgedBall(VTK_SHORT, { 40, 44, 36 }), { { 0.9, 0.8, 0.7 }, 120, 170, 0.1 });
  scene.Add(1, RidgedBall(VTK_FLOAT, { 44, 40, 48 }), { { 1.0, 0.3, 0.0 }, 120, 170, 0.4 })
    ->SetPosition(3.0, 2.0, -1.0);
  scene.mapper->SetImageSampleDistance(2.0f);
  ExpectTheImageOfTheShader(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryPart, ProcessorMarchingOfVolumes,
  testing::Values(VolumesChange{ "Plain", [](OverlapScene&, const ThreeBalls&) {} },
    VolumesChange{ "WithoutField",
      [](OverlapScene& s, const ThreeBalls&) { MapperOf(s)->SetAccelerationModeToOff(); } },
    VolumesChange{ "Shaded",
      [](OverlapScene&, const ThreeBalls& balls)
      {
        balls.ct->GetProperty()->ShadeOn();
        balls.dose->GetProperty()->ShadeOn();
      } },
    VolumesChange{ "BoxesAndASpline",
      [](OverlapScene& s, const ThreeBalls& balls)
      {
        MapperOf(s)->CubicInterpolationOn();
        balls.dose->GetProperty()->SetInterpolationTypeToNearest();
        balls.dose->GetProperty()->ShadeOn();
        balls.pet->GetProperty()->ShadeOn();
      } },
    VolumesChange{ "OpacityOfGradients",
      [](OverlapScene&, const ThreeBalls& balls)
      {
        UseGradientOpacity(balls.ct);
        UseGradientOpacity(balls.dose);
        balls.dose->GetProperty()->SetInterpolationTypeToNearest();
      } },
    VolumesChange{ "LightsFromTheSide",
      [](OverlapScene& s, const ThreeBalls& balls)
      {
        balls.pet->GetProperty()->ShadeOn();
        balls.pet->GetProperty()->SetSpecular(0.5);
        s.Draw(); // creates the head light
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPosition(30.0, 20.0, 10.0);
        light->SetDiffuseColor(0.9, 0.3, 0.6);
        s.renderer->AddLight(light);
      } },
    VolumesChange{
      "Noise", [](OverlapScene& s, const ThreeBalls&) { MapperOf(s)->UseJitteringOn(); } },
    VolumesChange{ "InPerspective",
      [](OverlapScene& s, const ThreeBalls&)
      {
        s.renderer->GetActiveCamera()->ParallelProjectionOff();
        s.renderer->ResetCamera();
      } },
    VolumesChange{
      "TranslucentGeometry", [](OverlapScene& s, const ThreeBalls&) { PutGlassIn(s); } }),
  [](const testing::TestParamInfo<VolumesChange>& info) { return info.param.name; });

TEST_F(ProcessorMarching, KeepsOverlappingVolumesOffTheDevice)
{
  OverlapScene scene(PictureSize);
  const ThreeBalls balls(scene);
  scene.Draw();
  const vtkIdType bytesOfShader = MapperOf(scene)->GetGraphicsMemoryBytes();
  scene.DrawByProcessor();
  const vtkIdType bytesOfPixels = 4 * sizeof(float) * PictureSize * PictureSize;
  EXPECT_LE(MapperOf(scene)->GetGraphicsMemoryBytes(), bytesOfPixels);
  scene.Draw();
  EXPECT_EQ(MapperOf(scene)->GetGraphicsMemoryBytes(), bytesOfShader);
}

TEST_F(ProcessorMarching, DrawsOverlappingVolumesThatDoNotFitTheDevice)
{
  OverlapScene scene(PictureSize);
  const ThreeBalls balls(scene);
  const std::vector<float> drawn = scene.DrawByProcessor();
  constexpr int BytesOfFirst = 40 * 44 * 36 * 2;
  for (const vtkIdType most : { BytesOfFirst - 1, 1000 })
  {
    MapperOf(scene)->SetMaximumGraphicsMemory(most);
    EXPECT_EQ(scene.DrawByProcessor(), drawn) << most;
    EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
    EXPECT_EQ(scene.DrawByProcessor(), drawn) << most << ", a second time";
  }
  {
    const ExpectedVtkErrors errors;
    scene.Draw();
    EXPECT_NE(
      errors.Text().find("Overlapping volumes cannot be drawn in blocks"), std::string::npos)
      << errors.Text();
  }
  MapperOf(scene)->SetMaximumGraphicsMemory(1 << 28);
  scene.DrawByProcessor();
  EXPECT_FALSE(scene.ShaderParts().empty()) << "they fit";
}

// The first volume would fit alone.
TEST_F(ProcessorMarching, DrawsVolumesOfWhichAnotherThanTheFirstDoesNotFitTheDevice)
{
  OverlapScene scene(PictureSize);
  scene.Add(0, RidgedBall(VTK_UNSIGNED_CHAR, { 9, 11, 8 }), { { 0.2, 0.4, 1 }, 60, 120, 0.3 });
  scene.Add(1, RidgedBall(VTK_FLOAT, { 40, 44, 36 }), { { 0.9, 0.8, 0.7 }, 30, 110, 0.1 });
  const std::vector<float> drawn = scene.DrawByProcessor();
  MapperOf(scene)->SetMaximumGraphicsMemory(100000);
  EXPECT_EQ(scene.DrawByProcessor(), drawn);
  EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
}
