// Everything that packets of rays support: images match those of the shaders to a twentieth of a
// grey level (RMSE).

#include "Module/Scenes/ProcessorMarching.h"

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// Shows values that are hardly ever the largest of a ray.
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
    // With a field, shaders look for bricks at every sample, packets at every fourth one.
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
        // Its segments are half as long as a shader's, which does not matter for short steps.
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
    Change{ "AFunctionOfValueAndGradient", ShowValueAndGradient },
    Change{ "AFunctionOfValueAndGradientWithLight",
      [](MapperScene& s)
      {
        ShowValueAndGradient(s);
        s.volume->GetProperty()->ShadeOn();
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
    Change{ "ASpline", [](MapperScene& s) { s.mapper->CubicInterpolationOn(); } },
    Change{ "ASplineWithLight",
      [](MapperScene& s)
      {
        s.mapper->CubicInterpolationOn();
        s.volume->GetProperty()->ShadeOn();
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
    Change{ "Boxes", ShowBoxes },
    Change{ "BoxesWithoutField",
      [](MapperScene& s)
      {
        ShowBoxes(s);
        s.mapper->SetAccelerationModeToOff();
      } },
    Change{ "BoxesWithLight",
      [](MapperScene& s)
      {
        ShowBoxes(s);
        s.volume->GetProperty()->ShadeOn();
      } },
    Change{ "BoxesWithLightAndOpacityOfGradients",
      [](MapperScene& s)
      {
        ShowBoxes(s);
        s.volume->GetProperty()->ShadeOn();
        LeaveLowerGradientsOut(s);
      } },
    Change{ "AMaximumOfBoxes",
      [](MapperScene& s)
      {
        ShowBoxes(s);
        ShowAMaximum(s);
      } },
    Change{ "AnAverage", [](MapperScene& s) { s.mapper->SetBlendModeToAverageIntensity(); } },
    Change{ "AnAverageOfSomeValues",
      [](MapperScene& s)
      {
        s.mapper->SetBlendModeToAverageIntensity();
        s.mapper->SetAverageIPScalarRange(-200.0, 300.0);
      } },
    Change{ "AnAverageAlongASpline",
      [](MapperScene& s)
      {
        s.mapper->SetBlendModeToAverageIntensity();
        s.mapper->CubicInterpolationOn();
      } },
    Change{ "ASum", [](MapperScene& s) { s.mapper->SetBlendModeToAdditive(); } },
    Change{ "ASumWithoutField",
      [](MapperScene& s)
      {
        s.mapper->SetBlendModeToAdditive();
        s.mapper->SetAccelerationModeToOff();
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
  testing::Values(VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_FLOAT, VTK_INT, VTK_DOUBLE));
