// Further scans in the window: added, checked for their space, saved in sessions.

#include "Answers.h"
#include "LabelledStudy.h"
#include "OverlaidStudy.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Segments/LabelMap.h"
#include "TorsoWindow.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/Panels/VolumesPanel.h"
#include "Viewer/View/SliceView.h"

#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QToolButton>

using namespace varimarch;

namespace
{

class FurtherScans : public Window
{
protected:
  bool AwaitOverlays(std::size_t count)
  {
    return QTest::qWaitFor(
      [&] { return this->Model()->CurrentScene().overlays.size() == count; }, MostMilliseconds);
  }

  /// Number of pixels of the 3D view that are mainly red.
  int RedPixels()
  {
    QSignalSpy drawn(this->View(), &VolumeView::Drawn);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !drawn.isEmpty(); }, MostMilliseconds));
    const QImage picture = this->Surface()->grabFramebuffer();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
    {
      for (int x = 0; x < picture.width(); ++x)
      {
        const QColor color = picture.pixelColor(x, y);
        count += color.red() > 60 && color.red() > 2 * color.blue();
      }
    }
    return count;
  }

  /// Adds the PET, and closes the warning that its file names no space.
  void AddPetOfFile()
  {
    this->window.AddScan(this->WritePet());
    ASSERT_TRUE(this->AwaitOverlays(1));
    auto* const warning = this->window.findChild<QMessageBox*>("otherSpace");
    ASSERT_TRUE(warning);
    warning->button(QMessageBox::Ok)->click();
  }

  /// Clicks into the middle of a slice, so that a new segment gets 512 voxels of the PET.
  void GrowRegionOfPet(SliceView* slice)
  {
    for (const char* const button : { "newSegment", "toolRegion" })
    {
      this->window.findChild<QPushButton*>(button)->click();
    }
    this->window.findChild<QDoubleSpinBox*>("smallestValue")->setValue(900.0);
    this->window.findChild<QDoubleSpinBox*>("largestValue")->setValue(1100.0);
    QTest::mouseClick(slice, Qt::LeftButton, {}, slice->rect().center());
  }

  /// Adds a PET with a warning, named "uptake".
  void AddPetWithWarning(const std::string& warning)
  {
    Study pet = *PetOver(this->Model()->CurrentStudy()->volume.image);
    pet.volume.warnings = { warning };
    OverlaidVolume overlay =
      OverlayOf(FileSource{ "/scans/pet", std::nullopt }, pet.volume, pet.statistics);
    overlay.name = "uptake";
    this->Model()->AddOverlay(overlay, std::make_shared<const Study>(pet), "add");
  }

  QString WritePet()
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(PetOver(this->Model()->CurrentStudy()->volume.image)->volume.image);
    writer->SetFileName(this->Path("pet.vti").toUtf8());
    writer->Write();
    return this->Path("pet.vti");
  }
};

}

TEST_F(FurtherScans, AreDrawnOverTheFirstWithAWarningOfTheirSpace)
{
  this->OpenTorso();
  this->AddPetOfFile();
  auto* const panel = this->window.findChild<VolumesPanel*>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel->isVisible(); }, MostMilliseconds));
  this->Model()->SetPreset(BuiltInPreset("pet-hot"), "hot");
  const int hot = this->RedPixels();
  panel->findChild<QListWidget*>()->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_LT(this->RedPixels() + 100, hot);
}

// A scan that is being read when another takes the last place.
TEST_F(FurtherScans, BeyondTheMostAreRefusedInASentence)
{
  this->OpenTorso();
  const QString pet = this->WritePet();
  for (std::size_t count = 1; count < MostVolumes; ++count)
  {
    this->window.AddScan(pet);
    ASSERT_TRUE(this->AwaitOverlays(count));
  }
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->window.AddScan(pet);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_TRUE(failed.first().first().toString().contains("At most 4 scans"));
  EXPECT_EQ(this->Model()->CurrentScene().overlays.size(), MostVolumes - 1);
}

TEST_F(FurtherScans, HaveASuggestedLookOfTheirOwn)
{
  this->OpenTorso();
  const std::string first = this->Model()->CurrentScene().look.name;
  this->AddPetOfFile();
  const std::string suggested = this->Model()->EditedLook().name;
  ASSERT_NE(suggested, first);
  this->Model()->SetPreset(BuiltInPreset("pet-hot"), "hot");
  for (QAction* const action : this->window.findChildren<QAction*>())
  {
    if (action->shortcut() == QKeySequence("R"))
    {
      action->trigger();
    }
  }
  EXPECT_EQ(this->Model()->EditedLook().name, suggested);
  EXPECT_EQ(this->Model()->CurrentScene().look.name, first);
}

TEST_F(FurtherScans, AreInSessions)
{
  this->OpenTorso();
  this->AddPetOfFile();
  this->Model()->Edit(ScenePart::Overlays, "move",
    [](Scene& scene) {
      scene.overlays[0].placement.moveMm = { 5.0, 0.0, 0.0 };
    });
  WriteScene(this->Model()->CurrentScene(), this->Path("session.json"));
  Answers discards(QMessageBox::Discard, {});
  this->window.Open(this->Path("torso.vti"));
  ASSERT_TRUE(this->AwaitOverlays(0));
  this->window.Open(this->Path("session.json"));
  ASSERT_TRUE(this->AwaitOverlays(1));
  EXPECT_EQ(this->Model()->CurrentScene().overlays[0].placement.moveMm[0], 5.0);
  ASSERT_EQ(this->Model()->CurrentStudy()->overlays.size(), 1);
}

TEST_F(FurtherScans, StayWhereTheyAreIfTheirRegistrationIsCancelled)
{
  this->OpenTorso();
  this->AddPetOfFile();
  auto* const panel = this->window.findChild<VolumesPanel*>();
  panel->findChild<QPushButton*>("register")->click();
  const QPointer<QProgressDialog> waiting = this->window.findChild<QProgressDialog*>("registering");
  ASSERT_TRUE(waiting);
  waiting->findChild<QPushButton*>()->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return waiting.isNull(); }, MostMilliseconds));
  QTest::qWait(1000); // its thread ends
  EXPECT_EQ(this->Model()->CurrentScene().overlays[0].placement, Placement());
}

TEST_F(FurtherScans, OfASessionMayBeGone)
{
  this->OpenTorso();
  this->AddPetOfFile();
  WriteScene(this->Model()->CurrentScene(), this->Path("session.json"));
  QFile::remove(this->Path("pet.vti"));
  Answers discards(QMessageBox::Discard, {});
  this->window.Open(this->Path("session.json"));
  ASSERT_TRUE(this->AwaitOverlays(0));
  EXPECT_FALSE(this->Model()->CurrentStudy()->volume.warnings.empty());
}

TEST_F(FurtherScans, ThatCannotBeReadLeaveTheFirst)
{
  this->OpenTorso();
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->window.AddScan(this->Path("missing.vti"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_TRUE(this->Model()->CurrentScene().overlays.empty());
  EXPECT_TRUE(this->Model()->CurrentStudy());
}

// The user segments the added PET by a click, saves the session with its segments, and opens it.
TEST_F(FurtherScans, HaveSegmentsOfTheirOwn)
{
  this->OpenTorso();
  this->AddPetOfFile();
  auto* const slice = this->window.findChild<SliceView*>();
  this->GrowRegionOfPet(slice);
  EXPECT_FALSE(this->Model()->CurrentScene().labels);
  ASSERT_TRUE(this->Model()->CurrentScene().overlays[0].labels);
  EXPECT_TRUE(QTest::qWaitFor([&]
    { return this->Model()->StudyOf(1)->segmentStatistics.at(0).voxels == 512; },
    MostMilliseconds));
  const QImage drawn = slice->grab().toImage();
  this->window.findChild<QPushButton*>("hideAll")->click();
  EXPECT_NE(slice->grab().toImage(), drawn) << "slices show them";
  this->Model()->History()->undo();

  const QString segments = this->Path("pet.seg.nrrd");
  WriteSegments(*this->Model()->CurrentStudy()->overlays[0]->labels,
    this->Model()->EditedLabels()->segments, {}, segments.toStdString());
  this->Model()->TakeSavedLabels(
    segments.toStdString(), this->Model()->EditedLabels()->segments, "save", 1);
  WriteScene(this->Model()->CurrentScene(), this->Path("session.json"));
  const Answers discards(QMessageBox::Discard, {});
  this->window.Open(this->Path("torso.vti"));
  ASSERT_TRUE(this->AwaitOverlays(0));
  this->window.Open(this->Path("session.json"));
  ASSERT_TRUE(this->AwaitOverlays(1));
  EXPECT_EQ(this->Model()->StudyOf(1)->segmentStatistics.at(0).voxels, 512);
  EXPECT_FALSE(this->Model()->VolumeWithUnsavedLabels());
}

TEST_F(FurtherScans, GetTheirRegionsThoughTheUserChoosesAnotherMeanwhile)
{
  this->OpenTorso();
  this->AddPetOfFile();
  this->GrowRegionOfPet(this->window.findChild<SliceView*>());
  this->Model()->SetEditedVolume(0);
  EXPECT_TRUE(QTest::qWaitFor(
    [&]
    {
      const auto pet = this->Model()->StudyOf(1);
      return pet->areSegmentsCounted && pet->segmentStatistics.at(0).voxels == 512;
    },
    MostMilliseconds));
  EXPECT_FALSE(this->Model()->EditedLabels()) << "those of the first";
}

TEST_F(FurtherScans, SayThatTheirSegmentsCannotBeRead)
{
  this->OpenTorso();
  this->AddPetOfFile();
  Scene scene = this->Model()->CurrentScene();
  scene.overlays[0].labels = SceneLabels{ this->Path("missing.seg.nrrd").toStdString() };
  WriteScene(scene, this->Path("session.json"));
  const Answers discards(QMessageBox::Discard, {});
  this->window.Open(this->Path("torso.vti"));
  ASSERT_TRUE(this->AwaitOverlays(0));
  this->window.Open(this->Path("session.json"));
  ASSERT_TRUE(this->AwaitOverlays(1));
  EXPECT_FALSE(this->Model()->CurrentScene().overlays[0].labels);
  const QStringList warnings = this->window.findChild<WarningBar*>()->Texts();
  EXPECT_EQ(warnings.filter("missing.seg.nrrd").size(), 1) << warnings.join('\n').toStdString();
}

TEST_F(FurtherScans, ShowTheirWarningsWithTheirNames)
{
  this->OpenTorso();
  const auto* const bar = this->window.findChild<WarningBar*>();
  const QStringList ofFirst = bar->Texts();
  this->AddPetWithWarning("2 slices are missing.");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->Texts(), ofFirst + QStringList("uptake: 2 slices are missing."));
  this->Model()->RemoveOverlay(0, "remove");
  EXPECT_EQ(bar->Texts(), ofFirst);
}

TEST_F(FurtherScans, KeepTheirWarningsClosedWhenTheyAreRenamed)
{
  this->OpenTorso();
  auto* const bar = this->window.findChild<WarningBar*>();
  const QStringList ofFirst = bar->Texts();
  this->AddPetWithWarning("2 slices are missing.");
  bar->findChild<QToolButton*>()->click();
  ASSERT_FALSE(bar->isVisible());
  this->Model()->Edit(
    ScenePart::Overlays, "rename", [](Scene& scene) { scene.overlays[0].name = "tracer"; });
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(bar->Texts(), ofFirst + QStringList("tracer: 2 slices are missing."));
  this->AddPetWithWarning("2 slices are missing.");
  EXPECT_TRUE(bar->isVisible()) << "this is another scan";
}

TEST_F(FurtherScans, AreNotOpenedInPartWhenSeveralAreDropped)
{
  this->OpenTorso();
  const auto study = this->Model()->CurrentStudy();
  ASSERT_TRUE(QFile::copy(this->Path("torso.vti"), this->Path("other.vti")));
  QSignalSpy failed(&this->window, &MainWindow::OpeningFailed);
  this->Drop({ this->Path("torso.vti"), this->Path("other.vti") });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_EQ(this->Model()->CurrentStudy(), study);
}

// The labels of the torso lie within the PET too, but have the voxels of the torso.
TEST_F(FurtherScans, LeaveADroppedSegmentationToTheScanWithItsGrid)
{
  this->OpenTorso();
  const LoadedVolume& torso = this->Model()->CurrentStudy()->volume;
  const LabelMap labels = LabelMapOf(LabelsOf(torso.image), "labels.nrrd", torso);
  const QString file = this->Path("torso.seg.nrrd");
  WriteSegments(labels, labels.segments, {}, file.toStdString());
  this->AddPetOfFile();
  ASSERT_EQ(this->Model()->EditedVolume(), 1);
  this->Drop({ file });
  EXPECT_TRUE(QTest::qWaitFor(
    [&] { return this->Model()->CurrentScene().labels.has_value(); }, MostMilliseconds));
  EXPECT_FALSE(this->Model()->CurrentScene().overlays[0].labels);
  EXPECT_EQ(this->Model()->EditedVolume(), 0) << "the panel shows them";
}
