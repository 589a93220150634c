// The quality panel: its slider is the renderer's error tolerance.

#include "SmallStudy.h"
#include "Viewer/Panels/QualityPanel.h"

#include <QLabel>
#include <QSlider>

#include <gtest/gtest.h>

using namespace varimarch;

TEST(QualityPanel, SetsTheErrorAndFollowsIt)
{
  SceneModel model;
  QualityPanel panel(&model);
  model.Open(ProceduralSource(), SmallStudy());
  auto* const slider = panel.findChild<QSlider*>();
  slider->setValue(slider->maximum());
  EXPECT_DOUBLE_EQ(model.CurrentScene().render.errorTolerance, 1.0 / 255.0);
  slider->setValue(0);
  EXPECT_DOUBLE_EQ(model.CurrentScene().render.errorTolerance, 1.0 / 8.0);
  model.History()->undo();
  EXPECT_EQ(slider->value(), slider->maximum());
}
