#include "PromiseEdits.h"

#include "PromiseContents.h"

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

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch::promise
{

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
