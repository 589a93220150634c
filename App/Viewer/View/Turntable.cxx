#include "Viewer/View/Turntable.h"

#include "Scene/OutputFile.h"
#include "Viewer/View/Mp4Movie.h"
#include "Viewer/View/TurnWriter.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <memory>

namespace varimarch
{

namespace
{

class PictureSeries : public TurnWriter
{
public:
  explicit PictureSeries(const QString& path)
    : path(path)
  {
  }

  ~PictureSeries() override
  {
    for (const QString& written : this->files)
    {
      QFile::remove(written);
    }
  }

  void Add(const QImage& picture) override
  {
    const QFileInfo name(this->path);
    const QString file = QStringLiteral("%1/%2-%3.png")
                           .arg(name.path(), name.completeBaseName())
                           .arg(this->files.size(), 3, 10, QChar('0'));
    this->files.append(file);
    if (!picture.save(file))
    {
      FailToWrite(file);
    }
  }

  void Complete() override { this->files.clear(); }

private:
  QString path;
  QStringList files;
};

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

std::unique_ptr<TurnWriter> WriterOf(const QString& path)
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

bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress)
{
  const std::unique_ptr<TurnWriter> writer = WriterOf(path);
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
    writer->Add(maker.Draw());
    maker.Turn(360.0 / count);
    if (!isTaken((i + 0.5) / count))
    {
      return false;
    }
  }
  writer->End();
  if (!isTaken((count - 0.5) / count))
  {
    return false;
  }
  writer->Complete();
  return true;
}

}
