#include "Viewer/View/TurnWriter.h"

#include <QCoreApplication>
#include <QFile>

#include <filesystem>
#include <stdexcept>

namespace varimarch
{

UnfinishedFile::UnfinishedFile(const QString& path)
  : path(path)
  , part(path + ".part")
{
}

UnfinishedFile::~UnfinishedFile()
{
  QFile::remove(this->part);
}

void UnfinishedFile::Complete()
{
  std::error_code error;
  std::filesystem::rename(this->part.toStdString(), this->path.toStdString(), error);
  if (error)
  {
    FailToWrite(this->path, QString::fromLocal8Bit(error.message().c_str()));
  }
}

void FailToWrite(const QString& path, const QString& reason)
{
  const QString sentence = reason.isEmpty()
    ? QCoreApplication::translate("Turntable", "Cannot write %1").arg(path)
    : QCoreApplication::translate("Turntable", "Cannot write %1: %2").arg(path, reason);
  throw std::runtime_error(sentence.toStdString());
}

}
