#include "PromiseBeginnings.h"
#include "PromiseContents.h"
#include "PromiseKinds.h"

#include <vtkCamera.h>

#include <algorithm>

namespace varimarch
{

namespace
{

using namespace promise;

void NoiseKind(PromiseScene& scene)
{
  BeginUnlit(scene, Noise(scene.dice), Size(scene.dice, 8, 16));
  scene.SetLook(Ramp(scene.dice));
  scene.LookFromAnywhere();
}

void ThinPeakKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, ThinPeak(scene.dice));
}

void StepKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, Steps(scene.dice));
}

void OpaqueKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, Opaque(scene.dice));
}

void SheetKind(PromiseScene& scene)
{
  BeginUnlit(scene, Sheets(scene.dice), Size(scene.dice, 10, 18));
  scene.SetLook(Dense(scene.dice));
  scene.LookFromAnywhere();
}

void WireKind(PromiseScene& scene)
{
  BeginUnlit(scene, Wires(scene.dice), Size(scene.dice, 10, 18));
  scene.SetLook(Dense(scene.dice));
  scene.LookFromAnywhere();
}

void WallKind(PromiseScene& scene)
{
  BeginUnlit(scene, Walls(scene.dice), Size(scene.dice, 10, 16));
  scene.SetLook({ { 0.3, 0.0 }, { 0.8, scene.dice.Between(0.1, 0.95) } });
  scene.LookFromAnywhere();
}

void BandKind(PromiseScene& scene)
{
  const int voxels = scene.dice.Whole(10, 24);
  BeginUnlit(scene, Distances(scene.dice, glm::ivec3(voxels)), glm::ivec3(voxels));
  scene.SetLook(Bands(scene.dice, voxels));
  scene.LookFromAnywhere();
}

// Columns that just fill a view, so that a regular grid of trial rays may meet each second one
// only.
void ColumnKind(PromiseScene& scene)
{
  const int columns = scene.dice.OneOf<int>({ 33, 49, 65, 97, 129, 193 });
  scene.AddVolume({ columns, columns / 2 + 1, 6 }, { 1.0, 2.0, 2.0 }, Columns(scene.dice));
  scene.SetLook({ { 0.55, 0.0 }, { 0.6, scene.dice.Between(0.3, 0.7) }, { 0.65, 0.0 } });
  scene.side = std::min(columns - 1, 96);
  scene.LookInParallel({ 0.0, 0.0, 1.0 }, 1.0);
  scene.Renderer()->GetActiveCamera()->SetParallelScale(0.5 * (columns - 1));
}

void ShadedKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Shade(scene.dice.OneOf<double>({ 0.0, 0.3 }));
  scene.AddHeadLight();
}

void LampsKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Shade(scene.dice.OneOf<double>({ 0.0, 0.3 }));
  scene.AddDistantLight();
  scene.AddLamp();
  scene.Renderer()->SetTwoSidedLighting(scene.dice.Chance(0.5));
}

// One voxel, or some, far from all others.
void FarFillKind(PromiseScene& scene)
{
  const double far = scene.dice.OneOf<double>({ -1e3, -1e6, -1e20, 1e6 });
  const int period = scene.dice.OneOf<int>({ 97, 1009 });
  const glm::ivec3 size = Size(scene.dice, 9, 14);
  const PromiseContent lumps = Lumps(scene.dice);
  BeginUnlit(
    scene,
    [&](glm::ivec3 voxel)
    { return (voxel.x + 7 * voxel.y + 31 * voxel.z + 5) % period == 0 ? far : lumps(voxel); },
    size);
  scene.SetLook({ { 0.0, 0.0 }, { 0.3, 0.0 }, { 0.8, scene.dice.Between(0.1, 0.8) }, { 1.05, 0.2 },
    { 1.1, 0.0 } });
  scene.LookFromAnywhere();
}

void GradientOpacityKind(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 9, 16);
  BeginUnlit(scene, scene.dice.Chance(0.5) ? Lumps(scene.dice) : Ball(scene.dice, size), size);
  scene.SetLook(Ramp(scene.dice));
  SetGradientOpacity(scene);
  scene.LookFromAnywhere();
}

void FarFillGradientKind(PromiseScene& scene)
{
  FarFillKind(scene);
  SetGradientOpacity(scene);
}

}

std::vector<PromiseKind> MatterPromiseKinds()
{
  return {
    { "noise", false, NoiseKind },
    { "thin-peak", false, ThinPeakKind },
    { "steps", false, StepKind },
    { "opaque", false, OpaqueKind },
    { "sheets", false, SheetKind },
    { "wires", false, WireKind },
    { "walls", false, WallKind },
    { "bands", false, BandKind },
    { "columns", false, ColumnKind },
    { "head-light", false, ShadedKind },
    { "lamps", false, LampsKind },
    { "far-fill", false, FarFillKind },
    { "gradient-opacity", false, GradientOpacityKind },
    { "far-fill-gradient", false, FarFillGradientKind },
  };
}

}
