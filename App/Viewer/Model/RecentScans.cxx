#include "Viewer/Model/RecentScans.h"

#include "Viewer/Model/BackgroundTask.h"

#include <QCoreApplication>
#include <QCryptographicHash>
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

QString SizeOf(const Study& study)
{
  const int* const count = study.volume.image->GetDimensions();
  return QStringLiteral("%1 x %2 x %3").arg(count[0]).arg(count[1]).arg(count[2]);
}

QVector<RecentScan> Existing(QVector<RecentScan> scans)
{
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                [](const RecentScan& scan) { return !QFile::exists(scan.path); }),
    scans.end());
  return scans;
}

}

QString RecentScan::Title() const
{
  const QString kind = this->modality.isEmpty()
    ? QCoreApplication::translate("RecentScans", "Volume")
    : this->modality;
  return (kind + ' ' + this->bodyPart).trimmed() + ", " + this->size;
}

QString RecentScan::Opened() const
{
  return QCoreApplication::translate("RecentScans", "opened %1")
    .arg(QLocale().toString(this->opened, QLocale::ShortFormat));
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
    scans.append({ text("path"), text("series"), text("modality"), text("bodyPart"), text("size"),
      settings.value("opened").toDateTime() });
  }
  // Scans stay in the list if a disk of the network does not answer.
  return ResultInTime([scans] { return Existing(scans); }).value_or(scans);
}

void RecentScans::Add(const FileSource& source, const Study& study)
{
  const RecentScan added = { QString::fromStdString(source.path), DigestOfSeries(source.series),
    QString::fromStdString(study.volume.modality), QString::fromStdString(study.volume.bodyPart),
    SizeOf(study), QDateTime::currentDateTime() };
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
    settings.setValue("series", scans[i].series);
    settings.setValue("modality", scans[i].modality);
    settings.setValue("bodyPart", scans[i].bodyPart);
    settings.setValue("size", scans[i].size);
    settings.setValue("opened", scans[i].opened);
  }
  settings.endArray();
  // Paths of scans are for their user only. A file that is written again keeps its permissions.
  settings.sync();
  QFile::setPermissions(settings.fileName(), QFile::ReadOwner | QFile::WriteOwner);
}

}
