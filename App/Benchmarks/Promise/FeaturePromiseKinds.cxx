#include "PromiseBeginnings.h"
#include "PromiseContents.h"
#include "PromiseKinds.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>

namespace varimarch
{

namespace
{

using namespace promise;

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

}
