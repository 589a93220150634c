// Pictures of the parts of a volume, laid over each other, against that of the whole.

#include "Module/Accuracy/DividedVolume.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

using namespace varimarch;

namespace
{

constexpr double SharedTolerance = 1.0 / 64.0;

// The values of ParaView's test volume, with 81 voxels along each axis.
vtkSmartPointer<vtkImageData> Wavelet()
{
  constexpr int Half = 40;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-Half, Half, -Half, Half, -Half, Half);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxel = static_cast<float*>(image->GetScalarPointer());
  for (int k = -Half; k <= Half; ++k)
  {
    for (int j = -Half; j <= Half; ++j)
    {
      for (int i = -Half; i <= Half; ++i)
      {
        const double x = double(i) / Half;
        const double y = double(j) / Half;
        const double z = double(k) / Half;
        *voxel++ = float(255.0 * std::exp(-2.0 * (x * x + y * y + z * z)) +
          10.0 * std::sin(30.0 * x) + 18.0 * std::sin(20.0 * y) + 5.0 * std::cos(25.0 * z));
      }
    }
  }
  return image;
}

void SetLook(MapperScene& scene, double opacity)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  scene.colors->AddRGBPoint(130.0, 0.9, 0.8, 0.3);
  scene.colors->AddRGBPoint(280.0, 1.0, 0.2, 0.1);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(120.0, 0.0);
  scene.opacities->AddPoint(280.0, opacity);
}

void Light(MapperScene& scene)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.2);
  property->SetSpecularPower(16.0);
}

void LookFrom(MapperScene& scene, const double (&eye)[3], const double (&focus)[3], double angle)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(angle);
  scene.renderer->ResetCameraClippingRange();
}

// Geometry that has a depth, but no colour, so that the image shows the volume alone.
class DepthActor : public vtkOpenGLActor
{
public:
  static DepthActor* New();
  vtkTypeMacro(DepthActor, vtkOpenGLActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    vtkOpenGLState* const state =
      vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    state->vtkglColorMask(0, 0, 0, 0);
    this->Superclass::Render(renderer, mapper);
    state->vtkglColorMask(1, 1, 1, 1);
  }
};

vtkStandardNewMacro(DepthActor);

struct DividedCase
{
  std::string name;
  std::function<void(MapperScene&)> set;
};

const std::vector<DividedCase>& DividedViews()
{
  static const std::vector<DividedCase> cases = { { "plain", [](MapperScene&) {} },
    { "lit", [](MapperScene& scene) { Light(scene); } },
    { "opaque",
      [](MapperScene& scene)
      {
        SetLook(scene, 0.95);
        Light(scene);
      } },
    { "turned", [](MapperScene& scene) { scene.volume->SetOrientation(180.0, 0.0, 0.0); } },
    { "oblique", [](MapperScene& scene) { scene.volume->SetOrientation(20.0, 30.0, 40.0); } },
    // Parts of 12 voxels would try shorter steps by their own sides.
    { "croppedToThinParts",
      [](MapperScene& scene)
      {
        SetLook(scene, 0.01);
        scene.mapper->CroppingOn();
        scene.mapper->SetCroppingRegionPlanes(-40.0, 40.0, -40.0, 40.0, -12.0, 12.0);
      } },
    { "cropped",
      [](MapperScene& scene)
      {
        scene.mapper->CroppingOn();
        scene.mapper->SetCroppingRegionPlanes(-40.0, 40.0, -28.0, 28.0, -20.0, 44.0);
      } },
    { "geometry",
      [](MapperScene& scene)
      {
        const double center[3] = { 6.0, -8.0, 4.0 };
        vtkNew<DepthActor> ball;
        ball->SetMapper(Ball(center, 22.0)->GetMapper());
        scene.renderer->AddActor(ball);
      } },
    { "inside",
      [](MapperScene& scene)
      {
        SetLook(scene, 0.05);
        LookFrom(scene, { 5.0, 3.0, 2.0 }, { 40.0, 30.0, 5.0 }, 60.0);
      } } };
  return cases;
}

const std::vector<DividedCase>& DividedSettings()
{
  static const std::vector<DividedCase> cases = {
    { "preIntegrated",
      [](MapperScene& scene)
      { scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::PreIntegrated); } },
    { "litPreIntegrated",
      [](MapperScene& scene)
      {
        scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::PreIntegrated);
        Light(scene);
      } },
    { "jittered", [](MapperScene& scene) { scene.mapper->UseJitteringOn(); } },
    { "withoutField",
      [](MapperScene& scene)
      { scene.mapper->SetAccelerationMode(vtkVariationFieldVolumeMapper::Off); } }
  };
  return cases;
}

// The peak signal to noise ratio of the colours of two images [dB].
double Decibels(const std::vector<float>& one, const std::vector<float>& other)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    const double difference = double(one[i]) - other[i];
    sum += i % 4 != 3 ? difference * difference : 0.0;
  }
  constexpr double Least = 1e-15; // images may be equal
  return -10.0 * std::log10(sum / (0.75 * double(one.size())) + Least);
}

void UsePackets(MapperScene& scene)
{
  scene.mapper->ProcessorMarchingOn();
  scene.mapper->SetErrorTolerance(SharedTolerance);
}

class SharedSamples : public testing::TestWithParam<DividedCase>
{
protected:
  SharedSamples()
  {
    UsePackets(this->scene);
    SetLook(this->scene, 0.2);
    LookFrom(this->scene, { 120.0, -170.0, 80.0 }, { 0.0, 0.0, 0.0 }, 30.0);
    this->GetParam().set(this->scene);
    this->scene.renderer->ResetCameraClippingRange();
    this->scene.Draw(); // opens the window
  }

  MapperScene scene{ Wavelet(), 128 };
};

}

TEST_P(SharedSamples, MakeTheImageOfPartsThatOfTheWhole)
{
  DividedVolume whole(this->scene, { 1, 1, 1 });
  const std::vector<float> image = whole.Draw();
  ASSERT_TRUE(whole.Steps());
  for (const std::array<int, 3>& parts :
    { std::array<int, 3>{ 2, 1, 1 }, { 1, 2, 2 }, { 2, 2, 2 } })
  {
    DividedVolume divided(this->scene, parts);
    const std::vector<float> laidOver = divided.Draw();
    ASSERT_TRUE(divided.Steps());
    EXPECT_EQ(divided.Steps()->step.sampleDistance, whole.Steps()->step.sampleDistance);
    const double decibels = Decibels(image, laidOver);
    EXPECT_GT(decibels, 90.0) << parts[0] << " " << parts[1] << " " << parts[2];
    this->RecordProperty(
      "decibels" + std::to_string(parts[0] * parts[1] * parts[2]), std::to_string(decibels));
  }
}

std::string NameOfDivided(const testing::TestParamInfo<DividedCase>& info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Views, SharedSamples, testing::ValuesIn(DividedViews()), NameOfDivided);
INSTANTIATE_TEST_SUITE_P(
  Settings, SharedSamples, testing::ValuesIn(DividedSettings()), NameOfDivided);

// Rays of parts neither take longer steps behind what is dense nor end where light is left.
TEST(SharedSamplesOfParts, KeepTheTolerance)
{
  MapperScene scene(SmallTorso());
  UsePackets(scene);
  scene.Draw();
  DividedVolume divided(scene, { 2, 2, 2 });
  const std::vector<float> image = divided.Draw();
  const std::vector<float> truth = scene.Truth();
  EXPECT_LE(CompareImages(image.data(), truth.data(), truth.size() / 4).percentile999,
    255.0 * SharedTolerance);
}

TEST(SharedSamplesOfParts, AreThoseOfTheWholeInCells)
{
  MapperScene scene(TorsoOfCells());
  UsePackets(scene);
  scene.Draw();
  DividedVolume whole(scene, { 1, 1, 1 });
  DividedVolume divided(scene, { 2, 1, 1 });
  const std::vector<float> image = whole.Draw();
  EXPECT_GT(Decibels(image, divided.Draw()), 90.0);
}
