#include "Viewer/View/PictureThread.h"

#include "Scene/OffscreenView.h"
#include "Viewer/View/MovingImageSize.h"
#include "Viewer/View/ShownParts.h"
#include "Viewer/View/VtkPictures.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace varimarch
{

namespace
{

// A picture that is no longer wanted takes at most this long, apart from a search for steps.
constexpr double LongestPartOfThreadSeconds = 0.1;

// A picture that is wanted, with what the thread needs to draw it.
struct Order
{
  Scene scene;
  ShownVoxels voxels;
  std::set<ScenePart> changed; // since the last order that was drawn
  int volume = 0;              // a number for the volume
  std::optional<WantedPicture> wanted;
};

// A copy that shares the voxels. VTK keeps the range of an array with the array, so each thread has
// arrays of its own, except for voxels in a file, which are known by their array.
vtkSmartPointer<vtkImageData> CopyOf(const LoadedVolume& volume)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->ShallowCopy(volume.image);
  if (!volume.isOnDisk)
  {
    vtkDataArray* const scalars = volume.image->GetPointData()->GetScalars();
    const auto own = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    own->ShallowCopy(scalars);
    copy->GetPointData()->SetScalars(own);
  }
  return copy;
}

// Voxels of labels are copied too, because they are edited in their place.
std::shared_ptr<const LabelMap> CopyOf(const std::shared_ptr<const LabelMap>& labels)
{
  if (!labels)
  {
    return nullptr;
  }
  auto copy = std::make_shared<LabelMap>(*labels);
  copy->image = vtkSmartPointer<vtkImageData>::New();
  copy->image->DeepCopy(labels->image);
  return copy;
}

void CopyVoxels(ScenePart part, const Study& study, ShownVoxels& voxels)
{
  const bool isNew = part == ScenePart::Volume;
  if (isNew || part == ScenePart::Voxels)
  {
    voxels.volume = CopyOf(study.volume);
  }
  if (isNew || part == ScenePart::Labels)
  {
    voxels.labels = CopyOf(study.labels);
  }
  if (isNew || part == ScenePart::Labels || part == ScenePart::Overlays)
  {
    voxels.overlays.clear();
    for (const auto& overlay : study.overlays)
    {
      voxels.overlays.push_back({ CopyOf(overlay->volume), CopyOf(overlay->labels) });
    }
  }
}

// The view of the thread, which lives and dies there.
class ThreadView
{
public:
  ThreadPicture Draw(const Order& order);

private:
  void Show(const Order& order, const QSize& size);

  std::unique_ptr<OffscreenView> view;
  QSize pixels;
  MovingImageSize moving;
};

vtkVariationFieldVolumeMapper* MapperOf(OffscreenView& view)
{
  return vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
}

void ThreadView::Show(const Order& order, const QSize& size)
{
  Scene scene = order.scene;
  scene.size = { size.width(), size.height() };
  if (!this->view || order.changed.count(ScenePart::Volume) > 0)
  {
    this->view.reset(); // before the next one, for the memory
    this->view = std::make_unique<OffscreenView>(scene, order.voxels.volume, MapperKind::Varimarch);
    ShowPart(ScenePart::Volume, scene, order.voxels, this->view->Pipeline());
    vtkVariationFieldVolumeMapper* const mapper = MapperOf(*this->view);
    mapper->SetMaximumAccumulatedPictures(RefiningPictures);
    mapper->SetLongestPartSeconds(LongestPartOfThreadSeconds);
    // The corner of the view says whether the error tolerance is kept; the mapper need not warn.
    mapper->AddObserver(vtkCommand::WarningEvent, vtkNew<vtkCallbackCommand>());
  }
  else
  {
    for (const ScenePart part : order.changed)
    {
      ShowPart(part, scene, order.voxels, this->view->Pipeline());
    }
    this->view->Resize(scene.size[0], scene.size[1]);
  }
  if (order.changed.count(ScenePart::Camera) > 0 || this->pixels != size)
  {
    this->view->Pipeline().SetCamera(scene.camera, double(scene.size[0]) / scene.size[1]);
  }
  this->pixels = size;
}

ThreadPicture ThreadView::Draw(const Order& order)
{
  const WantedPicture& wanted = *order.wanted;
  const double allocatedSeconds = 1.0 / wanted.picturesPerSecond;
  const bool isMoving = wanted.picturesPerSecond > 1.0;
  const QSize size = isMoving ? this->moving.Of(wanted.pixels) : wanted.pixels;
  const bool isFamiliar = size == this->pixels; // without the time for a new framebuffer
  QElapsedTimer timer;
  timer.start();
  this->Show(order, size);
  this->view->SetPicturesPerSecond(
    isMoving ? 1.0 / this->moving.SecondsForRays(allocatedSeconds) : wanted.picturesPerSecond);
  ThreadPicture picture;
  picture.seconds = this->view->Render();
  picture.image = ImageOfBytes(this->view->Bytes()).convertToFormat(QImage::Format_RGB32);
  picture.numbers = NumbersOf(MapperOf(*this->view));
  picture.wanted = wanted;
  if (isMoving && isFamiliar)
  {
    const double seconds = 1e-9 * double(timer.nsecsElapsed());
    this->moving.Took(
      wanted.pixels, seconds - MapperOf(*this->view)->GetTimeToDraw(), allocatedSeconds);
  }
  return picture;
}

}

// The orders and results of both threads, which take the mutex to use them.
struct PictureThread::Work
{
  std::mutex mutex;
  std::condition_variable changed;
  Order next;
  bool isDrawing = false;
  bool stops = false;
  std::optional<ThreadPicture> finished;
  bool hasFailed = false;
  std::thread thread;

  /// Waits for the next order, and takes it. Empty if the thread is to stop.
  std::optional<Order> Next()
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    this->changed.wait(lock, [this] { return this->stops || this->next.wanted; });
    if (this->stops)
    {
      return {};
    }
    this->isDrawing = true;
    Order order = this->next;
    this->next.wanted.reset();
    this->next.changed.clear();
    return order;
  }

  /// Keeps a picture unless its volume was replaced meanwhile. From now on the thread is idle:
  /// whoever is told of the picture may ask for the next part of it at once.
  void Finish(ThreadPicture picture, int volume)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->isDrawing = false;
    if (volume == this->next.volume)
    {
      this->finished = std::move(picture);
    }
  }

  void Run(const std::function<void()>& tell)
  {
    ThreadView view;
    while (const std::optional<Order> order = this->Next())
    {
      try
      {
        this->Finish(view.Draw(*order), order->volume);
      }
      catch (const std::exception&)
      {
        const std::lock_guard<std::mutex> lock(this->mutex);
        this->hasFailed = true;
        this->stops = true;
      }
      tell();
    }
  }
};

PictureThread::PictureThread(QObject* parent)
  : QObject(parent)
  , work(std::make_unique<Work>())
{
  const auto tell = [this]
  {
    QMetaObject::invokeMethod(
      this, [this] { this->TakePicture(); }, Qt::QueuedConnection);
  };
  this->work->thread = std::thread([work = this->work.get(), tell] { work->Run(tell); });
}

PictureThread::~PictureThread()
{
  {
    const std::lock_guard<std::mutex> lock(this->work->mutex);
    this->work->stops = true;
  }
  this->work->changed.notify_one();
  this->work->thread.join();
}

void PictureThread::Take(ScenePart part, const Scene& scene, const Study& study)
{
  if (part == ScenePart::Voxels && study.volume.image == this->copied)
  {
    return; // only the counts of the values are others
  }
  this->copied = study.volume.image;
  // Labels are large, and copied while the thread may go on.
  ShownVoxels voxels;
  CopyVoxels(part, study, voxels);
  const std::lock_guard<std::mutex> lock(this->work->mutex);
  Order& next = this->work->next;
  next.scene = scene;
  next.changed.insert(part);
  if (part == ScenePart::Volume)
  {
    ++next.volume;
    this->work->finished.reset();
    this->last.reset();
    next.voxels = std::move(voxels);
  }
  else if (part == ScenePart::Voxels)
  {
    next.voxels.volume = std::move(voxels.volume);
  }
  else if (part == ScenePart::Labels)
  {
    next.voxels.labels = std::move(voxels.labels);
    next.voxels.overlays = std::move(voxels.overlays);
  }
  else if (part == ScenePart::Overlays)
  {
    next.voxels.overlays = std::move(voxels.overlays);
  }
}

void PictureThread::Draw(const WantedPicture& wanted)
{
  {
    const std::lock_guard<std::mutex> lock(this->work->mutex);
    this->work->next.wanted = wanted;
  }
  this->work->changed.notify_one();
}

bool PictureThread::IsBusy() const
{
  const std::lock_guard<std::mutex> lock(this->work->mutex);
  return this->work->isDrawing || this->work->next.wanted || this->work->finished;
}

void PictureThread::TakePicture()
{
  std::optional<ThreadPicture> picture;
  bool hasFailed = false;
  {
    const std::lock_guard<std::mutex> lock(this->work->mutex);
    picture = std::exchange(this->work->finished, {});
    hasFailed = std::exchange(this->work->hasFailed, false); // to tell it once
  }
  if (hasFailed)
  {
    emit this->Failed();
  }
  else if (picture)
  {
    this->last = std::move(picture);
    emit this->Drawn();
  }
}

}
