// The panel of the lights: adds, places, colours and removes them, each in a step of its own.

#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/SceneLights.h"
#include "SmallStudy.h"
#include "Viewer/Panels/LightsPanel.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class LightsOfAModel : public testing::Test
{
protected:
  LightsOfAModel()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->panel.show();
  }

  const std::vector<SceneLight>& Lights() const { return this->model.CurrentScene().lights; }

  template <class Widget>
  Widget* Find(const char* name) const
  {
    return this->panel.findChild<Widget*>(name);
  }

  QDoubleSpinBox* Digits(const char* name) const
  {
    return this->Find<QWidget>(name)->findChild<QDoubleSpinBox*>();
  }

  void Add(int kind) const
  {
    this->Find<QToolButton>("addLight")->menu()->actions().at(kind)->trigger();
  }

  QListWidget* List() const { return this->Find<QListWidget>("lightsList"); }

  SceneModel model;
  LightsPanel panel{ &this->model };
};

}

TEST_F(LightsOfAModel, ASceneWithoutLightsHasThatAtTheEyeWhichStays)
{
  EXPECT_TRUE(this->Lights().empty());
  ASSERT_EQ(this->List()->count(), 1);
  EXPECT_FALSE(this->Find<QPushButton>("removeLight")->isEnabled());
  EXPECT_FALSE(this->Find<QWidget>("lightAzimuth")->isVisible());
  this->Add(1);
  ASSERT_EQ(this->Lights().size(), 2u);
  EXPECT_EQ(this->Lights()[0].kind, LightKind::Head);
  EXPECT_EQ(this->Lights()[1].kind, LightKind::Camera);
  EXPECT_EQ(this->List()->currentRow(), 1) << "the new one is selected";
  this->model.History()->undo();
  EXPECT_TRUE(this->Lights().empty());
}

TEST_F(LightsOfAModel, AnglesTurnALight)
{
  this->Add(1);
  EXPECT_FALSE(this->Find<QWidget>("lightPosition")->isVisible());
  EXPECT_NEAR(this->Digits("lightAzimuth")->value(), 45.0, 1e-6);
  this->Digits("lightAzimuth")->setValue(-90.0);
  this->Digits("lightElevation")->setValue(0.0);
  EXPECT_NEAR(this->Lights()[1].direction[0], -1.0, 1e-9) << "from the left of the image";
  EXPECT_NEAR(this->Lights()[1].direction[1], 0.0, 1e-9);
  EXPECT_EQ(this->model.History()->count(), 3);
  auto* const slider = this->Find<QWidget>("lightElevation")->findChild<QSlider*>();
  slider->setSliderDown(true);
  slider->setSliderPosition(400);
  slider->setSliderPosition(450);
  slider->setSliderDown(false);
  EXPECT_EQ(this->model.History()->count(), 4) << "a drag is one step";
}

TEST_F(LightsOfAModel, APointMovesByNumbersAndToTheCrosshair)
{
  this->Add(3);
  ASSERT_TRUE(this->Find<QWidget>("lightPosition")->isVisible());
  EXPECT_EQ(this->Lights()[1].positionMm, MiddleOf(this->model.CurrentStudy()->volume.image));
  this->Digits("lightPosition")->setValue(12.5);
  EXPECT_EQ(this->Lights()[1].positionMm[0], 12.5);
  this->model.Edit(ScenePart::Slices, "crosshair",
    [](Scene& scene) {
      scene.slices.crosshairMm = { { 1.0, 2.0, 3.0 } };
    });
  QTest::mouseClick(this->Find<QPushButton>("lightToCrosshair"), Qt::LeftButton);
  EXPECT_EQ(this->Lights()[1].positionMm, (std::array{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(this->Digits("lightPosition")->value(), 1.0);
}

TEST_F(LightsOfAModel, ColourAndIntensityAreThoseOfTheSelectedLight)
{
  this->Add(2);
  this->List()->setCurrentRow(0);
  this->Digits("lightIntensity")->setValue(0.5);
  EXPECT_EQ(this->Lights()[0].intensity, 0.5);
  EXPECT_EQ(this->Lights()[1].intensity, 1.0);
  QTest::mouseClick(this->Find<QPushButton>("lightColor"), Qt::LeftButton);
  auto* const dialog = this->panel.findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setCurrentColor(Qt::red);
  EXPECT_EQ(this->Lights()[0].rgb, (std::array{ 1.0, 0.0, 0.0 })) << "while it is chosen";
  dialog->reject();
  EXPECT_EQ(this->Lights()[0].rgb, (std::array{ 1.0, 1.0, 1.0 }));
}

TEST_F(LightsOfAModel, TheSelectedLightIsRemoved)
{
  this->Add(1);
  this->List()->setCurrentRow(0);
  QTest::mouseClick(this->Find<QPushButton>("removeLight"), Qt::LeftButton);
  ASSERT_EQ(this->Lights().size(), 1u);
  EXPECT_EQ(this->Lights()[0].kind, LightKind::Camera);
  EXPECT_FALSE(this->Find<QPushButton>("removeLight")->isEnabled());
}

TEST_F(LightsOfAModel, ShadowsAreAStepThatIsUndone)
{
  EXPECT_EQ(this->Digits("shadows")->value(), 0.0);
  this->Digits("shadows")->setValue(0.6);
  EXPECT_EQ(this->model.CurrentScene().shadows, 0.6);
  EXPECT_TRUE(this->Lights().empty()) << "lights stay";
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().shadows, 0.0);
  EXPECT_EQ(this->Digits("shadows")->value(), 0.0);
}

TEST_F(LightsOfAModel, SoftnessIsThatOfALightThatIsNotAtTheEye)
{
  EXPECT_FALSE(this->Digits("lightSoftness")->isVisibleTo(&this->panel));
  this->model.Edit(ScenePart::Lights, "a light",
    [](Scene& scene) { scene.lights = { SceneLight{ LightKind::Directional } }; });
  EXPECT_TRUE(this->Digits("lightSoftness")->isVisibleTo(&this->panel));
  this->Digits("lightSoftness")->setValue(15.0);
  EXPECT_EQ(this->model.CurrentScene().lights[0].softnessDegrees, 15.0);
  this->model.History()->undo();
  EXPECT_EQ(this->Digits("lightSoftness")->value(), 0.0);
}

TEST_F(LightsOfAModel, TheLightOfThePresetReplacesAllAndIsUndone)
{
  auto* const suited = this->panel.findChild<QPushButton*>("suitedLight");
  this->model.Edit(ScenePart::Look, "a look", [](Scene& scene) { scene.look.name = "mine"; });
  EXPECT_FALSE(suited->isEnabled());
  this->model.Edit(
    ScenePart::Look, "a preset", [](Scene& scene) { scene.look = BuiltInPreset("ct-bone").look; });
  ASSERT_TRUE(suited->isEnabled());
  suited->click();
  EXPECT_EQ(this->model.CurrentScene().lights.size(), 2u);
  EXPECT_EQ(this->model.CurrentScene().shadows, 1.0);
  this->model.History()->undo();
  EXPECT_TRUE(this->model.CurrentScene().lights.empty());
}

TEST_F(LightsOfAModel, ScatteringIsAStepThatIsUndone)
{
  this->Digits("scattering")->setValue(0.5);
  this->Digits("anisotropy")->setValue(-0.25);
  this->Digits("scatteringReach")->setValue(0.75);
  EXPECT_EQ(this->model.CurrentScene().scattering, (Scattering{ 0.5, -0.25, 0.75 }));
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().scattering, (Scattering{ 0.5, -0.25, 0.0 }));
  EXPECT_EQ(this->Digits("scatteringReach")->value(), 0.0);
}

TEST_F(LightsOfAModel, OcclusionIsAStepThatIsUndone)
{
  this->Digits("occlusion")->setValue(0.5);
  this->Digits("occlusionReach")->setValue(20.0);
  EXPECT_EQ(this->model.CurrentScene().occlusion, (Occlusion{ 0.5, 20.0 }));
  EXPECT_TRUE(this->Lights().empty()) << "lights stay";
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().occlusion, (Occlusion{ 0.5, 0.0 }));
  EXPECT_EQ(this->Digits("occlusionReach")->value(), 0.0);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().occlusion, Occlusion());
  EXPECT_EQ(this->Digits("occlusion")->value(), 0.0);
}
