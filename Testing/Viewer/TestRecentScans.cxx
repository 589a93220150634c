// The list of recent scans: the latest first, each once, and no name of a file in what is shown.

#include "SmallStudy.h"
#include "Viewer/Model/RecentScans.h"

#include <QFile>
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

  QTemporaryDir folder;
  RecentScans scans;
};

}

TEST_F(Recent, AreListedTheLatestFirstAndOnce)
{
  const auto study = SmallStudy();
  this->scans.Add(this->File("a"), *study);
  this->scans.Add(this->File("b"), *study);
  this->scans.Add(this->File("a"), *study);
  ASSERT_EQ(RecentScans().List().size(), 2);
  EXPECT_EQ(RecentScans().List()[0].path, this->File("a"));
}

TEST_F(Recent, SayWhatTheyAreAndNotOfWhom)
{
  this->scans.Add(this->File("DOE^JOHN"), *SmallStudy());
  const QString label = this->scans.List().first().label;
  EXPECT_FALSE(label.contains("DOE"));
  EXPECT_TRUE(label.startsWith("CT, 32 x 28 x 20"));
}

TEST_F(Recent, ForgetWhatIsGoneAndWhatIsOldest)
{
  const auto study = SmallStudy();
  this->scans.Add(this->folder.filePath("missing"), *study);
  EXPECT_TRUE(this->scans.List().isEmpty());
  for (int i = 0; i < RecentScans::Most + 3; ++i)
  {
    this->scans.Add(this->File(QString::number(i)), *study);
  }
  EXPECT_EQ(this->scans.List().size(), RecentScans::Most);
  EXPECT_EQ(this->scans.List().last().path, this->File("3"));
}
