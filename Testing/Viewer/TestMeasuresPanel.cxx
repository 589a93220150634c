// The list of measurements, and the thickness of slices.

#include "SmallStudy.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Panels/SlabBar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Measures : public testing::Test
{
protected:
  Measures()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->model.Edit(ScenePart::Measures, "measure",
      [](Scene& scene)
      {
        scene.distances = { { { 0, 0, 0 }, { 3, 4, 0 }, {} } };
        scene.angles = { { { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, "knee" } };
        scene.boxes = { { { -20, -20, -20 }, { 20, 20, 20 }, {} } };
      });
  }

  QTableWidget* Table() { return this->panel.findChild<QTableWidget*>(); }
  QString Text(int row, int column) { return this->Table()->item(row, column)->text(); }

  SceneModel model;
  MeasuresPanel panel{ &this->model };
};

}

TEST_F(Measures, AreListedWithTheirValues)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene) {
      scene.distances.push_back({ { 0, 0, 0 }, { 0, 0, 2 }, {} });
    });
  ASSERT_EQ(this->Table()->rowCount(), 4);
  EXPECT_EQ(this->Text(0, 1), "5.0 mm");
  EXPECT_EQ(this->Text(1, 1), "2.0 mm");
  EXPECT_EQ(this->Text(2, 0), "knee");
  EXPECT_EQ(this->Text(2, 1), QString::fromUtf8("90.0°"));
  EXPECT_TRUE(this->Text(3, 1).contains(" voxels")) << this->Text(3, 1).toStdString();
}

TEST_F(Measures, HaveShorterTextsForBoxesInImages)
{
  const Study& study = *this->model.CurrentStudy();
  const MeasureTexts texts(this->model.CurrentScene(), study.volume.image);
  const QStringList lines = texts.boxLabels.at(0).split('\n');
  ASSERT_EQ(lines.size(), 2);
  EXPECT_TRUE(texts.boxes.at(0).startsWith(lines[0] + ", from ")) << lines[0].toStdString();
  EXPECT_TRUE(texts.boxes.at(0).contains('\n' + lines[1] + ", ")) << lines[1].toStdString();
  EXPECT_EQ(VolumeText(999.0), QString::fromUtf8("999 mm³"));
  EXPECT_EQ(VolumeText(1234.0), "1.23 ml");
}

TEST_F(Measures, AreRenamedRemovedAndRestored)
{
  this->model.History()->undo();
  this->model.History()->redo();
  this->Table()->item(2, 0)->setText("liver");
  EXPECT_EQ(this->model.CurrentScene().boxes[0].name, "liver");
  this->Table()->setCurrentCell(1, 0);
  for (QPushButton* button : this->panel.findChildren<QPushButton*>())
  {
    if (button->text() == "Remove")
    {
      button->click();
    }
  }
  EXPECT_TRUE(this->model.CurrentScene().angles.empty());
  EXPECT_EQ(this->Table()->rowCount(), 2);
  EXPECT_EQ(this->Text(1, 0), "liver");
  this->model.History()->undo();
  EXPECT_EQ(this->Text(1, 0), "knee");
}

TEST_F(Measures, SetTheThicknessOfSlices)
{
  SlabBar bar(&this->model);
  this->model.History()->undo();
  this->model.Edit(ScenePart::Slices, "slab", [](Scene& scene) { scene.slices.slabMm = 12.0; });
  EXPECT_EQ(bar.findChild<QDoubleSpinBox*>()->value(), 12.0);
  bar.findChild<QDoubleSpinBox*>()->setValue(20.0);
  bar.findChild<QComboBox*>()->setCurrentIndex(2);
  EXPECT_EQ(this->model.CurrentScene().slices.slabMm, 20.0);
  EXPECT_EQ(this->model.CurrentScene().slices.slabBlend, SlabBlend::Mean);
  this->model.History()->undo();
  EXPECT_EQ(bar.findChild<QComboBox*>()->currentIndex(), 0);
}
