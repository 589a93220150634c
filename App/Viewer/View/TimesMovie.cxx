#include "Viewer/View/TimesMovie.h"

#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/Turntable.h"

#include <numeric>

namespace varimarch
{

namespace
{

// The time that each picture shows.
std::vector<int> TimesOfPictures(const TimesMovie& movie, const QString& path)
{
  const LoadedTimes& times = movie.study->volume.times;
  if (IsMovie(path))
  {
    return TimesOfMovie(times, movie.speed, MoviePicturesPerSecond);
  }
  std::vector<int> all(times.values.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}

WrittenTimes WriteTimesMovie(
  const TimesMovie& movie, const QString& path, const std::function<bool(double)>& onProgress)
{
  const std::vector<int> times = TimesOfPictures(movie, path);
  StudyTimes reader(movie.scene, movie.study);
  PictureMaker maker(movie.scene, *movie.study, movie.options);
  int drawn = -1;
  QImage picture;
  const auto draw = [&](int number, const std::function<bool(double)>& onPart)
  {
    const int time = times[std::size_t(number)];
    if (time != drawn)
    {
      maker.ShowTime(*reader.Read(time, [&](double) { return onPart(0.0); }));
      picture = maker.Draw(onPart);
      drawn = time;
    }
    return picture;
  };
  const bool isComplete = WritePictures(int(times.size()), draw, path, onProgress);
  return { isComplete, QString::fromStdString(reader.Problem()) };
}

}
