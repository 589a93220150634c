#include "Viewer/View/Turntable.h"

#include "Scene/OutputFile.h"
#include "Viewer/View/Mp4Movie.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

namespace varimarch
{

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

}
