#include "Viewer/View/PictureExport.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr int PicturesPerSecond = 24;

[[noreturn]] void Fail(const QString& path)
{
  throw std::runtime_error(
    QCoreApplication::translate("Turntable", "Cannot write %1").arg(path).toStdString());
}

// Takes the pictures of a turn; what was taken goes when it is not completed.
class Series
{
public:
  virtual ~Series() = default;
  virtual void Add(const QImage& picture) = 0;
  virtual void Complete() = 0;
};

class PictureSeries : public Series
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
      Fail(file);
    }
  }

  void Complete() override { this->files.clear(); }

private:
  QString path;
  QStringList files;
};

class Movie : public Series
{
public:
  explicit Movie(const QString& path)
    : path(path)
    , part(path + ".part")
  {
    this->writer->SetFileName(this->part.toUtf8());
    this->writer->SetRate(PicturesPerSecond);
    this->writer->SetQuality(2);
    this->writer->SetInputData(this->frame);
  }

  ~Movie() override
  {
    if (this->started)
    {
      this->writer->End();
    }
    QFile::remove(this->part);
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
      Fail(this->path);
    }
  }

  void Complete() override
  {
    this->writer->End();
    this->started = false;
    QFile::remove(this->path);
    if (!QFile::rename(this->part, this->path))
    {
      Fail(this->path);
    }
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
  QString part;
  vtkNew<vtkImageData> frame;
  vtkNew<vtkOggTheoraWriter> writer;
  bool started = false;
};

}

bool WriteTurntable(PictureMaker& maker, int count, const QString& path,
  const std::function<bool(double)>& onProgress)
{
  std::unique_ptr<Series> series;
  if (path.endsWith(".ogv"))
  {
    series = std::make_unique<Movie>(path);
  }
  else
  {
    series = std::make_unique<PictureSeries>(path);
  }
  for (int i = 0; i < count; ++i)
  {
    if (!onProgress(double(i) / count))
    {
      return false;
    }
    series->Add(maker.Draw());
    maker.Turn(360.0 / count);
  }
  series->Complete();
  return true;
}

}
