#ifndef Varimarch_Viewer_Mp4Movie_h
#define Varimarch_Viewer_Mp4Movie_h

#include "Scene/OutputFile.h"
#include "Viewer/View/TurnWriter.h"

#include <QProcess>

namespace varimarch
{

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

}

#endif
