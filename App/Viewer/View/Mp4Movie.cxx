#include "Viewer/View/Mp4Movie.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QStandardPaths>

namespace varimarch
{

namespace
{

constexpr int MomentMs = 50;
constexpr int LongestAnswerMs = 10000;

QString StartFailureText(const QProcess& ffmpeg)
{
  return QCoreApplication::translate("Turntable", "ffmpeg could not be started: %1")
    .arg(ffmpeg.errorString());
}

// H.264 if available, because every player supports it.
QStringList EncoderOptions()
{
  QProcess ffmpeg;
  ffmpeg.start(FfmpegProgram(), { "-hide_banner", "-encoders" });
  ffmpeg.waitForFinished(LongestAnswerMs);
  return ffmpeg.readAllStandardOutput().contains(" libx264 ")
    ? QStringList{ "-c:v", "libx264", "-crf", "18" }
    : QStringList{ "-c:v", "mpeg4", "-q:v", "3" };
}

// Metadata in ffmpeg's file format; https://ffmpeg.org/ffmpeg-formats.html#Metadata
QByteArray MetadataOf(const QImage& picture)
{
  QString comment = picture.text("varimarch-scene");
  comment.replace(QRegularExpression("([=;#\\\\\n])"), "\\\\1");
  return ";FFMETADATA1\ncomment=" + comment.toUtf8() + "\n";
}

QByteArray PixelsOf(const QImage& picture)
{
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  const int rowBytes = 3 * (rgb.width() & ~1);
  QByteArray pixels;
  for (int row = 0; row < (rgb.height() & ~1); ++row)
  {
    pixels.append(reinterpret_cast<const char*>(rgb.constScanLine(row)), rowBytes);
  }
  return pixels;
}

}

QString FfmpegProgram()
{
  return QStandardPaths::findExecutable("ffmpeg");
}

Mp4Movie::Mp4Movie(const QString& path)
  : path(path)
  , file(path.toStdString())
  , metadata(path.toStdString() + ".txt")
{
  QObject::connect(&this->ffmpeg, &QProcess::errorOccurred,
    [this](QProcess::ProcessError error)
    { this->refuses = this->refuses || error == QProcess::WriteError; });
}

Mp4Movie::~Mp4Movie()
{
  if (this->ffmpeg.state() != QProcess::NotRunning)
  {
    this->ffmpeg.kill();
    this->ffmpeg.waitForFinished(LongestAnswerMs);
  }
}

void Mp4Movie::Start(const QImage& first)
{
  if (FfmpegProgram().isEmpty())
  {
    FailToWrite(this->path,
      QCoreApplication::translate(
        "Turntable", "MP4 needs the program ffmpeg, which is not installed"));
  }
  const QByteArray description = MetadataOf(first);
  QFile metadataFile(QString::fromStdString(this->metadata.Part()));
  if (!metadataFile.open(QIODevice::WriteOnly) ||
    metadataFile.write(description) != description.size() || !metadataFile.flush())
  {
    FailToWrite(this->path, metadataFile.errorString());
  }
  const QString size = QStringLiteral("%1x%2").arg(first.width() & ~1).arg(first.height() & ~1);
  const QString rate = QString::number(MoviePicturesPerSecond);
  QStringList options = { "-hide_banner", "-loglevel", "error", "-y" };
  options += { "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", size, "-r", rate, "-i", "pipe:0" };
  options += { "-f", "ffmetadata", "-i", "file:" + metadataFile.fileName(), "-map_metadata", "1" };
  options += EncoderOptions();
  options += { "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4" };
  this->ffmpeg.setStandardOutputFile(QProcess::nullDevice());
  this->ffmpeg.start(
    FfmpegProgram(), options << "file:" + QString::fromStdString(this->file.Part()));
  if (!this->ffmpeg.waitForStarted(LongestAnswerMs))
  {
    FailToWrite(this->path, StartFailureText(this->ffmpeg));
  }
}

void Mp4Movie::Add(const QImage& picture)
{
  if (!this->started)
  {
    this->Start(picture);
    this->started = true;
  }
  this->ffmpeg.write(PixelsOf(picture));
}

void Mp4Movie::End()
{
  this->ended = true;
  this->ffmpeg.closeWriteChannel();
}

bool Mp4Movie::IsBusy()
{
  if (this->ended)
  {
    this->ffmpeg.waitForFinished(MomentMs);
    return this->ffmpeg.state() != QProcess::NotRunning;
  }
  if (this->ffmpeg.bytesToWrite() > 0)
  {
    this->ffmpeg.waitForBytesWritten(MomentMs);
  }
  if (this->refuses || this->ffmpeg.state() == QProcess::NotRunning)
  {
    this->FailWithFfmpegError();
  }
  return this->ffmpeg.bytesToWrite() > 0;
}

void Mp4Movie::Complete()
{
  if (this->refuses || this->ffmpeg.exitStatus() != QProcess::NormalExit ||
    this->ffmpeg.exitCode() != 0)
  {
    this->FailWithFfmpegError();
  }
  this->file.Complete();
}

void Mp4Movie::FailWithFfmpegError()
{
  this->ffmpeg.waitForFinished(LongestAnswerMs);
  const QStringList lines =
    QString::fromLocal8Bit(this->ffmpeg.readAllStandardError()).split('\n', Qt::SkipEmptyParts);
  FailToWrite(this->path,
    lines.isEmpty()
      ? QCoreApplication::translate("Turntable", "ffmpeg exited with code %1")
          .arg(this->ffmpeg.exitCode())
      : QCoreApplication::translate("Turntable", "ffmpeg reports: %1").arg(lines.last().trimmed()));
}

}
