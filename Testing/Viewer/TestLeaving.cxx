// Nothing that the user made is lost, and files that were saved can be opened again.

#include "Answers.h"
#include "Scene/Json/SceneFile.h"
#include "TorsoWindow.h"
#include "Viewer/Model/StudyTimes.h"

#include <QAction>
#include <QDir>
#include <QStandardPaths>
#include <QStatusBar>

using namespace varimarch;

namespace
{

// Shows a window, accepts the autosaved copy that it offers, and waits for the scan.
bool Restores(MainWindow& window)
{
  window.show();
  {
    const Answers yes(QMessageBox::Yes, {});
    window.OfferAutosaved();
  }
  return QTest::qWaitFor(
    [&] { return window.Model()->CurrentStudy() != nullptr; }, MostMilliseconds);
}

class Leaving : public Window
{
protected:
  void SetUp() override { this->OpenTorso(); }

  void Measure()
  {
    this->Model()->Edit(ScenePart::Measures, "measure",
      [](Scene& scene) {
        scene.measures.push_back(
          { MeasureKind::Distance, { { 0, 0, 0 }, { 30, 40, 0 } }, "aorta" });
      });
  }

  bool IsOpenedAgain(const std::shared_ptr<const Study>& before)
  {
    return QTest::qWaitFor(
      [&] { return this->Model()->CurrentStudy() != before; }, MostMilliseconds);
  }
};

}

TEST_F(Leaving, AsksBeforeMeasurementsAreLost)
{
  this->Measure();
  const auto study = this->Model()->CurrentStudy();
  {
    const Answers cancel(QMessageBox::Cancel, {});
    this->window.close();
    EXPECT_EQ(cancel.Questions(), 1);
    EXPECT_TRUE(this->window.isVisible());
    this->window.Open(this->Path("torso.vti"));
    EXPECT_EQ(cancel.Questions(), 2);
    EXPECT_FALSE(this->window.Loader()->IsLoading());
    EXPECT_EQ(this->Model()->CurrentScene().measures.size(), 1u);
  }
  const Answers discard(QMessageBox::Discard, {});
  this->window.Open(this->Path("torso.vti"));
  ASSERT_TRUE(this->IsOpenedAgain(study));
  EXPECT_TRUE(this->Model()->CurrentScene().measures.empty());
  this->window.close();
  EXPECT_FALSE(this->window.isVisible());
  EXPECT_EQ(discard.Questions(), 1) << "nothing is lost at the end";
}

TEST_F(Leaving, AsksAboutWhatWasMeasuredInACoarseCopy)
{
  QFile large(this->Path("large.nrrd"));
  ASSERT_TRUE(large.open(QIODevice::WriteOnly));
  large.write("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1024 1024 512\n"
              "encoding: raw\nspacings: 1 1 1\n\n");
  ASSERT_TRUE(large.resize(large.pos() + (512 << 20)));
  large.close();
  ChooseMemoryGigabytes(2);
  this->window.Open(large.fileName());
  const auto isPreview = [&] { return this->Model()->CurrentStudy()->volume.isPreview; };
  ASSERT_TRUE(QTest::qWaitFor(isPreview, MostMilliseconds));
  this->Measure();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !isPreview(); }, MostMilliseconds));
  ChooseMemoryGigabytes(0);
  EXPECT_EQ(this->Model()->CurrentScene().measures.size(), 1u);
  const Answers discard(QMessageBox::Discard, {});
  this->window.close();
  EXPECT_EQ(discard.Questions(), 1);
}

TEST_F(Leaving, SavesASessionThatOpensAgainAndAsksNoMore)
{
  this->Measure();
  const Answers save(QMessageBox::Save, this->Path("sess"));
  this->window.close();
  EXPECT_FALSE(this->window.isVisible());
  EXPECT_EQ(save.Questions(), 1);
  ASSERT_TRUE(QFile::exists(this->Path("sess.json")));

  // Sessions of other programs, or renamed ones, may have any name.
  ASSERT_TRUE(QFile::rename(this->Path("sess.json"), this->Path("sess")));
  const auto study = this->Model()->CurrentStudy();
  this->window.show();
  this->window.Open(this->Path("sess"));
  ASSERT_TRUE(this->IsOpenedAgain(study));
  ASSERT_EQ(this->Model()->CurrentScene().measures.size(), 1u);
  EXPECT_EQ(this->Model()->CurrentScene().measures[0].name, "aorta");
  this->window.close();
  EXPECT_EQ(save.Questions(), 1);
}

TEST_F(Leaving, FindsTheScanFromASessionInAnotherFolder)
{
  const auto study = this->Model()->CurrentStudy();
  const QString before = QDir::currentPath();
  QDir::setCurrent(this->folder.path());
  this->window.Open("torso.vti");
  QDir::setCurrent(before);
  ASSERT_TRUE(this->IsOpenedAgain(study));
  ASSERT_TRUE(QDir(this->folder.path()).mkdir("sessions"));
  WriteScene(this->Model()->CurrentScene(), this->Path("sessions/one.json"));
  const Scene session = ReadScene(this->Path("sessions/one.json").toStdString());
  EXPECT_TRUE(QFile::exists(QString::fromStdString(std::get<FileSource>(session.volume).path)));
}

TEST_F(Leaving, KeepsTheAutosavedCopyThatWasNotRestored)
{
  this->Measure();
  const QString copy =
    QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosaved.json";
  const auto hasMeasure = [&]
  { return QFile::exists(copy) && ReadScene(copy.toStdString()).measures.size() == 1; };
  ASSERT_TRUE(QTest::qWaitFor(hasMeasure, MostMilliseconds));
  // This window goes on, so what a crash would have left is a copy that no viewer has locked.
  const QString left = QFileInfo(copy).path() + "/autosaved-2.json";
  ASSERT_TRUE(QFile::copy(copy, left));
  {
    MainWindow next;
    next.show();
    next.close();
  }
  EXPECT_TRUE(QFile::exists(left)) << "nothing was opened that could have replaced it";
  MainWindow later;
  ASSERT_TRUE(Restores(later));
  EXPECT_EQ(later.Model()->CurrentScene().measures.size(), 1u);
  const Answers discard(QMessageBox::Discard, {});
  later.close();
  EXPECT_EQ(discard.Questions(), 1) << "the restored work is in no file of the user's";
  EXPECT_FALSE(QFile::exists(left));
  EXPECT_TRUE(QFile::exists(copy)) << "the copy of a viewer that runs on";
}

TEST_F(Leaving, RestoresSegmentsThatWereDrawnBeforeACrash)
{
  this->Model()->AddSegment("tumour", "new segment");
  this->Model()->ChangeLabels({ { 3, 5, 2, 2, 1, 1 }, { 0, 0, 0 }, { 1, 1, 1 } }, "paint");
  const QString copies = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  const QString copy = copies + "/autosaved.json";
  const auto hasSegments = [&]
  { return QFile::exists(copy) && ReadScene(copy.toStdString()).labels; };
  ASSERT_TRUE(QTest::qWaitFor(hasSegments, MostMilliseconds));
  // A crash would have left the copy that this window has locked.
  QFile scene(copy);
  ASSERT_TRUE(scene.open(QIODevice::ReadOnly));
  QFile left(copies + "/autosaved-2.json");
  ASSERT_TRUE(left.open(QIODevice::WriteOnly));
  left.write(scene.readAll().replace("autosaved.seg.nrrd", "autosaved-2.seg.nrrd"));
  left.close();
  ASSERT_TRUE(QFile::copy(copies + "/autosaved.seg.nrrd", copies + "/autosaved-2.seg.nrrd"));

  MainWindow later;
  ASSERT_TRUE(Restores(later));
  ASSERT_TRUE(later.Model()->CurrentScene().labels);
  EXPECT_EQ(later.Model()->CurrentScene().labels->segments[0].name, "tumour");
  EXPECT_EQ(later.Model()->CurrentStudy()->segmentStatistics[0].voxels, 3);
  EXPECT_TRUE(later.Model()->HasUnsavedLabels()) << "the copy goes at the end";
  const Answers discard(QMessageBox::Discard, {});
  later.close();
  EXPECT_EQ(discard.Questions(), 1);
  EXPECT_FALSE(QFile::exists(copies + "/autosaved-2.seg.nrrd"));
}

TEST_F(Leaving, SaysThatAnImageIsSaved)
{
  const Answers save(QMessageBox::Save, this->Path("torso"));
  this->window.findChild<QAction*>("exportImage")->trigger();
  EXPECT_TRUE(QFile::exists(this->Path("torso.png")));
  EXPECT_EQ(this->window.statusBar()->currentMessage(), "Saved " + this->Path("torso.png"));
}
