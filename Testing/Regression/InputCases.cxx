#include "Regression/RegressionCase.h"

#include "Module/Scenes/ComponentVolumes.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/ReferenceMixture.h"
#include "Module/Scenes/UnevenGrid.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkImageMagnitude.h>
#include <vtkPointData.h>
#include <vtkUniformGrid.h>

#include <cmath>

namespace
{

// A mirrored and turned torso whose first voxel has other indices than 0.
vtkSmartPointer<vtkImageData> TurnedTorso()
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const double direction[9] = { 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0 };
  torso->SetDirectionMatrix(direction);
  int extent[6];
  torso->GetExtent(extent);
  torso->SetExtent(
    extent[0] + 5, extent[1] + 5, extent[2], extent[3], extent[4] - 3, extent[5] - 3);
  return torso;
}

RegressionCase TypeCase(const std::string& name, int type)
{
  return { name,
    [type]
    {
      const vtkSmartPointer<vtkImageData> torso = TorsoOfType(type);
      const auto scene = NewScene(torso);
      ShowUpperValues(*scene);
      return SceneOf(scene);
    } };
}

// The torso in floats, with another value wherever a function of the voxel's index is true.
template <class IsOther>
vtkSmartPointer<vtkImageData> TorsoWith(double value, IsOther isOther)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const auto floats = vtkSmartPointer<vtkImageData>::New();
  floats->CopyStructure(torso);
  floats->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < torso->GetNumberOfPoints(); ++i)
  {
    floats->GetPointData()->GetScalars()->SetComponent(
      i, 0, isOther(i) ? value : torso->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  return floats;
}

RegressionScene NotFinite()
{
  const auto scene =
    NewScene(TorsoWith(std::nan(""), [](vtkIdType point) { return point % 1000 == 7; }));
  scene->mapper->SetNanColor(0.1, 1.0, 0.3);
  scene->mapper->SetNanOpacity(0.05);
  return SceneOf(scene);
}

// A ball about the middle of the torso.
bool IsInBall(vtkIdType point)
{
  const glm::dvec3 voxel(point % 40, point / 40 % 36, point / (40 * 36));
  return glm::length((voxel - glm::dvec3(20.0, 14.0, 12.0)) / glm::dvec3(9.0, 9.0, 6.0)) < 1.0;
}

RegressionScene FarValues()
{
  return SceneOf(NewScene(TorsoWith(-1e20, IsInBall)));
}

RegressionScene Blanking()
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->CopyStructure(torso);
  grid->GetPointData()->SetScalars(torso->GetPointData()->GetScalars());
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    if (IsInBall(point))
    {
      grid->BlankPoint(point);
    }
  }
  return SceneOf(NewScene(grid));
}

RegressionScene CellData()
{
  return SceneOf(NewScene(TorsoOfCells()));
}

RegressionScene Rectilinear()
{
  const Places places = { UnevenPlaces(10, 18.0, 2.0), UnevenPlaces(9, 15.0, 0.6),
    UnevenPlaces(11, 20.0, 1.0) };
  const auto scene = NewScene(EvenImage(places));
  scene->colors->RemoveAllPoints();
  scene->colors->AddRGBPoint(0.0, 0.9, 0.3, 0.2);
  scene->colors->AddRGBPoint(1.0, 0.2, 0.6, 0.9);
  scene->opacities->RemoveAllPoints();
  scene->opacities->AddPoint(0.3, 0.0);
  scene->opacities->AddPoint(1.0, 0.4);
  scene->volume->SetScale(1.2, 0.8, 1.0);
  scene->volume->RotateZ(20.0);
  scene->renderer->ResetCamera();
  scene->mapper->SetInputData(WaveGrid(places));
  return SceneOf(scene, UnevenMaterial(*scene, places));
}

// A ball for each component, about the corners of a tetrahedron.
double TetrahedronValue(glm::ivec3 voxel, int component)
{
  const glm::dvec3 corner(component & 1 ? 10.0 : 6.0, component & 2 ? 10.0 : 6.0,
    component == 0 || component == 3 ? 6.0 : 10.0);
  return 150.0 - 14.0 * glm::length(glm::dvec3(voxel) - corner);
}

RegressionScene SceneOfComponents(int type, int components, bool independent)
{
  const auto scene = NewScene(ImageOf(type, components, TetrahedronValue, { 17, 17, 17 }));
  vtkVolumeProperty* const property = scene->volume->GetProperty();
  property->SetIndependentComponents(independent);
  for (int component = 0; component < components; ++component)
  {
    SetLook(property, component, looks[component]);
    property->SetComponentWeight(component, 1.0 - 0.2 * component);
  }
  property->SetShade(independent);
  const auto mixture = std::make_shared<ReferenceMixture>(*scene);
  return SceneOf(scene,
    [mixture](glm::dvec3 position, const varimarch::Ray& ray)
    { return mixture->At(position, ray); });
}

// The filter by which vtkSmartVolumeMapper draws magnitudes makes the torso, moved to values from 0
// on, of vectors.
RegressionScene VectorMagnitude()
{
  constexpr double Air = 1100.0;
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  vtkNew<vtkImageData> vectors;
  vectors->CopyStructure(torso);
  vectors->AllocateScalars(VTK_FLOAT, 3);
  vtkDataArray* const values = torso->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < torso->GetNumberOfPoints(); ++i)
  {
    const double length = values->GetTuple1(i) + Air;
    vectors->GetPointData()->GetScalars()->SetTuple3(
      i, 0.6 * length, 0.48 * length, -0.64 * length);
    values->SetTuple1(i, length);
  }
  const auto scene = NewScene(torso);
  scene->colors->RemoveAllPoints();
  scene->colors->AddRGBPoint(Air, 0.8, 0.5, 0.4);
  scene->colors->AddRGBPoint(Air + 400.0, 1.0, 0.95, 0.85);
  scene->opacities->RemoveAllPoints();
  scene->opacities->AddPoint(Air - 200.0, 0.0);
  scene->opacities->AddPoint(Air + 400.0, 0.2);
  vtkNew<vtkImageMagnitude> magnitude;
  magnitude->SetInputData(vectors);
  magnitude->Update(); // VTK's mapper gets the image without the filter
  scene->mapper->SetInputConnection(magnitude->GetOutputPort());
  return SceneOf(scene);
}

RegressionScene Blocks()
{
  const auto scene =
    NewScene(varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 56, 48 }, 7 }));
  // Half of it must hold the picture; the volume has 344064 bytes.
  scene->mapper->SetMaximumGraphicsMemory(400000);
  return SceneOf(scene);
}

}

std::vector<RegressionCase> InputCases()
{
  return {
    { "ExtentAndDirection", [] { return SceneOf(NewScene(TurnedTorso())); } },
    TypeCase("ScalarsOfUnsignedChar", VTK_UNSIGNED_CHAR),
    TypeCase("ScalarsOfChar", VTK_CHAR),
    TypeCase("ScalarsOfInt", VTK_INT),
    TypeCase("ScalarsOfDouble", VTK_DOUBLE),
    { "CellData", CellData },
    { "Rectilinear", Rectilinear },
    { "Blanking", Blanking },
    { "IndependentComponents", [] { return SceneOfComponents(VTK_SHORT, 4, true); } },
    { "TwoDependentComponents", [] { return SceneOfComponents(VTK_SHORT, 2, false); } },
    { "FourDependentComponents", [] { return SceneOfComponents(VTK_UNSIGNED_CHAR, 4, false); } },
    { "VectorMagnitude", VectorMagnitude },
    { "NotFinite", NotFinite },
    { "FarValues", FarValues },
    { "Blocks", Blocks },
  };
}
