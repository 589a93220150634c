#include "Viewer/Model/StudyTimes.h"

#include "Scene/Model/Scene.h"
#include "Viewer/Model/SceneModel.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace varimarch
{

StudyTimes::StudyTimes(const Scene& scene, std::shared_ptr<const Study> study)
  : study(std::move(study))
{
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const Study& one = StudyOfVolume(*this->study, volume);
    this->readers.push_back(FollowsTimes(*this->study, one)
        ? std::make_unique<SizedTimes>(scene, volume, one.volume)
        : nullptr);
  }
}

std::shared_ptr<const Study> StudyTimes::Read(int time, const LoadObserver& observer)
{
  bool isCancelled = false;
  const LoadObserver asking = [&](double part)
  {
    isCancelled = isCancelled || (observer && !observer(part));
    return !isCancelled;
  };
  for (int volume = 0; volume < int(this->readers.size()); ++volume)
  {
    try
    {
      this->ReadVolume(volume, time, asking);
    }
    catch (const std::runtime_error& failure)
    {
      if (volume == 0 || isCancelled)
      {
        throw;
      }
      this->problem = this->problem.empty() ? failure.what() : this->problem;
    }
  }
  return this->study;
}

void StudyTimes::ReadVolume(int volume, int time, const LoadObserver& observer)
{
  const Study& one = StudyOfVolume(*this->study, volume);
  if (this->readers[volume] && one.volume.times.current != time)
  {
    const LoadedVolume ofTime = this->readers[volume]->Read(time, observer);
    this->study = WithVolume(*this->study, volume, AtTime(one, ofTime));
  }
}

std::shared_ptr<const Study> ShownStudy(const SceneModel& model)
{
  return StudyTimes(model.CurrentScene(), model.CurrentStudy()).Read(model.ChosenTime());
}

SizedTimes::SizedTimes(const Scene& scene, int volume, const LoadedVolume& shown)
  : reader(WithinMemory(std::get<FileSource>(VolumeSourceOf(scene, volume))))
  , size(SizeOf(shown))
{
}

SizedTimes::Size SizedTimes::SizeOf(const LoadedVolume& volume)
{
  const int* const sides = volume.image->GetDimensions();
  return { sides[0], sides[1], sides[2], volume.image->GetNumberOfScalarComponents() };
}

LoadedVolume SizedTimes::Read(int time, const LoadObserver& observer)
{
  LoadedVolume volume = this->reader.Read(time, observer);
  const auto textOf = [](const Size& size)
  {
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " voxels of " + std::to_string(size[3]) + " components";
  };
  if (const Size found = SizeOf(volume); found != this->size)
  {
    throw std::runtime_error("Cannot show the time of number " + std::to_string(time) +
      ", counted from 0: expected " + textOf(this->size) + " as at the other times, found " +
      textOf(found));
  }
  return volume;
}

namespace
{

constexpr double LongestMovieSeconds = 3600.0;

struct TimeTexts
{
  Q_DECLARE_TR_FUNCTIONS(TimeTexts)
};

}

double SecondsOfTime(const LoadedTimes& times, int time, TimeSpeed speed)
{
  if (!speed.IsAsAcquired())
  {
    return 1.0 / speed.timesPerSecond;
  }
  const std::size_t first = std::min(std::size_t(time), times.values.size() - 2);
  return times.values[first + 1] - times.values[first];
}

std::vector<int> TimesOfMovie(const LoadedTimes& times, TimeSpeed speed, double picturesPerSecond)
{
  std::vector<int> shown;
  double end = 0.0;
  for (int time = 0; time < int(times.values.size()); ++time)
  {
    end += SecondsOfTime(times, time, speed);
    if (!(end <= LongestMovieSeconds))
    {
      throw std::runtime_error(
        TimeTexts::tr("A movie lasts at most an hour, and this one would be longer. Choose a speed "
                      "beside the slider of the times.")
          .toStdString());
    }
    const auto count = std::size_t(std::llround(end * picturesPerSecond));
    shown.resize(std::max(count, shown.size() + 1), time);
  }
  return shown;
}

QString TimeText(const LoadedTimes& times, int time)
{
  const QLocale locale;
  const QString number = TimeTexts::tr("%1 of %2").arg(time + 1).arg(times.values.size());
  return times.areSeconds ? TimeTexts::tr("%1 s, %2")
                              .arg(locale.toString(times.values[std::size_t(time)], 'f', 2), number)
                          : number;
}

namespace
{

const QString MemoryKey = QStringLiteral("memory/gigabytes");

}

int ChosenMemoryGigabytes()
{
  return std::max(0, QSettings().value(MemoryKey).toInt());
}

void ChooseMemoryGigabytes(int gigabytes)
{
  QSettings().setValue(MemoryKey, gigabytes);
}

FileSource WithinMemory(FileSource file)
{
  if (file.memoryMegabytes <= 0.0)
  {
    file.memoryMegabytes = 1e3 * ChosenMemoryGigabytes();
  }
  return file;
}

}
