#ifndef Varimarch_Viewer_Turntable_h
#define Varimarch_Viewer_Turntable_h

#include "Viewer/View/PictureExport.h"

#include <QStringList>

#include <functional>

namespace varimarch
{

/// The kinds of file that a turn can be written to here, for a file dialog, the best first:
/// "Movie, MP4 (*.mp4)" where there is ffmpeg to make it, "Movie, Ogg Theora (*.ogv)", "Pictures
/// (*.png)".
QStringList TurntableFilters();

/// Pictures of a whole turn about the picture's vertical: a movie where the path ends in ".mp4" or
/// ".ogv", else a series "NAME-000.png" and on. Nothing is left of it when it is stopped or fails.
/// @param onProgress  told the part that is done, [0, 1); says whether to go on
/// @return whether it is complete
/// @throws std::runtime_error one sentence
bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress);

}

#endif
