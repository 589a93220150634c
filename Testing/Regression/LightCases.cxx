#include "Regression/RegressionCase.h"

#include "Module/Scenes/CubicScene.h"
#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/ReferenceMixture.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{

void HeadLight(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
}

void SeveralLights(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->SetSpecularPower(5.0);
  UseSunAndLamp(scene.renderer);
}

// Shades a scene whose lights `add` adds.
// @param add  (renderer)
template <class Add>
void ShadeIn(MapperScene& scene, const Add& add)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->SetSpecularPower(5.0);
  scene.renderer->AutomaticLightCreationOff();
  scene.renderer->RemoveAllLights();
  add(scene.renderer);
}

void AddSun(vtkRenderer* renderer)
{
  AddLight(renderer, { 1.0, -0.5, 2.0 }, glm::dvec3(0.0));
}

// In front of the torso, from which it is as far as the torso is wide.
vtkLight* AddLamp(vtkRenderer* renderer)
{
  vtkLight* const lamp = AddLight(renderer, { -60.0, -250.0, 30.0 }, glm::dvec3(0.0));
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  return lamp;
}

void DirectionalLight(MapperScene& scene)
{
  ShadeIn(scene, AddSun);
}

void PositionalLight(MapperScene& scene)
{
  ShadeIn(scene, AddLamp);
}

void SpotLight(MapperScene& scene)
{
  ShadeIn(scene,
    [](vtkRenderer* renderer)
    {
      vtkLight* const spot = AddLamp(renderer);
      spot->SetConeAngle(20.0);
      spot->SetExponent(0.0);
    });
}

void ColouredLights(MapperScene& scene)
{
  ShadeIn(scene,
    [](vtkRenderer* renderer)
    {
      AddLight(renderer, { 2.0, -1.0, 1.0 }, glm::dvec3(0.0))->SetColor(1.0, 0.4, 0.1);
      AddLight(renderer, { -2.0, -1.0, 1.0 }, glm::dvec3(0.0))->SetColor(0.1, 0.4, 1.0);
    });
}

// Half of the light of a lamp is scattered, and mostly goes back.
void ScatteringMatter(MapperScene& scene)
{
  PositionalLight(scene);
  scene.mapper->SetVolumetricScatteringBlending(0.5);
  scene.mapper->SetScatteringAnisotropy(-0.3);
}

// The reference needs a ray to the light for each of its samples, so that these images are small.
RegressionScene InShadows(void (*light)(MapperScene&))
{
  constexpr double Tolerance = 1e-3;
  const auto scene = NewScene(SmallTorso(), RegressionSide / 2);
  light(*scene);
  scene->mapper->ShadowsOn();
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene]
  { return scene->TruthOf(MaterialInOwnShadows(*scene, Tolerance), Tolerance); };
  return regression;
}

// A ball above a plate, so small that the reference can ask for light from many sides: int16, 16 x
// 16 x 12 voxels of 4 mm, soft at its surfaces.
vtkSmartPointer<vtkImageData> BallOverPlate()
{
  constexpr glm::ivec3 Size(16, 16, 12);
  constexpr double VoxelMm = 4.0;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Size.x, Size.y, Size.z);
  image->SetSpacing(VoxelMm, VoxelMm, VoxelMm);
  image->SetOrigin(-0.5 * VoxelMm * (Size.x - 1), -0.5 * VoxelMm * (Size.y - 1), 0.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* voxel = static_cast<short*>(image->GetScalarPointer());
  for (int z = 0; z < Size.z; ++z)
  {
    for (int y = 0; y < Size.y; ++y)
    {
      for (int x = 0; x < Size.x; ++x)
      {
        const double outsideOfBall = glm::distance(glm::dvec3(x, y, z), { 7.5, 7.5, 6.5 }) - 2.5;
        const double outside = std::min(outsideOfBall, z - 2.0); // distance from both [voxels]
        *voxel++ = short(100.0 - 300.0 * std::clamp(outside, -1.0, 1.0));
      }
    }
  }
  return image;
}

// @param material  (scene, tolerance) -> its truth
RegressionScene OfBallOverPlate(
  void (*prepare)(MapperScene&), MapperScene::Material (*material)(MapperScene&, double))
{
  constexpr double Tolerance = 1e-3;
  const auto scene = NewScene(BallOverPlate(), RegressionSide / 2);
  prepare(*scene);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, material]
  { return scene->TruthOf(material(*scene, Tolerance), Tolerance); };
  return regression;
}

void AmbientOcclusion(MapperScene& scene)
{
  DirectionalLight(scene);
  scene.mapper->SetAmbientOcclusion(0.5);
}

void SoftShadows(MapperScene& scene)
{
  ShadeIn(scene,
    [](vtkRenderer* renderer)
    {
      AddLight(renderer, { 2.0, -1.0, 2.0 }, glm::dvec3(0.0))
        ->GetInformation()
        ->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), 20.0);
    });
  scene.mapper->ShadowsOn();
}

void Damping(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetDampingGradient(300.0);
}

void GradientOpacity(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.1);
  factors->AddPoint(150.0, 1.0);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
}

MapperScene::Material MixtureOf(MapperScene& scene)
{
  const auto mixture = std::make_shared<ReferenceMixture>(scene);
  return [mixture](glm::dvec3 position, const varimarch::Ray& ray)
  { return mixture->At(position, ray); };
}

void GrayFunction(MapperScene& scene)
{
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(-200.0, 0.1);
  gray->AddPoint(400.0, 0.9);
  scene.volume->GetProperty()->SetColor(gray);
}

void Nearest(MapperScene& scene)
{
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.volume->GetProperty()->ShadeOn();
}

RegressionScene Cubic()
{
  const auto scene = std::make_shared<CubicScene>(NoisyEdge(VTK_SHORT).Get(), RegressionSide);
  scene->mapper->SetErrorTolerance(1.0 / 64.0);
  scene->mapper->ProcessorMarchingOn();
  return SceneOf(scene, scene->Truth());
}

void BinaryMask(MapperScene& scene)
{
  scene.mapper->SetMaskTypeToBinary();
  scene.mapper->SetMaskInput(MaskOf(
    { 40, 36, 24 }, [](glm::ivec3 voxel) { return (voxel.x / 8 + voxel.z / 6) % 2; },
    VTK_UNSIGNED_CHAR));
}

RegressionScene LabelMap()
{
  const auto torso = std::make_shared<LabelledTorso>(RegressionSide);
  torso->scene.mapper->SetErrorTolerance(1.0 / 64.0);
  torso->scene.mapper->ProcessorMarchingOn();
  return SceneOf(std::shared_ptr<MapperScene>(torso, &torso->scene),
    [torso](glm::dvec3 position, const varimarch::Ray& ray)
    { return torso->MaterialAt(position, ray); });
}

RegressionScene LabelMapOverTwoValues()
{
  const auto torso = std::make_shared<LabelledTorso>(RegressionSide);
  torso->scene.mapper->SetErrorTolerance(1.0 / 64.0);
  torso->scene.mapper->ProcessorMarchingOn();
  ShowValueAndGradient(torso->scene);
  const MapperScene::Material withoutLabel = MaterialOfTwoValues(torso->scene);
  return SceneOf(std::shared_ptr<MapperScene>(torso, &torso->scene),
    [torso, withoutLabel](glm::dvec3 position, const varimarch::Ray& ray)
    { return torso->MaterialOver(withoutLabel, position, ray); });
}

}

std::vector<RegressionCase> LightCases()
{
  return {
    TorsoCase("HeadLight", HeadLight),
    MaterialCase("SeveralLights", SeveralLights, MaterialInLights),
    MaterialCase("DirectionalLight", DirectionalLight, MaterialInLights),
    MaterialCase("PositionalLight", PositionalLight, MaterialInLights),
    MaterialCase("SpotLight", SpotLight, MaterialInLights),
    MaterialCase("ColouredLights", ColouredLights, MaterialInLights),
    { "Shadows", [] { return InShadows(DirectionalLight); }, 5.0, TooManySegments },
    { "ShadowsOfALamp", [] { return InShadows(PositionalLight); } },
    { "ShadowsOfTwoLights", [] { return InShadows(ColouredLights); } },
    { "SoftShadows", [] { return OfBallOverPlate(SoftShadows, MaterialInOwnShadows); }, 5.0,
      TooManySegments },
    { "AmbientOcclusion", [] { return OfBallOverPlate(AmbientOcclusion, OccludedMaterial); } },
    MaterialCase("Scattering", ScatteringMatter, MaterialInLights),
    MaterialCase("Damping", Damping, DampedMaterial),
    MaterialCase("GradientOpacity", GradientOpacity, MixtureOf),
    MaterialCase("TwoValues", ShowValueAndGradient, MaterialOfTwoValues),
    TorsoCase("GrayFunction", GrayFunction),
    TorsoCase("Nearest", Nearest),
    { "Cubic", Cubic },
    MaterialCase("BinaryMask", BinaryMask, MaskedMaterial),
    { "LabelMap", LabelMap },
    { "LabelMapOverTwoValues", LabelMapOverTwoValues },
  };
}
