#include "PromiseBeginnings.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>

namespace varimarch::promise
{

// A volume of a content, seen from anywhere.
void BeginUnlit(PromiseScene& scene, const PromiseContent& content, glm::ivec3 size, int type)
{
  scene.AddVolume(size, Spacing(scene.dice), content, type);
  scene.side = scene.dice.OneOf<int>({ 32, 40, 48 });
  if (scene.dice.Chance(0.5))
  {
    scene.Turn();
  }
}

void BeginAnyUnlit(PromiseScene& scene, const PromiseNodes& nodes, int type)
{
  const glm::ivec3 size = Size(scene.dice, 8, 18);
  BeginUnlit(scene, AnyContent(scene.dice, size), size, type);
  scene.SetLook(nodes, scene.dice.Between(0.5, 3.0));
  scene.LookFromAnywhere();
}

void SetGradientOpacity(PromiseScene& scene)
{
  vtkNew<vtkPiecewiseFunction> factors;
  const double width = scene.ValueOf(1.0) - scene.ValueOf(0.0);
  const double from = scene.dice.Between(0.0, 0.08) * width;
  const double rise = scene.dice.OneOf<double>({ 0.003, 0.03, 0.12 }) * width;
  factors->AddPoint(from, scene.dice.Between(0.0, 0.4));
  factors->AddPoint(from + rise, scene.dice.Between(0.5, 1.0));
  scene.Property()->SetGradientOpacity(factors);
}

void BeginLit(PromiseScene& scene, const PromiseContent& content, glm::ivec3 size,
  const PromiseNodes& nodes, int type)
{
  scene.AddVolume(size, Spacing(scene.dice), content, type);
  scene.side = scene.dice.OneOf<int>({ 24, 28, 32 });
  scene.SetLook(nodes, scene.dice.Between(0.7, 2.0));
  if (scene.dice.Chance(0.4))
  {
    scene.Turn();
  }
  scene.LookFromAnywhere();
  scene.Shade(scene.dice.OneOf<double>({ 0.0, 0.2 }));
}

void BeginAnyLit(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 8, 14);
  BeginLit(scene, AnyContent(scene.dice, size), size, AnyNodes(scene.dice));
}

void BeginLitBands(PromiseScene& scene)
{
  const int voxels = scene.dice.Whole(10, 18);
  BeginLit(scene, Distances(scene.dice, glm::ivec3(voxels)), glm::ivec3(voxels),
    Bands(scene.dice, voxels));
}

void BeginLitSheets(PromiseScene& scene)
{
  BeginLit(scene, Sheets(scene.dice), Size(scene.dice, 10, 16), Dense(scene.dice));
}

void BeginLitWires(PromiseScene& scene)
{
  BeginLit(scene, Wires(scene.dice), Size(scene.dice, 10, 14), Dense(scene.dice));
}

void BeginLitWalls(PromiseScene& scene)
{
  BeginLit(scene, Walls(scene.dice), Size(scene.dice, 10, 14),
    { { 0.3, 0.0 }, { 0.8, scene.dice.Between(0.3, 0.95) } });
}

void BeginLitNoise(PromiseScene& scene)
{
  BeginLit(scene, Noise(scene.dice), Size(scene.dice, 8, 12), Ramp(scene.dice));
}

void BeginLitPetOverCt(PromiseScene& scene)
{
  scene.AddVolume(glm::ivec3(5), glm::dvec3(4.0), Ball(scene.dice, glm::ivec3(5)));
  const PromiseContent ct =
    scene.dice.Chance(0.5) ? Walls(scene.dice) : AnyContent(scene.dice, glm::ivec3(15));
  scene.AddVolume(glm::ivec3(15), glm::dvec3(1.0), ct);
  scene.side = 24;
  scene.SetLook({ { 0.1, 0.0 }, { 0.9, scene.dice.Between(0.2, 0.6) } }, 1.0, 0);
  scene.SetLook({ { 0.3, 0.0 }, { 0.7, scene.dice.Between(0.2, 0.9) } }, 1.0, 1);
  if (scene.dice.Chance(0.4))
  {
    scene.Turn(1);
  }
  scene.LookFromAnywhere();
  scene.Shade();
}

void Occlude(PromiseScene& scene)
{
  scene.AddHeadLight();
  scene.side = std::min(scene.side, 16);
  scene.Mapper()->SetAmbientOcclusion(scene.dice.Between(0.4, 1.0));
  scene.Mapper()->SetAmbientOcclusionReach(
    scene.dice.Between(3.0, 8.0) * scene.Image()->GetSpacing()[0]);
}

vtkLight* CastShadows(PromiseScene& scene)
{
  scene.Mapper()->ShadowsOn();
  return scene.AddDistantLight();
}

void Soften(vtkLight* light, PromiseScene& scene)
{
  light->GetInformation()->Set(
    vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), scene.dice.Between(2.0, 25.0));
}

}
