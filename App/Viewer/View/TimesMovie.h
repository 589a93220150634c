#ifndef Varimarch_Viewer_TimesMovie_h
#define Varimarch_Viewer_TimesMovie_h

#include "Viewer/Model/Study.h"
#include "Viewer/Model/TimeSpeed.h"
#include "Viewer/View/PictureExport.h"

#include <functional>

namespace varimarch
{

/// The times of a scan to be drawn one after the other.
struct TimesMovie
{
  Scene scene; ///< its volume is a file with several times
  std::shared_ptr<const Study> study;
  ExportOptions options;
  TimeSpeed speed;
};

/// The end of a movie of times.
struct WrittenTimes
{
  bool isComplete; ///< false if it was cancelled
  /// Why a volume over the scan stays at another time, as StudyTimes tells it; empty if none does.
  QString problem;
};

/// Reads and renders all times for the writer of a file name, see TurnWriterFor. A movie shows each
/// time for as long as the speed says, a series of images shows it once. What is cancelled or fails
/// leaves the files that were there before.
/// @param onProgress  receives the fraction done, [0, 1); returns false to cancel
/// @throws std::runtime_error with one sentence
WrittenTimes WriteTimesMovie(
  const TimesMovie& movie, const QString& path, const std::function<bool(double)>& onProgress);

}

#endif
