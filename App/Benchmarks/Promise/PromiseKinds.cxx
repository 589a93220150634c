#include "PromiseKinds.h"
#include "PromiseParts.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>

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

namespace
{

void CropKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Crop();
}

void ClipKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.AddClippingPlane();
  if (scene.dice.Chance(0.5))
  {
    scene.AddClippingPlane();
  }
}

void LabelKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.SetMask(false);
}

void BinaryMaskKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.SetMask(true);
}

void NearestKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Property()->SetInterpolationTypeToNearest();
}

void MaximumKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Mapper()->SetBlendModeToMaximumIntensity();
}

void MinimumKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Mapper()->SetBlendModeToMinimumIntensity();
}

void AverageKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Mapper()->SetBlendModeToAverageIntensity();
}

void AverageRangeKind(PromiseScene& scene)
{
  AverageKind(scene);
  const double from = scene.dice.Between(0.1, 0.8);
  scene.Mapper()->SetAverageIPScalarRange(from, from + scene.dice.Between(0.05, 0.5));
}

void AdditiveKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, Ramp(scene.dice));
  scene.Property()->SetScalarOpacityUnitDistance(scene.dice.Between(3.0, 20.0));
  scene.Mapper()->SetBlendModeToAdditive();
}

void IsosurfaceKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, Ramp(scene.dice));
  scene.Mapper()->SetBlendModeToIsoSurface();
  scene.Property()->GetIsoSurfaceValues()->SetValue(0, scene.dice.Between(0.2, 0.5));
  if (scene.dice.Chance(0.5))
  {
    scene.Property()->GetIsoSurfaceValues()->SetValue(1, scene.dice.Between(0.5, 0.8));
  }
  if (scene.dice.Chance(0.5))
  {
    scene.Shade(0.2);
    scene.AddHeadLight();
  }
}

void TinyVolumeKind(PromiseScene& scene)
{
  const glm::ivec3 size = scene.dice.OneOf<glm::ivec3>(
    { { 1, 1, 1 }, { 2, 1, 1 }, { 2, 2, 2 }, { 3, 2, 2 }, { 8, 8, 1 }, { 1, 9, 9 }, { 64, 1, 1 } });
  BeginUnlit(scene, Noise(scene.dice), size);
  scene.SetLook(AnyNodes(scene.dice), scene.dice.Between(0.3, 1.0));
  scene.LookFromAnywhere();
}

void IntegerKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice),
    scene.dice.OneOf<int>(
      { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_DOUBLE }));
}

void ShearKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.Shear();
}

void InsideKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.LookFrom(scene.Direction(), scene.dice.Between(0.05, 0.3));
  scene.Renderer()->GetActiveCamera()->SetViewAngle(scene.dice.Between(30.0, 80.0));
}

void SmallPictureKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.side = scene.dice.Whole(6, 20);
}

// PET of voxels of 4 mm over CT of voxels of 1 mm.
void PetOverCtKind(PromiseScene& scene)
{
  scene.AddVolume(glm::ivec3(6), glm::dvec3(4.0), Ball(scene.dice, glm::ivec3(6)));
  scene.AddVolume(glm::ivec3(18), glm::dvec3(1.0), AnyContent(scene.dice, glm::ivec3(18)));
  scene.SetLook({ { 0.1, 0.0 }, { 0.9, scene.dice.Between(0.2, 0.6) } }, 1.0, 0);
  scene.SetLook(AnyNodes(scene.dice), 1.0, 1);
  if (scene.dice.Chance(0.5))
  {
    scene.Turn(1);
  }
  if (scene.dice.Chance(0.5))
  {
    scene.Shade();
    scene.AddHeadLight();
  }
  scene.LookFromAnywhere();
}

void GeometryKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  scene.AddGeometry(scene.dice.Between(0.0, 0.2) * scene.Direction(), 0.35, true);
}

void FlagKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, AnyNodes(scene.dice));
  vtkPiecewiseFunction* const opacity = scene.Property()->GetScalarOpacity();
  double node[4];
  opacity->GetNodeValue(0, node);
  node[2] = scene.dice.Between(0.2, 0.8);
  node[3] = scene.dice.OneOf<double>({ 0.0, 0.3, 0.8, 1.0 });
  opacity->SetNodeValue(0, node);
  vtkColorTransferFunction* const color = scene.Property()->GetRGBTransferFunction();
  switch (scene.dice.Whole(0, 3))
  {
    case 0:
      color->SetColorSpaceToHSV();
      break;
    case 1:
      color->SetColorSpaceToLab();
      break;
    case 2:
      opacity->ClampingOff();
      break;
    default:
      color->SetColorSpaceToDiverging();
  }
}

void ShaderKind(PromiseScene& scene)
{
  BeginAnyUnlit(scene, Ramp(scene.dice));
  scene.Mapper()->ProcessorMarchingOff();
}

}

std::vector<PromiseKind> FeaturePromiseKinds()
{
  return {
    { "cropped", false, CropKind },
    { "clipped", false, ClipKind },
    { "labels", false, LabelKind },
    { "binary-mask", false, BinaryMaskKind },
    { "nearest", false, NearestKind },
    { "maximum", false, MaximumKind },
    { "minimum", false, MinimumKind },
    { "average", false, AverageKind },
    { "average-of-range", false, AverageRangeKind },
    { "additive", false, AdditiveKind },
    { "isosurfaces", false, IsosurfaceKind },
    { "tiny-volume", false, TinyVolumeKind },
    { "integers", false, IntegerKind },
    { "sheared", false, ShearKind },
    { "inside", false, InsideKind },
    { "small-picture", false, SmallPictureKind },
    { "pet-over-ct", false, PetOverCtKind },
    { "geometry", false, GeometryKind },
    { "shaped-functions", false, FlagKind },
    { "shaders", false, ShaderKind },
  };
}

namespace
{

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

const std::vector<PromiseKind>& PromiseKinds()
{
  static const std::vector<PromiseKind> kinds = []
  {
    std::vector<PromiseKind> all;
    for (auto* const make : { MatterPromiseKinds, FeaturePromiseKinds, EditPromiseKinds,
           ShadowPromiseKinds, LightPromiseKinds, OcclusionPromiseKinds })
    {
      const std::vector<PromiseKind> some = make();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kinds;
}

}
