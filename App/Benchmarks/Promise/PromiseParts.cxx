#include "PromiseParts.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch::promise
{

PromiseContent Noise(Dice& dice)
{
  return [&dice](glm::ivec3) { return dice.Between(0.0, 1.0); };
}

PromiseContent Lumps(Dice& dice)
{
  const auto wave = [&]
  { return glm::dvec3(dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0)); };
  const glm::dvec3 a = wave();
  const glm::dvec3 b = wave();
  return [a, b](glm::ivec3 voxel)
  {
    const glm::dvec3 place(voxel);
    return 0.5 + 0.25 * std::sin(glm::dot(a, place)) + 0.25 * std::cos(glm::dot(b, place) + 1.0);
  };
}

PromiseContent Ball(Dice& dice, glm::ivec3 size)
{
  const glm::dvec3 middle = glm::dvec3(size) *
    glm::dvec3(dice.Between(0.35, 0.65), dice.Between(0.35, 0.65), dice.Between(0.35, 0.65));
  const double radius = dice.Between(0.3, 0.6) * std::min({ size.x, size.y, size.z });
  return [=](glm::ivec3 voxel)
  { return std::clamp(1.3 - glm::length(glm::dvec3(voxel) - middle) / radius, 0.0, 1.0); };
}

PromiseContent Sheets(Dice& dice)
{
  const int axis = dice.Whole(0, 2);
  const int across = (axis + 1) % 3;
  const int place = 2 * dice.Whole(2, 4) + 1;
  const int end = dice.Whole(4, 9);
  const double faint = dice.Between(0.1, 0.45);
  return [=](glm::ivec3 voxel)
  { return voxel[axis] == place && voxel[across] < end ? 0.95 : faint; };
}

PromiseContent Wires(Dice& dice)
{
  const int axis = dice.Whole(0, 2);
  const int period = dice.Whole(2, 5);
  const int first = dice.Whole(0, 4);
  const double faint = dice.Between(0.0, 0.4);
  return [=](glm::ivec3 voxel)
  {
    const int one = voxel[(axis + 1) % 3] + first;
    const int other = voxel[(axis + 2) % 3] + 2 * first;
    return one % period == 0 && other % period == 1 ? 0.95 : faint;
  };
}

PromiseContent Walls(Dice& dice)
{
  const int period = dice.Whole(3, 5);
  const int axis = dice.Whole(0, 2);
  const double noise = dice.OneOf<double>({ 0.0, 0.1 });
  return [=, &dice](glm::ivec3 voxel)
  {
    const bool isWall = (voxel[axis] % period == 1 && voxel[(axis + 1) % 3] > 2) ||
      (voxel[(axis + 2) % 3] % 5 == 2 && voxel[axis] > 6);
    return isWall ? 1.0 : noise * dice.Between(0.0, 1.0);
  };
}

PromiseContent Distances(Dice& dice, glm::ivec3 size)
{
  const int axis = dice.Whole(0, 2);
  return [=](glm::ivec3 voxel) { return voxel[axis] / double(size[axis]); };
}

PromiseContent Columns(Dice& dice)
{
  const double between = dice.Between(0.7, 0.8);
  return [=, &dice](glm::ivec3 voxel)
  { return voxel.x % 2 == 1 ? between : dice.Between(0.0, 1.0); };
}

PromiseContent AnyContent(Dice& dice, glm::ivec3 size)
{
  switch (dice.Whole(0, 5))
  {
    case 0:
      return Noise(dice);
    case 1:
      return Ball(dice, size);
    case 2:
      return Sheets(dice);
    case 3:
      return Wires(dice);
    case 4:
      return Walls(dice);
    default:
      return Lumps(dice);
  }
}

glm::ivec3 Size(Dice& dice, int least, int most)
{
  return { dice.Whole(least, most), dice.Whole(least, most), dice.Whole(least, most) };
}

glm::dvec3 Spacing(Dice& dice)
{
  if (dice.Chance(0.4))
  {
    return glm::dvec3(dice.OneOf<double>({ 1.0, 1.0, 0.4, 3.0 }));
  }
  return { dice.Between(0.5, 2.0), dice.Between(0.5, 2.0), dice.Between(0.5, 3.0) };
}

PromiseNodes Ramp(Dice& dice)
{
  const double from = dice.Between(0.0, 0.5);
  return { { from, 0.0 }, { from + dice.Between(0.1, 0.6), dice.Between(0.02, 0.9) } };
}

PromiseNodes ThinPeak(Dice& dice)
{
  const double at = dice.Between(0.2, 0.8);
  const double half = dice.InOrdersBetween(0.004, 0.08);
  return { { at - half, 0.0 }, { at, dice.Between(0.1, 0.95) }, { at + half, 0.0 } };
}

PromiseNodes Steps(Dice& dice)
{
  PromiseNodes nodes;
  double at = dice.Between(0.05, 0.2);
  double before = 0.0;
  const int count = dice.Whole(1, 4);
  for (int i = 0; i < count; ++i)
  {
    const double after = dice.OneOf<double>({ 0.0, dice.Between(0.02, 0.8) });
    nodes.emplace_back(at, before);
    nodes.emplace_back(at, after);
    before = after;
    at += dice.Between(0.05, 0.25);
  }
  return nodes;
}

PromiseNodes Opaque(Dice& dice)
{
  const double from = dice.Between(0.1, 0.4);
  return { { from, 0.0 }, { from + dice.Between(0.05, 0.4), 1.0 } };
}

PromiseNodes Bands(Dice& dice, int voxels)
{
  const double most = dice.OneOf<double>({ 0.1, 0.3, 0.7 });
  PromiseNodes nodes;
  for (int i = 1; i + 1 < voxels; ++i)
  {
    for (const double place : { -0.2, -0.1, 0.1, 0.2 })
    {
      nodes.emplace_back((i + 0.5 + place) / voxels, std::abs(place) < 0.15 ? most : 0.0);
    }
  }
  return nodes;
}

PromiseNodes Dense(Dice& dice)
{
  const double faint = dice.Between(0.02, 0.1);
  return { { 0.05, 0.0 }, { 0.15, faint }, { 0.5, faint }, { 0.7, dice.Between(0.1, 0.4) },
    { 0.9, dice.Between(0.5, 0.95) } };
}

PromiseNodes AnyNodes(Dice& dice)
{
  switch (dice.Whole(0, 4))
  {
    case 0:
      return ThinPeak(dice);
    case 1:
      return Steps(dice);
    case 2:
      return Dense(dice);
    default:
      return Ramp(dice);
  }
}

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

namespace
{

void Repeat(PromiseScene& scene, int count, void (*edit)(PromiseScene&))
{
  for (int i = 0; i < count; ++i)
  {
    scene.edits.emplace_back([&scene, edit] { edit(scene); });
  }
}

void Pan(PromiseScene& scene)
{
  vtkCamera* const camera = scene.Renderer()->GetActiveCamera();
  const double shift = scene.DiagonalMm() * scene.dice.Between(0.01, 0.08);
  const glm::dvec3 way = shift * scene.Direction();
  double position[3];
  double focus[3];
  camera->GetPosition(position);
  camera->GetFocalPoint(focus);
  camera->SetPosition(position[0] + way.x, position[1] + way.y, position[2] + way.z);
  camera->SetFocalPoint(focus[0] + way.x, focus[1] + way.y, focus[2] + way.z);
}

void Orbit(PromiseScene& scene)
{
  const double degrees = scene.dice.OneOf<double>({ 0.5, 1.0, 3.0, 10.0 });
  vtkCamera* const camera = scene.Renderer()->GetActiveCamera();
  camera->Azimuth(degrees);
  if (scene.dice.Chance(0.5))
  {
    camera->Elevation(degrees);
    camera->OrthogonalizeViewUp();
  }
}

void EditLook(PromiseScene& scene)
{
  vtkPiecewiseFunction* const opacity = scene.Property()->GetScalarOpacity();
  switch (scene.dice.Whole(0, 3))
  {
    case 0:
    {
      double node[4];
      const int index = scene.dice.Whole(0, opacity->GetSize() - 1);
      opacity->GetNodeValue(index, node);
      node[1] = std::clamp(node[1] + scene.dice.Between(-0.3, 0.3), 0.0, 0.98);
      opacity->SetNodeValue(index, node);
      break;
    }
    case 1:
      opacity->AddPoint(scene.ValueOf(scene.dice.Between(0.0, 1.0)), scene.dice.Between(0.0, 0.8));
      break;
    case 2:
      scene.Property()->SetScalarOpacityUnitDistance(
        scene.dice.Between(0.5, 2.0) * scene.Property()->GetScalarOpacityUnitDistance());
      break;
    default:
      scene.SetLook(AnyNodes(scene.dice));
  }
}

void EditData(PromiseScene& scene)
{
  const int* const size = scene.Image()->GetDimensions();
  scene.Replace(0, AnyContent(scene.dice, { size[0], size[1], size[2] }));
}

void EditLight(PromiseScene& scene)
{
  vtkLight* const light = vtkLight::SafeDownCast(scene.Renderer()->GetLights()->GetItemAsObject(0));
  switch (scene.dice.Whole(0, 6))
  {
    case 0:
    {
      const glm::dvec3 from = 100.0 * scene.DiagonalMm() * scene.Direction();
      light->SetPosition(from.x, from.y, from.z);
      break;
    }
    case 1:
      light->SetIntensity(scene.dice.Between(0.3, 1.2));
      break;
    case 2:
      light->GetInformation()->Set(
        vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), scene.dice.Between(0.0, 20.0));
      break;
    case 3:
      scene.Mapper()->SetShadows(!scene.Mapper()->GetShadows());
      break;
    case 4:
      scene.Mapper()->SetShadowStrength(scene.dice.Between(0.2, 1.0));
      break;
    case 5:
      scene.Mapper()->SetVolumetricScatteringBlending(scene.dice.OneOf<double>({ 0.0, 0.5, 1.0 }));
      break;
    default:
      scene.Property()->SetDiffuse(scene.dice.Between(0.3, 1.0));
  }
}

void EditMatrix(PromiseScene& scene)
{
  scene.dice.Chance(0.5) ? scene.Turn() : scene.Shear();
}

void EditCuts(PromiseScene& scene)
{
  vtkPlaneCollection* const planes = scene.Mapper()->GetClippingPlanes();
  switch (scene.dice.Whole(0, 3))
  {
    case 0:
      if (planes && planes->GetNumberOfItems() > 0)
      {
        planes->GetItem(0)->Push(scene.dice.Between(-0.1, 0.1) * scene.DiagonalMm());
        break;
      }
      scene.AddClippingPlane();
      break;
    case 1:
      scene.Crop();
      break;
    case 2:
      scene.Mapper()->SetCropping(!scene.Mapper()->GetCropping());
      break;
    default:
      scene.Mapper()->RemoveAllClippingPlanes();
  }
}

void EditMask(PromiseScene& scene)
{
  vtkImageData* const mask = scene.Mapper()->GetMaskInput();
  switch (scene.dice.Whole(0, 3))
  {
    case 0:
      scene.Mapper()->SetMaskType(1 - scene.Mapper()->GetMaskType());
      break;
    case 1:
      scene.SetMask(scene.Mapper()->GetMaskType() == vtkVariationFieldVolumeMapper::BinaryMaskType);
      break;
    case 2:
      scene.Mapper()->SetMaskInput(nullptr);
      break;
    default:
      if (mask)
      {
        vtkDataArray* const labels = mask->GetPointData()->GetScalars();
        for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
        {
          labels->SetComponent(i, 0, 2.0 - labels->GetComponent(i, 0));
        }
        labels->Modified();
        mask->Modified();
      }
  }
}

void EditAnything(PromiseScene& scene)
{
  void (*const edits[])(PromiseScene&) = { Pan, Orbit, EditLook, EditLook, EditData, EditMatrix,
    EditCuts, EditLight, EditLight };
  edits[scene.dice.Whole(0, 8)](scene);
}

}

void AddPans(PromiseScene& scene, int count)
{
  Repeat(scene, count, Pan);
}

void AddOrbits(PromiseScene& scene, int count)
{
  Repeat(scene, count, Orbit);
}

void AddLookEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditLook);
}

void AddDataEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditData);
}

void AddLightEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditLight);
}

void AddMatrixEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditMatrix);
}

void AddCutEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditCuts);
}

void AddMaskEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditMask);
}

void AddAnyEdits(PromiseScene& scene, int count)
{
  Repeat(scene, count, EditAnything);
}

}
