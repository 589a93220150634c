#include "Regression/RegressionCase.h"

#include "Module/CubicScene.h"
#include "Module/LabelledTorso.h"
#include "Module/ProcessorMarching.h"
#include "Module/ReferenceMaterials.h"
#include "Module/ReferenceMixture.h"
#include "Module/UsualSettings.h"

#include <vtkLight.h>

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
