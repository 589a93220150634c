#ifndef Varimarch_Viewer_Mp4Movie_h
#define Varimarch_Viewer_Mp4Movie_h

#include "Scene/OutputFile.h"
#include "Viewer/View/TurnWriter.h"

#include <QProcess>
#include <QTemporaryFile>

namespace varimarch
{

/// The place of the program ffmpeg on the PATH; empty where there is none.
QString FfmpegProgram();

/// A movie of H.264, or of MPEG-4 where ffmpeg lacks x264, that ffmpeg makes of what it is sent.
/// Its comment is the scene that the first picture tells. H.264 stores colours for two by two
/// pixels: an odd last row or column is left out.
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
  [[noreturn]] void FailAsFfmpegSays();

  QString path;
  UnfinishedFile file;
  QTemporaryFile metadata;
  QProcess ffmpeg;
  bool started = false;
  bool ended = false;
  bool refuses = false; ///< ffmpeg takes no more
};

}

#endif
