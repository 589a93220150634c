#include "Viewer/Studies/StudyTexts.h"

#include <QDate>
#include <QLocale>
#include <QStringList>

namespace varimarch
{

QString PersonText(const QString& stored)
{
  // The forms of a name in several alphabets, of which the first may be empty.
  const QStringList forms = stored.split('=', Qt::SkipEmptyParts);
  QStringList parts = forms.isEmpty() ? QStringList() : forms.first().split('^');
  if (parts.isEmpty())
  {
    return {};
  }
  const QString family = parts.takeFirst();
  const QString given = parts.join(' ').simplified();
  return given.isEmpty() ? family : family + ", " + given;
}

QString DateText(const QString& stored)
{
  const QDate date = QDate::fromString(stored, "yyyyMMdd");
  return date.isValid() ? QLocale().toString(date, QLocale::ShortFormat) : stored;
}

}
