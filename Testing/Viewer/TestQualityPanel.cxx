// The quality panel: its slider is the renderer's error tolerance.

#include "SmallStudy.h"
#include "Viewer/Panels/QualityPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

TEST(QualityPanel, SetsTheErrorAndFollowsIt)
{
  SceneModel model;
  QualityPanel panel(&model);
  model.Open(ProceduralSource(), SmallStudy());
  auto* const slider = panel.findChild<QSlider*>("error");
  slider->setValue(slider->maximum());
  EXPECT_DOUBLE_EQ(model.CurrentScene().render.errorTolerance, 1.0 / 255.0);
  slider->setValue(0);
  EXPECT_DOUBLE_EQ(model.CurrentScene().render.errorTolerance, 1.0 / 8.0);
  model.History()->undo();
  EXPECT_EQ(slider->value(), slider->maximum());
}

TEST(QualityPanel, RaysHaveAnEndOfTheirOwnOnlyWithoutAPromise)
{
  SceneModel model;
  QualityPanel panel(&model);
  panel.show();
  model.Open(ProceduralSource(), SmallStudy());
  auto* const promises = panel.findChild<QCheckBox*>("promises");
  auto* const end = panel.findChild<QWidget*>("end");
  EXPECT_FALSE(end->isVisible());
  QTest::keyClick(promises, Qt::Key_Space);
  EXPECT_EQ(model.CurrentScene().render.errorTolerance, 0.0);
  EXPECT_FALSE(panel.findChild<QSlider*>("error")->isEnabled());
  ASSERT_TRUE(end->isVisible());
  end->findChild<QDoubleSpinBox*>()->setValue(0.25);
  EXPECT_EQ(model.CurrentScene().render.earlyTerminationTransmittance, 0.25);
  QTest::keyClick(promises, Qt::Key_Space);
  EXPECT_EQ(model.CurrentScene().render.errorTolerance, 1.0 / 64.0);
  EXPECT_EQ(model.History()->count(), 3);
  model.History()->undo();
  EXPECT_FALSE(promises->isChecked());
}

TEST(QualityPanel, RefinesOnlyVolumesInTheirFile)
{
  for (const bool isOnDisk : { false, true })
  {
    SceneModel model;
    QualityPanel panel(&model);
    panel.show();
    const auto study = std::make_shared<Study>(*SmallStudy());
    study->volume.isOnDisk = isOnDisk;
    model.Open(ProceduralSource(), study);
    auto* const refined = panel.findChild<QCheckBox*>("refined");
    EXPECT_EQ(refined->isVisible(), isOnDisk);
    refined->setVisible(true); // for the key
    QTest::keyClick(refined, Qt::Key_Space);
    EXPECT_EQ(model.CurrentScene().render.level, VolumeLevel::Refined);
    model.History()->undo();
    EXPECT_FALSE(refined->isChecked());
  }
}

TEST(QualityPanel, ChoosesInterpolationAndJitter)
{
  SceneModel model;
  QualityPanel panel(&model);
  model.Open(ProceduralSource(), SmallStudy());
  auto* const list = panel.findChild<QComboBox*>("interpolation");
  EXPECT_EQ(list->currentText(), "Linear");
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(model.CurrentScene().render.interpolation, Interpolation::Cubic);
  QTest::keyClick(panel.findChild<QCheckBox*>("jitter"), Qt::Key_Space);
  EXPECT_TRUE(model.CurrentScene().render.jitter);
  model.History()->undo();
  model.History()->undo();
  EXPECT_EQ(list->currentText(), "Linear");
  EXPECT_FALSE(panel.findChild<QCheckBox*>("jitter")->isChecked());
}
