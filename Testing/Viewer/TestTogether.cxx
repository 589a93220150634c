// Files that are opened together, and a single image of a series.

#include "Module/Files/PhantomFiles.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/SliceView.h"
#include "Waiting.h"

#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Together : public testing::Test
{
protected:
  Together() { this->window.show(); }

  void WriteSeries(const std::string& uid, int sliceCount)
  {
    DicomOptions options;
    options.seriesUid = uid;
    for (int slice = 0; slice < sliceCount; ++slice)
    {
      this->folder.Write("study/" + uid + "-" + std::to_string(slice),
        DicomBytes(phantom::Stored(0), slice, options));
    }
  }

  QStringList FilesOf(const std::string& uid, int count)
  {
    QStringList files;
    for (int slice = 0; slice < count; ++slice)
    {
      files << QString::fromStdString(
        this->folder.Path("study/" + uid + "-" + std::to_string(slice)));
    }
    return files;
  }

  bool IsOpened()
  {
    return QTest::qWaitFor(
      [this] { return this->window.Model()->CurrentStudy() != nullptr; }, MostMilliseconds);
  }

  int SliceCount()
  {
    return this->window.Model()->CurrentStudy()->volume.image->GetDimensions()[2];
  }

  int CountShownSlices()
  {
    int count = 0;
    for (const SliceView* slice : this->window.findChildren<SliceView*>())
    {
      count += slice->isVisible() ? 1 : 0;
    }
    return count;
  }

  TemporaryFolder folder;
  MainWindow window;
};

}

// Several files that are dropped are one request, not the first of them.
TEST_F(Together, TheFilesOfASeriesOpenThatSeries)
{
  this->WriteSeries("1.2.33", 5);
  this->WriteSeries("1.2.44", 3);
  this->window.OpenTogether(this->FilesOf("1.2.44", 3));
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->SliceCount(), 3);
}

TEST_F(Together, TheFilesOfSeveralSeriesOfferThese)
{
  this->WriteSeries("1.2.33", 5);
  this->WriteSeries("1.2.44", 3);
  this->WriteSeries("1.2.55", 2);
  this->window.OpenTogether(this->FilesOf("1.2.55", 2) + this->FilesOf("1.2.44", 3));
  ASSERT_TRUE(
    QTest::qWaitFor([this] { return this->window.findChild<SeriesPicker*>(); }, MostMilliseconds));
  EXPECT_EQ(this->window.findChild<SeriesPicker*>()->findChild<QListWidget*>()->count(), 2);
}

TEST_F(Together, FilesThatAreNoSingleScanAreASentence)
{
  QStringList files;
  for (const char* const name : { "a.nii", "b.nii" })
  {
    files << QString::fromStdString(this->folder.Write(name, NiftiBytes(phantom::Stored(0))));
  }
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->window.OpenTogether(files);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_TRUE(failed.first().first().toString().startsWith("Cannot open 2 files at once"));
  // Notes beside a volume do not count.
  files[1] = QString::fromStdString(this->folder.Write("b.txt", "notes"));
  this->window.OpenTogether(files);
  EXPECT_TRUE(this->IsOpened());
}

TEST_F(Together, ASingleImageIsShownAloneAndOffersItsSeries)
{
  this->WriteSeries("1.2.33", 5);
  this->window.OpenTogether(this->FilesOf("1.2.33", 1));
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->CountShownSlices(), 1);
  EXPECT_FALSE(this->window.CentralView()->isVisible());
  ASSERT_TRUE(QTest::qWaitFor(
    [this]
    {
      const QStringList told = this->window.findChild<WarningBar*>()->Texts();
      return !told.filter("series of 5 images").isEmpty();
    },
    MostMilliseconds));
  this->window.findChild<QPushButton*>("remedy")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->SliceCount() == 5; }, MostMilliseconds));
  EXPECT_EQ(this->CountShownSlices(), 3);
  EXPECT_TRUE(this->window.CentralView()->isVisible());
}
