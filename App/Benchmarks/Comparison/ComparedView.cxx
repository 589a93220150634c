#include "ComparedView.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace varimarch
{

ComparedView ComparedViewOf(vtkRenderer* renderer, const VolumeGeometry& geometry)
{
  ComparedView view;
  view.window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  renderer->GetTiledSizeAndOrigin(
    &view.sizePixels.x, &view.sizePixels.y, &view.originPixels.x, &view.originPixels.y);
  vtkCamera* const camera = renderer->GetActiveCamera();
  view.clipFromGrid = ClipFromWorld(renderer) * geometry.worldFromGrid;
  view.eyeWorld = glm::make_vec3(camera->GetPosition());
  view.directionWorld = glm::make_vec3(camera->GetDirectionOfProjection());
  const glm::dvec3 up = glm::make_vec3(camera->GetViewUp());
  view.upWorld = glm::normalize(up - glm::dot(up, view.directionWorld) * view.directionWorld);
  view.isParallel = camera->GetParallelProjection() != 0;
  const glm::dmat4 gridFromWorld = glm::inverse(geometry.worldFromGrid);
  view.eyeGrid = gridFromWorld *
    (view.isParallel ? glm::dvec4(-view.directionWorld, 0.0) : glm::dvec4(view.eyeWorld, 1.0));
  return view;
}

void ComparisonFrame::Use(const std::string& main, const std::string& shadow) const
{
  this->program.Use(this->view.window, "Grid.vert.glsl", this->volume.FragmentFiles(main, shadow));
  this->volume.SetUniforms(this->program, this->view.eyeGrid);
  const glm::dmat3 gridFromWorld = glm::inverse(this->volume.Geometry().WorldFromGridDirection());
  this->program.Set("toLightWorld", glm::vec3(this->toLightWorld));
  this->program.Set("toLightGrid", glm::vec3(gridFromWorld * this->toLightWorld));
}

}
