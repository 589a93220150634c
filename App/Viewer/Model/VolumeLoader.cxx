#include "Viewer/Model/VolumeLoader.h"

#include "Viewer/Model/RecentScans.h"

#include <QThread>

#include <algorithm>
#include <exception>
#include <new>

namespace varimarch
{

// State shared by the thread and the loader.
struct VolumeLoader::Task
{
  VolumeSource source;
  QString digest; ///< identifies the requested series; may be empty
  std::atomic<bool> stop{ false };
  std::shared_ptr<const Study> study; ///< set on success
  std::vector<SeriesSummary> series;  ///< the series to choose from, if there are several
  QString failure;                    ///< set on failure
};

VolumeLoader::VolumeLoader(QObject* parent)
  : QObject(parent)
{
}

VolumeLoader::~VolumeLoader()
{
  if (this->thread)
  {
    this->thread->disconnect(this);
    this->task->stop = true;
    this->thread->wait();
    delete this->thread;
  }
}

// Runs in the thread.
void VolumeLoader::Read(Task& task)
{
  const auto observe = [&](double part)
  {
    emit this->Progress(part);
    return !task.stop;
  };
  auto* const file = std::get_if<FileSource>(&task.source);
  if (file && MayHoldSeveralSeries(*file))
  {
    task.series = ListSeries(file->path, observe);
    const bool isKnown = !task.digest.isEmpty();
    const auto known = std::find_if(task.series.begin(), task.series.end(),
      [&](const SeriesSummary& series)
      { return isKnown && DigestOfSeries(series.uid) == task.digest; });
    if (known != task.series.end())
    {
      file->series = known->uid;
    }
    else if (isKnown || task.series.size() > 1)
    {
      return;
    }
  }
  LoadedVolume volume = LoadVolume(task.source, observe);
  ImageStatistics statistics(volume.image);
  task.study = std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

void VolumeLoader::Run(Task& task)
{
  try
  {
    this->Read(task);
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

void VolumeLoader::Load(const VolumeSource& source, const QString& series)
{
  if (this->thread)
  {
    this->Cancel();
    this->thread->wait();
    this->Finish();
  }
  this->task = std::make_shared<Task>();
  this->task->source = source;
  this->task->digest = series;
  this->thread = QThread::create([this, task = this->task] { this->Run(*task); });
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
  }
}

void VolumeLoader::Finish()
{
  this->thread->deleteLater();
  this->thread = nullptr;
  const std::shared_ptr<Task> ended = std::move(this->task);
  if (ended->stop)
  {
    emit this->Cancelled();
  }
  else if (ended->study)
  {
    emit this->Loaded(ended->source, ended->study);
  }
  else if (ended->failure.isEmpty())
  {
    emit this->SeriesFound(std::get<FileSource>(ended->source), ended->series);
  }
  else
  {
    emit this->Failed(ended->failure);
  }
}

}
