#include "Viewer/Model/RecentScans.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QLocale>

#include <vtkImageData.h>

#include <algorithm>

namespace varimarch
{

namespace
{

const QString Key = QStringLiteral("recentScans");

QString LabelOf(const Study& study)
{
  const int* const count = study.volume.image->GetDimensions();
  const QString modality = study.volume.modality.empty()
    ? QCoreApplication::translate("RecentScans", "Volume")
    : QString::fromStdString(study.volume.modality);
  return QCoreApplication::translate("RecentScans", "%1, %2 x %3 x %4, opened %5")
    .arg(modality)
    .arg(count[0])
    .arg(count[1])
    .arg(count[2])
    .arg(QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat));
}

}

QVector<RecentScan> RecentScans::List() const
{
  QVector<RecentScan> scans;
  const QStringList kept = this->settings.value(Key).toStringList();
  for (int i = 0; i + 1 < kept.size(); i += 2)
  {
    if (QFile::exists(kept[i]))
    {
      scans.append({ kept[i], kept[i + 1] });
    }
  }
  return scans;
}

void RecentScans::Add(const QString& path, const Study& study)
{
  QVector<RecentScan> scans = this->List();
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                [&](const RecentScan& scan) { return scan.path == path; }),
    scans.end());
  scans.prepend({ path, LabelOf(study) });
  this->Keep(scans.mid(0, Most));
}

void RecentScans::Clear()
{
  this->Keep({});
}

void RecentScans::Keep(const QVector<RecentScan>& scans)
{
  QStringList kept;
  for (const RecentScan& scan : scans)
  {
    kept << scan.path << scan.label;
  }
  this->settings.setValue(Key, kept);
}

}
