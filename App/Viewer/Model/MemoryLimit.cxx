#include "Viewer/Model/MemoryLimit.h"

#include "Scene/VolumeSource.h"

#include <QSettings>

#include <algorithm>

namespace varimarch
{

namespace
{

const QString MemoryKey = QStringLiteral("memory/gigabytes");

}

int ChosenMemoryGigabytes()
{
  return std::max(0, QSettings().value(MemoryKey).toInt());
}

void ChooseMemoryGigabytes(int gigabytes)
{
  QSettings().setValue(MemoryKey, gigabytes);
}

FileSource WithinMemory(FileSource file)
{
  if (file.memoryMegabytes <= 0.0)
  {
    file.memoryMegabytes = 1e3 * ChosenMemoryGigabytes();
  }
  return file;
}

}
