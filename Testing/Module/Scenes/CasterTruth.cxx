#include "Module/Scenes/CasterTruth.h"

#include "Support/TriangleHits.h"

#include <vtkMatrixToLinearTransform.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <memory>

using namespace varimarch;

namespace
{

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> TrianglesOf(vtkActor* actor)
{
  actor->GetMapper()->Update();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
  vtkNew<vtkMatrixToLinearTransform> matrix;
  matrix->SetInput(actor->GetMatrix());
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputConnection(triangles->GetOutputPort());
  moved->SetTransform(matrix);
  moved->Update();
  std::vector<Corners> all;
  for (vtkIdType i = 0; i < moved->GetOutput()->GetNumberOfCells(); ++i)
  {
    vtkCell* const cell = moved->GetOutput()->GetCell(i);
    Corners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[std::size_t(k)] = glm::make_vec3(cell->GetPoints()->GetPoint(k));
    }
    all.push_back(corners);
  }
  return all;
}

bool IsMet(const Corners& corners, const Ray& ray, double farMm)
{
  const TrueHit hit = HitOf(corners, ray);
  return hit.inside >= 0.0 && hit.t > 0.0 && hit.t < farMm;
}

}

MapperScene::Material MaterialInShadowsOf(
  MapperScene& scene, const std::vector<vtkActor*>& actors, double tolerance)
{
  std::vector<Corners> triangles;
  for (vtkActor* actor : actors)
  {
    const std::vector<Corners> own = TrianglesOf(actor);
    triangles.insert(triangles.end(), own.begin(), own.end());
  }
  const LightReaching through = LightThroughVolume(scene, tolerance);
  const auto samples = std::make_shared<const SceneSamples>(scene);
  return MaterialInShadows(scene,
    [=](glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm)
    {
      const glm::dvec3 from = samples->PositionWorld(positionGrid);
      const bool isHidden = std::any_of(triangles.begin(), triangles.end(),
        [&](const Corners& corners) {
          return IsMet(corners, { from, towardsWorld }, farMm);
        });
      return isHidden ? 0.0 : through(positionGrid, towardsWorld, farMm);
    });
}
