#ifndef Varimarch_Viewer_Turntable_h
#define Varimarch_Viewer_Turntable_h

#include "Viewer/View/PictureExport.h"

#include <QStringList>

#include <functional>

namespace varimarch
{

/// File filters of the available formats for a file dialog, the best first: "Movie, MP4 (*.mp4)" if
/// ffmpeg is installed, "Movie, Ogg Theora (*.ogv)", "Images (*.png)".
QStringList TurntableFilters();

/// Renders a full turn about the vertical of the image. Writes a movie if the path ends in ".mp4"
/// or ".ogv", and otherwise a series "NAME-000.png", "NAME-001.png" and so on. Deletes the files if
/// cancelled or on failure.
/// @param onProgress  receives the fraction done, [0, 1); returns false to cancel
/// @return true if complete
/// @throws std::runtime_error with one sentence
bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress);

}

#endif
