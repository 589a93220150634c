// The part of VolumeView that keeps the camera of the view and that of the scene alike.

#include "Viewer/View/VolumeView.h"

#include "Scene/SceneCamera.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyle.h>
#include <vtkRenderWindowInteractor.h>

namespace varimarch
{

namespace
{

// The view of a placement that has a clipping range keeps it; VTK's style adapts that of others.
bool IsAt(const Camera& placement, vtkCamera* camera, bool adaptsClippingRange)
{
  std::array<double, 2> range;
  camera->GetClippingRange(range.data());
  return placement.pose == PoseOf(camera) &&
    placement.parallel == (camera->GetParallelProjection() != 0) &&
    (placement.clippingRangeMm ? *placement.clippingRangeMm == range : adaptsClippingRange);
}

}

vtkInteractorStyle* VolumeView::Style()
{
  return vtkInteractorStyle::SafeDownCast(this->window->GetInteractor()->GetInteractorStyle());
}

void VolumeView::FollowCamera()
{
  if (IsAt(this->model->CurrentScene().camera, this->pipeline->Renderer()->GetActiveCamera(),
        this->Style()->GetAutoAdjustCameraClippingRange() != 0))
  {
    return; // the change came from this view
  }
  this->TakeCamera();
  // Two views that are compared turn together.
  this->Draw(PicturesPerSecondWhileMoving);
  this->pacer.RequestFine();
}

void VolumeView::TakeCamera()
{
  const Camera& camera = this->model->CurrentScene().camera;
  this->Style()->SetAutoAdjustCameraClippingRange(!camera.clippingRangeMm);
  this->pipeline->SetCamera(camera, this->Aspect());
  this->Tell(ScenePart::Camera);
}

void VolumeView::BeginTurning()
{
  this->turning = NewGesture();
  this->isTurning = true;
  this->pacer.StopRefinement();
}

void VolumeView::EndTurning()
{
  this->isTurning = false;
  this->pacer.RequestFine();
  this->KeepCamera();
}

// Records the camera that the user turned as an undo step.
void VolumeView::KeepCamera()
{
  if (!this->pipeline)
  {
    return;
  }
  vtkCamera* const camera = this->pipeline->Renderer()->GetActiveCamera();
  const CameraPose pose = PoseOf(camera);
  if (!(this->model->CurrentScene().camera.pose == pose))
  {
    this->model->Edit(
      ScenePart::Camera, tr("turn the camera"), [&](Scene& scene) { scene.camera.pose = pose; },
      this->turning);
    this->Tell(ScenePart::Camera);
    if (this->IsDrawnInThread())
    {
      this->Draw(PicturesPerSecondWhileMoving);
    }
  }
}

Camera VolumeView::CurrentCamera() const
{
  Camera camera = this->model->CurrentScene().camera;
  camera.pose = PoseOf(this->pipeline->Renderer()->GetActiveCamera());
  return camera;
}

double VolumeView::Aspect() const
{
  return this->size().isEmpty() ? 1.0 : double(this->width()) / this->height();
}

}
