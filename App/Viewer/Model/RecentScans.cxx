#include "Viewer/Model/RecentScans.h"

#include "Viewer/Model/ResultInTime.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <QLocale>
#include <QSettings>

#include <vtkImageData.h>

#include <algorithm>

namespace varimarch
{

namespace
{

const QString RecentScansKey = QStringLiteral("recentScans");

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

QVector<RecentScan> Existing(QVector<RecentScan> scans)
{
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                [](const RecentScan& scan) { return !QFile::exists(scan.path); }),
    scans.end());
  return scans;
}

}

QString DigestOfSeries(const std::string& uid)
{
  const QByteArray bytes = QByteArray::fromStdString(uid);
  return bytes.isEmpty() ? QString()
                         : QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

QVector<RecentScan> RecentScans::List() const
{
  QVector<RecentScan> scans;
  QSettings settings;
  const int count = settings.beginReadArray(RecentScansKey);
  for (int i = 0; i < count; ++i)
  {
    settings.setArrayIndex(i);
    const auto text = [&](const char* key) { return settings.value(key).toString(); };
    scans.append({ text("path"), text("label"), text("series") });
  }
  // Scans stay in the list if a disk of the network does not answer.
  return ResultInTime([scans] { return Existing(scans); }).value_or(scans);
}

void RecentScans::Add(const FileSource& source, const Study& study)
{
  const RecentScan added = { QString::fromStdString(source.path), LabelOf(study),
    DigestOfSeries(source.series) };
  QVector<RecentScan> scans = this->List();
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                [&](const RecentScan& scan)
                { return scan.path == added.path && scan.series == added.series; }),
    scans.end());
  scans.prepend(added);
  this->Keep(scans.mid(0, Most));
}

void RecentScans::Clear()
{
  this->Keep({});
}

void RecentScans::Keep(const QVector<RecentScan>& scans)
{
  QSettings settings;
  settings.remove(RecentScansKey);
  settings.beginWriteArray(RecentScansKey, scans.size());
  for (int i = 0; i < scans.size(); ++i)
  {
    settings.setArrayIndex(i);
    settings.setValue("path", scans[i].path);
    settings.setValue("label", scans[i].label);
    settings.setValue("series", scans[i].series);
  }
  settings.endArray();
  // Paths of scans are for their user only. A file that is written again keeps its permissions.
  settings.sync();
  QFile::setPermissions(settings.fileName(), QFile::ReadOwner | QFile::WriteOwner);
}

}
