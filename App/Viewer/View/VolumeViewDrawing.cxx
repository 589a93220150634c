// The frames of a VolumeView: quick, fine and refined; and those that are lost.

#include "Viewer/View/VolumeView.h"

#include "Scene/FloatCapture.h"
#include "Viewer/WaitCursor.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkVariationFieldVolumeMapper.h>

namespace varimarch
{

namespace
{

constexpr double PicturesPerSecondWhenStill = 0.01;
constexpr int RefiningPictures = 8;
constexpr double LongestPartSeconds = 0.3;

}

void VolumeView::Draw(double framesPerSecond)
{
  if (this->isLost)
  {
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
}

std::optional<PictureNumbers> VolumeView::Numbers()
{
  auto* const ours = this->OurMapper();
  return ours ? NumbersOf(ours) : std::optional<PictureNumbers>();
}

void VolumeView::Refine()
{
  if (this->still.IsIncomplete())
  {
    this->ContinueStill();
    return;
  }
  auto* const ours = this->OurMapper();
  if (!ours || ours->GetDrawnPart() >= 1.0 || this->isLost)
  {
    return;
  }
  this->refining = true;
  this->window->Render();
  this->refining = false;
  this->pacer.RequestRefinement();
  emit this->Refined(ours->GetDrawnPart() * ours->GetMaximumAccumulatedPictures());
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
  if (this->capturing || this->isLost)
  {
    return;
  }
  this->window->WaitForCompletion();
  const double seconds = 1e-9 * double(this->pictureTimer.nsecsElapsed());
  this->overlay->update();
  if (this->refining && this->isWhole)
  {
    return; // one of several frames to be averaged
  }
  this->pictureSeconds = seconds + (this->refining ? this->pictureSeconds : 0.0);
  this->isWhole = !this->OurMapper() || this->OurMapper()->GetAccumulatedPictures() > 0;
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

void VolumeView::initializeGL()
{
  QVTKOpenGLNativeWidget::initializeGL();
  if (this->isLost)
  {
    this->isLost = false;
    this->pacer.Request();
  }
}

}
