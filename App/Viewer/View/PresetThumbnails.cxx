#include "Viewer/View/PresetThumbnails.h"

#include "Scene/OffscreenView.h"
#include "Scene/Presets.h"
#include "Scene/SmallCopy.h"
#include "Viewer/View/VtkPictures.h"

#include <QElapsedTimer>
#include <QThread>

#include <atomic>
#include <exception>

namespace varimarch
{

namespace
{

constexpr int CopyVoxelsPerSide = 128; ///< side of the reduced copy [voxels]
constexpr int RestMilliseconds = 500;
constexpr double ErrorTolerance = 1.0 / 32.0;
constexpr double Zoom = 1.3; // most volumes are empty in their corners

}

// Data of the thread. The volume is a shallow copy, of which the thread only reads the voxels.
struct PresetThumbnails::Task
{
  vtkNew<vtkImageData> volume;
  std::vector<Preset> presets;
  QSize pixels;
  std::atomic<bool> stop{ false };
  std::atomic<bool> rest{ false };

  // Pauses if requested; returns false if the task was stopped.
  bool ShouldContinue()
  {
    while (!this->stop && this->rest.exchange(false))
    {
      QThread::msleep(RestMilliseconds);
    }
    return !this->stop;
  }
};

PresetThumbnails::PresetThumbnails(QObject* parent)
  : QObject(parent)
{
}

PresetThumbnails::~PresetThumbnails()
{
  if (this->thread)
  {
    this->thread->disconnect(this);
    this->atWork->stop = true;
    this->thread->wait();
    delete this->thread;
  }
}

void PresetThumbnails::Draw(
  const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels)
{
  this->task = std::make_shared<Task>();
  this->task->volume->ShallowCopy(study->volume.image);
  this->task->presets = std::move(presets);
  this->task->pixels = pixels;
  this->task->rest = true;
  if (this->atWork)
  {
    this->atWork->stop = true;
  }
  else
  {
    this->Start();
  }
}

void PresetThumbnails::Rest()
{
  if (this->task)
  {
    this->task->rest = true;
  }
}

void PresetThumbnails::Start()
{
  this->atWork = this->task;
  this->thread = QThread::create([this, task = this->task] { this->Run(task); });
  connect(this->thread, &QThread::finished, this, &PresetThumbnails::Finish);
  this->thread->start();
}

void PresetThumbnails::Finish()
{
  this->thread->deleteLater();
  this->thread = nullptr;
  const bool isLast = this->atWork == this->task;
  this->atWork.reset();
  if (!isLast)
  {
    this->Start();
  }
}

// Runs in the thread.
void PresetThumbnails::Run(const std::shared_ptr<Task>& task)
{
  // A gallery that is shown again asks for nothing if it has all pictures.
  if (task->presets.empty() || !task->ShouldContinue())
  {
    return;
  }
  try
  {
    Scene scene;
    TakePreset(task->presets.front(), scene);
    scene.size = { task->pixels.width(), task->pixels.height() };
    scene.render.errorTolerance = ErrorTolerance;
    scene.camera.zoom = Zoom;
    OffscreenView view(scene, SmallCopy(task->volume, CopyVoxelsPerSide), MapperKind::Varimarch);
    for (int index = 0; index < int(task->presets.size()) && task->ShouldContinue(); ++index)
    {
      TakePreset(task->presets[index], scene);
      view.Pipeline().SetLook(scene.look);
      view.Pipeline().SetBackground(scene.background);
      view.Render();
      QMetaObject::invokeMethod(
        this,
        [this, task, index, picture = ImageOfBytes(view.Bytes())]
        {
          if (task == this->task)
          {
            emit this->Drawn(index, picture);
          }
        },
        Qt::QueuedConnection);
    }
  }
  catch (const std::exception&)
  {
    // Without OpenGL there are no thumbnails, but the presets can still be chosen.
  }
}

}
