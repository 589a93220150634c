#include "PromiseBeginnings.h"
#include "PromiseContents.h"
#include "PromiseEdits.h"
#include "PromiseKinds.h"

namespace varimarch
{

namespace
{

using namespace promise;

void PanKind(PromiseScene& scene)
{
  const glm::ivec3 size(24, 16, 8);
  const PromiseContent noise = Noise(scene.dice);
  BeginUnlit(
    scene, [&](glm::ivec3 voxel) { return voxel.x < 12 ? 0.3 + 0.01 * voxel.z : noise(voxel); },
    size);
  scene.SetLook({ { 0.3, 0.0 }, { 0.55, 0.02 }, { 0.6, 0.7 }, { 0.65, 0.0 } });
  scene.LookInParallel(scene.Direction(), scene.dice.Between(0.15, 0.4));
  AddPans(scene, 4);
}

void OrbitKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  AddOrbits(scene, 4);
}

void LookEditKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  AddLookEdits(scene, 4);
}

void DataEditKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  AddDataEdits(scene, 3);
  AddMatrixEdits(scene, 1);
}

void CutEditKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  AddCutEdits(scene, 4);
}

void MaskEditKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.SetMask(false);
  AddMaskEdits(scene, 4);
}

}

std::vector<PromiseKind> EditPromiseKinds()
{
  return {
    { "pan", false, PanKind },
    { "orbit", false, OrbitKind },
    { "look-edits", false, LookEditKind },
    { "data-edits", false, DataEditKind },
    { "cut-edits", false, CutEditKind },
    { "mask-edits", false, MaskEditKind },
  };
}

}
