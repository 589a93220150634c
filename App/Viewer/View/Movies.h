#ifndef Varimarch_Viewer_Movies_h
#define Varimarch_Viewer_Movies_h

#include "Scene/Files/OutputFile.h"
#include "Viewer/Model/Study.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/PictureExport.h"

#include <QImage>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <string>

namespace varimarch
{

constexpr int MoviePicturesPerSecond = 24;

/// Writes the images of a turntable in order. The destructor deletes what was written unless
/// Complete was called. Every function throws std::runtime_error with one sentence.
class TurnWriter
{
public:
  virtual ~TurnWriter() = default;

  /// @param picture  of the same size as those before
  virtual void Add(const QImage& picture) = 0;

  /// Marks the end of the images.
  virtual void End() {}

  /// Waits a moment for pending work and returns true if some is left.
  virtual bool IsBusy() { return false; }

  /// Makes the file final. Call it after End, when IsBusy returns false.
  virtual void Complete() = 0;
};

/// Throws std::runtime_error with "Cannot write turn.mp4" and the reason, if known.
[[noreturn]] void FailToWrite(const QString& path, const QString& reason = {});

/// Path of the ffmpeg program on the PATH; empty if it is not installed.
QString FfmpegProgram();

/// An MP4 movie encoded by ffmpeg as H.264, or as MPEG-4 if ffmpeg lacks x264. Its comment is the
/// scene stored in the first image. H.264 subsamples colours by two, so an odd last row or column
/// is dropped.
class Mp4Movie : public TurnWriter
{
public:
  explicit Mp4Movie(const QString& path);
  ~Mp4Movie() override;

  void Add(const QImage& picture) override;
  void End() override;
  bool IsBusy() override;
  void Complete() override;

private:
  void Start(const QImage& first);
  [[noreturn]] void FailWithFfmpegError();

  QString path;
  UnfinishedFile file;
  UnfinishedFile metadata; ///< for ffmpeg to read; never completed
  QProcess ffmpeg;
  bool started = false;
  bool ended = false;
  bool refuses = false; ///< ffmpeg accepts no more input
};

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
