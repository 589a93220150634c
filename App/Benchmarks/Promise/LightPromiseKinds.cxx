#include "PromiseKinds.h"
#include "PromiseParts.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>

namespace varimarch
{

namespace
{

using namespace promise;

void ShadowNoise(PromiseScene& scene)
{
  BeginLitNoise(scene);
  CastShadows(scene);
}

void ShadowAny(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
}

void ShadowSheets(PromiseScene& scene)
{
  BeginLitSheets(scene);
  CastShadows(scene);
}

// Light along a sheet, whose shadow lies between the nodes of a lattice.
void ShadowAlongSheet(PromiseScene& scene)
{
  const int plane = 2 * scene.dice.Whole(2, 4) + 1;
  const int end = scene.dice.Whole(6, 12);
  scene.AddVolume({ 13, 13, 19 }, glm::dvec3(1.0),
    [=](glm::ivec3 voxel) { return voxel.x == plane && voxel.z < end ? 0.9 : 0.4; });
  scene.side = 32;
  scene.SetLook({ { 0.3, 0.06 }, { 0.5, 0.06 }, { 0.7, 0.3 }, { 0.9, 0.9 } });
  scene.LookFrom({ scene.dice.Between(-0.4, 0.4), -1.0, scene.dice.Between(-0.3, 0.3) }, 1.8);
  scene.Shade();
  vtkLight* const light = CastShadows(scene);
  light->SetPosition(scene.dice.Between(-5.0, 5.0), scene.dice.Between(-5.0, 5.0), -100.0);
}

void ShadowBands(PromiseScene& scene)
{
  BeginLitBands(scene);
  CastShadows(scene);
}

void ShadowWires(PromiseScene& scene)
{
  BeginLitWires(scene);
  CastShadows(scene);
}

void ShadowWalls(PromiseScene& scene)
{
  BeginLitWalls(scene);
  CastShadows(scene);
}

void ShadowSteps(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 8, 14);
  BeginLit(scene, AnyContent(scene.dice, size), size, Steps(scene.dice));
  CastShadows(scene);
}

void ShadowOpaque(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 8, 14);
  BeginLit(scene, Lumps(scene.dice), size, Opaque(scene.dice));
  CastShadows(scene);
}

void ShadowIntegers(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 8, 14);
  BeginLit(scene, AnyContent(scene.dice, size), size, AnyNodes(scene.dice),
    scene.dice.OneOf<int>({ VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT }));
  CastShadows(scene);
}

void ShadowPetOverCt(PromiseScene& scene)
{
  BeginLitPetOverCt(scene);
  CastShadows(scene);
}

void ShadowCuts(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.dice.Chance(0.5) ? scene.Crop() : scene.AddClippingPlane();
}

void ShadowLabels(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.SetMask(scene.dice.Chance(0.4));
}

void ShadowNearest(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.Property()->SetInterpolationTypeToNearest();
  CastShadows(scene);
}

// Geometry out of the view, which casts shadows only.
void ShadowGeometry(PromiseScene& scene)
{
  BeginAnyLit(scene);
  double eye[3];
  scene.Renderer()->GetActiveCamera()->GetPosition(eye);
  vtkLight* const light = CastShadows(scene);
  const glm::dvec3 way = glm::dvec3(eye[0], eye[1], eye[2]) - scene.MiddleMm() +
    0.3 * scene.DiagonalMm() * scene.Direction();
  const glm::dvec3 from = scene.MiddleMm() + 100.0 * way;
  light->SetPosition(from.x, from.y, from.z);
  const glm::dvec3 focus = scene.MiddleMm();
  light->SetFocalPoint(focus.x, focus.y, focus.z);
  scene.AddGeometry(1.5 / scene.DiagonalMm() * way, 0.4, false);
}

void ShadowGradientOpacity(PromiseScene& scene)
{
  const glm::ivec3 size = Size(scene.dice, 8, 13);
  BeginLit(scene, Ball(scene.dice, size), size, Ramp(scene.dice));
  CastShadows(scene);
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(scene.dice.Between(0.0, 0.05), scene.dice.Between(0.0, 0.4));
  factors->AddPoint(scene.dice.Between(0.06, 0.15), 1.0);
  scene.Property()->SetGradientOpacity(factors);
}

void ShadowSheared(PromiseScene& scene)
{
  BeginAnyLit(scene);
  scene.Shear();
  CastShadows(scene);
}

void ShadowInside(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.LookFrom(scene.Direction(), scene.dice.Between(0.05, 0.3));
}

void ShadowSmallPicture(PromiseScene& scene)
{
  BeginAnyLit(scene);
  CastShadows(scene);
  scene.side = scene.dice.Whole(6, 16);
}

}

std::vector<PromiseKind> ShadowPromiseKinds()
{
  return {
    { "shadow-noise", true, ShadowNoise },
    { "shadow", true, ShadowAny },
    { "shadow-sheets", true, ShadowSheets },
    { "shadow-along-sheet", true, ShadowAlongSheet },
    { "shadow-bands", true, ShadowBands },
    { "shadow-wires", true, ShadowWires },
    { "shadow-walls", true, ShadowWalls },
    { "shadow-steps", true, ShadowSteps },
    { "shadow-opaque", true, ShadowOpaque },
    { "shadow-integers", true, ShadowIntegers },
    { "shadow-pet-over-ct", true, ShadowPetOverCt },
    { "shadow-cuts", true, ShadowCuts },
    { "shadow-masks", true, ShadowLabels },
    { "shadow-nearest", true, ShadowNearest },
    { "shadow-geometry", true, ShadowGeometry },
    { "shadow-gradient-opacity", true, ShadowGradientOpacity },
    { "shadow-sheared", true, ShadowSheared },
    { "shadow-inside", true, ShadowInside },
    { "shadow-small-picture", true, ShadowSmallPicture },
  };
}

namespace
{

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

namespace
{

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
