// The look panel shows the model, every change is an undo step, and files preserve looks.

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "SmallStudy.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

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
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "CT bone");
  EXPECT_EQ(this->Digits("Ambient")->value(), this->Shown().shading.ambient);
  EXPECT_EQ(this->Digits("Power")->value(), this->Shown().shading.specularPower);
  EXPECT_TRUE(this->Find<QGroupBox>("shading")->isChecked());
}

TEST_F(PanelOfAModel, EveryControlEditsTheModelInAStepOfItsOwn)
{
  const std::string before = LookText(this->Shown());
  this->Digits("Ambient")->setValue(0.5);
  EXPECT_EQ(this->Shown().shading.ambient, 0.5);
  this->Digits("unitDistance")->setValue(2.5);
  EXPECT_EQ(this->Shown().opacityUnitDistanceMm, 2.5);
  this->Choose("blend", "Maximum");
  EXPECT_EQ(this->Shown().blend, Blend::MaximumIntensity);
  QTest::keyClick(this->Find<QGroupBox>("shading"), Qt::Key_Space);
  EXPECT_FALSE(this->Shown().shading.enabled);
  this->Choose("presets", "CT lungs");
  EXPECT_EQ(this->Shown().opacities.size(), BuiltInPreset("ct-lung").look.opacities.size());
  EXPECT_EQ(this->model.History()->count(), 5);
  while (this->model.History()->canUndo())
  {
    this->model.History()->undo();
  }
  EXPECT_EQ(LookText(this->Shown()), before);
  EXPECT_EQ(this->Digits("Ambient")->value(), BuiltInPreset("ct-bone").look.shading.ambient);
}

TEST_F(PanelOfAModel, DampingIsUpToATenthOfTheRangePerVoxel)
{
  QDoubleSpinBox* const damping = this->Digits("damping");
  EXPECT_EQ(damping->value(), 0.0);
  EXPECT_GT(damping->maximum(), 1.0);
  damping->setValue(1.0);
  EXPECT_EQ(this->Shown().dampingGradient, 1.0);
  this->model.History()->undo();
  EXPECT_EQ(damping->value(), 0.0);
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

TEST_F(PanelOfAModel, AnEditedPresetIsLabelledAsEdited)
{
  this->Digits("Ambient")->setValue(0.5);
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "CT bone, edited");
  this->model.History()->undo();
  EXPECT_EQ(this->Find<QComboBox>("presets")->currentText(), "CT bone");
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

TEST_F(PanelOfAModel, SavedLooksLoadAsSaved)
{
  this->Digits("Ambient")->setValue(0.5);
  Look saved = this->Shown();
  saved.name = "mine";
  const QString path = this->folder.filePath("mine.json");
  this->panel.Save(path);
  this->Choose("presets", "CT lungs");
  this->panel.Load(path);
  EXPECT_EQ(LookText(this->Shown()), LookText(saved));
  EXPECT_FALSE(this->Find<QLabel>("problem")->isVisible());
  this->model.History()->undo();
  EXPECT_EQ(this->Shown().name, "ct-lung");
}

TEST_F(PanelOfAModel, SlicerPropertiesAreSavedAndLoadedByTheirExtension)
{
  const Look saved = this->Shown();
  const QString path = this->folder.filePath("bone.vp");
  this->panel.Save(path);
  this->Choose("presets", "CT lungs");
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

TEST_F(PanelOfAModel, ABlendModeShowsOnlyItsParameters)
{
  EXPECT_TRUE(this->Find<QWidget>("unitDistance")->isVisible());
  EXPECT_FALSE(this->Find<QWidget>("averagedRange")->isVisible());
  this->Choose("blend", "Average");
  EXPECT_FALSE(this->Find<QWidget>("unitDistance")->isVisible());
  EXPECT_FALSE(this->Find<QWidget>("shading")->isVisible());
  EXPECT_FALSE(this->Find<QWidget>("gradientOpacity")->isVisible());
  ASSERT_TRUE(this->Find<QWidget>("averagedRange")->isVisible());
  EXPECT_FALSE(this->Shown().averagedRange);
  this->Find<QDoubleSpinBox>("averagedFirst")->setValue(-500.0);
  ASSERT_TRUE(this->Shown().averagedRange);
  EXPECT_EQ((*this->Shown().averagedRange)[0], -500.0);
  this->model.History()->undo();
  EXPECT_FALSE(this->Shown().averagedRange);
}

TEST_F(PanelOfAModel, ChoosingIsosurfacesAddsOneAndUndoRemovesIt)
{
  this->Choose("blend", "Isosurfaces");
  EXPECT_EQ(this->Shown().blend, Blend::Isosurface);
  EXPECT_EQ(this->Shown().isosurfaces.size(), 1u);
  EXPECT_TRUE(this->Find<QWidget>("shading")->isVisible());
  this->model.History()->undo();
  EXPECT_TRUE(this->Shown().isosurfaces.empty());
}

TEST_F(PanelOfAModel, ShadingsAreChosenByNameAndRecognizedByTheirCoefficients)
{
  auto* const lights = this->Find<QComboBox>("lights");
  EXPECT_EQ(lights->currentText(), "Custom");
  this->Choose("lights", "Glossy");
  EXPECT_EQ(this->Shown().shading.specularPower, 48.0);
  EXPECT_EQ(this->Digits("Power")->value(), 48.0);
  EXPECT_EQ(lights->findText("Custom"), -1);
  this->Choose("lights", "Flat: unshaded colours");
  EXPECT_FALSE(this->Shown().shading.enabled);
  EXPECT_TRUE(lights->isEnabled()) << "the way back";
  this->Choose("lights", "Soft");
  EXPECT_TRUE(this->Find<QGroupBox>("shading")->isChecked());
  this->Digits("Ambient")->setValue(0.5);
  EXPECT_EQ(lights->currentText(), "Custom");
}

TEST_F(PanelOfAModel, AColourMapIsAppliedInOneStep)
{
  const std::vector<OpacityNode> before = this->Shown().opacities;
  this->Find<QToolButton>("colorMaps")->menu()->actions().at(1)->trigger();
  EXPECT_EQ(this->Shown().opacities.size(), before.size());
  EXPECT_EQ(this->Shown().colors.front().value, before.front().value);
  EXPECT_EQ(this->Shown().colors.back().value, before.back().value);
  EXPECT_LT(this->Shown().colors.front().rgb.r, 0.01) << "cividis begins in dark blue";
  EXPECT_EQ(this->model.History()->count(), 1);
}

TEST_F(PanelOfAModel, GradientOpacityIsInTheSceneOnlyWhileItIsOn)
{
  auto* const box = this->Find<QCheckBox>("gradientOpacity");
  ASSERT_TRUE(QTest::qWaitFor([&] { return box->isEnabled(); })) << "counted in a thread";
  EXPECT_FALSE(this->Find<QWidget>("gradientEditor")->isVisible());
  QTest::keyClick(box, Qt::Key_Space);
  ASSERT_EQ(this->Shown().gradientOpacities.size(), 2u);
  EXPECT_EQ(this->Shown().gradientOpacities[0].opacity, 0.0);
  EXPECT_GT(this->Shown().gradientOpacities[0].value, 0.0);
  auto* const editor = this->Find<TransferFunctionEditor>("gradientEditor");
  EXPECT_TRUE(editor->isVisible());
  EXPECT_TRUE(editor->Picture().statistics);
  editor->Select({ { NodeKind::Opacity, 1 } });
  QTest::keyClick(editor, Qt::Key_Down);
  EXPECT_NEAR(this->Shown().gradientOpacities[1].opacity, 0.99, 1e-9);
  const std::vector<OpacityNode> edited = this->Shown().gradientOpacities;
  QTest::keyClick(box, Qt::Key_Space);
  EXPECT_TRUE(this->Shown().gradientOpacities.empty());
  QTest::keyClick(box, Qt::Key_Space);
  ASSERT_EQ(this->Shown().gradientOpacities.size(), 2u);
  EXPECT_EQ(this->Shown().gradientOpacities[1].opacity, edited[1].opacity)
    << "the curve is remembered";
  EXPECT_EQ(this->model.History()->count(), 4);
}

TEST_F(PanelOfAModel, FilesOfOtherProgramsAreReadInUnitsOfTheVolume)
{
  const QString path = this->folder.filePath("map.json");
  std::ofstream(path.toStdString())
    << R"([ { "Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0,], "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1] } ])";
  this->panel.Load(path);
  const ImageStatistics& statistics = this->model.CurrentStudy()->statistics;
  ASSERT_EQ(this->Shown().opacities.size(), 2u);
  EXPECT_EQ(this->Shown().opacities[0].value, statistics.Smallest());
  EXPECT_EQ(this->Shown().opacities[1].value, statistics.Largest());
}
