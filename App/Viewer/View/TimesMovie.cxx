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

bool WriteTimesMovie(
  const TimesMovie& movie, const QString& path, const std::function<bool(double)>& onProgress)
{
  const std::vector<int> times = TimesOfPictures(movie, path);
  StudyTimes reader(movie.scene, movie.study);
  PictureMaker maker(movie.scene, *movie.study, movie.options);
  int drawn = -1;
  QImage picture;
  const auto draw = [&](int number)
  {
    const int time = times[std::size_t(number)];
    if (time != drawn)
    {
      const double part = double(number) / double(times.size());
      maker.ShowTime(*reader.Read(time, [&](double) { return onProgress(part); }));
      picture = maker.Draw();
      drawn = time;
    }
    return picture;
  };
  return WritePictures(int(times.size()), draw, path, onProgress);
}

}
