#include "Viewer/View/TurnWriter.h"

#include <QCoreApplication>

#include <stdexcept>

namespace varimarch
{

void FailToWrite(const QString& path, const QString& reason)
{
  const QString sentence = reason.isEmpty()
    ? QCoreApplication::translate("Turntable", "Cannot write %1").arg(path)
    : QCoreApplication::translate("Turntable", "Cannot write %1: %2").arg(path, reason);
  throw std::runtime_error(sentence.toStdString());
}

}
