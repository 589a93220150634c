// The frames of a VolumeView: quick, fine and refined; and those that are lost.

#include "Viewer/View/VolumeView.h"

#include "Scene/Images/EmptyPicture.h"
#include "Scene/Images/FloatCapture.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/Log.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkVariationFieldVolumeMapper.h>

namespace varimarch
{

namespace
{

constexpr double PicturesPerSecondWhenStill = 0.01;
constexpr double LongestPartSeconds = 0.3;

}

void VolumeView::Draw(double framesPerSecond)
{
  if (this->isLost)
  {
    return;
  }
  if (this->IsDrawnInThread())
  {
    if (this->pipeline && !this->size().isEmpty())
    {
      this->thread->Draw({ this->size() * this->devicePixelRatioF(), framesPerSecond,
        this->refining, !this->refines });
    }
    return;
  }
  // While the user turns the camera, VTK's interactor style sets the rate.
  if (!this->isTurning)
  {
    this->window->SetDesiredUpdateRate(framesPerSecond);
  }
  this->window->Render();
}

// VTK's CPU mapper renders a frame in one piece.
void VolumeView::DrawFinely()
{
  if (this->kind == MapperKind::VtkGpu && this->pipeline && !this->size().isEmpty())
  {
    this->still.Begin(this->window, this->pipeline->Renderer());
    return;
  }
  std::optional<WaitCursor> cursor;
  if (!this->OurMapper())
  {
    cursor.emplace();
  }
  this->Draw(PicturesPerSecondWhenStill);
}

vtkVariationFieldVolumeMapper* VolumeView::OurMapper()
{
  return this->pipeline ? vtkVariationFieldVolumeMapper::SafeDownCast(this->pipeline->Mapper())
                        : nullptr;
}

void VolumeView::SetRefining(bool newRefines)
{
  this->refines = newRefines;
  this->ApplyRefining();
  this->pacer.Request();
}

void VolumeView::ApplyRefining()
{
  if (auto* const ours = this->OurMapper())
  {
    ours->SetMaximumAccumulatedPictures(this->refines ? RefiningPictures : 1);
    ours->SetLongestPartSeconds(this->refines ? LongestPartSeconds : 0.0);
  }
  const bool isDrawnHere = !this->IsDrawnInThread();
  if (isDrawnHere)
  {
    this->TakeCuts();
  }
  this->surface->setVisible(isDrawnHere);
  this->window->GetInteractor()->SetEnableRender(isDrawnHere);
  if (this->pipeline)
  {
    this->pipeline->Renderer()->SetDraw(isDrawnHere);
  }
}

void VolumeView::DrawInThread()
{
  this->thread = std::make_unique<PictureThread>();
  connect(this->thread.get(), &PictureThread::Drawn, this, &VolumeView::TakePicture);
  // Queued, because it ends the thread.
  connect(this->thread.get(), &PictureThread::Failed, this, &VolumeView::GiveUpThread,
    Qt::QueuedConnection);
  this->ApplyRefining();
  if (this->pipeline)
  {
    this->Tell(ScenePart::Volume);
    this->pacer.Request();
  }
}

void VolumeView::GiveUpThread()
{
  LogEvent("pictures are not drawn in a thread");
  this->thread.reset();
  this->ApplyRefining();
  this->pacer.Request();
}

// Tells the thread that a part of the scene has changed. The camera is that of the view.
void VolumeView::Tell(ScenePart part)
{
  if (!this->thread)
  {
    return;
  }
  Scene scene = this->model->CurrentScene();
  scene.camera = this->CurrentCamera();
  this->thread->Take(part, scene, this->model->CurrentStudy());
  this->overlay->update(); // the picture that is shown is out of date
}

bool VolumeView::IsOutOfDate() const
{
  const ThreadPicture* const picture = this->IsDrawnInThread() ? this->thread->Last() : nullptr;
  return picture &&
    (!this->thread->IsLastCurrent() ||
      picture->wanted.pixels != this->size() * this->devicePixelRatioF());
}

void VolumeView::TakePicture()
{
  if (!this->IsDrawnInThread())
  {
    return;
  }
  const ThreadPicture picture = *this->thread->Last();
  this->Count(picture.seconds, picture.wanted.refines);
  if (picture.wanted.refines)
  {
    emit this->Refined(picture.numbers.drawnPart * picture.numbers.mostAveraged);
  }
  if (picture.wanted.picturesPerSecond < 1.0)
  {
    this->pacer.RequestRefinement();
  }
}

QSize VolumeView::PicturePixels() const
{
  const bool isOfThread = this->IsDrawnInThread() && this->thread->Last();
  return isOfThread ? this->thread->Last()->image.size() : this->size() * this->devicePixelRatioF();
}

QString VolumeView::Report()
{
  return this->pipeline
    ? PictureReport(this->Numbers(), this->kind, this->model->CurrentScene(), this->pictureSeconds)
    : QString();
}

std::optional<PictureNumbers> VolumeView::Numbers()
{
  std::optional<PictureNumbers> numbers = this->NumbersOfMapper();
  if (numbers && this->model->CurrentStudy()->volume.isPreview)
  {
    numbers->isCoarse = true;
  }
  return numbers;
}

std::optional<PictureNumbers> VolumeView::NumbersOfMapper()
{
  if (this->IsDrawnInThread())
  {
    const ThreadPicture* const picture = this->thread->Last();
    PictureNumbers numbers =
      picture ? picture->numbers : PictureNumbers{ 0, RefiningPictures, 0.0 };
    numbers.isOutOfDate = this->IsOutOfDate();
    numbers.isMoving = this->isTurning;
    return numbers;
  }
  auto* const ours = this->OurMapper();
  if (!ours)
  {
    return std::nullopt;
  }
  PictureNumbers numbers = NumbersOf(ours);
  numbers.reasonForNothing = this->reasonForNothing;
  numbers.isMoving = this->isTurning;
  numbers.isFine &= !this->isTurning;
  return numbers;
}

void VolumeView::Refine()
{
  if (this->still.IsIncomplete())
  {
    this->ContinueStill();
    return;
  }
  const std::optional<PictureNumbers> numbers = this->Numbers();
  const bool isComplete = !numbers || numbers->drawnPart >= 1.0;
  if (isComplete || this->isLost || (this->IsDrawnInThread() && this->thread->IsBusy()))
  {
    return;
  }
  this->refining = true;
  this->Draw(PicturesPerSecondWhenStill);
  this->refining = false;
  if (!this->IsDrawnInThread())
  {
    this->pacer.RequestRefinement();
    const PictureNumbers now = *this->Numbers();
    emit this->Refined(now.drawnPart * now.mostAveraged);
  }
}

// A change of the scene clears the image, and the next frame begins it again.
void VolumeView::ContinueStill()
{
  if (!this->still.Continue())
  {
    this->pacer.RequestRefinement();
    return;
  }
  this->pictureSeconds = this->still.Seconds();
  this->overlay->update();
  emit this->Drawn();
}

vtkSmartPointer<vtkImageData> VolumeView::FloatPicture()
{
  if (this->kind == MapperKind::VtkGpu)
  {
    return this->still.Picture();
  }
  if (this->IsDrawnInThread())
  {
    return this->thread->Last() && !this->IsOutOfDate() ? this->thread->Last()->floats : nullptr;
  }
  this->capturing = true;
  const vtkSmartPointer<vtkImageData> picture =
    CaptureFloatImage(this->window, this->pipeline->Renderer());
  this->capturing = false;
  return picture;
}

void VolumeView::BeginPicture()
{
  this->still.Clear();
  this->pictureTimer.start();
}

void VolumeView::EndPicture()
{
  if (this->capturing || this->isLost || this->IsDrawnInThread())
  {
    return;
  }
  this->window->WaitForCompletion();
  // An image while the user turns the camera is replaced at once.
  const bool isStill = !this->isTurning && this->pipeline && this->OurMapper();
  this->reasonForNothing = isStill
    ? ReasonForNothing(BytesOf(this->window), *this->pipeline, this->model->CurrentScene())
    : std::string();
  this->Count(1e-9 * double(this->pictureTimer.nsecsElapsed()), this->refining);
}

// Counts a drawing that has just ended.
void VolumeView::Count(double seconds, bool refines)
{
  this->overlay->update();
  if (refines && this->isWhole)
  {
    return; // one of several frames to be averaged
  }
  this->pictureSeconds = seconds + (refines ? this->pictureSeconds : 0.0);
  const std::optional<PictureNumbers> numbers = this->NumbersOfMapper();
  const bool voxelsFollow = numbers && numbers->isCoarse && numbers->drawnPart < 1.0;
  this->isWhole = !numbers || (numbers->averaged > 0 && !voxelsFollow);
  if (this->isWhole)
  {
    emit this->Drawn();
  }
}

void VolumeView::LoseGraphics()
{
  if (!this->isLost)
  {
    this->isLost = true;
    emit this->GraphicsLost();
  }
}

void VolumeView::TakeContext()
{
  if (this->isLost)
  {
    this->isLost = false;
    this->pacer.Request();
  }
}

}
