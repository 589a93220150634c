#include "Viewer/View/VolumeView.h"

#include "Scene/SceneCamera.h"

#include <QLabel>
#include <QTimer>

#include <vtkCommand.h>
#include <vtkEventQtSlotConnect.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRendererCollection.h>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr double PicturesPerSecondWhileMoving = 15.0;
constexpr double PicturesPerSecondWhenStill = 0.01;

}

VolumeView::VolumeView(SceneModel* model, MapperKind kind, QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , model(model)
  , kind(kind)
  , report(new QLabel(this))
{
  this->setRenderWindow(this->window);
  this->window->SetMultiSamples(0);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  vtkRenderWindowInteractor* const interactor = this->interactor();
  interactor->SetInteractorStyle(style);
  interactor->SetDesiredUpdateRate(PicturesPerSecondWhileMoving);
  interactor->SetStillUpdateRate(PicturesPerSecondWhenStill);
  this->events->Connect(style, vtkCommand::EndInteractionEvent, this, SLOT(KeepCamera()));
  this->events->Connect(this->window, vtkCommand::StartEvent, this, SLOT(BeginPicture()));
  this->events->Connect(this->window, vtkCommand::EndEvent, this, SLOT(EndPicture()));

  this->report->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->report->setStyleSheet(QStringLiteral("color: #c8c8c8; background: transparent;"));
  this->report->move(8, 8);
  connect(model, &SceneModel::Changed, this, &VolumeView::Update);
}

VolumeView::~VolumeView()
{
  // The window lives on while members are destroyed; what it calls does not.
  this->events->Disconnect();
}

void VolumeView::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  if (this->pipeline && !this->model->CurrentScene().camera.pose)
  {
    this->TakeCamera();
  }
}

void VolumeView::Update(ScenePart part)
{
  const Scene& scene = this->model->CurrentScene();
  switch (part)
  {
    case ScenePart::Volume:
      this->TakeVolume();
      break;
    case ScenePart::Look:
      this->pipeline->SetLook(scene.look);
      break;
    case ScenePart::Camera:
      this->TakeCamera();
      break;
    case ScenePart::Render:
      this->pipeline->SetRenderOptions(scene.render);
      break;
    case ScenePart::Background:
      this->pipeline->SetBackground(scene.background);
      break;
  }
  this->RequestPicture();
}

void VolumeView::TakeVolume()
{
  if (this->pipeline)
  {
    this->window->RemoveRenderer(this->pipeline->Renderer());
  }
  this->pipeline.emplace(
    this->model->CurrentScene(), this->model->CurrentStudy()->volume.image, this->kind);
  this->window->AddRenderer(this->pipeline->Renderer());
  this->TakeCamera();
}

void VolumeView::TakeCamera()
{
  this->pipeline->SetCamera(this->model->CurrentScene().camera, this->Aspect());
}

// What the user has turned the camera to becomes a step of the history.
void VolumeView::KeepCamera()
{
  if (this->pipeline)
  {
    const CameraPose pose = PoseOf(this->pipeline->Renderer()->GetActiveCamera());
    this->model->Edit(
      ScenePart::Camera, tr("turn the camera"), [&](Scene& scene) { scene.camera.pose = pose; });
  }
}

void VolumeView::RequestPicture()
{
  if (!this->pictureRequested)
  {
    this->pictureRequested = true;
    QTimer::singleShot(0, this,
      [this]
      {
        this->pictureRequested = false;
        this->window->Render();
      });
  }
}

void VolumeView::BeginPicture()
{
  this->pictureTimer.start();
}

void VolumeView::EndPicture()
{
  this->window->WaitForCompletion();
  this->pictureSeconds = 1e-9 * double(this->pictureTimer.nsecsElapsed());
  if (this->pipeline)
  {
    const double tolerance = this->model->CurrentScene().render.errorTolerance;
    const QString error = tolerance > 0.0
      ? tr("error at most 1/%1").arg(int(std::lround(1.0 / tolerance)))
      : tr("error not bounded");
    this->report->setText(tr("%1 ms  ·  %2").arg(1e3 * this->pictureSeconds, 0, 'f', 0).arg(error));
    this->report->adjustSize();
  }
  emit this->Drawn();
}

double VolumeView::Aspect() const
{
  return this->height() > 0 ? double(this->width()) / this->height() : 1.0;
}

}
