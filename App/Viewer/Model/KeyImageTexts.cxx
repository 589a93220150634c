#include "Viewer/Model/KeyImageTexts.h"

#include "Viewer/Model/TimeSpeed.h"

#include <QCoreApplication>

namespace varimarch
{

namespace
{

struct KeyImageTexts
{
  Q_DECLARE_TR_FUNCTIONS(KeyImageTexts)
};

}

QString TitleOf(const KeyImage& image)
{
  return image.name.empty() ? TitleOf(image.view) : QString::fromStdString(image.name);
}

QString TitleOf(KeyView view)
{
  switch (view)
  {
    case KeyView::Axial:
      return KeyImageTexts::tr("Axial slice");
    case KeyView::Coronal:
      return KeyImageTexts::tr("Coronal slice");
    case KeyView::Sagittal:
      return KeyImageTexts::tr("Sagittal slice");
    default:
      return KeyImageTexts::tr("Volume");
  }
}

bool IsAtTime(const KeyImage& image, const LoadedTimes& times)
{
  return image.time && times.AreSeveral() && *image.time < int(times.values.size());
}

QString TimeTextOf(const KeyImage& image, const LoadedTimes& times)
{
  return IsAtTime(image, times) ? TimeText(times, *image.time) : QString();
}

}
