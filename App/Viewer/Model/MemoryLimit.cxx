#include "Viewer/Model/MemoryLimit.h"

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

}
