#include "Viewer/Model/TimeSeries.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace varimarch
{

namespace
{

std::uint64_t BytesOf(vtkImageData* image)
{
  return std::uint64_t(image->GetNumberOfPoints()) *
    std::uint64_t(image->GetScalarSize() * image->GetNumberOfScalarComponents());
}

}

struct TimeSeries::Found
{
  LoadedVolume volume;
  std::optional<ImageStatistics> statistics; ///< if the time had not been counted
};

TimeSeries::TimeSeries(SceneModel* model, QObject* parent)
  : QObject(parent)
  , model(model)
  , overlays(model)
{
  connect(&this->overlays, &OverlayTimes::Failed, this, &TimeSeries::Failed);
  this->showing.setSingleShot(true);
  connect(&this->showing, &QTimer::timeout, this, &TimeSeries::ShowChosen);
  connect(&this->task, &BackgroundTask::Failed, this, &TimeSeries::Leave);
  connect(model, &SceneModel::Changed, this, &TimeSeries::Follow);
}

void TimeSeries::SetMostBytes(std::uint64_t bytes)
{
  this->mostBytes = bytes;
}

int TimeSeries::Count() const
{
  return int(this->model->CurrentStudy()->volume.times.values.size());
}

// Counts that came with a study are of all times.
bool TimeSeries::AreCounted() const
{
  return this->sum && (this->counted.empty() || int(this->counted.size()) == this->Count());
}

bool TimeSeries::IsScanShown() const
{
  return this->model->CurrentStudy()->volume.times.current == this->model->ChosenTime();
}

// A step back can bring a study with the voxels of another time.
void TimeSeries::Follow(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->Begin();
  }
  if (part == ScenePart::Time)
  {
    this->failed.erase(this->model->ChosenTime()); // it is tried again
  }
  const bool mayDiffer = part == ScenePart::Volume || part == ScenePart::Time ||
    part == ScenePart::Labels || part == ScenePart::Overlays;
  if (this->reader && mayDiffer)
  {
    this->showing.start(0);
  }
}

void TimeSeries::Begin()
{
  this->task.Cancel();
  this->reader.reset();
  this->kept.clear();
  this->counted.clear();
  this->failed.clear();
  this->sum.reset();
  const auto study = this->model->CurrentStudy();
  const LoadedTimes& times = study->volume.times;
  if (times.AreSeveral())
  {
    this->reader = std::make_shared<SizedTimes>(this->model->CurrentScene(), 0, study->volume);
    this->kept.emplace(times.current, study->volume);
    this->sum = study->allTimes;
  }
  emit this->KeptChanged();
}

void TimeSeries::ShowChosen()
{
  if (!this->reader)
  {
    return;
  }
  const auto chosen = this->kept.find(this->model->ChosenTime());
  if (chosen != this->kept.end() && !this->IsScanShown())
  {
    this->model->ShowTime(chosen->second);
  }
  this->DropOthers();
  if (this->AreCounted() && !this->model->CurrentStudy()->allTimes)
  {
    this->model->TakeCounts(this->sum);
  }
  this->ReadNext();
}

// The times in the order of playing, in which a packed file is unpacked once, and the time before
// the chosen one.
std::vector<int> TimeSeries::Needed() const
{
  const LoadedVolume& shown = this->model->CurrentStudy()->volume;
  const int count = this->Count();
  const std::uint64_t fitting = this->mostBytes / std::max<std::uint64_t>(BytesOf(shown.image), 1);
  const int most =
    shown.isOnDisk ? 1 : int(std::clamp<std::uint64_t>(fitting, 2, std::uint64_t(count)));
  const int chosen = this->model->ChosenTime();
  std::vector<int> needed;
  for (int ahead = 0; ahead < most; ++ahead)
  {
    needed.push_back((chosen + ahead) % count);
  }
  if (most > 2)
  {
    needed.back() = (chosen + count - 1) % count;
  }
  return needed;
}

std::optional<int> TimeSeries::NextToRead() const
{
  const auto hasFailed = [this](int time) { return this->failed.count(time) > 0; };
  for (const int time : this->Needed())
  {
    if (this->kept.count(time) == 0 && !hasFailed(time))
    {
      return time;
    }
  }
  const bool counts = !this->model->CurrentStudy()->volume.isOnDisk && !this->AreCounted();
  for (int time = 0; counts && time < this->Count(); ++time)
  {
    if (this->counted.count(time) == 0 && !hasFailed(time))
    {
      return time;
    }
  }
  return std::nullopt;
}

void TimeSeries::ReadNext()
{
  const std::optional<int> next = this->task.IsRunning() ? std::nullopt : this->NextToRead();
  if (!next)
  {
    return;
  }
  const int time = *next;
  const LoadedVolume& shown = this->model->CurrentStudy()->volume;
  const bool counts = this->counted.count(time) == 0 && !shown.isOnDisk && !this->AreCounted();
  this->reading = time;
  this->task.Start(
    [time, counts, source = this->reader](const TaskProgress& progress)
    {
      Found found = { source->Read(time, progress), {} };
      if (counts)
      {
        found.statistics.emplace(found.volume.image);
      }
      return found;
    },
    [this, time](Found found) { this->Take(time, std::move(found)); });
}

void TimeSeries::Take(int time, Found found)
{
  if (found.statistics)
  {
    if (this->sum)
    {
      found.statistics->Add(*this->sum);
    }
    this->sum = std::make_shared<const ImageStatistics>(*std::move(found.statistics));
    this->counted.insert(time);
  }
  this->kept.emplace(time, std::move(found.volume));
  this->ShowChosen();
}

void TimeSeries::DropOthers()
{
  const std::vector<int> needed = this->Needed();
  for (auto one = this->kept.begin(); one != this->kept.end();)
  {
    const bool isNeeded = std::find(needed.begin(), needed.end(), one->first) != needed.end();
    one = isNeeded ? std::next(one) : this->kept.erase(one);
  }
  emit this->KeptChanged();
}

void TimeSeries::Leave(const QString& reason)
{
  this->failed.insert(this->reading);
  if (this->reading == this->model->ChosenTime() && !this->IsScanShown())
  {
    this->model->ShowTime(this->model->CurrentStudy()->volume);
    emit this->Failed(reason);
  }
  this->showing.start(0);
}

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
