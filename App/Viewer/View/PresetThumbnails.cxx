#include "Viewer/View/PresetThumbnails.h"

#include "Scene/OffscreenView.h"
#include "Scene/Presets.h"
#include "Scene/SmallCopy.h"
#include "Viewer/View/VtkPictures.h"

#include <QThread>

#include <chrono>
#include <exception>

namespace varimarch
{

namespace
{

constexpr int CopyVoxelsPerSide = 128; ///< side of the reduced copy [voxels]
constexpr int RestMilliseconds = 500;
constexpr double ErrorTolerance = 1.0 / 32.0;
constexpr double Zoom = 1.3; // most volumes are empty in their corners

// The pictures that are wanted. The volume is a shallow copy, of which the thread only reads the
// voxels.
struct WantedThumbnails
{
  vtkSmartPointer<vtkImageData> volume;
  std::vector<Preset> presets;
  QSize pixels;
  std::shared_ptr<std::atomic<bool>> rests;
};

// Pauses if requested; returns false if the work was cancelled.
bool ShouldContinue(std::atomic<bool>& rests, const TaskProgress& progress)
{
  while (progress(-1.0) && rests.exchange(false))
  {
    QThread::msleep(RestMilliseconds);
  }
  return progress(-1.0);
}

// Draws the pictures one after the other. Runs in the thread.
void DrawThumbnails(const WantedThumbnails& wanted, const TaskProgress& progress,
  const std::function<void(int, const QImage&)>& show)
{
  // A gallery that is shown again asks for nothing if it has all pictures.
  if (wanted.presets.empty() || !ShouldContinue(*wanted.rests, progress))
  {
    return;
  }
  Scene scene;
  TakePreset(wanted.presets.front(), scene);
  scene.size = { wanted.pixels.width(), wanted.pixels.height() };
  scene.render.errorTolerance = ErrorTolerance;
  scene.camera.zoom = Zoom;
  OffscreenView view(scene, SmallCopy(wanted.volume, CopyVoxelsPerSide), MapperKind::Varimarch);
  for (int index = 0; index < int(wanted.presets.size()) && ShouldContinue(*wanted.rests, progress);
       ++index)
  {
    TakePreset(wanted.presets[index], scene);
    view.Pipeline().SetLook(scene.look);
    view.Pipeline().SetBackground(scene.background);
    view.Render();
    show(index, ImageOfBytes(view.Bytes()));
  }
}

}

// A thread that draws is never left alone. Where there is no OpenGL, the task fails, and there are
// no thumbnails; the presets can still be chosen.
PresetThumbnails::PresetThumbnails(QObject* parent)
  : QObject(parent)
{
  this->task.SetPatience(std::chrono::hours(24));
}

void PresetThumbnails::Draw(
  const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels)
{
  this->rests = std::make_shared<std::atomic<bool>>(true);
  const WantedThumbnails wanted = { vtkSmartPointer<vtkImageData>::New(), std::move(presets),
    pixels, this->rests };
  wanted.volume->ShallowCopy(study->volume.image);
  this->task.StartAfterLast(
    [this, wanted](const TaskProgress& progress, const TaskPost& post)
    {
      DrawThumbnails(wanted, progress,
        [&](int index, const QImage& picture)
        { post([this, index, picture] { emit this->Drawn(index, picture); }); });
    },
    [] {});
}

void PresetThumbnails::Rest()
{
  if (this->rests)
  {
    *this->rests = true;
  }
}

}
