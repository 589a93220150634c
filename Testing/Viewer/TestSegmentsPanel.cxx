// The list of segments: every change is an undo step, and the table has the values of the scan.

#include "Answers.h"
#include "LabelledStudy.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Panels/SegmentsPanel.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/SliceView.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class SegmentList : public testing::Test
{
protected:
  SegmentList()
  {
    this->model.Open(ProceduralSource{ ProceduralKind::Torso }, SmallStudy());
    this->model.ShowLabels({ "/scans/labels.nrrd" }, LabelledStudy(), "open a segmentation");
    this->panel.show();
  }

  const std::vector<Segment>& Segments() { return this->model.CurrentScene().labels->segments; }
  QTableWidget* Table() { return this->panel.findChild<QTableWidget*>(); }
  QTableWidgetItem* Item(int row, int column) { return this->Table()->item(row, column); }
  QString Text(int row, int column) { return this->Item(row, column)->text(); }
  QPushButton* Button(const char* name) { return this->panel.findChild<QPushButton*>(name); }
  QLabel* Note() { return this->panel.findChild<QLabel*>("note"); }

  SceneModel model;
  SegmentsPanel panel{ &this->model };
};

}

TEST_F(SegmentList, HasNamesColoursAndTheValuesOfTheScan)
{
  ASSERT_EQ(this->Table()->rowCount(), 2);
  EXPECT_EQ(this->Text(0, 0), "Label 3");
  EXPECT_EQ(this->Item(0, 0)->checkState(), Qt::Checked);
  const QColor swatch = this->Item(1, 0)->icon().pixmap(14, 14).toImage().pixelColor(7, 7);
  EXPECT_NEAR(swatch.redF(), this->Segments()[1].rgb.r, 0.01);
  EXPECT_NEAR(swatch.blueF(), this->Segments()[1].rgb.b, 0.01);

  const Study& study = *this->model.CurrentStudy();
  const double* const spacing = study.volume.image->GetSpacing();
  const double ml = 32 * 28 * 10 * spacing[0] * spacing[1] * spacing[2] / 1000.0;
  EXPECT_EQ(this->Text(0, 1), NumberText(ml, ml < 100.0 ? 2 : 0));
  double sum = 0.0;
  double largest = -1e9;
  for (int x = 0; x < 32; ++x)
  {
    for (int z = 10; z < 20; ++z)
    {
      const double value = study.volume.image->GetScalarComponentAsDouble(x, 0, z, 0);
      sum += value;
      largest = std::max(largest, value);
    }
  }
  EXPECT_EQ(this->Text(1, 2), NumberText(sum / 320.0, 1));
  EXPECT_EQ(this->Text(1, 4), NumberText(largest, 0));
  EXPECT_TRUE(this->Table()->horizontalHeaderItem(2)->text().contains("HU"));
}

TEST_F(SegmentList, ShowsHidesAndRenamesSegmentsInStepsThatCanBeUndone)
{
  this->Item(0, 0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(this->Segments()[0].visible);
  EXPECT_TRUE(this->Segments()[1].visible);
  this->Item(1, 0)->setText("skin");
  EXPECT_EQ(this->Segments()[1].name, "skin");
  EXPECT_FALSE(this->Segments()[0].visible);
  this->Button("showAll")->click();
  EXPECT_EQ(this->Item(0, 0)->checkState(), Qt::Checked);
  this->Button("hideAll")->click();
  EXPECT_EQ(this->Item(1, 0)->checkState(), Qt::Unchecked);
  QUndoStack* const history = this->model.History();
  history->undo();
  history->undo();
  EXPECT_EQ(this->Item(0, 0)->checkState(), Qt::Unchecked);
  history->undo();
  EXPECT_EQ(this->Text(1, 0), "Label 5");
  history->undo();
  EXPECT_EQ(this->Item(0, 0)->checkState(), Qt::Checked);
}

TEST_F(SegmentList, ChangesTheOpacityOfTheSelectedSegments)
{
  auto* const number = this->panel.findChild<QDoubleSpinBox*>();
  EXPECT_EQ(number->value(), 1.0);
  this->Table()->selectRow(1);
  number->setValue(0.25);
  EXPECT_EQ(this->Segments()[0].opacity, 1.0);
  EXPECT_EQ(this->Segments()[1].opacity, 0.25);
  this->Table()->selectAll();
  number->setValue(0.5);
  EXPECT_EQ(this->Segments()[0].opacity, 0.5);
  EXPECT_EQ(this->Segments()[1].opacity, 0.5);
  this->model.History()->undo();
  EXPECT_EQ(this->Segments()[1].opacity, 0.25);
}

TEST_F(SegmentList, ChangesAColourAndKeepsTheOldOneIfTheDialogIsCancelled)
{
  const glm::dvec3 before = this->Segments()[1].rgb;
  this->Table()->selectRow(1);
  this->Button("color")->click();
  auto* dialog = this->panel.findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setCurrentColor(Qt::green);
  EXPECT_EQ(this->Segments()[1].rgb, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_NE(this->Segments()[0].rgb, glm::dvec3(0.0, 1.0, 0.0));
  dialog->reject();
  EXPECT_EQ(this->Segments()[1].rgb, before);
}

TEST_F(SegmentList, SavesTheStatisticsAsATable)
{
  const QTemporaryDir folder;
  const Answers save(QMessageBox::Ok, folder.filePath("segments"));
  QSignalSpy saved(&this->panel, &SegmentsPanel::Saved);
  this->Button("saveStatistics")->click();
  ASSERT_EQ(saved.count(), 1);
  EXPECT_EQ(saved.first().first().toString(), folder.filePath("segments.csv"));
  QFile file(folder.filePath("segments.csv"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[1].startsWith("3,\"Label 3\",8960,")) << lines[1].toStdString();
}

TEST_F(SegmentList, IsEmptyAfterTheSegmentationIsClosed)
{
  this->Button("closeSegmentation")->click();
  EXPECT_FALSE(this->model.CurrentScene().labels);
  EXPECT_FALSE(this->model.CurrentStudy()->labels);
  EXPECT_FALSE(this->Table()->isVisible());
  EXPECT_TRUE(this->Button("openSegmentation")->isVisible());
  this->model.History()->undo();
  EXPECT_TRUE(this->model.CurrentStudy()->labels);
  EXPECT_EQ(this->Text(0, 0), "Label 3");
  EXPECT_TRUE(this->Table()->isVisible());
}

TEST_F(SegmentList, SaysWhyTheVolumeShowsNoSegments)
{
  EXPECT_FALSE(this->Note()->isVisible());
  this->model.Edit(
    ScenePart::Look, "maximum", [](Scene& scene) { scene.look.blend = Blend::MaximumIntensity; });
  EXPECT_TRUE(this->Note()->isVisible());
  EXPECT_TRUE(this->Note()->text().contains("Composite"));
}

TEST_F(SegmentList, ColoursSlicesAndExportedImages)
{
  const auto green = [](const QImage& image)
  {
    int count = 0;
    for (int i = 0; i < image.width() * image.height(); ++i)
    {
      const QColor color = image.pixelColor(i % image.width(), i / image.width());
      count += color.green() > color.red() + 20 && color.green() > color.blue() + 20 ? 1 : 0;
    }
    return count;
  };
  SliceView slice(&this->model, SlicePlane::Coronal);
  slice.resize(200, 160);
  const auto exported = [this]
  {
    return PictureMaker(
      this->model.CurrentScene(), *this->model.CurrentStudy(), { { 80, 60 }, false, false })
      .Draw();
  };
  this->Button("hideAll")->click();
  EXPECT_EQ(green(exported()), 0);
  // The crosshair and its colour cross the whole slice.
  const int before = green(slice.grab().toImage());
  this->model.Edit(ScenePart::Segments, "green",
    [](Scene& scene)
    {
      scene.labels->segments[0].visible = true;
      scene.labels->segments[0].rgb = { 0.0, 1.0, 0.0 };
    });
  EXPECT_GT(green(slice.grab().toImage()), before + 2000);
  EXPECT_GT(green(exported()), 300);
}
