#include "Viewer/View/Movies.h"

#include "Viewer/Model/StudyTimes.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace varimarch
{

void FailToWrite(const QString& path, const QString& reason)
{
  const QString sentence = reason.isEmpty()
    ? QCoreApplication::translate("Turntable", "Cannot write %1").arg(path)
    : QCoreApplication::translate("Turntable", "Cannot write %1: %2").arg(path, reason);
  throw std::runtime_error(sentence.toStdString());
}

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

namespace
{

// The part of the time of a picture that drawing takes; the rest is for its writer.
constexpr double DrawingPart = 0.9;

class PictureSeries : public TurnWriter
{
public:
  explicit PictureSeries(const QString& path)
    : path(path)
  {
  }

  void Add(const QImage& picture) override
  {
    const QFileInfo name(this->path);
    const QString file = QStringLiteral("%1/%2-%3.png")
                           .arg(name.path(), name.completeBaseName())
                           .arg(int(this->files.size()), 3, 10, QChar('0'));
    this->files.push_back(std::make_unique<UnfinishedFile>(file.toStdString()));
    if (!SaveAsPng(picture, this->files.back()->Part()))
    {
      FailToWrite(file, qt_error_string());
    }
  }

  void Complete() override
  {
    for (const auto& file : this->files)
    {
      file->Complete();
    }
  }

private:
  QString path;
  std::vector<std::unique_ptr<UnfinishedFile>> files;
};

// True if the last page of an Ogg file is marked as the last, and ends with the file; RFC 3533. The
// writer does not look whether the system took its bytes.
bool EndsAsOgg(const std::string& path)
{
  constexpr qint64 LongestPage = 65307;
  QFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::ReadOnly) || !file.seek(std::max<qint64>(0, file.size() - LongestPage)))
  {
    return false;
  }
  const QByteArray end = file.readAll();
  const int page = end.lastIndexOf("OggS");
  const int table = page + 27;
  if (page < 0 || end.size() < table)
  {
    return false;
  }
  const int segmentCount = uchar(end[table - 1]);
  const QByteArray segments = end.mid(table, segmentCount);
  const int contentBytes = std::accumulate(
    segments.begin(), segments.end(), 0, [](int sum, char bytes) { return sum + uchar(bytes); });
  constexpr int LastPage = 4;
  return (end[page + 5] & LastPage) != 0 && table + segmentCount + contentBytes == end.size();
}

class OggMovie : public TurnWriter
{
public:
  explicit OggMovie(const QString& path)
    : path(path)
    , file(path.toStdString())
  {
    this->writer->SetFileName(this->file.Part().c_str());
    this->writer->SetRate(MoviePicturesPerSecond);
    this->writer->SetQuality(2);
    this->writer->SetInputData(this->frame);
  }

  ~OggMovie() override
  {
    if (this->started)
    {
      this->writer->End();
    }
  }

  void Add(const QImage& picture) override
  {
    this->TakeFrame(picture);
    if (!this->started)
    {
      this->writer->Start();
      this->started = true;
    }
    this->writer->Write();
    if (this->writer->GetError())
    {
      FailToWrite(this->path);
    }
  }

  void Complete() override
  {
    this->writer->End();
    this->started = false;
    if (!EndsAsOgg(this->file.Part()))
    {
      FailToWrite(this->path,
        QCoreApplication::translate("Turntable", "the disk is full, or its end was not written"));
    }
    this->file.Complete();
  }

private:
  void TakeFrame(const QImage& picture)
  {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888).mirrored();
    this->frame->SetDimensions(rgb.width(), rgb.height(), 1);
    this->frame->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* const pixels = static_cast<unsigned char*>(this->frame->GetScalarPointer());
    for (int row = 0; row < rgb.height(); ++row)
    {
      std::copy_n(rgb.constScanLine(row), 3 * rgb.width(), pixels + 3 * row * rgb.width());
    }
    this->frame->Modified();
  }

  QString path;
  UnfinishedFile file;
  vtkNew<vtkImageData> frame;
  vtkNew<vtkOggTheoraWriter> writer;
  bool started = false;
};

}

std::unique_ptr<TurnWriter> TurnWriterFor(const QString& path)
{
  if (path.endsWith(".mp4", Qt::CaseInsensitive))
  {
    return std::make_unique<Mp4Movie>(path);
  }
  if (path.endsWith(".ogv", Qt::CaseInsensitive))
  {
    return std::make_unique<OggMovie>(path);
  }
  return std::make_unique<PictureSeries>(path);
}

QStringList TurntableFilters()
{
  QStringList filters;
  if (!FfmpegProgram().isEmpty())
  {
    filters << QCoreApplication::translate("Turntable", "Movie, MP4 (*.mp4)");
  }
  return filters << QCoreApplication::translate("Turntable", "Movie, Ogg Theora (*.ogv)")
                 << QCoreApplication::translate("Turntable", "Images (*.png)");
}

bool IsMovie(const QString& path)
{
  return path.endsWith(".mp4", Qt::CaseInsensitive) || path.endsWith(".ogv", Qt::CaseInsensitive);
}

bool WritePictures(int count, const PictureDrawing& draw, const QString& path,
  const std::function<bool(double)>& onProgress)
{
  const std::unique_ptr<TurnWriter> writer = TurnWriterFor(path);
  const auto isTaken = [&](double part)
  {
    while (writer->IsBusy())
    {
      if (!onProgress(part))
      {
        return false;
      }
    }
    return true;
  };
  for (int i = 0; i < count; ++i)
  {
    if (!onProgress(double(i) / count))
    {
      return false;
    }
    const QImage picture =
      draw(i, [&](double part) { return onProgress((i + DrawingPart * part) / count); });
    if (picture.isNull())
    {
      return false;
    }
    writer->Add(picture);
    if (!isTaken((i + DrawingPart) / count))
    {
      return false;
    }
  }
  writer->End();
  if (!isTaken((count - 1.0 + DrawingPart) / count))
  {
    return false;
  }
  writer->Complete();
  return true;
}

bool WriteChange(PictureMaker& maker, int count, const std::function<void(double)>& show,
  const QString& path, const std::function<bool(double)>& onProgress)
{
  const auto draw = [&](int number, const std::function<bool(double)>& onPart)
  {
    show(double(number) / (count - 1));
    return maker.Draw(onPart);
  };
  return WritePictures(count, draw, path, onProgress);
}

bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress)
{
  const auto draw = [&](int, const std::function<bool(double)>& onPart)
  {
    const QImage picture = maker.Draw(onPart);
    maker.Turn(360.0 / count);
    return picture;
  };
  return WritePictures(count, draw, path, onProgress);
}

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
