#include "Viewer/Model/OverlayTimes.h"

#include <iterator>

namespace varimarch
{

OverlayTimes::OverlayTimes(SceneModel* model, QObject* parent)
  : QObject(parent)
  , model(model)
{
  this->reading.setSingleShot(true);
  connect(&this->reading, &QTimer::timeout, this, &OverlayTimes::ReadNext);
  connect(&this->task, &BackgroundTask::Failed, this, &OverlayTimes::Leave);
  connect(model, &SceneModel::Changed, this, &OverlayTimes::Follow);
}

void OverlayTimes::Follow(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->task.Cancel(); // it reads for a scan that is closed, by a reader of its own
    this->readers.clear();
  }
  if (part == ScenePart::Volume || part == ScenePart::Time)
  {
    this->failed.clear(); // they are tried again
  }
  if (part == ScenePart::Volume || part == ScenePart::Overlays)
  {
    this->ForgetRemoved();
  }
  if (this->NextToRead())
  {
    this->reading.start(0);
  }
}

void OverlayTimes::ForgetRemoved()
{
  std::set<Volume> shown;
  for (const auto& overlay : this->model->CurrentStudy()->overlays)
  {
    shown.insert(overlay->labelGuard);
  }
  for (auto reader = this->readers.begin(); reader != this->readers.end();)
  {
    reader = shown.count(reader->first) > 0 ? std::next(reader) : this->readers.erase(reader);
  }
}

std::optional<int> OverlayTimes::NextToRead() const
{
  const auto study = this->model->CurrentStudy();
  const int time = this->model->ChosenTime();
  for (int volume = 1; study && volume <= int(study->overlays.size()); ++volume)
  {
    const Study& overlay = *study->overlays[volume - 1];
    if (FollowsTimes(*study, overlay) && overlay.volume.times.current != time &&
      this->failed.count({ overlay.labelGuard, time }) == 0)
    {
      return volume;
    }
  }
  return std::nullopt;
}

std::shared_ptr<SizedTimes> OverlayTimes::ReaderOf(int volume)
{
  const auto study = this->model->StudyOf(volume);
  std::shared_ptr<SizedTimes>& reader = this->readers[study->labelGuard];
  if (!reader)
  {
    reader = std::make_shared<SizedTimes>(this->model->CurrentScene(), volume, study->volume);
  }
  return reader;
}

void OverlayTimes::ReadNext()
{
  const std::optional<int> volume = this->task.IsRunning() ? std::nullopt : this->NextToRead();
  if (!volume)
  {
    return;
  }
  const int time = this->model->ChosenTime();
  const auto study = this->model->StudyOf(*volume);
  this->last = { study->labelGuard, time };
  this->task.Start([time, source = this->ReaderOf(*volume)](const TaskProgress& progress)
    { return source->Read(time, progress); },
    [this, study](const LoadedVolume& found)
    {
      const std::optional<int> now = this->model->VolumeOf(*study);
      if (now && found.times.current == this->model->ChosenTime())
      {
        this->model->ShowTime(found, *now);
      }
      this->reading.start(0);
    });
}

void OverlayTimes::Leave(const QString& reason)
{
  this->failed.insert(this->last);
  emit this->Failed(reason);
  this->reading.start(0);
}

}
