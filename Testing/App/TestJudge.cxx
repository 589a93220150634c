// The judge of the promise against closed forms (Documentation/Mathematics.md).

#include "Promise/Judge.h"
#include "Promise/PictureVerdict.h"
#include "Promise/PromiseParts.h"
#include "Promise/PromiseScene.h"
#include "Stages/VolumeStage.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

constexpr double Opacity = 0.3;
constexpr double Color = 0.8;

// A homogeneous box, 20 mm wide and `thickness` along z, seen along -z.
class HomogeneousBlock
{
public:
  explicit HomogeneousBlock(double thicknessMm)
    : scene(1, window)
  {
    this->scene.AddVolume(
      { 5, 5, 5 }, { 5.0, 5.0, 0.25 * thicknessMm }, [](glm::ivec3) { return 0.5; });
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, Opacity);
    opacity->AddPoint(1.0, Opacity);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, Color, Color, Color);
    this->scene.Property()->SetScalarOpacity(opacity);
    this->scene.Property()->SetColor(color);
    this->scene.side = 4;
    this->scene.LookInParallel({ 0.0, 0.0, 1.0 }, 0.02);
  }

  // A light from an angle to the axis of the view.
  vtkLight* AddLight(double degrees)
  {
    vtkLight* const light = this->scene.AddDistantLight();
    light->SetColor(1.0, 1.0, 1.0);
    light->SetPosition(
      1e6 * std::sin(glm::radians(degrees)), 0.0, 1e6 * std::cos(glm::radians(degrees)));
    return light;
  }

  void Scatter()
  {
    this->scene.Shade();
    this->scene.Property()->SetAmbient(0.0);
    this->scene.Property()->SetDiffuse(1.0);
    this->scene.Mapper()->SetVolumetricScatteringBlending(1.0);
    this->scene.Mapper()->ShadowsOn();
  }

  // The middle of the picture, which is drawn once so that VTK places lights and camera.
  glm::dvec4 Middle(int fineness)
  {
    this->scene.Draw();
    this->truth = ReadJudgeScene(this->scene.Objects());
    return Judge(this->truth).Pixel({ 2.0, 2.0 }, fineness);
  }

  vtkNew<vtkHeadlessRenderWindow> window;
  PromiseScene scene;
  JudgeScene truth;
};

const double Extinction = -std::log1p(-Opacity); // the unit distance is 1 mm

}

TEST(Judge, HomogeneousMatterHasItsClosedForm)
{
  HomogeneousBlock block(4.0);
  block.scene.Property()->SetScalarOpacityUnitDistance(1.0);
  const glm::dvec4 color = block.Middle(1);
  const double alpha = 1.0 - std::exp(-4.0 * Extinction);
  EXPECT_NEAR(color.a, alpha, 1e-6);
  EXPECT_NEAR(color.r, Color * alpha, 1e-6);
}

TEST(Judge, ScatteredLightFromAnAngleHasItsClosedForm)
{
  HomogeneousBlock block(4.0);
  block.scene.Property()->SetScalarOpacityUnitDistance(1.0);
  block.AddLight(35.0);
  block.Scatter();
  const double cosine = std::cos(glm::radians(35.0));
  const double expected =
    Color * cosine / (cosine + 1.0) * (1.0 - std::exp(-4.0 * Extinction * (1.0 / cosine + 1.0)));
  EXPECT_NEAR(block.Middle(4).r, expected, 1e-5);
  EXPECT_NEAR(block.Middle(1).r, expected, 1e-3);
}

TEST(Judge, SoftLightOfDenseMatterHasItsClosedForm)
{
  HomogeneousBlock block(4.0);
  block.scene.Property()->SetScalarOpacityUnitDistance(0.05);
  block.AddLight(0.0)->GetInformation()->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), 20.0);
  block.Scatter();
  const double cosine = std::cos(glm::radians(20.0));
  const double expected = Color * (1.0 - std::log(2.0 / (1.0 + cosine)) / (1.0 - cosine));
  EXPECT_NEAR(block.Middle(4).r, expected, 1e-5);
}

TEST(Judge, VisibilityInAHomogeneousSlabHasItsClosedForm)
{
  HomogeneousBlock block(4.0);
  block.scene.Property()->SetScalarOpacityUnitDistance(1.0);
  block.scene.Mapper()->SetAmbientOcclusion(1.0);
  block.scene.Mapper()->SetAmbientOcclusionReach(1.5);
  block.Middle(1);
  // All ways to a face are longer than the reach there.
  EXPECT_NEAR(
    JudgeLight(block.truth, 1).Visibility(glm::dvec3(0.0)), std::exp(-1.5 * Extinction), 1e-9);
  // Half of the directions lead out of a face, and so does the rule, which is symmetric.
  EXPECT_NEAR(JudgeLight(block.truth, 1).Visibility({ 0.0, 0.0, 2.0 }),
    0.5 + 0.5 * std::exp(-1.5 * Extinction), 1e-9);
}

TEST(Judge, GeometryIsMetWhereItIs)
{
  const std::vector<JudgeTriangle> triangles = { { glm::dvec3(-1.0, -1.0, 3.0),
    glm::dvec3(1.0, -1.0, 3.0), glm::dvec3(0.0, 1.0, 3.0) } };
  EXPECT_DOUBLE_EQ(JudgedHit(triangles, { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } }), 2.0);
  EXPECT_TRUE(std::isinf(JudgedHit(triangles, { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } })));
  EXPECT_TRUE(std::isinf(JudgedHit(triangles, { { 2.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } })));
}

namespace
{

// A turned volume of lumps with a look that bends and jumps.
void MakeLumps(PromiseScene& scene, int mode, bool isLit)
{
  scene.AddVolume({ 9, 8, 7 }, { 1.0, 1.3, 0.8 }, promise::Lumps(scene.dice));
  scene.SetLook({ { 0.3, 0.0 }, { 0.31, 0.2 }, { 0.5, 0.2 }, { 0.5, 0.4 }, { 0.9, 0.7 } }, 2.0);
  scene.Turn();
  scene.LookFrom(scene.Direction(), 1.3);
  scene.Shade();
  scene.Property()->SetShade(isLit);
  scene.AddHeadLight();
  scene.Property()->GetIsoSurfaceValues()->SetValue(0, 0.45);
  scene.Mapper()->SetBlendMode(mode);
  scene.side = 16;
  scene.Draw();
}

// The largest difference between the judge and the tree's reference integrator.
double LargestDifference(int mode, bool isLit)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  PromiseScene scene(std::uint64_t(mode) + 3, window);
  MakeLumps(scene, mode, isLit);
  VolumeStage stage(scene.Image(), scene.side, window);
  stage.volume->SetProperty(scene.Property());
  stage.volume->SetUserMatrix(scene.Volume()->GetMatrix());
  stage.mapper->SetBlendMode(mode);
  stage.renderer->SetActiveCamera(scene.Renderer()->GetActiveCamera());
  const std::vector<float> reference = stage.Truth(1e-7);
  const JudgeScene truth = ReadJudgeScene(scene.Objects());
  double largest = 0.0;
  for (int i = 0; i < scene.side * scene.side; ++i)
  {
    const glm::dvec4 judged = Judge(truth).Pixel({ i % scene.side + 0.5, i / scene.side + 0.5 }, 8);
    for (int channel = 0; channel < 4; ++channel)
    {
      largest = std::max(
        largest, std::abs(judged[channel] - double(reference[std::size_t(4 * i + channel)])));
    }
  }
  return largest;
}

}

// The reference integrator of the tree is another program for the same integral.
TEST(Judge, AgreesWithTheReferenceIntegratorInAllBlendModes)
{
  for (const int mode :
    { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
      vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
      vtkVolumeMapper::ADDITIVE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND })
  {
    EXPECT_LT(LargestDifference(mode, false), 1e-5) << "mode " << mode;
  }
}

// The judge does not cut rays where a lit surface turns away from the eye, and errs a little there.
TEST(Judge, AgreesWithTheReferenceIntegratorInAHeadLight)
{
  EXPECT_LT(LargestDifference(vtkVolumeMapper::COMPOSITE_BLEND, true), 2e-3);
  EXPECT_LT(LargestDifference(vtkVolumeMapper::ISOSURFACE_BLEND, true), 1e-5);
}

namespace
{

// The judge's picture as if a mapper had drawn it.
std::vector<float> PerfectPicture(const JudgeScene& truth)
{
  std::vector<float> picture;
  for (int i = 0; i < truth.width * truth.height; ++i)
  {
    const glm::dvec4 color =
      Judge(truth).Pixel({ i % truth.width + 0.5, i / truth.width + 0.5 }, 8);
    picture.insert(
      picture.end(), { float(color.r), float(color.g), float(color.b), float(color.a) });
  }
  return picture;
}

}

TEST(PictureVerdict, CountsPixelsBeyondTheTolerance)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  PromiseScene scene(5, window);
  scene.AddVolume({ 6, 6, 6 }, glm::dvec3(1.0), promise::Lumps(scene.dice));
  scene.SetLook({ { 0.2, 0.0 }, { 0.9, 0.6 } });
  scene.LookFrom({ 1.0, 0.4, 0.3 });
  scene.side = 40;
  scene.Draw();
  const JudgeScene truth = ReadJudgeScene(scene.Objects());
  std::vector<float> picture = PerfectPicture(truth);
  const std::vector<float> nothing(picture.size());
  using Answer = PictureVerdict::Answer;
  EXPECT_EQ(VerdictOn(truth, picture, nothing, 1).answer, Answer::Kept);
  // One of 1600 pixels may be off; two may not.
  picture[4 * 700] += 3.0f * float(truth.errorTolerance);
  const PictureVerdict one = VerdictOn(truth, picture, nothing, 1);
  EXPECT_EQ(one.answer, Answer::Kept);
  EXPECT_EQ(one.beyond, 1);
  EXPECT_NEAR(one.largest, 3.0, 0.1);
  picture[4 * 900 + 3] = std::nanf("");
  EXPECT_EQ(VerdictOn(truth, picture, nothing, 1).answer, Answer::Beyond);
}
