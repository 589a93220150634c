#include "Viewer/View/VolumeView.h"

#include "March/Device/GraphicsDriver.h"
#include "Scene/Model/Scene.h"
#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Scene/Volumes/Placing.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/Overlay.h"
#include "Viewer/View/PictureThread.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkEventQtSlotConnect.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInteractorStyle.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <cmath>
#include <utility>

namespace varimarch
{

// Paints over the image and lets mouse events through.
class VolumeView::OverlayWidget : public QWidget
{
public:
  explicit OverlayWidget(VolumeView* view)
    : QWidget(view)
    , view(view)
  {
    this->setObjectName("overlay");
    this->setAttribute(Qt::WA_TransparentForMouseEvents);
  }

protected:
  void paintEvent(QPaintEvent*) override
  {
    if (this->view->pipeline)
    {
      QPainter painter(this);
      const auto& [red, green, blue] = this->view->model->CurrentScene().background;
      const QColor background = QColor::fromRgbF(red, green, blue);
      this->view->still.Paint(painter, this->rect(), background);
      this->PaintPictureOfThread(painter, background);
      const QString text = this->view->Report();
      this->view->setAccessibleDescription(text); // for screen readers
      const QRectF report = DrawLegibly(painter, this->rect().adjusted(10, 10, -10, -10),
        this->view->reportSide | Qt::AlignTop, text);
      DrawOverlay(painter,
        { this->view->model->CurrentScene(), this->view->texts,
          this->view->model->CurrentStudy()->volume.image },
        this->view->Frame(), this->view->Mask(), { report });
      this->view->tools.Paint(painter);
    }
  }

private:
  void PaintPictureOfThread(QPainter& painter, const QColor& background)
  {
    if (!this->view->IsDrawnInThread())
    {
      return;
    }
    if (const ThreadPicture* const picture = this->view->thread->Last())
    {
      painter.drawImage(this->rect(), picture->image);
    }
    else
    {
      painter.fillRect(this->rect(), background);
    }
  }

  VolumeView* view;
};

VolumeView::VolumeView(SceneModel* model, MapperKind kind, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , kind(kind)
  , tools(model, *this, [this] { return this->CurrentCamera(); })
{
  // A new child is an event, which takes all other members.
  this->surface = new VolumeSurface(this);
  this->overlay = new OverlayWidget(this);
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
  for (const Qt::GestureType gesture :
    { Qt::PinchGesture, Qt::PanGesture, Qt::TapGesture, Qt::TapAndHoldGesture, Qt::SwipeGesture })
  {
    this->grabGesture(gesture);
  }
  this->setAccessibleName(tr("Volume"));
  this->ConnectWindow();
  connect(&this->pacer, &FramePacer::QuickFrameDue, this,
    [this] { this->Draw(PicturesPerSecondWhileMoving); });
  connect(&this->pacer, &FramePacer::FineFrameDue, this, &VolumeView::DrawFinely);
  connect(&this->pacer, &FramePacer::RefinementDue, this, &VolumeView::Refine);
  connect(model, &SceneModel::Changed, this, &VolumeView::Update);
  if (model->CurrentStudy())
  {
    this->Update(ScenePart::Volume);
  }
}

VolumeView::~VolumeView()
{
  // The window outlives some members, so disconnect its events first.
  this->events->Disconnect();
}

void VolumeView::ConnectWindow()
{
  this->surface->setRenderWindow(this->window);
  connect(this->surface, &VolumeSurface::ContextIsNew, this, &VolumeView::TakeContext);
  this->window->SetMultiSamples(0);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  vtkRenderWindowInteractor* const interactor = this->window->GetInteractor();
  interactor->SetInteractorStyle(style);
  interactor->SetDesiredUpdateRate(PicturesPerSecondWhileMoving);
  // The timer requests the fine frame, so that scrolling the wheel stays smooth.
  interactor->SetStillUpdateRate(PicturesPerSecondWhileMoving);
  this->events->Connect(style, vtkCommand::StartInteractionEvent, this, SLOT(BeginTurning()));
  this->events->Connect(style, vtkCommand::InteractionEvent, this, SLOT(KeepCamera()));
  this->events->Connect(style, vtkCommand::EndInteractionEvent, this, SLOT(EndTurning()));
  this->events->Connect(this->window, vtkCommand::StartEvent, this, SLOT(BeginPicture()));
  this->events->Connect(this->window, vtkCommand::EndEvent, this, SLOT(EndPicture()));
}

vtkRenderWindow* VolumeView::RenderWindow()
{
  return this->window;
}

bool VolumeView::event(QEvent* event)
{
  if (!this->pipeline && dynamic_cast<QInputEvent*>(event))
  {
    return QWidget::event(event); // VTK's style warns of a window without a renderer
  }
  if (this->pipeline && this->PressSegment(event))
  {
    return true;
  }
  if (this->pipeline && this->tools.Take(event))
  {
    if (event->type() == QEvent::MouseMove && this->tools.Measures())
    {
      this->Point(static_cast<QMouseEvent*>(event)->localPos());
    }
    this->overlay->update();
    return true;
  }
  if (event->type() == QEvent::MouseButtonDblClick)
  {
    emit this->DoubleClicked();
    return true;
  }
  if (event->type() == QEvent::MouseMove)
  {
    const auto* const mouse = static_cast<QMouseEvent*>(event);
    if (mouse->buttons() == Qt::NoButton)
    {
      this->setCursor(this->tools.Cursor(mouse->localPos()));
      this->overlay->update();
      this->Point(mouse->localPos());
    }
  }
  this->input.ProcessEvent(event, this->window->GetInteractor());
  return QWidget::event(event);
}

void VolumeView::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  this->surface->resize(this->size());
  this->overlay->resize(this->size());
  // The surface tells VTK its size only while it is visible.
  const QSize pixels = this->size() * this->devicePixelRatioF();
  this->input.SetDevicePixelRatio(float(this->devicePixelRatioF()));
  this->window->GetInteractor()->UpdateSize(pixels.width(), pixels.height());
  if (this->pipeline && !this->model->CurrentScene().camera.pose)
  {
    this->TakeCamera();
  }
  this->pacer.Request();
}

void VolumeView::Update(ScenePart part)
{
  if (part == ScenePart::Camera)
  {
    this->FollowCamera();
  }
  else if (part == ScenePart::Measures)
  {
    this->TakeMeasures();
  }
  else if (this->Takes(part))
  {
    this->pacer.Request();
  }
}

// Takes a part of the scene that is drawn by the mapper. Returns false for the others.
bool VolumeView::Takes(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->TakeVolume();
    return true;
  }
  if (part == ScenePart::Cuts && this->IsDrawnInThread())
  {
    this->hasCuts = false;
  }
  else if (!ShowPart(part, this->model->CurrentScene(), VoxelsOf(*this->model->CurrentStudy()),
             *this->pipeline))
  {
    return false;
  }
  if (part == ScenePart::Voxels || part == ScenePart::Overlays)
  {
    this->TakeMeasures();
  }
  this->Tell(part);
  return true;
}

// Masks take long to make, so the pipeline of the window has none until it draws.
void VolumeView::TakeCuts()
{
  if (this->pipeline && !std::exchange(this->hasCuts, true))
  {
    this->pipeline->SetCuts(this->model->CurrentScene().cuts);
  }
}

vtkImageData* VolumeView::Mask() const
{
  if (!this->IsDrawnInThread())
  {
    return this->pipeline->Mask();
  }
  const ThreadPicture* const picture = this->thread->Last();
  return picture ? picture->mask.Get() : nullptr;
}

void VolumeView::TakeMeasures()
{
  this->texts = this->model->Texts();
  this->overlay->update();
}

void VolumeView::TakeVolume()
{
  if (this->pipeline)
  {
    this->window->RemoveRenderer(this->pipeline->Renderer());
  }
  Scene scene = this->model->CurrentScene();
  this->hasCuts = !this->IsDrawnInThread();
  if (!this->hasCuts)
  {
    scene.cuts = {};
  }
  this->pipeline.emplace(scene, this->model->CurrentStudy()->volume.image, this->kind);
  ShowPart(ScenePart::Volume, scene, VoxelsOf(*this->model->CurrentStudy()), *this->pipeline);
  // The corner of the view says whether the error tolerance is kept; the mapper need not warn.
  this->pipeline->Mapper()->AddObserver(vtkCommand::WarningEvent, vtkNew<vtkCallbackCommand>());
  this->events->Connect(this->pipeline->Mapper(), GraphicsResetEvent, this, SLOT(LoseGraphics()));
  this->ApplyRefining();
  this->window->AddRenderer(this->pipeline->Renderer());
  this->texts = this->model->Texts();
  this->tools.Forget();
  this->TakeCamera();
  this->Tell(ScenePart::Volume);
}

PictureFrame VolumeView::Frame() const
{
  return FrameOf(this->pipeline->Renderer()->GetActiveCamera(), this->size());
}

void VolumeView::SetTool(LeftButton button)
{
  this->tools.Choose(button);
  if (button == LeftButton::Walk)
  {
    this->setFocus(); // for the keys
  }
  this->setCursor(this->tools.Cursor(this->mapFromGlobal(QCursor::pos())));
  this->overlay->update();
}

void VolumeView::ShowCutHandles(bool shown)
{
  this->tools.ShowCutHandles(shown);
  this->overlay->update();
}

void VolumeView::SetReportSide(Qt::AlignmentFlag side)
{
  this->reportSide = side;
  this->overlay->update();
}

// The part of VolumeView that keeps the camera of the view and that of the scene alike.

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

// The part of VolumeView that finds what is under the pointer.

std::optional<std::array<double, 3>> VolumeView::PointAt(const QPointF& place) const
{
  const SightLine sight = this->Frame().sightLineAt(place);
  return PointSeen(this->model->CurrentScene(), this->model->CurrentStudy()->volume.image,
    NumbersOf(sight.nearest), NumbersOf(sight.farthest), this->Mask());
}

// The point of the edited volume that is seen if it is alone. The cuts are those of the first.
std::optional<std::array<double, 3>> VolumeView::PointOfEdited(const QPointF& place) const
{
  const int edited = this->model->EditedVolume();
  if (edited == 0)
  {
    return this->PointAt(place);
  }
  Scene scene = this->model->EditedScene();
  scene.cuts.planes = PlanesOf(scene.cuts, this->model->CurrentStudy()->volume.image);
  scene.cuts.box = SceneCuts().box;
  const SightLine sight = this->Frame().sightLineAt(place);
  return PointSeen(scene,
    Placed(this->model->EditedStudy()->volume.image, PlacementOf(scene, edited)),
    NumbersOf(sight.nearest), NumbersOf(sight.farthest));
}

void VolumeView::AskForWords(const QPointF& place, const std::function<void(const QString&)>& take)
{
  AskForWordsOver(this, place, take);
}

void VolumeView::Point(const QPointF& place)
{
  const std::optional<std::array<double, 3>> point = this->PointAt(place);
  emit this->Pointed(point
      ? PointText(this->model->CurrentScene(), *this->model->CurrentStudy(), *point)
      : QString());
}

// True if the event is a press that adds a region to a segment.
bool VolumeView::PressSegment(QEvent* event)
{
  const bool isPress = event->type() == QEvent::MouseButtonPress;
  const auto* const mouse = isPress ? static_cast<QMouseEvent*>(event) : nullptr;
  if (!mouse || mouse->button() != Qt::LeftButton || !this->segmentEditor ||
    !this->segmentEditor->TakesVolume())
  {
    return false;
  }
  if (const auto point = this->PointOfEdited(mouse->localPos()))
  {
    this->segmentEditor->AddRegion(*point);
  }
  return true;
}

namespace
{

constexpr int StillMilliseconds = 250;
constexpr int RefinementMilliseconds = 20; // between the parts, for other events

void Prepare(QTimer& timer, int milliseconds)
{
  timer.setSingleShot(true);
  timer.setInterval(milliseconds);
}

// Calls an action when the timer ends and no mouse button is held.
template <class Action>
void WhenReleased(QTimer& timer, const Action& action)
{
  QObject::connect(&timer, &QTimer::timeout, &timer,
    [&timer, action]
    {
      if (QGuiApplication::mouseButtons() == Qt::NoButton)
      {
        action();
      }
      else
      {
        timer.start();
      }
    });
}

}

FramePacer::FramePacer(QObject* parent)
  : QObject(parent)
{
  Prepare(this->quickFrame, 0);
  Prepare(this->fineFrame, StillMilliseconds);
  Prepare(this->refinement, RefinementMilliseconds);
  connect(&this->quickFrame, &QTimer::timeout, this, &FramePacer::QuickFrameDue);
  WhenReleased(this->fineFrame,
    [this]
    {
      emit this->FineFrameDue();
      this->refinement.start();
    });
  WhenReleased(this->refinement, [this] { emit this->RefinementDue(); });
}

void FramePacer::Request()
{
  this->quickFrame.start();
  this->RequestFine();
}

void FramePacer::RequestFine()
{
  this->refinement.stop();
  this->fineFrame.start();
}

VolumeSurface::VolumeSurface(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->setFocusPolicy(Qt::NoFocus);
}

void VolumeSurface::initializeGL()
{
  QVTKOpenGLNativeWidget::initializeGL();
  emit this->ContextIsNew();
}

}
