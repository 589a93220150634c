// The panel of the look: it shows the model, every change of it is a step, and files lose nothing.

#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

using namespace varimarch;

namespace
{

class PanelOfAModel : public testing::Test
{
protected:
  PanelOfAModel()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->panel.show();
  }

  const Look& Shown() const { return this->model.CurrentScene().look; }

  template <class Widget>
  Widget* Find(const char* name) const
  {
    return this->panel.findChild<Widget*>(name);
  }

  QDoubleSpinBox* Digits(const char* name) const
  {
    return this->Find<QWidget>(name)->findChild<QDoubleSpinBox*>();
  }

  void Choose(const char* list, const QString& text) const
  {
    auto* const box = this->Find<QComboBox>(list);
    box->setCurrentText(text);
    emit box->activated(box->currentIndex());
  }

  SceneModel model;
  LookPanel panel{ &this->model };
  QTemporaryDir folder;
};

}

TEST_F(PanelOfAModel, ShowsTheModel)
{
  const auto* const editor = this->Find<TransferFunctionEditor>("transferFunctionEditor");
  EXPECT_TRUE(SameCurves(editor->Picture().look, this->Shown()));
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "ct-bone");
  EXPECT_EQ(this->Digits("Ambient")->value(), this->Shown().shading.ambient);
  EXPECT_EQ(this->Digits("Power")->value(), this->Shown().shading.specularPower);
  EXPECT_TRUE(this->Find<QGroupBox>("shading")->isChecked());
}

TEST_F(PanelOfAModel, EveryControlEditsTheModelInAStepOfItsOwn)
{
  this->Digits("Ambient")->setValue(0.5);
  EXPECT_EQ(this->Shown().shading.ambient, 0.5);
  this->Digits("unitDistance")->setValue(2.5);
  EXPECT_EQ(this->Shown().opacityUnitDistanceMm, 2.5);
  this->Choose("blend", "maximum");
  EXPECT_EQ(this->Shown().blend, Blend::MaximumIntensity);
  QTest::keyClick(this->Find<QGroupBox>("shading"), Qt::Key_Space);
  EXPECT_FALSE(this->Shown().shading.enabled);
  this->Choose("presets", "ct-lung");
  EXPECT_EQ(this->Shown().opacities.size(), Preset("ct-lung").opacities.size());
  EXPECT_EQ(this->model.History()->count(), 5);
  while (this->model.History()->canUndo())
  {
    this->model.History()->undo();
  }
  EXPECT_EQ(LookText(this->Shown()), LookText(Preset("ct-bone")));
  EXPECT_EQ(this->Digits("Ambient")->value(), Preset("ct-bone").shading.ambient);
}

TEST_F(PanelOfAModel, ASliderThatIsDraggedIsOneStep)
{
  auto* const slider = this->Find<QWidget>("Diffuse")->findChild<QSlider*>();
  slider->setSliderDown(true);
  slider->setSliderPosition(100);
  slider->setSliderPosition(250);
  slider->setSliderDown(false);
  EXPECT_EQ(this->Shown().shading.diffuse, 0.5);
  EXPECT_EQ(this->model.History()->count(), 1);
}

TEST_F(PanelOfAModel, APresetThatWasEditedIsNoLongerCalledSo)
{
  this->Digits("Ambient")->setValue(0.5);
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "ct-bone, edited");
  this->model.History()->undo();
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "ct-bone");
}

TEST_F(PanelOfAModel, AnEditOfTheCurveReachesTheModel)
{
  auto* const editor = this->Find<TransferFunctionEditor>("transferFunctionEditor");
  editor->Select({ { NodeKind::Opacity, 1 } });
  QTest::keyClick(editor, Qt::Key_Right);
  EXPECT_EQ(this->Shown().opacities[1].value, 301.0);
  this->model.History()->undo();
  EXPECT_EQ(editor->Picture().look.opacities[1].value, 300.0);
}

TEST_F(PanelOfAModel, WhatIsSavedIsWhatIsLoaded)
{
  this->Digits("Ambient")->setValue(0.5);
  Look saved = this->Shown();
  saved.name = "mine";
  const QString path = this->folder.filePath("mine.json");
  this->panel.Save(path);
  this->Choose("presets", "ct-lung");
  this->panel.Load(path);
  EXPECT_EQ(LookText(this->Shown()), LookText(saved));
  EXPECT_FALSE(this->Find<QLabel>("problem")->isVisible());
  this->model.History()->undo();
  EXPECT_EQ(this->Shown().name, "ct-lung");
}

TEST_F(PanelOfAModel, ASlicerPropertyIsWrittenAndReadByItsName)
{
  const Look saved = this->Shown();
  const QString path = this->folder.filePath("bone.vp");
  this->panel.Save(path);
  this->Choose("presets", "ct-lung");
  this->panel.Load(path);
  EXPECT_EQ(this->Shown().name, "bone");
  EXPECT_TRUE(SameCurves(this->Shown(), saved));
}

TEST_F(PanelOfAModel, ABadFileIsExplainedAndChangesNothing)
{
  const QString path = this->folder.filePath("bad.json");
  std::ofstream(path.toStdString()) << R"({ "colors": [], "opacities": 3 })";
  const std::string before = LookText(this->Shown());
  for (const QString& bad : { path, this->folder.filePath("missing.json") })
  {
    this->panel.Load(bad);
    EXPECT_TRUE(this->Find<QLabel>("problem")->isVisible());
    EXPECT_TRUE(this->Find<QLabel>("problem")->text().contains(bad));
  }
  this->panel.Save(this->folder.filePath("missing/mine.json"));
  EXPECT_TRUE(this->Find<QLabel>("problem")->text().contains("missing/mine"));
  EXPECT_EQ(LookText(this->Shown()), before);
  EXPECT_EQ(this->model.History()->count(), 0);
}
