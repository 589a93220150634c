// Views that are marked for the report.

#include "Module/Files/PhantomFiles.h"
#include "ScanOfTimes.h"
#include "Scene/Json/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Reports/ScanReport.h"

#include <QFile>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class KeyImages : public testing::Test
{
protected:
  KeyImages()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->SetSlab(7.0);
    this->box.Mark(KeyView::Coronal);
    this->SetSlab(2.0);
  }

  void SetSlab(double slabMm)
  {
    this->model.Edit(
      ScenePart::Slices, "slab", [&](Scene& scene) { scene.slices.slabMm = slabMm; });
  }

  void Press(const QString& text)
  {
    for (QPushButton* const button : this->box.findChildren<QPushButton*>())
    {
      if (button->text() == text)
      {
        button->click();
      }
    }
  }

  qint64 ReportBytes()
  {
    const QTemporaryDir folder;
    const QString path = folder.filePath("report.pdf");
    WriteScanReport(&this->model, path);
    return QFile(path).size();
  }

  QListWidget* List() { return this->box.findChild<QListWidget*>(); }
  const std::vector<KeyImage>& All() const { return this->model.CurrentScene().keyImages; }

  SceneModel model;
  KeyImagesBox box{ &this->model };
};

}

TEST_F(KeyImages, AreListedRenamedGoneToAndRemoved)
{
  ASSERT_EQ(this->List()->count(), 1);
  EXPECT_EQ(this->List()->item(0)->text(), "Coronal slice");
  this->List()->item(0)->setText("stenosis");
  EXPECT_EQ(this->All()[0].name, "stenosis");
  this->Press("Go to");
  EXPECT_EQ(this->model.CurrentScene().slices.slabMm, 7.0) << "as it was when it was marked";
  this->box.Mark(KeyView::Volume);
  EXPECT_EQ(this->List()->currentRow(), 1);
  this->List()->setCurrentRow(0);
  this->Press("Remove");
  ASSERT_EQ(this->All().size(), 1);
  EXPECT_EQ(this->All()[0].view, KeyView::Volume);
  this->model.History()->undo();
  EXPECT_EQ(this->List()->item(0)->text(), "stenosis");
}

TEST_F(KeyImages, AreKeptInSessions)
{
  const Scene back = SceneFromText(SceneText(this->model.CurrentScene()), "test");
  ASSERT_EQ(back.keyImages.size(), 1);
  EXPECT_EQ(back.keyImages[0].view, KeyView::Coronal);
  EXPECT_EQ(back.keyImages[0].slices.slabMm, 7.0);
}

TEST_F(KeyImages, AreInTheReport)
{
  this->List()->item(0)->setText("DOE");
  const QString html = ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy());
  EXPECT_TRUE(html.contains("<img src='key-image-1'"));
  EXPECT_FALSE(html.contains("DOE"));
  const qint64 withImage = this->ReportBytes();
  this->Press("Remove");
  EXPECT_LT(this->ReportBytes(), withImage - 2000) << "the image itself";
}

namespace
{

// Key images of a scan with several times.
class KeyImagesOfTimes : public KeyImages
{
protected:
  KeyImagesOfTimes()
  {
    this->files.Write("times.nrrd", NrrdOfTimes());
    const FileSource source = { this->files.Path("times.nrrd"), std::nullopt };
    LoadedVolume volume = LoadVolume(source);
    ImageStatistics statistics(volume.image);
    this->model.Open(
      source, std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) }));
    this->ShowTime(4);
    this->box.Mark(KeyView::Axial);
    this->ShowTime(1);
  }

  void ShowTime(int time)
  {
    const FileSource source = { this->files.Path("times.nrrd"), std::nullopt };
    this->model.ShowTime(TimeReader(source).Read(time, {}));
  }

  TemporaryFolder files;
};

}

TEST_F(KeyImagesOfTimes, GoToTheirTimeAndViewInOneStep)
{
  ASSERT_EQ(this->All().back().time, 4);
  EXPECT_EQ(this->List()->item(0)->toolTip(), "0.20 s, 5 of 6");
  this->SetSlab(5.0);
  const int steps = this->model.History()->count();
  this->Press("Go to");
  EXPECT_EQ(this->model.ChosenTime(), 4);
  EXPECT_EQ(this->model.CurrentScene().slices.slabMm, 0.0);
  EXPECT_EQ(this->model.History()->count(), steps + 1);
  this->model.History()->undo();
  EXPECT_EQ(this->model.ChosenTime(), 1);
  EXPECT_EQ(this->model.CurrentScene().slices.slabMm, 5.0);
}

TEST_F(KeyImagesOfTimes, KeepTheirTimeInSessions)
{
  const Scene back = SceneFromText(SceneText(this->model.CurrentScene()), "test");
  EXPECT_EQ(back.keyImages.back().time, 4);
}

TEST_F(KeyImagesOfTimes, AreReadForTheReportAtTheirTime)
{
  EXPECT_TRUE(ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy())
                .contains("Axial slice, 0.20 s, 5 of 6<br>"));
  EXPECT_GT(this->ReportBytes(), 0);
  this->files.Write("times.nrrd", NrrdOfTimes().substr(0, 1000));
  EXPECT_THROW(this->ReportBytes(), std::runtime_error) << "the time is in the file only";
}

// A session may have been edited, or its scan exchanged.
TEST_F(KeyImagesOfTimes, LeaveATimeThatTheScanDoesNotHave)
{
  this->model.Edit(
    ScenePart::KeyImages, "edit", [](Scene& scene) { scene.keyImages.back().time = 6; });
  this->Press("Go to");
  EXPECT_EQ(this->model.ChosenTime(), 1);
  EXPECT_GT(this->ReportBytes(), 0);
}

TEST_F(KeyImages, DoNotShowTheNamesOfMeasurementsInTheReport)
{
  const auto bytesWithName = [this](const std::string& name)
  {
    this->model.Edit(ScenePart::Measures, "measure",
      [&](Scene& scene)
      {
        scene.slices.crosshairMm = { { 0.0, 0.0, 0.0 } };
        scene.measures = { { MeasureKind::Distance, { { -40, 0, 0 }, { 40, 0, 0 } }, name } };
      });
    return double(this->ReportBytes());
  };
  EXPECT_NEAR(bytesWithName(std::string(25, 'W')), bytesWithName(""), 500.0);
}
