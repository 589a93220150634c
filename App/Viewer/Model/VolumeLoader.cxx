#include "Viewer/Model/VolumeLoader.h"

#include <QThread>
#include <QTimer>

#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Time that a thread has to stop; it has more when the program ends.
constexpr int StopMilliseconds = 2000;
constexpr int StopMillisecondsAtEnd = 10000;

}

// State shared by the thread and the loader. A thread that waits for a disk that is gone outlives
// the loader.
struct VolumeLoader::Task : public std::enable_shared_from_this<VolumeLoader::Task>
{
  /// Lets the loader emit Previewed, unless it has left the thread alone before it gets there.
  void Show(const VolumeSource& source, const std::shared_ptr<const Study>& study);

  std::function<Found(const LoadObserver&)> read;
  std::atomic<bool> stop{ false };
  Found found;
  QString failure; ///< set on failure

  std::mutex mutex;
  VolumeLoader* loader; ///< receives the progress; null if it has left the thread alone
};

void VolumeLoader::Task::Show(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  if (this->loader)
  {
    const auto show = [to = this->loader, task = this->shared_from_this(), source, study]
    {
      if (to->task == task && !task->stop)
      {
        emit to->Previewed(source, study);
      }
    };
    QMetaObject::invokeMethod(this->loader, show, Qt::QueuedConnection);
  }
}

VolumeLoader::VolumeLoader(QObject* parent)
  : QObject(parent)
{
}

VolumeLoader::~VolumeLoader()
{
  if (this->thread)
  {
    QThread* const last = this->thread;
    this->task->stop = true;
    const bool hasStopped = last->wait(StopMillisecondsAtEnd);
    this->LeaveThread();
    if (hasStopped)
    {
      delete last;
    }
  }
}

void VolumeLoader::Load(const VolumeSource& source, const QString& series,
  const std::optional<SceneLabels>& labels, const std::vector<OverlaidVolume>& overlays)
{
  this->Load({ source, series, labels, overlays });
}

void VolumeLoader::Load(const VolumeWish& wish)
{
  this->StartShowing([wish](const LoadObserver& observe, const ShowPreview& show)
    { return ReadVolume(wish, observe, show); });
}

void VolumeLoader::LoadTogether(const std::vector<std::string>& paths)
{
  this->StartShowing([paths](const LoadObserver& observe, const ShowPreview& show)
    { return ReadTogether(paths, observe, show); });
}

void VolumeLoader::StartShowing(const ReadAndShow& read)
{
  auto request = std::make_shared<Task>();
  request->read = [read, task = request.get()](const LoadObserver& observe)
  {
    return read(observe,
      [task](const VolumeSource& shown, const std::shared_ptr<const Study>& study)
      { task->Show(shown, study); });
  };
  this->Start(request);
}

void VolumeLoader::LoadLabels(const SceneLabels& labels, std::shared_ptr<const Study> scan)
{
  auto request = std::make_shared<Task>();
  request->read = [=](const LoadObserver& observe)
  {
    Found found;
    found.labels = labels;
    found.labelled = WithLabels(*scan, varimarch::LoadLabels(labels, scan->volume, observe));
    return found;
  };
  this->Start(request);
}

void VolumeLoader::LoadBeside(
  const std::string& path, const std::vector<std::shared_ptr<const Study>>& scans)
{
  auto request = std::make_shared<Task>();
  request->read = [=](const LoadObserver& observe) { return ReadBeside(path, scans, observe); };
  this->Start(request);
}

// Runs in the thread.
void VolumeLoader::Run(Task& task)
{
  const auto observe = [&](double part)
  {
    const std::lock_guard<std::mutex> lock(task.mutex);
    if (task.loader)
    {
      emit task.loader->Progress(part);
    }
    return !task.stop;
  };
  try
  {
    task.found = task.read(observe);
  }
  catch (const std::bad_alloc&)
  {
    task.failure = tr("There is not enough memory for this volume.");
  }
  catch (const std::exception& problem)
  {
    task.failure = QString::fromStdString(problem.what());
  }
}

void VolumeLoader::Start(std::shared_ptr<Task> request)
{
  if (this->thread)
  {
    this->task->stop = true;
    this->thread->wait(StopMilliseconds);
    this->EndCancelled();
  }
  this->task = std::move(request);
  this->task->loader = this;
  this->thread = QThread::create([task = this->task] { Run(*task); });
  // A signal of the previous thread may still be queued.
  connect(this->thread, &QThread::finished, this,
    [this, ended = this->thread]
    {
      if (ended == this->thread)
      {
        this->Finish();
      }
    });
  this->thread->start();
}

void VolumeLoader::Cancel()
{
  if (this->task)
  {
    this->task->stop = true;
    QTimer::singleShot(StopMilliseconds, this,
      [this, cancelled = this->task]
      {
        if (cancelled == this->task)
        {
          this->EndCancelled();
        }
      });
  }
}

// The thread may still wait for its file. It then ends some day, or with the program.
std::shared_ptr<VolumeLoader::Task> VolumeLoader::LeaveThread()
{
  this->thread->disconnect(this);
  connect(this->thread, &QThread::finished, this->thread, &QObject::deleteLater);
  if (this->thread->isFinished())
  {
    this->thread->deleteLater();
  }
  this->thread = nullptr;
  const std::lock_guard<std::mutex> lock(this->task->mutex);
  this->task->loader = nullptr;
  return std::move(this->task);
}

void VolumeLoader::EndCancelled()
{
  this->LeaveThread();
  emit this->Cancelled();
}

void VolumeLoader::Finish()
{
  const std::shared_ptr<Task> ended = this->LeaveThread();
  if (ended->stop)
  {
    emit this->Cancelled();
  }
  else if (!ended->failure.isEmpty())
  {
    emit this->Failed(ended->failure);
  }
  else
  {
    this->Report(*ended);
  }
}

void VolumeLoader::Report(const Task& ended)
{
  const Found& found = ended.found;
  if (!found.segmentations.empty())
  {
    emit this->SegmentationsFound(found.segmentations);
  }
  if (found.study && found.labelled)
  {
    emit this->PossibleLabelsLoaded(found.labels, found.labelled, found.study);
  }
  else if (found.labelled)
  {
    emit this->LabelsLoaded(found.labels, found.labelled);
  }
  else if (found.study)
  {
    emit this->Loaded(found.source, found.study);
  }
  else
  {
    emit this->SeriesFound(std::get<FileSource>(found.source), found.series);
  }
}

}
