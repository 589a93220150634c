#include "Viewer/Model/VolumeLoader.h"

#include "Viewer/Model/MemoryLimit.h"
#include "Viewer/Model/RecentScans.h"

#include <QThread>
#include <QTimer>

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
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

// The result of a request. A folder with several series has neither study.
struct Found
{
  VolumeSource source;
  std::shared_ptr<const Study> study; ///< the volume, if one was read
  SceneLabels labels;
  std::shared_ptr<const Study> labelled;    ///< a scan with labels over it, if they were read
  std::vector<SeriesSummary> series;        ///< all series of a folder
  std::vector<SeriesSummary> segmentations; ///< the segmentations among them
};

bool IsSegmentation(const SeriesSummary& series)
{
  return series.modality == "SEG";
}

LoadedVolume LoadWithinMemory(const VolumeSource& source, const LoadObserver& observe)
{
  const auto* const file = std::get_if<FileSource>(&source);
  return LoadVolume(file ? WithinMemory(*file) : source, observe);
}

Study StudyWithoutLabels(LoadedVolume volume)
{
  ImageStatistics statistics(volume.image);
  return { std::move(volume), std::move(statistics) };
}

// The volume as a study, with labels over it. Labels that cannot be read do not lose the volume.
std::shared_ptr<const Study> StudyOf(LoadedVolume volume, const std::string& path,
  const std::optional<SceneLabels>& labels, const LoadObserver& observe)
{
  Study study = StudyWithoutLabels(std::move(volume));
  try
  {
    if (labels)
    {
      return WithLabels(study, LoadLabels(*labels, study.volume, observe));
    }
    if (!study.volume.segments.empty())
    {
      LabelMap own = LabelMapOf(study.volume, path, study.volume);
      own.warnings.clear(); // they are those of the volume
      return WithLabels(study, std::move(own));
    }
  }
  catch (const std::runtime_error& reason)
  {
    study.volume.warnings.push_back(reason.what());
  }
  return std::make_shared<const Study>(std::move(study));
}

// The volume over another one. It is drawn by its look even if its values are labels.
std::shared_ptr<const Study> OverlayStudy(
  const OverlaidVolume& overlay, const LoadObserver& observe)
{
  LoadedVolume volume = LoadWithinMemory(overlay.source, observe);
  return overlay.labels ? StudyOf(std::move(volume), {}, overlay.labels, observe)
                        : std::make_shared<const Study>(StudyWithoutLabels(std::move(volume)));
}

// The volume with others over it. One that cannot be read is null.
std::shared_ptr<const Study> WithOverlays(const std::shared_ptr<const Study>& first,
  const std::vector<OverlaidVolume>& overlays, const LoadObserver& observe)
{
  Study study = *first;
  for (const OverlaidVolume& overlay : overlays)
  {
    study.overlays.emplace_back();
    try
    {
      study.overlays.back() = OverlayStudy(overlay, observe);
    }
    catch (const std::runtime_error& reason)
    {
      study.volume.warnings.push_back(reason.what());
    }
  }
  return std::make_shared<const Study>(std::move(study));
}

// The only series that fulfils a condition.
template <class Condition>
const SeriesSummary* OnlySeries(const std::vector<SeriesSummary>& series, const Condition& isWanted)
{
  const auto first = std::find_if(series.begin(), series.end(), isWanted);
  return std::count_if(series.begin(), series.end(), isWanted) == 1 ? &*first : nullptr;
}

// The series to open without a question; null if the user has to choose.
const SeriesSummary* SeriesToOpen(const std::vector<SeriesSummary>& series, const QString& digest)
{
  if (!digest.isEmpty())
  {
    return OnlySeries(
      series, [&](const SeriesSummary& one) { return DigestOfSeries(one.uid) == digest; });
  }
  return series.size() == 1 ? &series.front() : OnlySeries(series, std::not_fn(IsSegmentation));
}

Found ReadVolume(const VolumeSource& source, const QString& digest,
  const std::optional<SceneLabels>& labels, const LoadObserver& observe)
{
  Found found;
  found.source = source;
  auto* const file = std::get_if<FileSource>(&found.source);
  if (file && MayHoldSeveralSeries(*file))
  {
    found.series = ListSeries(file->path, observe);
    std::copy_if(found.series.begin(), found.series.end(), std::back_inserter(found.segmentations),
      IsSegmentation);
    const SeriesSummary* const chosen = SeriesToOpen(found.series, digest);
    if (!chosen && (!found.series.empty() || !digest.isEmpty()))
    {
      return found;
    }
    // The only series of a folder needs no name.
    if (chosen && (found.series.size() > 1 || !digest.isEmpty()))
    {
      file->series = chosen->uid;
    }
  }
  found.study = StudyOf(
    LoadWithinMemory(found.source, observe), file ? file->path : std::string(), labels, observe);
  return found;
}

Found ReadBeside(const std::string& path, const Study& scan, const LoadObserver& observe)
{
  Found found;
  found.source = FileSource{ path, std::nullopt };
  found.labels.path = path;
  LoadedVolume volume = LoadWithinMemory(found.source, observe);
  const bool areLabels = !volume.segments.empty();
  try
  {
    found.labelled = WithLabels(scan, LabelMapOf(volume, path, scan.volume));
  }
  catch (const std::runtime_error&)
  {
    // They belong to no scan, or to another one.
    if (areLabels)
    {
      throw;
    }
  }
  if (!areLabels)
  {
    found.study = StudyOf(std::move(volume), path, std::nullopt, observe);
  }
  return found;
}

}

// State shared by the thread and the loader. A thread that waits for a disk that is gone outlives
// the loader.
struct VolumeLoader::Task
{
  std::function<Found(const LoadObserver&)> read;
  std::atomic<bool> stop{ false };
  Found found;
  QString failure; ///< set on failure

  std::mutex mutex;
  VolumeLoader* loader; ///< receives the progress; null if it has left the thread alone
};

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
  auto request = std::make_shared<Task>();
  request->read = [=](const LoadObserver& observe)
  {
    Found found = ReadVolume(source, series, labels, observe);
    if (found.study && !overlays.empty())
    {
      found.study = WithOverlays(found.study, overlays, observe);
    }
    return found;
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

void VolumeLoader::LoadBeside(const std::string& path, std::shared_ptr<const Study> scan)
{
  auto request = std::make_shared<Task>();
  request->read = [=](const LoadObserver& observe) { return ReadBeside(path, *scan, observe); };
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
