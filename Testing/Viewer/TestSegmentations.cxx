// Segmentations over a scan in the window: opened, dropped, offered, saved in sessions.

#include "Answers.h"
#include "LabelledStudy.h"
#include "Module/Files/PhantomSegmentation.h"
#include "OverlaidStudy.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "TorsoWindow.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/Panels/SegmentsPanel.h"

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QTableWidget>

using namespace varimarch;

namespace
{

class Segmentations : public Window
{
protected:
  /// Writes the labels of the torso. The file does not say that they are labels.
  QString WriteLabels(const QString& name)
  {
    const LoadedVolume torso =
      LoadVolume(FileSource{ this->Path("torso.vti").toStdString(), std::nullopt });
    WriteVolume(LabelsOf(torso.image), this->Path(name).toStdString());
    return this->Path(name);
  }

  /// Writes the labels of the torso as a segmentation of 3D Slicer.
  QString WriteSegmentation()
  {
    QFile labels(this->WriteLabels("labels.nrrd"));
    EXPECT_TRUE(labels.open(QIODevice::ReadOnly));
    QByteArray bytes = labels.readAll();
    bytes.insert(bytes.indexOf("\n\n") + 1,
      "Segment0_ID:=Segment_1\nSegment0_Name:=lower half\nSegment0_LabelValue:=3\n"
      "Segment0_Layer:=0\nSegment0_Color:=0 1 0\n");
    QFile segmentation(this->Path("torso.seg.nrrd"));
    EXPECT_TRUE(segmentation.open(QIODevice::WriteOnly));
    segmentation.write(bytes);
    return this->Path("torso.seg.nrrd");
  }

  /// Writes the slices of the phantom, and a segmentation of its middle slice in the frame of
  /// reference 1.2.52.
  static void WriteDisc(const TemporaryFolder& disc, const std::string& frameOfReference)
  {
    const StoredVolume volume = phantom::Stored(0);
    for (int slice = 0; slice < 3; ++slice)
    {
      phantom_dicom::Elements elements = phantom_dicom::SliceElements(volume, slice);
      elements[0x00200052] = phantom_dicom::Text("UI", frameOfReference);
      disc.Write("slice" + std::to_string(slice), phantom_dicom::FileBytes(elements));
    }
    disc.Write("segmentation",
      phantom_dicom::FileBytes(phantom_dicom::Segmentation(
        volume, { { 4, "liver" } }, { { 4, 1, std::vector<int>(20, 1) } })));
  }

  bool AwaitSegments(std::size_t count)
  {
    return QTest::qWaitFor(
      [&]
      {
        const auto& labels = this->Model()->CurrentScene().labels;
        return labels && labels->segments.size() == count;
      },
      MostMilliseconds);
  }

  QMessageBox* AwaitQuestion(const char* name)
  {
    const auto isThere = [&] { return this->window.findChild<QMessageBox*>(name) != nullptr; };
    return QTest::qWaitFor(isThere, MostMilliseconds) ? this->window.findChild<QMessageBox*>(name)
                                                      : nullptr;
  }

  static void Press(QMessageBox* box, const QString& text)
  {
    for (QAbstractButton* button : box->buttons())
    {
      if (button->text().remove('&') == text)
      {
        button->click();
        return;
      }
    }
    FAIL() << "no button " << text.toStdString();
  }

  /// Number of pixels of the 3D view that are mainly green.
  int GreenPixels()
  {
    const QImage image = this->Surface()->grabFramebuffer();
    int count = 0;
    for (int i = 0; i < image.width() * image.height(); ++i)
    {
      const QColor color = image.pixelColor(i % image.width(), i / image.width());
      count += color.green() > color.red() + 30 && color.green() > color.blue() + 30 ? 1 : 0;
    }
    return count;
  }

  bool IsGreenSoon()
  {
    return QTest::qWaitFor([this] { return this->GreenPixels() > 1000; }, MostMilliseconds);
  }
};

}

TEST_F(Segmentations, AreOpenedFromTheMenuOverTheScan)
{
  auto* const action = this->window.findChild<QAction*>("openSegmentation");
  ASSERT_TRUE(action);
  EXPECT_FALSE(action->isEnabled()) << "there is no scan yet";
  this->OpenTorso();
  ASSERT_TRUE(action->isEnabled());
  const auto scan = this->Model()->CurrentStudy();
  const Answers choose(QMessageBox::Ok, this->WriteLabels("labels.nii.gz"));
  action->trigger();
  ASSERT_TRUE(this->AwaitSegments(2));
  EXPECT_EQ(this->Model()->CurrentStudy()->volume.image, scan->volume.image);
  const auto* const panel = this->window.findChild<SegmentsPanel*>();
  EXPECT_EQ(panel->findChild<QTableWidget*>()->rowCount(), 2);
  this->Model()->History()->undo();
  EXPECT_FALSE(this->Model()->CurrentStudy()->labels);
  this->Model()->History()->redo();
  EXPECT_TRUE(this->Model()->CurrentStudy()->labels);
  this->window.close();
  EXPECT_EQ(choose.Questions(), 0) << "an opened segmentation is no work";
}

TEST_F(Segmentations, AreDrawnInTheirColoursUntilTheyAreHidden)
{
  this->OpenTorso();
  EXPECT_EQ(this->GreenPixels(), 0);
  this->Drop({ this->WriteSegmentation() });
  ASSERT_TRUE(this->AwaitSegments(2));
  EXPECT_EQ(this->Model()->CurrentScene().labels->segments[0].name, "lower half");
  EXPECT_TRUE(this->IsGreenSoon());
  this->Model()->Edit(
    ScenePart::Segments, "hide", [](Scene& scene) { scene.labels->segments[0].visible = false; });
  EXPECT_TRUE(QTest::qWaitFor([this] { return this->GreenPixels() == 0; }, MostMilliseconds));
}

TEST_F(Segmentations, AreAskedForWhenTheFileDoesNotSayThatItsValuesAreLabels)
{
  this->OpenTorso();
  this->Drop({ this->WriteLabels("labels.nrrd") });
  const QPointer<QMessageBox> first = this->AwaitQuestion("possibleSegmentation");
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->text().contains("has 2 different"));
  Press(first, "Show as segments");
  ASSERT_TRUE(this->AwaitSegments(2));

  this->Drop({ this->Path("labels.nrrd") });
  delete first.data();
  QMessageBox* const second = this->AwaitQuestion("possibleSegmentation");
  ASSERT_TRUE(second);
  Press(second, "Open as a scan");
  EXPECT_FALSE(this->Model()->CurrentScene().labels);
  EXPECT_EQ(this->Model()->CurrentStudy()->statistics.Largest(), 5.0);
}

TEST_F(Segmentations, AreNotAskedForWhenAScanIsDropped)
{
  this->OpenTorso();
  const auto before = this->Model()->CurrentStudy();
  this->Drop({ this->Path("torso.vti") });
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return this->Model()->CurrentStudy() != before; }, MostMilliseconds));
  EXPECT_FALSE(this->window.findChild<QMessageBox*>("possibleSegmentation"));
  EXPECT_FALSE(this->Model()->CurrentScene().labels);
}

TEST_F(Segmentations, OfAnotherPlaceAreRefusedInASentence)
{
  this->OpenTorso();
  const LoadedVolume torso =
    LoadVolume(FileSource{ this->Path("torso.vti").toStdString(), std::nullopt });
  LoadedVolume labels = LabelsOf(torso.image);
  labels.image->SetOrigin(5000.0, 0.0, 0.0);
  WriteVolume(labels, this->Path("far.nrrd").toStdString());
  QSignalSpy failed(this->window.Loader(), &LoadController::Failed);
  this->window.Loader()->StartLabels({ this->Path("far.nrrd").toStdString() }, 0);
  ASSERT_TRUE(failed.wait(MostMilliseconds));
  const QString reason = failed.first().first().toString();
  EXPECT_TRUE(reason.contains("far.nrrd") && reason.contains("choose")) << reason.toStdString();
  EXPECT_FALSE(this->Model()->CurrentScene().labels);
}

TEST_F(Segmentations, AreSavedInSessionsWithTheirChanges)
{
  this->OpenTorso();
  this->Drop({ this->WriteSegmentation() });
  ASSERT_TRUE(this->AwaitSegments(2));
  this->Model()->Edit(ScenePart::Segments, "change",
    [](Scene& scene)
    {
      scene.labels->segments[0].visible = false;
      scene.labels->segments[1].name = "skin";
    });
  const Answers cancel(QMessageBox::Cancel, {});
  this->window.close();
  EXPECT_EQ(cancel.Questions(), 1) << "changed segments are work";
  WriteScene(this->Model()->CurrentScene(), this->Path("session.json"));

  MainWindow later;
  later.Open(this->Path("session.json"));
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return later.Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  ASSERT_TRUE(later.Model()->CurrentScene().labels);
  const std::vector<Segment>& segments = later.Model()->CurrentScene().labels->segments;
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_FALSE(segments[0].visible);
  EXPECT_EQ(segments[0].name, "lower half");
  EXPECT_EQ(segments[1].name, "skin");
}

TEST_F(Segmentations, ThatAreGoneDoNotLoseTheScanOfASession)
{
  this->OpenTorso();
  Scene scene = this->Model()->CurrentScene();
  scene.labels = { this->Path("gone.nrrd").toStdString() };
  WriteScene(scene, this->Path("session.json"));
  MainWindow later;
  later.show();
  later.Open(this->Path("session.json"));
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return later.Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  EXPECT_FALSE(later.Model()->CurrentScene().labels);
  const auto* const bar = later.findChild<WarningBar*>();
  EXPECT_TRUE(bar->isVisible());
  bool isTold = false;
  for (const QLabel* label : bar->findChildren<QLabel*>())
  {
    isTold = isTold || label->text().contains("gone.nrrd");
  }
  EXPECT_TRUE(isTold);
}

// A folder with the slices of the phantom and a segmentation of them.
TEST_F(Segmentations, InTheFolderOfAScanAreOffered)
{
  const TemporaryFolder disc;
  WriteDisc(disc, "1.2.52");
  this->window.Open(QString::fromStdString(disc.Path("")));
  QMessageBox* const question = this->AwaitQuestion("foundSegmentation");
  ASSERT_TRUE(question);
  EXPECT_FALSE(this->window.findChild<SeriesPicker*>()) << "the scan is the only one";
  EXPECT_EQ(this->Model()->CurrentStudy()->volume.modality, "CT");
  question->button(QMessageBox::Yes)->click();
  ASSERT_TRUE(this->AwaitSegments(1));
  EXPECT_EQ(this->Model()->CurrentScene().labels->segments[0].name, "liver");
  EXPECT_EQ(this->Model()->CurrentScene().labels->series, "1.2.66");
  EXPECT_EQ(this->Model()->CurrentStudy()->segmentStatistics[0].voxels, 20);
}

TEST_F(Segmentations, OfAnotherFrameOfReferenceAreNotOffered)
{
  const TemporaryFolder disc;
  WriteDisc(disc, "1.2.53");
  this->window.Open(QString::fromStdString(disc.Path("")));
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return this->Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  EXPECT_EQ(this->Model()->CurrentStudy()->volume.modality, "CT");
  EXPECT_FALSE(this->window.findChild<QMessageBox*>("foundSegmentation"));
}

TEST_F(Segmentations, WithoutAScanAreDrawnAlone)
{
  this->window.Open(this->WriteSegmentation());
  ASSERT_TRUE(this->AwaitSegments(2));
  EXPECT_FALSE(this->window.findChild<WarningBar*>()->isVisible());
  EXPECT_TRUE(this->IsGreenSoon());
}

TEST_F(Segmentations, AreSavedWithASentenceOnWhatTheFormatLacks)
{
  this->OpenTorso();
  this->Model()->AddSegment("tumour", "new segment");
  auto* const save = this->window.findChild<QPushButton*>("saveSegmentation");
  {
    const Answers complete(QMessageBox::Ok, this->Path("tumour.seg.nrrd"));
    save->click();
    EXPECT_TRUE(QFile::exists(this->Path("tumour.seg.nrrd")));
    EXPECT_EQ(complete.Questions(), 0);
  }
  const Answers lossy(QMessageBox::Ok, this->Path("tumour.nii.gz"));
  save->click();
  EXPECT_TRUE(QFile::exists(this->Path("tumour.nii.gz")));
  EXPECT_GE(lossy.Questions(), 1) << "NIfTI has no names and colours";
}

TEST_F(Segmentations, OfAnAddedScanThatIsRemovedMeanwhileAreGivenToNoOther)
{
  this->OpenTorso();
  const QString file = this->WriteSegmentation();
  AddPet(*this->Model());
  const Answers named(QMessageBox::Ok, file);
  this->window.findChild<QPushButton*>("openSegmentation")->click();
  ASSERT_TRUE(this->window.Loader()->IsLoading());
  this->Model()->RemoveOverlay(0, "remove");
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return !this->window.Loader()->IsLoading(); }, MostMilliseconds));
  EXPECT_FALSE(this->Model()->CurrentScene().labels);
  EXPECT_FALSE(this->window.findChild<QMessageBox*>()) << "the file was read";
}
