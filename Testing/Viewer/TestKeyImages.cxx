// Views that are marked for the report.

#include "Scene/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/Panels/KeyImagesBox.h"
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
