// Rays that the processor marches, in packets, where OpenGL is drawn by it too: the pictures are
// those of the shaders, to a twentieth of a grey level (RMSE).

#include "Module/ProcessorMarching.h"
#include "Scene/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkContourValues.h>
#include <vtkLight.h>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

void LeaveLowerGradientsOut(MapperScene& scene)
{
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.0);
  factors->AddPoint(100.0, 1.0);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
}

// Of values that hardly any ray has the largest of.
void ShowAMaximum(MapperScene& scene)
{
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1100.0, 0.0);
  scene.opacities->AddPoint(1500.0, 1.0);
}

void ShowAMinimum(MapperScene& scene)
{
  scene.mapper->SetBlendModeToMinimumIntensity();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1300.0, 1.0);
  scene.opacities->AddPoint(500.0, 0.0);
}

// Skin, through which bone is seen.
void ShowIsosurfaces(MapperScene& scene)
{
  scene.mapper->SetBlendModeToIsoSurface();
  scene.volume->GetProperty()->ShadeOn();
  vtkContourValues* const values = scene.volume->GetProperty()->GetIsoSurfaceValues();
  values->SetValue(0, -300.0);
  values->SetValue(1, 100.0);
  values->SetValue(2, 300.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-300.0, 0.2);
  scene.opacities->AddPoint(300.0, 0.8);
}

// Beside the head light; with ambient light and highlights.
vtkLight* ShineFromTheSide(MapperScene& scene)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetSpecular(0.4);
  scene.Draw(); // which makes the head light
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(300.0, 200.0, 100.0);
  light->SetAmbientColor(0.5, 0.4, 0.3);
  light->SetDiffuseColor(0.9, 0.3, 0.6);
  light->SetSpecularColor(0.2, 0.8, 0.4);
  scene.renderer->AddLight(light);
  return light;
}

}

class ProcessorMarchingOf
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingOf, IsThePictureOfTheShader)
{
  MapperScene scene(SmallTorso());
  GetParam().make(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryPart, ProcessorMarchingOf,
  testing::Values(Change{ "Midpoints", [](MapperScene&) {} },
    Change{ "Light", [](MapperScene& s) { s.volume->GetProperty()->ShadeOn(); } },
    // With a field shaders look for bricks at every sample, packets at every fourth.
    Change{ "LightAtMidpoints",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.mapper->SetIntegrationRule(Mapper::Midpoint);
        s.mapper->SetAccelerationModeToOff();
      } },
    Change{ "Highlights",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.volume->GetProperty()->SetSpecular(0.7);
        s.volume->GetProperty()->SetSpecularPower(23.0);
      } },
    Change{ "Damping",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.mapper->SetDampingGradient(200.0);
      } },
    Change{ "PreIntegration",
      [](MapperScene& s)
      {
        // Its segments are half as long as a shader's: at steps as short as these that is the same.
        s.mapper->SetIntegrationRule(Mapper::PreIntegrated);
        s.mapper->AutoAdjustSampleDistancesOff();
        s.mapper->SetSampleDistance(0.5);
      } },
    Change{ "OpacityOfGradients", LeaveLowerGradientsOut },
    Change{ "OpacityOfGradientsAtMidpoints",
      [](MapperScene& s)
      {
        LeaveLowerGradientsOut(s);
        s.mapper->SetIntegrationRule(Mapper::Midpoint);
        s.mapper->SetAccelerationModeToOff();
      } },
    Change{ "LightAndOpacityOfGradients",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        LeaveLowerGradientsOut(s);
      } },
    Change{ "LightsFromTheSide",
      [](MapperScene& s)
      {
        ShineFromTheSide(s);
        ShineFromTheSide(s)->SetLightTypeToCameraLight();
      } },
    Change{ "LightOnOneSide",
      [](MapperScene& s)
      {
        ShineFromTheSide(s);
        s.renderer->TwoSidedLightingOff();
      } },
    Change{ "ANearLight",
      [](MapperScene& s)
      {
        vtkLight* const light = ShineFromTheSide(s);
        light->PositionalOn();
        light->SetAttenuationValues(0.5, 0.002, 1e-5);
        light->SetConeAngle(40.0);
        light->SetExponent(3.0);
      } },
    Change{ "DampingOfLights",
      [](MapperScene& s)
      {
        ShineFromTheSide(s);
        s.mapper->SetDampingGradient(200.0);
      } },
    Change{ "AMaximum", ShowAMaximum }, Change{ "AMinimum", ShowAMinimum },
    Change{ "AMaximumWithoutField",
      [](MapperScene& s)
      {
        ShowAMaximum(s);
        s.mapper->SetAccelerationModeToOff();
      } },
    Change{ "AMaximumOfAPart",
      [](MapperScene& s)
      {
        ShowAMaximum(s);
        Clip(s);
      } },
    Change{ "Isosurfaces", ShowIsosurfaces },
    Change{ "IsosurfacesWithoutFieldNorLight",
      [](MapperScene& s)
      {
        ShowIsosurfaces(s);
        s.volume->GetProperty()->ShadeOff();
        s.mapper->SetAccelerationModeToOff();
      } },
    Change{ "IsosurfacesOfAPart",
      [](MapperScene& s)
      {
        ShowIsosurfaces(s);
        Clip(s);
      } },
    Change{ "NoField", [](MapperScene& s) { s.mapper->SetAccelerationModeToOff(); } },
    Change{ "NoFieldAndLight",
      [](MapperScene& s)
      {
        s.mapper->SetAccelerationModeToOff();
        s.volume->GetProperty()->ShadeOn();
      } },
    Change{ "Noise", [](MapperScene& s) { s.mapper->UseJitteringOn(); } },
    Change{ "ClippingPlanes", Clip },
    Change{ "Geometry",
      [](MapperScene& s)
      {
        const double middle[3] = { 0.0, 0.0, 0.0 };
        s.renderer->AddActor(Ball(middle, 80.0));
      } },
    Change{ "WindowAndLevel",
      [](MapperScene& s)
      {
        s.mapper->SetFinalColorWindow(0.6f);
        s.mapper->SetFinalColorLevel(0.4f);
      } },
    Change{ "AParallelProjection",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->ParallelProjectionOn();
        s.renderer->GetActiveCamera()->SetParallelScale(180.0);
      } },
    Change{ "AViewAlongAnAxis",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 1.0);
        s.renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
        s.renderer->ResetCamera();
      } },
    Change{ "AnEyeInTheVolume",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->SetPosition(0.0, 20.0, 0.0);
        s.renderer->ResetCameraClippingRange();
      } },
    Change{ "FewerRays",
      [](MapperScene& s)
      {
        s.mapper->SetImageSampleDistance(2.0f);
        const double middle[3] = { 0.0, 0.0, 0.0 };
        s.renderer->AddActor(Ball(middle, 80.0));
      } },
    Change{ "MeanOfPictures", [](MapperScene& s) { s.mapper->SetMaximumAccumulatedPictures(2); } }),
  NameOf);

class ProcessorMarchingOfVoxels
  : public ProcessorMarching
  , public testing::WithParamInterface<int>
{
};

TEST_P(ProcessorMarchingOfVoxels, IsThePictureOfTheShader)
{
  MapperScene scene(TorsoOfType(GetParam()));
  ShowUpperValues(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryType, ProcessorMarchingOfVoxels,
  testing::Values(
    VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_FLOAT));

class ProcessorMarchingOfBlends
  : public ProcessorMarching
  , public testing::WithParamInterface<int>
{
};

TEST_P(ProcessorMarchingOfBlends, HasNothingButPixelsOnTheDevice)
{
  vtkNew<vtkPlane> plane; // oblique: others are a box
  plane->SetNormal(1.0, 1.0, 1.0);
  const auto prepare = [&](MapperScene& scene)
  {
    scene.mapper->SetBlendMode(GetParam());
    scene.mapper->UseJitteringOn();
    scene.mapper->AddClippingPlane(plane);
    LeaveLowerGradientsOut(scene);
    ShineFromTheSide(scene);
    scene.renderer->GetActiveCamera()->Zoom(8.0); // until all pixels see something
  };
  MapperScene scene(SmallTorso());
  prepare(scene);
  scene.mapper->ProcessorMarchingOn();
  scene.Draw();
  const vtkIdType pixels = vtkIdType(scene.size) * scene.size * 4 * vtkIdType(sizeof(float));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), pixels);
  scene.mapper->ProcessorMarchingOff();
  scene.Draw();
  MapperScene byShader(SmallTorso());
  prepare(byShader);
  const std::vector<float> drawn = byShader.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), byShader.mapper->GetGraphicsMemoryBytes());
  EXPECT_EQ(scene.Draw(), drawn);
}

INSTANTIATE_TEST_SUITE_P(EveryBlend, ProcessorMarchingOfBlends,
  testing::Values(
    Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::ISOSURFACE_BLEND));

// At these tolerances no single ray decides, in which a difference of rounding could be seen.
TEST_F(ProcessorMarching, FindsTheStepsOfTheShaderForATolerance)
{
  for (const double tolerance : { 1.0 / 32.0, 1.0 / 128.0 })
  {
    MapperScene scene(SmallTorso());
    scene.mapper->SetErrorTolerance(tolerance);
    ASSERT_TRUE(ByProcessor(scene));
    const double ofPackets = scene.mapper->GetUsedSampleDistance();
    scene.Draw();
    ASSERT_FALSE(scene.ShaderParts().empty());
    EXPECT_NEAR(scene.mapper->GetUsedSampleDistance(), ofPackets, 0.02 * ofPackets);
  }
}

TEST_F(ProcessorMarching, SeesWhatChanges)
{
  MapperScene scene(SmallTorso());
  ExpectSamePicture(scene);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-400.0, 0.0);
  scene.opacities->AddPoint(-100.0, 0.05);
  ExpectSamePicture(scene);
  short* const voxels = static_cast<short*>(scene.image->GetScalarPointer());
  std::fill(voxels, voxels + 40 * 36 * 12, short(-1000));
  scene.image->Modified();
  ExpectSamePicture(scene);
}

// The smallest volume that is for packets, which read pairs up to its very end.
TEST_F(ProcessorMarching, ReadsNothingBeyondTheLastVoxel)
{
  vtkNew<vtkImageData> cell;
  cell->SetDimensions(2, 2, 2);
  cell->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < 8; ++i)
  {
    static_cast<short*>(cell->GetScalarPointer())[i] = short(50 * i);
  }
  MapperScene scene(cell);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.9);
  ExpectSamePicture(scene);
}

// A strip is a part of the pixels, whose packets begin elsewhere.
TEST_F(ProcessorMarching, InPartsIsThePictureInTheEnd)
{
  MapperScene scene(SmallTorso(), 150);
  scene.mapper->ProcessorMarchingOn();
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetLongestPartSeconds(1e-9);
  std::vector<float> last;
  do
  {
    last = scene.Draw();
  } while (scene.mapper->GetDrawnPart() < 1.0);
  EXPECT_TRUE(scene.ShaderParts().empty());
  const varimarch::ImageError difference =
    varimarch::CompareImages(last.data(), whole.data(), whole.size() / 4);
  EXPECT_LT(difference.largest, 0.01);
}

// What shaders have on the device goes when they are not needed, and comes again.
TEST_F(ProcessorMarching, ComesAndGoes)
{
  MapperScene scene(SmallTorso());
  scene.mapper->ProcessorMarchingOn();
  const std::vector<float> first = scene.Draw();
  scene.mapper->SetBlendModeToMaximumIntensity();
  EXPECT_NE(scene.Draw(), first);
  scene.mapper->SetBlendModeToComposite();
  EXPECT_EQ(scene.Draw(), first);
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 1);
}

TEST_F(ProcessorMarching, TakesMoreSamplesThanShadersMay)
{
  MapperScene scene(SmallTorso(), 16);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(scene.image->GetLength() / 60000.0);
  const std::vector<float> truth = scene.Truth();
  for (const bool byProcessor : { false, true })
  {
    scene.mapper->SetProcessorMarching(byProcessor);
    const ExpectedVtkErrors itIsTooShort;
    const std::vector<float> drawn = scene.Draw();
    EXPECT_EQ(itIsTooShort.Messages().empty(), byProcessor);
    const varimarch::ImageError error =
      varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LT(error.largest, 0.3);
  }
}

TEST_F(ProcessorMarching, LeavesShadersTheirLongerSteps)
{
  const ExpectedVtkErrors itCannotBeKept;
  MapperScene scene(
    varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 64, 64 }, 7 }), 16);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetErrorTolerance(1e-6);
  scene.mapper->ProcessorMarchingOn();
  scene.Draw();
  const double shortestOfLit = scene.image->GetLength() / 10000.0;
  EXPECT_LT(scene.mapper->GetUsedSampleDistance(), 0.95 * shortestOfLit);
  scene.mapper->DrawFetchCountsOn();
  scene.Draw();
  EXPECT_GT(scene.mapper->GetUsedSampleDistance(), 0.95 * shortestOfLit);
}
