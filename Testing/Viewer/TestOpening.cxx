// Questions before opening a file, warnings, and protection of the patient's data.

#include "Answers.h"
#include "Module/Files/PhantomSegmentation.h"
#include "OpeningWindow.h"
#include "SilentFile.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Open/RawForm.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/Studies/StudyListWindow.h"

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

using namespace varimarch;

namespace
{

class Opening : public OpeningWindow
{
protected:
  /// The warnings that the window shows; empty if it shows none.
  QString WarningText() const
  {
    const auto* const bar = this->window.findChild<WarningBar*>();
    QString text;
    for (const QLabel* label : bar->findChildren<QLabel*>())
    {
      text += bar->isVisible() ? label->text() : QString();
    }
    return text;
  }

  template <class Widget>
  Widget* Awaited()
  {
    const auto isThere = [this] { return this->window.findChild<Widget*>() != nullptr; };
    return QTest::qWaitFor(isThere, MostMilliseconds) ? this->window.findChild<Widget*>() : nullptr;
  }

  int SliceCount()
  {
    return this->window.Model()->CurrentStudy()->volume.image->GetDimensions()[2];
  }
};

}

TEST_F(Opening, AFileThatDoesNotAnswerIsASentence)
{
  const std::string path = this->folder.Write("a.nii", NiftiBytes(phantom::Stored(0)));
  const SilentFile file(path);
  if (!file.IsSilent())
  {
    GTEST_SKIP() << "the file system has no leases";
  }
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->window.Open(QString::fromStdString(path));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed.first().first().toString().contains("a.nii\" does not answer"));
}

TEST_F(Opening, AnEmptyNameIsASentence)
{
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->window.Open("");
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed.first().first().toString(), "There is no file to open: its name is empty.");
  EXPECT_FALSE(this->window.Loader()->IsLoading());
}

TEST_F(Opening, ACoarseCopyIsShownUntilALargeVolumeHasBeenRead)
{
  const std::string path = this->folder.Write("large.nrrd",
    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1024 1024 512\n"
    "encoding: raw\nspacings: 1 1 1\n\n");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) + (512 << 20));
  ChooseMemoryGigabytes(2);
  this->Open("large.nrrd");
  ASSERT_TRUE(this->IsOpened());
  SceneModel* const model = this->window.Model();
  ASSERT_TRUE(model->CurrentStudy()->volume.isPreview);
  EXPECT_TRUE(this->WarningText().contains("A coarse copy"));
  model->Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 2.0; });
  ASSERT_TRUE(
    QTest::qWaitFor([=] { return model->CurrentStudy()->volume.isOnDisk; }, 10 * MostMilliseconds));
  ChooseMemoryGigabytes(0);
  EXPECT_EQ(model->CurrentScene().camera.zoom, 2.0);
}

TEST_F(Opening, AsksWhichOfSeveralSeriesAndWarns)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->Open("DOE^JANE");
  auto* const picker = this->Awaited<SeriesPicker>();
  ASSERT_TRUE(picker);
  EXPECT_FALSE(this->window.Model()->CurrentStudy());
  QTest::keyClick(picker->findChild<QListWidget*>(), Qt::Key_Down);
  QTest::keyClick(picker->findChild<QListWidget*>(), Qt::Key_Return);
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->SliceCount(), 2);
  EXPECT_EQ(std::get<FileSource>(this->window.Model()->CurrentScene().volume).series, "1.2.33");
  EXPECT_TRUE(this->WarningText().contains("compressed with loss"));
}

TEST_F(Opening, OffersTheKindsOfVolumeInASeries)
{
  for (int echo = 0; echo < 2; ++echo)
  {
    for (int slice = 0; slice < 3; ++slice)
    {
      DicomOptions options;
      options.instance = 10 * echo;
      options.echoMs = 10.0 * (echo + 1);
      options.intercept = 1000.0 * echo;
      this->folder.Write("echoes/" + std::to_string(10 * echo + slice),
        DicomBytes(phantom::Stored(0), slice, options));
    }
  }
  this->Open("echoes");
  ASSERT_TRUE(this->IsOpened());
  auto* const kinds = this->window.findChild<QMenu*>("kinds");
  ASSERT_TRUE(kinds);
  auto* const file = qobject_cast<QMenu*>(kinds->parentWidget());
  ASSERT_TRUE(file);
  emit file->aboutToShow();
  ASSERT_EQ(kinds->actions().size(), 2);
  EXPECT_EQ(kinds->actions()[1]->text(), "2  echo 20");
  EXPECT_TRUE(kinds->actions()[0]->isChecked());
  kinds->actions()[1]->trigger();
  ASSERT_TRUE(this->IsOpened());
  SceneModel* const model = this->window.Model();
  ASSERT_TRUE(
    QTest::qWaitFor([=] { return std::get<FileSource>(model->CurrentScene().volume).kind == 2; },
      MostMilliseconds));
  EXPECT_EQ(model->CurrentStudy()->volume.image->GetScalarComponentAsDouble(1, 2, 1, 0),
    phantom::ValueAt({ 1, 2, 1 }) + 1000.0);
}

TEST_F(Opening, OpensARecentSeriesWithoutAskingAgain)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->Open("DOE^JANE");
  ASSERT_TRUE(this->Awaited<SeriesPicker>());
  QTest::keyClick(this->Awaited<SeriesPicker>()->findChild<QListWidget*>(), Qt::Key_Down);
  QTest::keyClick(this->Awaited<SeriesPicker>()->findChild<QListWidget*>(), Qt::Key_Return);
  ASSERT_TRUE(this->IsOpened());

  MainWindow later;
  auto* const recent = later.findChild<QMenu*>("recent");
  ASSERT_TRUE(recent);
  emit recent->aboutToShow();
  recent->actions().first()->trigger();
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return later.Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  EXPECT_EQ(later.Model()->CurrentStudy()->volume.image->GetDimensions()[2], 2);
  EXPECT_FALSE(later.findChild<SeriesPicker*>());
}

TEST_F(Opening, OpensASeriesOfTheStudyList)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->window.findChild<QAction*>("showStudies")->trigger();
  auto* const list = this->window.findChild<StudyListWindow*>();
  ASSERT_TRUE(list);
  list->Read({ QString::fromStdString(this->folder.Path("DOE^JANE")) });
  auto* const tree = list->findChild<QTreeWidget*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tree->topLevelItemCount() == 1; }, MostMilliseconds));
  QTreeWidgetItem* const study = tree->topLevelItem(0)->child(0);
  ASSERT_EQ(study->childCount(), 2);
  for (int i = 0; i < 2; ++i)
  {
    if (study->child(i)->text(4) == "2")
    {
      tree->setCurrentItem(study->child(i));
    }
  }
  list->findChild<QPushButton*>("open")->click();
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->SliceCount(), 2);
  EXPECT_TRUE(list->isVisible());
}

TEST_F(Opening, KeepsTheWarningsClosedWhileSegmentsAreDrawn)
{
  this->WriteSeries("1.2.33", 3);
  this->Open("DOE^JANE");
  ASSERT_TRUE(this->IsOpened());
  auto* const bar = this->window.findChild<WarningBar*>();
  bar->findChild<QToolButton*>()->click();
  this->window.Model()->AddSegment("liver", "new segment");
  EXPECT_FALSE(bar->isVisible());
  const Answers discard(QMessageBox::Discard, {});
  this->Open("DOE^JANE");
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar->isVisible(); }, MostMilliseconds));
}

TEST_F(Opening, KnowsTheSegmentsOfASegmentation)
{
  const std::vector<int> pixels(20, 1);
  this->folder.Write("segments/a",
    phantom_dicom::FileBytes(phantom_dicom::Segmentation(phantom::Stored(0), { { 4, "liver" } },
      { { 4, 0, pixels }, { 4, 1, pixels }, { 4, 2, pixels } })));
  this->Open("segments");
  ASSERT_TRUE(this->IsOpened());
  const std::vector<Segment>& segments = this->window.Model()->CurrentStudy()->volume.segments;
  ASSERT_EQ(segments.size(), 1);
  EXPECT_EQ(segments.front().name, "liver");
}

TEST_F(Opening, ShowsSlicesWithTheWindowOfTheFile)
{
  // Offsets of cal_max and cal_min in the header, NIfTI-1 standard.
  std::string bytes = NiftiBytes(phantom::Stored(0));
  const float range[] = { 300.0f, 100.0f };
  std::memcpy(bytes.data() + 124, range, sizeof range);
  this->folder.Write("window.nii", bytes);
  this->Open("window.nii");
  ASSERT_TRUE(this->IsOpened());
  const auto windowLevel = this->window.Model()->CurrentStudy()->volume.windowLevel;
  ASSERT_TRUE(windowLevel);
  EXPECT_EQ(*windowLevel, (std::array<double, 2>{ 200.0, 200.0 }));
}

TEST_F(Opening, AsksForTheLayoutOfARawFile)
{
  this->folder.Write("scan_4x4x3_uint8.raw", std::string(48, 'a'));
  this->Open("scan_4x4x3_uint8.raw");
  auto* const form = this->Awaited<RawForm>();
  ASSERT_TRUE(form);
  form->findChild<QPushButton*>("open")->click();
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->SliceCount(), 3);
  EXPECT_FALSE(this->window.findChild<WarningBar*>()->isVisible());
}

TEST_F(Opening, KeepsPatientDataOutOfTheLog)
{
  const QTemporaryDir log;
  StartLog(log.path());
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->Open("DOE^JANE");
  auto* const picker = this->Awaited<SeriesPicker>();
  ASSERT_TRUE(picker);
  QTest::keyClick(picker->findChild<QListWidget*>(), Qt::Key_Return);
  ASSERT_TRUE(this->IsOpened());
  QSignalSpy failed(this->window.Loader(), &LoadController::Failed);
  this->folder.Write("DOE^JANE.nrrd", "NRRD0004\ntype: nonsense\n\n");
  this->Open("DOE^JANE.nrrd");
  ASSERT_TRUE(failed.wait(MostMilliseconds));
  this->window.close();

  QFile file(LogFileIn(log.path()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  for (const char* event : { "loading", "series to choose from, count 2",
         "volume opened, columns 5, rows 4, slices 3", "opening failed", "window closed" })
  {
    EXPECT_TRUE(text.contains(event)) << event;
  }
  const QString place = QString::fromStdString(this->folder.Path(""));
  for (const QString& secret : { QString("doe"), QString("jane"), QString("1.2.33"), place })
  {
    EXPECT_FALSE(text.contains(secret, Qt::CaseInsensitive)) << secret.toStdString();
  }
}

TEST_F(Opening, CanBeClosedWhileItAsks)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->Open("DOE^JANE");
  ASSERT_TRUE(this->Awaited<SeriesPicker>());
  this->window.close();
}
