// The list of volumes: which are shown, how and where, and whose look is edited.

#include "LabelledStudy.h"
#include "OverlaidStudy.h"
#include "Scene/Looks/Presets.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/Panels/VolumesPanel.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/SliceView.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class VolumeList : public testing::Test
{
protected:
  VolumeList()
  {
    this->model.Open(ProceduralSource{ ProceduralKind::Torso }, SmallStudy());
    this->panel.show();
    AddPet(this->model);
  }

  const std::vector<OverlaidVolume>& Overlays() { return this->model.CurrentScene().overlays; }
  QListWidget* List() { return this->panel.findChild<QListWidget*>(); }
  QDoubleSpinBox* Number(const char* name) { return this->panel.findChild<QDoubleSpinBox*>(name); }
  void Press(const char* name)
  {
    QTest::mouseClick(this->panel.findChild<QPushButton*>(name), Qt::LeftButton);
  }

  SceneModel model;
  VolumesPanel panel{ &this->model };
};

}

TEST_F(VolumeList, NamesAllVolumesAndEditsTheAddedOne)
{
  ASSERT_EQ(this->List()->count(), 2);
  EXPECT_EQ(this->List()->item(1)->text(), "PT pet");
  EXPECT_EQ(this->List()->currentRow(), 1);
  EXPECT_EQ(this->model.EditedVolume(), 1);
  EXPECT_EQ(this->model.EditedLook().name, "pet-hot");
  this->model.History()->undo();
  EXPECT_EQ(this->List()->count(), 1);
  EXPECT_EQ(this->model.EditedVolume(), 0);
  this->model.History()->redo();
  EXPECT_EQ(this->List()->count(), 2);
}

TEST_F(VolumeList, ChoosesTheVolumeWhoseLookIsEdited)
{
  const LookPanel looks(&this->model);
  const std::string first = this->model.CurrentScene().look.name;
  this->model.SetPreset(BuiltInPreset("mr-head"), "choose");
  EXPECT_EQ(this->Overlays()[0].look.name, "mr-head");
  EXPECT_EQ(this->model.CurrentScene().look.name, first);
  this->List()->setCurrentRow(0);
  this->model.SetPreset(BuiltInPreset("ct-skin"), "choose");
  EXPECT_EQ(this->Overlays()[0].look.name, "mr-head");
  EXPECT_EQ(this->model.CurrentScene().look.name, "ct-skin");
}

TEST_F(VolumeList, ShowsHidesAndRenames)
{
  this->List()->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(this->Overlays()[0].visible);
  this->List()->item(1)->setText("before therapy");
  EXPECT_EQ(this->Overlays()[0].name, "before therapy");
  this->List()->item(1)->setText("");
  EXPECT_EQ(this->List()->item(1)->text(), "pet") << "the folder of the scan";
  this->List()->item(1)->setText("");
  EXPECT_EQ(this->List()->item(1)->text(), "pet");
  this->model.History()->undo();
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_TRUE(this->Overlays()[0].visible);
  EXPECT_EQ(this->List()->item(1)->text(), "PT pet");
  EXPECT_EQ(this->List()->item(1)->checkState(), Qt::Checked);
}

TEST_F(VolumeList, OrdersAndRemoves)
{
  AddPet(this->model, "/scans/second");
  EXPECT_EQ(this->Overlays()[1].name, "PT second");
  this->Press("up");
  EXPECT_EQ(this->Overlays()[0].name, "PT second");
  EXPECT_EQ(this->List()->currentRow(), 1);
  this->Press("remove");
  ASSERT_EQ(this->Overlays().size(), 1);
  EXPECT_EQ(this->Overlays()[0].name, "PT pet");
  EXPECT_EQ(this->model.CurrentStudy()->overlays.size(), 1);
  this->model.History()->undo();
  EXPECT_EQ(this->Overlays().size(), 2);
}

// The panels that edit looks show a volume's look until they hear of another volume.
TEST_F(VolumeList, SaysThatUndoneStepsExchangeTheEditedVolume)
{
  AddPet(this->model, "/scans/second");
  this->Press("up");
  this->List()->setCurrentRow(2);
  ASSERT_EQ(this->Overlays()[1].name, "PT pet");
  int exchanges = 0;
  QObject::connect(&this->model, &SceneModel::Changed, &this->panel,
    [&](ScenePart part) { exchanges += part == ScenePart::EditedVolume; });
  this->model.History()->undo();
  EXPECT_EQ(this->Overlays()[1].name, "PT second");
  EXPECT_EQ(this->model.EditedVolume(), 2);
  EXPECT_EQ(exchanges, 1);
  this->model.Edit(
    ScenePart::Overlays, "hide", [](Scene& scene) { scene.overlays[0].visible = false; });
  EXPECT_EQ(exchanges, 1);
}

TEST_F(VolumeList, FollowsTheFirstVolumeIntoAnotherForm)
{
  this->model.Exchange(ProceduralSource{ ProceduralKind::Torso }, SmallStudy(), "rectify");
  EXPECT_EQ(this->model.CurrentStudy()->overlays.size(), 1);
  this->model.RemoveOverlay(0, "remove");
  this->model.Exchange(
    ProceduralSource{ ProceduralKind::Torso }, this->model.ExchangedStudy(), "as scanned");
  EXPECT_TRUE(this->model.CurrentStudy()->overlays.empty());
}

TEST_F(VolumeList, StaysWhenLabelsThatWereReadMeanwhileAreShown)
{
  const auto labelled = LabelledStudy(); // read before the PET was added
  this->model.Open(ProceduralSource{ ProceduralKind::Torso }, WithoutLabels(*labelled));
  AddPet(this->model);
  this->model.ShowLabels({ "labels.nrrd" }, labelled, "open a segmentation");
  EXPECT_EQ(this->model.CurrentStudy()->overlays.size(), this->Overlays().size());
}

TEST_F(VolumeList, HasRoomForFour)
{
  auto* const add = this->panel.findChild<QPushButton*>("addScan");
  QSignalSpy wanted(&this->panel, &VolumesPanel::AddWanted);
  this->Press("addScan");
  EXPECT_EQ(wanted.count(), 1);
  AddPet(this->model);
  EXPECT_TRUE(add->isEnabled());
  AddPet(this->model);
  EXPECT_FALSE(add->isEnabled());
}

TEST_F(VolumeList, MovesAndTurnsByNumbers)
{
  this->Number("move1")->setValue(-12.5);
  this->Number("turn2")->setValue(30.0);
  EXPECT_EQ(this->Overlays()[0].placement, (Placement{ { 0.0, 0.0, 30.0 }, { 0.0, -12.5, 0.0 } }));
  this->Press("resetPlace");
  EXPECT_EQ(this->Overlays()[0].placement, Placement());
  EXPECT_EQ(this->Number("move1")->value(), 0.0);
  this->model.History()->undo();
  EXPECT_EQ(this->Number("move1")->value(), -12.5);
}

TEST_F(VolumeList, ANumberLeavesTheDigitsOfTheOthers)
{
  const Placement registered = { { 1.234, 2.345, 3.456 }, { 4.567, 5.678, 6.789 } };
  this->model.Edit(ScenePart::Overlays, "register",
    [&](Scene& scene) { scene.overlays[0].placement = registered; });
  this->Number("move1")->setValue(7.0);
  Placement expected = registered;
  expected.moveMm[1] = 7.0;
  EXPECT_EQ(this->Overlays()[0].placement, expected);
}

TEST_F(VolumeList, IsNotMadeAnewForAChoice)
{
  const QSignalSpy resets(this->List()->model(), &QAbstractItemModel::modelReset);
  this->List()->setCurrentRow(0);
  EXPECT_TRUE(resets.isEmpty());
  EXPECT_EQ(this->model.EditedVolume(), 0);
}

TEST_F(VolumeList, SetsOpacityAndColoursInSlices)
{
  auto* const opacity = this->panel.findChild<NumberSlider*>()->findChild<QDoubleSpinBox*>();
  opacity->setValue(0.25);
  EXPECT_NEAR(this->Overlays()[0].opacity, 0.25, 0.01);
  auto* const colors = this->panel.findChild<QComboBox*>();
  EXPECT_EQ(colors->currentIndex(), int(SliceColors::Hot));
  colors->setFocus();
  QTest::keyClick(colors, Qt::Key_Down);
  EXPECT_EQ(this->Overlays()[0].sliceColors, SliceColors::Green);
}

TEST_F(VolumeList, TheValueAtTheCursorHasTheUptake)
{
  const double* const middle = this->model.CurrentStudy()->volume.image->GetCenter();
  const std::array<double, 3> point = { middle[0], middle[1], middle[2] };
  const auto text = [&]
  { return PointText(this->model.CurrentScene(), *this->model.CurrentStudy(), point); };
  EXPECT_TRUE(text().contains("PT pet: SUV 2")) << text().toStdString();
  this->List()->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(text().contains("SUV")) << text().toStdString();
}

TEST_F(VolumeList, MeasuresOfAPetAreUptakes)
{
  Scene scene;
  const auto pet = PetOver(this->model.CurrentStudy()->volume.image);
  const double* const middle = pet->volume.image->GetCenter();
  scene.measures = { { MeasureKind::Box,
    { { middle[0] - 9.0, middle[1] - 9.0, middle[2] - 9.0 },
      { middle[0] + 9.0, middle[1] + 9.0, middle[2] + 9.0 } } } };
  const QString text = MeasureTexts(scene, *pet).values.first();
  EXPECT_TRUE(text.startsWith("mean 2.00 ± 0.00 SUV, from 2 to 2 SUV")) << text.toStdString();
}

TEST_F(VolumeList, ABoxMeasuresAllThatAreShown)
{
  const double* const middle = this->model.CurrentStudy()->volume.image->GetCenter();
  this->model.Edit(ScenePart::Measures, "box",
    [&](Scene& scene)
    {
      scene.measures = { { MeasureKind::Box,
                           { { middle[0] - 9.0, middle[1] - 9.0, middle[2] - 9.0 },
                             { middle[0] + 9.0, middle[1] + 9.0, middle[2] + 9.0 } } },
        { MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } } };
    });
  const MeasureTexts& texts = this->model.Texts();
  const QStringList lines = texts.values[0].split('\n');
  ASSERT_EQ(lines.size(), 3);
  EXPECT_TRUE(lines[0].endsWith(" HU")) << lines[0].toStdString();
  EXPECT_EQ(lines[2], QString::fromUtf8("Volume 2 (PT): mean 2.00 ± 0.00 SUV, from 2 to 2 SUV"));
  EXPECT_EQ(texts.labels[0].section('\n', 2), QString::fromUtf8("PT: mean 2.00 ± 0.00 SUV"));
  EXPECT_EQ(texts.values[1], "5.0 mm");
  const MeasuresPanel measures(&this->model);
  const auto* const table = measures.findChild<QTableWidget*>();
  this->model.Edit(ScenePart::Overlays, "move",
    [](Scene& scene) {
      scene.overlays[0].placement.moveMm = { 500.0, 0.0, 0.0 };
    });
  EXPECT_FALSE(this->model.Texts().values[0].contains("SUV")) << "it is elsewhere now";
  this->model.History()->undo();
  EXPECT_TRUE(this->model.Texts().values[0].contains("SUV"));
  this->model.Edit(ScenePart::Measures, "measure", [](Scene& scene) { scene.measures.pop_back(); });
  EXPECT_TRUE(table->item(0, 1)->text().contains("SUV"));
  this->List()->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(table->item(0, 1)->text().contains("SUV")) << "it is hidden";
}

TEST_F(VolumeList, SlicesBlendThemOrAlternate)
{
  FusionBar bar(&this->model);
  // A quarter of the hot scale is red.
  this->model.Edit(ScenePart::Overlays, "window",
    [](Scene& scene) {
      scene.overlays[0].windowLevel = { { 4000.0, 2000.0 } };
    });
  EXPECT_TRUE(bar.isVisible());
  SliceView slice(&this->model, SlicePlane::Axial);
  slice.resize(200, 200);
  const auto redAt = [&](int x, int y)
  {
    const QColor color = slice.grab().toImage().pixelColor(x, y);
    return color.red() - color.blue();
  };
  const double pixelsPerMm =
    std::abs(slice.PlaceOf({ 10.0, 0.0, 0.0 }).x() - slice.PlaceOf({ 0.0, 0.0, 0.0 }).x()) / 10.0;
  const int beside = int(10.0 * pixelsPerMm); // off the crosshair
  EXPECT_GT(redAt(100 + beside, 100 + beside), 40);
  bar.findChild<NumberSlider*>()->findChild<QDoubleSpinBox*>()->setValue(0.0);
  EXPECT_EQ(this->model.CurrentScene().slices.fusionOpacity, 0.0);
  EXPECT_EQ(redAt(100 + beside, 100 + beside), 0);
  auto* const checkerboard = bar.findChild<QCheckBox*>();
  QTest::mouseClick(
    checkerboard, Qt::LeftButton, Qt::NoModifier, { 5, checkerboard->height() / 2 });
  EXPECT_EQ(this->model.CurrentScene().slices.fusion, SliceFusion::Checkerboard);
  int red = 0;
  const QImage picture = slice.grab().toImage();
  for (int x = 0; x < 200; ++x)
  {
    red +=
      picture.pixelColor(x, 100 + beside).red() > 100 + picture.pixelColor(x, 100 + beside).blue();
  }
  EXPECT_GT(red, 5);
  EXPECT_LT(red, int(88.0 * pixelsPerMm));
}

TEST_F(VolumeList, ExportedImagesShowThemWithoutTheirFiles)
{
  const auto draw = [&]
  {
    PictureMaker maker(
      this->model.CurrentScene(), *this->model.CurrentStudy(), { { 64, 64 }, false, false });
    return maker.Draw();
  };
  const QImage both = draw();
  const QString text = both.text("varimarch-scene");
  EXPECT_TRUE(text.contains("overlays"));
  EXPECT_FALSE(text.contains("/scans/pet")) << text.toStdString();
  EXPECT_FALSE(text.contains("PT pet")) << text.toStdString();
  this->model.RemoveOverlay(0, "remove");
  EXPECT_NE(both, draw());
}
