#include "PromiseBeginnings.h"
#include "PromiseContents.h"
#include "PromiseEdits.h"
#include "PromiseKinds.h"

namespace varimarch
{

namespace
{

using namespace promise;

void SoftAny(PromiseScene& scene)
{
  BeginAnyLit(scene);
  Soften(CastShadows(scene), scene);
}

void SoftSheets(PromiseScene& scene)
{
  BeginLitSheets(scene);
  Soften(CastShadows(scene), scene);
}

void SoftBands(PromiseScene& scene)
{
  BeginLitBands(scene);
  Soften(CastShadows(scene), scene);
}

void LampOutside(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.AddLamp(true);
  scene.Mapper()->ShadowsOn();
}

void LampInside(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.AddLamp(false);
  scene.Mapper()->ShadowsOn();
}

void SoftLamp(PromiseScene& scene)
{
  BeginAnyLit(scene);
  Soften(scene.AddLamp(true), scene);
  scene.Mapper()->ShadowsOn();
}

void SeveralLights(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.AddLamp(true);
  scene.AddHeadLight();
}

void WeakOneSided(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.Mapper()->SetShadowStrength(scene.dice.Between(0.2, 0.9));
  scene.Renderer()->TwoSidedLightingOff();
}

void Scattering(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.AddDistantLight();
  scene.Mapper()->SetVolumetricScatteringBlending(scene.dice.OneOf<double>({ 0.5, 1.0, 1.5 }));
  scene.Mapper()->SetScatteringAnisotropy(scene.dice.Between(-0.7, 0.7));
}

void ScatteringReach(PromiseScene& scene)
{
  Scattering(scene);
  scene.Mapper()->SetGlobalIlluminationReach(scene.dice.OneOf<double>({ 0.1, 0.5, 1.0 }));
}

void ScatteringShadows(PromiseScene& scene)
{
  Scattering(scene);
  scene.Mapper()->ShadowsOn();
}

void ScatteringBands(PromiseScene& scene)
{
  BeginLitBands(scene);
  CastShadows(scene);
  scene.Mapper()->SetVolumetricScatteringBlending(1.0);
}

void ScatteringPetOverCt(PromiseScene& scene)
{
  BeginLitPetOverCt(scene);
  CastShadows(scene);
  scene.Mapper()->SetVolumetricScatteringBlending(1.0);
}

void LightEdits(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  AddLightEdits(scene, 4);
}

void ShadowLookEdits(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  AddLookEdits(scene, 2);
  AddDataEdits(scene, 2);
}

void ShadowMaskEdits(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.SetMask(scene.dice.Chance(0.5));
  CastShadows(scene);
  AddMaskEdits(scene, 4);
}

void ShadowMoves(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  AddPans(scene, 2);
  AddOrbits(scene, 2);
}

void ShadowAnyEdits(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  AddAnyEdits(scene, 4);
}

}

std::vector<PromiseKind> LightPromiseKinds()
{
  return {
    { "soft", true, SoftAny },
    { "soft-sheets", true, SoftSheets },
    { "soft-bands", true, SoftBands },
    { "lamp-outside", true, LampOutside },
    { "lamp-inside", true, LampInside },
    { "soft-lamp", true, SoftLamp },
    { "several-lights", true, SeveralLights },
    { "weak-one-sided", true, WeakOneSided },
    { "scattering", true, Scattering },
    { "scattering-reach", true, ScatteringReach },
    { "scattering-shadows", true, ScatteringShadows },
    { "scattering-bands", true, ScatteringBands },
    { "scattering-pet-over-ct", true, ScatteringPetOverCt },
    { "light-edits", true, LightEdits },
    { "shadow-look-edits", true, ShadowLookEdits },
    { "shadow-mask-edits", true, ShadowMaskEdits },
    { "shadow-moves", true, ShadowMoves },
    { "shadow-any-edits", true, ShadowAnyEdits },
  };
}

}
