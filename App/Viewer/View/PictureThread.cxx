#include "Viewer/View/PictureThread.h"

#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/SceneLights.h"
#include "Viewer/Model/Study.h"
#include "Viewer/View/VtkPictures.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

/// Copies of images for another thread, each made once for each version and kept as long as it is
/// asked for: whoever draws a copy knows by its address that nothing has changed.
class ImageCopies
{
public:
  using Make = std::function<vtkSmartPointer<vtkImageData>()>;

  /// From Begin() to End(), copies are asked for. Those that are not are forgotten then.
  void Begin();
  void End();

  /// @param make  makes a copy if there is none of this version
  vtkSmartPointer<vtkImageData> Of(vtkImageData* source, int version, const Make& make);

private:
  struct Copy
  {
    vtkSmartPointer<vtkImageData> source; ///< kept, so that no other image has its address
    int version;
    vtkSmartPointer<vtkImageData> copy;
  };

  std::vector<Copy> before;
  std::vector<Copy> used;
};

void ImageCopies::Begin()
{
  this->before = std::exchange(this->used, {});
}

// A copy that is no longer needed keeps the voxels of its volume.
void ImageCopies::End()
{
  this->before.clear();
}

vtkSmartPointer<vtkImageData> ImageCopies::Of(vtkImageData* source, int version, const Make& make)
{
  const auto known = std::find_if(this->before.begin(), this->before.end(),
    [&](const Copy& one) { return one.source == source && one.version == version; });
  this->used.push_back({ source, version, known == this->before.end() ? make() : known->copy });
  return this->used.back().copy;
}

// A picture that is no longer wanted takes at most this long; a search for steps is stopped.
constexpr double LongestPartOfThreadSeconds = 0.1;

// A picture that is wanted, with what the thread needs to draw it.
struct Order
{
  Scene scene;
  std::shared_ptr<const Study> study;
  ShownVoxels voxels;          // labels are still the window's
  std::set<ScenePart> changed; // since the last order that was drawn
  int volume = 0;              // a number for the volume
  int changes = 0;             // number of changes that were taken
  std::optional<WantedPicture> wanted;
};

// The view of the thread, which lives and dies there.
class ThreadView
{
public:
  /// @param isWanted  false stops the search for the steps of a fine picture
  /// @return empty if it was stopped
  std::optional<ThreadPicture> Draw(Order order, const std::function<bool()>& isWanted);

private:
  void CopyLabels(Order& order);
  void Show(const Order& order, const QSize& size);
  void ChooseFrames(const WantedPicture& wanted);
  vtkSmartPointer<vtkImageData> SharedMask();

  std::unique_ptr<OffscreenView> view;
  ImageCopies labels;
  QSize pixels;
  MovingImageSize moving;
};

// Labels are large, so they are copied here. They may be newer than the order, so its version does
// not name the copy; another order follows then.
void ThreadView::CopyLabels(Order& order)
{
  if (order.changed.empty())
  {
    return; // the view has what it draws
  }
  this->labels.Begin();
  const auto copyFor = [this](const Study& study, std::shared_ptr<const LabelMap>& shown)
  {
    if (shown)
    {
      auto copy = std::make_shared<LabelMap>(*shown);
      copy->image =
        this->labels.Of(shown->image, WritesOfLabels(study), [&] { return CopyOfLabels(study); });
      shown = copy;
    }
  };
  copyFor(*order.study, order.voxels.labels);
  for (std::size_t i = 0; i < order.voxels.overlays.size(); ++i)
  {
    copyFor(*order.study->overlays[i], order.voxels.overlays[i].labels);
  }
  this->labels.End();
}

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
    // The corner of the view says whether the error tolerance is kept; the mapper need not warn.
    MapperOf(*this->view)->AddObserver(vtkCommand::WarningEvent, vtkNew<vtkCallbackCommand>());
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

void ThreadView::ChooseFrames(const WantedPicture& wanted)
{
  vtkVariationFieldVolumeMapper* const mapper = MapperOf(*this->view);
  mapper->SetMaximumAccumulatedPictures(wanted.isSingle ? 1 : RefiningPictures);
  mapper->SetLongestPartSeconds(wanted.isSingle ? 0.0 : LongestPartOfThreadSeconds);
}

// The mask for the window, which looks up what is removed.
vtkSmartPointer<vtkImageData> ThreadView::SharedMask()
{
  vtkImageData* const mask = this->view->Pipeline().Mask();
  return mask ? SharedCopy({ mask, {}, {} }) : nullptr;
}

std::optional<ThreadPicture> ThreadView::Draw(Order order, const std::function<bool()>& isWanted)
{
  this->CopyLabels(order);
  const WantedPicture& wanted = *order.wanted;
  const double allocatedSeconds = 1.0 / wanted.picturesPerSecond;
  const bool isMoving = wanted.picturesPerSecond > 1.0;
  const QSize size = isMoving ? this->moving.Of(wanted.pixels) : wanted.pixels;
  const bool isFamiliar = size == this->pixels; // without the time for a new framebuffer
  QElapsedTimer timer;
  timer.start();
  this->Show(order, size);
  this->ChooseFrames(wanted);
  this->view->SetPicturesPerSecond(
    isMoving ? 1.0 / this->moving.SecondsForRays(allocatedSeconds) : wanted.picturesPerSecond);
  ThreadPicture picture;
  const std::optional<double> seconds =
    isMoving ? this->view->Render() : this->view->RenderWhile(isWanted);
  if (!seconds)
  {
    return std::nullopt;
  }
  picture.seconds = *seconds;
  picture.image = ImageOfBytes(this->view->Bytes()).convertToFormat(QImage::Format_RGB32);
  picture.numbers = NumbersOf(MapperOf(*this->view));
  picture.numbers.isFine &= !isMoving;
  picture.numbers.reasonForNothing = isMoving ? "" : this->view->ReasonForNothing(order.scene);
  picture.mask = this->SharedMask();
  picture.wanted = wanted;
  picture.changes = order.changes;
  if (wanted.isSingle && !isMoving)
  {
    picture.floats = this->view->FloatImage([&](double) { return isWanted(); });
  }
  if (isMoving && isFamiliar)
  {
    const double secondsOfAll = 1e-9 * double(timer.nsecsElapsed());
    vtkVariationFieldVolumeMapper* const mapper = MapperOf(*this->view);
    this->moving.Took(wanted.pixels, secondsOfAll - mapper->GetTimeToDraw(),
      mapper->GetUsedImageSampleDistance(), allocatedSeconds);
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

  /// False once another picture is wanted instead of the one that is drawn, or none.
  bool IsWanted()
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    return !this->stops && !this->next.wanted;
  }

  /// Keeps a picture, unless it was stopped or its volume was replaced meanwhile. From now on the
  /// thread is idle: whoever is told of the picture may ask for the next part of it at once.
  void Finish(std::optional<ThreadPicture> picture, int volume)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->isDrawing = false;
    if (picture && volume == this->next.volume)
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
        this->Finish(view.Draw(*order, [this] { return this->IsWanted(); }), order->volume);
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

void PictureThread::Take(
  ScenePart part, const Scene& scene, const std::shared_ptr<const Study>& study)
{
  if (part == ScenePart::Voxels && study->volume.image == this->copied)
  {
    return; // only the counts of the values are others
  }
  this->copied = study->volume.image;
  if (part == ScenePart::Volume)
  {
    this->shared = {};
  }
  ShownVoxels voxels = this->SharedVoxels(*study);
  const std::lock_guard<std::mutex> lock(this->work->mutex);
  Order& next = this->work->next;
  next.scene = scene;
  next.study = study;
  next.changed.insert(part);
  next.changes = ++this->changes;
  next.voxels = std::move(voxels);
  if (part == ScenePart::Volume)
  {
    ++next.volume;
    this->work->finished.reset();
    this->last.reset();
  }
}

ShownVoxels PictureThread::SharedVoxels(const Study& study)
{
  ShownVoxels voxels = VoxelsOf(study);
  voxels.volume = this->shared.Of(study.volume);
  for (std::size_t i = 0; i < voxels.overlays.size(); ++i)
  {
    voxels.overlays[i].image = this->shared.Of(study.overlays[i]->volume);
  }
  return voxels;
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

ShownVoxels VoxelsOf(const Study& study)
{
  return { study.volume.image, study.labels, VoxelsOfOverlays(study) };
}

bool ShowPart(
  ScenePart part, const Scene& scene, const ShownVoxels& voxels, ScenePipeline& pipeline)
{
  switch (part)
  {
    case ScenePart::Volume:
      return ShowPart(ScenePart::Labels, scene, voxels, pipeline);
    case ScenePart::Voxels:
      pipeline.SetImage(voxels.volume);
      return true;
    case ScenePart::Look:
      pipeline.SetLook(scene.look);
      [[fallthrough]];
    case ScenePart::Overlays:
      pipeline.SetOverlays(scene.overlays, voxels.overlays);
      return true;
    case ScenePart::Lights:
      pipeline.SetLighting(LightingOf(scene));
      return true;
    case ScenePart::Cuts:
      pipeline.SetCuts(scene.cuts);
      return true;
    case ScenePart::Labels:
      pipeline.SetLabels(voxels.labels);
      [[fallthrough]];
    case ScenePart::Segments:
      if (scene.labels)
      {
        pipeline.SetSegments(scene.labels->segments);
      }
      pipeline.SetOverlays(scene.overlays, voxels.overlays);
      return true;
    case ScenePart::Render:
      pipeline.SetRenderOptions(scene.render);
      return true;
    case ScenePart::Background:
      pipeline.SetBackground(scene.background);
      return true;
    default:
      return false;
  }
}

vtkSmartPointer<vtkImageData> VolumeCopies::Of(const LoadedVolume& volume)
{
  this->ForgetReleased();
  const auto known = std::find_if(this->copies.begin(), this->copies.end(),
    [&](const Copy& one) { return one.source == volume.image; });
  if (known != this->copies.end())
  {
    return known->copy;
  }
  this->copies.push_back({ volume.image, SharedCopy(volume) });
  return this->copies.back().copy;
}

// Nobody else holds a source with one reference, so that its voxels are not needed any more.
void VolumeCopies::ForgetReleased()
{
  this->copies.erase(std::remove_if(this->copies.begin(), this->copies.end(),
                       [](const Copy& one) { return one.source->GetReferenceCount() == 1; }),
    this->copies.end());
}

namespace
{

constexpr int CoarsestDivisor = 4;
constexpr double FewestPixels = 1 << 18; // fewer would be seen
constexpr double MostPixels = 1 << 21;   // before times are known

// Fractions of the allocated time: an image is to leave the rest to its rays, and the limit for a
// finer one.
constexpr double Most = 0.4;
constexpr double Spare = 0.2;
constexpr double Smallest = 0.5;

// Distances between rays [pixels of the image]: the most that an image is to have, and the limit
// for a finer one, whose rays are at most twice as far apart.
constexpr double MostRayDistance = 2.05;
constexpr double SpareRayDistance = 1.0;

double PixelsOf(const QSize& size, int divisor)
{
  return double(size.width()) * size.height() / (divisor * divisor);
}

}

int MovingImageSize::DivisorFor(const QSize& wanted) const
{
  int used = this->divisor;
  while (used < CoarsestDivisor && PixelsOf(wanted, used) > MostPixels)
  {
    ++used;
  }
  while (used > 1 && PixelsOf(wanted, used) < FewestPixels)
  {
    --used;
  }
  return used;
}

QSize MovingImageSize::Of(const QSize& wanted) const
{
  const int used = this->DivisorFor(wanted);
  return { std::max(wanted.width() / used, 1), std::max(wanted.height() / used, 1) };
}

void MovingImageSize::Took(
  const QSize& wanted, double seconds, double rayDistance, double allocatedSeconds)
{
  const int used = this->DivisorFor(wanted);
  this->otherSeconds = seconds;
  const double finer = used > 1 ? double(used * used) / ((used - 1) * (used - 1)) : 1.0;
  if (seconds > Most * allocatedSeconds || rayDistance > MostRayDistance)
  {
    this->divisor = std::min(used + 1, CoarsestDivisor);
  }
  else if (seconds * finer < Spare * allocatedSeconds && rayDistance <= SpareRayDistance)
  {
    this->divisor = std::max(used - 1, 1);
  }
}

double MovingImageSize::SecondsForRays(double allocatedSeconds) const
{
  return std::max(allocatedSeconds - this->otherSeconds, Smallest * allocatedSeconds);
}

}
