#include "Module/CasterTruth.h"

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

// Cramer's rule, as in any textbook.
bool IsMet(const Corners& corners, glm::dvec3 from, glm::dvec3 towards, double farMm)
{
  const glm::dvec3 a = corners[1] - corners[0];
  const glm::dvec3 b = corners[2] - corners[0];
  const glm::dvec3 c = from - corners[0];
  const double all = -glm::dot(glm::cross(a, b), towards);
  const double u = -glm::dot(glm::cross(c, b), towards) / all;
  const double v = -glm::dot(glm::cross(a, c), towards) / all;
  const double t = glm::dot(glm::cross(a, b), c) / all;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < farMm;
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
        [&](const Corners& corners) { return IsMet(corners, from, towardsWorld, farMm); });
      return isHidden ? 0.0 : through(positionGrid, towardsWorld, farMm);
    });
}
