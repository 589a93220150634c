#include "PromiseBeginnings.h"
#include "PromiseContents.h"
#include "PromiseEdits.h"
#include "PromiseKinds.h"

namespace varimarch
{

namespace
{

using namespace promise;

void OccludedAny(PromiseScene& scene)
{
  BeginAnyLit(scene);
  Occlude(scene);
}

void OccludedNoise(PromiseScene& scene)
{
  BeginLitNoise(scene);
  Occlude(scene);
}

void OccludedWalls(PromiseScene& scene)
{
  BeginLitWalls(scene);
  Occlude(scene);
}

void OccludedBands(PromiseScene& scene)
{
  BeginLitBands(scene);
  Occlude(scene);
  scene.side = 10; // many nodes of functions make the judge slow
}

void OccludedSheets(PromiseScene& scene)
{
  BeginLitSheets(scene);
  Occlude(scene);
}

void OccludedNearest(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.Property()->SetInterpolationTypeToNearest();
  Occlude(scene);
}

void OccludedUnlit(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.Property()->ShadeOff();
  Occlude(scene);
}

void OccludedShadows(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  Occlude(scene);
}

void OccludedPetOverCt(PromiseScene& scene)
{
  BeginLitPetOverCt(scene);
  Occlude(scene);
  scene.Mapper()->SetAmbientOcclusionReach(scene.dice.Between(3.0, 8.0));
}

void OcclusionEdits(PromiseScene& scene)
{
  BeginAnyLit(scene);
  Occlude(scene);
  AddLookEdits(scene, 1);
  AddDataEdits(scene, 1);
  AddOrbits(scene, 1);
}

}

std::vector<PromiseKind> OcclusionPromiseKinds()
{
  return {
    { "occlusion", true, OccludedAny },
    { "occlusion-noise", true, OccludedNoise },
    { "occlusion-walls", true, OccludedWalls },
    { "occlusion-bands", true, OccludedBands },
    { "occlusion-sheets", true, OccludedSheets },
    { "occlusion-nearest", true, OccludedNearest },
    { "occlusion-unlit", true, OccludedUnlit },
    { "occlusion-shadows", true, OccludedShadows },
    { "occlusion-pet-over-ct", true, OccludedPetOverCt },
    { "occlusion-edits", true, OcclusionEdits },
  };
}

}
