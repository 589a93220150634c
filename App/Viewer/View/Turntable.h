#ifndef Varimarch_Viewer_Turntable_h
#define Varimarch_Viewer_Turntable_h

#include "Viewer/View/PictureExport.h"
#include "Viewer/View/TurnWriter.h"

#include <QStringList>

#include <functional>
#include <memory>

namespace varimarch
{

/// File filters of the available formats for a file dialog, the best first: "Movie, MP4 (*.mp4)" if
/// ffmpeg is installed, "Movie, Ogg Theora (*.ogv)", "Images (*.png)".
QStringList TurntableFilters();

/// The writer that a file name chooses: a movie if it ends in ".mp4" or ".ogv", and otherwise a
/// series "NAME-000.png", "NAME-001.png" and so on.
std::unique_ptr<TurnWriter> TurnWriterFor(const QString& path);

/// True if a file name chooses a movie.
bool IsMovie(const QString& path);

/// Draws the picture of a number, counted from 0, and tells the fraction of it that is done; null
/// if the receiver cancels.
using PictureDrawing = std::function<QImage(int, const std::function<bool(double)>&)>;

/// Writes pictures for the writer of a file name. What is cancelled or fails leaves the files that
/// were there before.
/// @param onProgress  receives the fraction done, [0, 1); returns false to cancel
/// @return true if complete
/// @throws std::runtime_error with one sentence
bool WritePictures(int count, const PictureDrawing& draw, const QString& path,
  const std::function<bool(double)>& onProgress);

/// Renders a change of the scene from its beginning to its end as WritePictures does.
/// @param count  > 1
/// @param show  called before each picture with the part that is done, [0, 1]
bool WriteChange(PictureMaker& maker, int count, const std::function<void(double)>& show,
  const QString& path, const std::function<bool(double)>& onProgress);

/// Renders a full turn about the vertical of the image as WritePictures does.
bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress);

}

#endif
