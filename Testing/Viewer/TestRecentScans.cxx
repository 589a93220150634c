// Recent scans: the latest first, each once, without file names in their labels.

#include "SmallStudy.h"
#include "Viewer/Model/RecentScans.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Recent : public testing::Test
{
protected:
  Recent() { this->scans.Clear(); }
  ~Recent() override { this->scans.Clear(); }

  QString File(const QString& name)
  {
    QFile file(this->folder.filePath(name));
    file.open(QIODevice::WriteOnly);
    return file.fileName();
  }

  FileSource Source(const QString& name, const std::string& series = {})
  {
    return { this->File(name).toStdString(), std::nullopt, series };
  }

  QTemporaryDir folder;
  RecentScans scans;
};

}

TEST_F(Recent, AreListedTheLatestFirstAndOnce)
{
  const auto study = SmallStudy();
  this->scans.Add(this->Source("a"), *study);
  this->scans.Add(this->Source("b"), *study);
  this->scans.Add(this->Source("a"), *study);
  ASSERT_EQ(RecentScans().List().size(), 2);
  EXPECT_EQ(RecentScans().List()[0].path, this->File("a"));
}

TEST_F(Recent, HaveLabelsWithoutPatientData)
{
  this->scans.Add(this->Source("DOE^JOHN"), *SmallStudy());
  const RecentScan scan = this->scans.List().first();
  EXPECT_EQ(scan.Title(), "CT, 32 x 28 x 20");
  EXPECT_TRUE(scan.Opened().startsWith("opened "));
  EXPECT_FALSE(scan.Opened().contains("DOE"));
}

TEST_F(Recent, DistinguishTheSeriesOfAFolderWithoutTheirUid)
{
  const auto study = SmallStudy();
  for (const char* const uid : { "1.2.33", "1.2.44", "1.2.33" })
  {
    this->scans.Add(this->Source("disc", uid), *study);
  }
  ASSERT_EQ(this->scans.List().size(), 2);
  EXPECT_EQ(this->scans.List().first().series, DigestOfSeries("1.2.33"));
  EXPECT_NE(DigestOfSeries("1.2.33"), DigestOfSeries("1.2.44"));
  EXPECT_TRUE(DigestOfSeries("").isEmpty());
  QSettings settings;
  settings.sync();
  QFile kept(settings.fileName());
  ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
  const QByteArray text = kept.readAll();
  EXPECT_TRUE(text.contains(DigestOfSeries("1.2.33").toUtf8()));
  EXPECT_FALSE(text.contains("1.2.33"));
}

TEST_F(Recent, DropMissingFilesAndTheOldestScans)
{
  const auto study = SmallStudy();
  this->scans.Add(
    FileSource{ this->folder.filePath("missing").toStdString(), std::nullopt }, *study);
  EXPECT_TRUE(this->scans.List().isEmpty());
  for (int i = 0; i < RecentScans::Most + 3; ++i)
  {
    this->scans.Add(this->Source(QString::number(i)), *study);
  }
  EXPECT_EQ(this->scans.List().size(), RecentScans::Most);
  EXPECT_EQ(this->scans.List().last().path, this->File("3"));
}
