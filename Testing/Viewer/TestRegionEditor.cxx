// The editor of regions, operated by mouse and keyboard as a user does, on a model with undo.

#include "SmallStudy.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/RegionEditor/RegionEditor.h"
#include "Waiting.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class RegionsOfAModel : public testing::Test
{
protected:
  RegionsOfAModel()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->panel.resize(500, 1000);
    this->panel.show();
    this->isOn = this->panel.findChild<QCheckBox*>("regions");
    this->editor = this->panel.findChild<RegionEditor*>();
  }

  void SwitchOn()
  {
    ASSERT_TRUE(QTest::qWaitFor([&] { return this->isOn->isEnabled(); }, MostMilliseconds))
      << "counted in a thread";
    QTest::keyClick(this->isOn, Qt::Key_Space);
    ASSERT_EQ(this->Regions().size(), 1u);
    QTest::qWait(50); // until the editor has its place
  }

  const std::vector<LookRegion>& Regions() const { return this->model.CurrentScene().look.regions; }
  QRectF Rect(int region) const
  {
    return this->editor->Picture().layout.RectOf(this->Regions()[std::size_t(region)]);
  }

  void Drag(const QPointF& from, const QPointF& way)
  {
    QTest::mousePress(this->editor, Qt::LeftButton, {}, from.toPoint());
    this->MoveTo(from + 0.5 * way);
    this->MoveTo(from + way);
    QTest::mouseRelease(this->editor, Qt::LeftButton, {}, (from + way).toPoint());
  }

  void MoveTo(const QPointF& at)
  {
    QMouseEvent event(QEvent::MouseMove, at.toPoint(), this->editor->mapToGlobal(at.toPoint()),
      Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(this->editor, &event);
  }

  void Key(int key, Qt::KeyboardModifiers modifiers = {})
  {
    QTest::keyClick(this->editor, Qt::Key(key), modifiers);
  }

  QDoubleSpinBox* Digits(const char* name) const
  {
    return this->panel.findChild<QWidget*>(name)->findChild<QDoubleSpinBox*>();
  }

  // Replaces the first region by a small one in the middle of the plane.
  void MakeSmall()
  {
    this->SwitchOn();
    const ValueGradientHistogram& histogram = *this->editor->Picture().histogram;
    const double width = histogram.values[1] - histogram.values[0];
    Look look = this->model.CurrentScene().look;
    look.regions[0].values = { histogram.values[0] + 0.4 * width,
      histogram.values[0] + 0.6 * width };
    look.regions[0].gradients = { 0.4 * histogram.largestGradient,
      0.6 * histogram.largestGradient };
    this->model.SetLook(look, "small");
    this->model.History()->clear();
  }

  int Steps() { return this->model.History()->count(); }

  SceneModel model;
  LookPanel panel{ &this->model };
  QCheckBox* isOn;
  RegionEditor* editor;
};

}

TEST_F(RegionsOfAModel, AreInTheSceneOnlyWhileTheyAreOn)
{
  EXPECT_FALSE(this->editor->isVisible());
  this->SwitchOn();
  EXPECT_TRUE(this->editor->isVisible());
  EXPECT_TRUE(this->editor->Picture().histogram);
  const LookRegion first = this->Regions()[0];
  EXPECT_LT(first.values[0], first.values[1]);
  EXPECT_LT(first.gradients[0], first.gradients[1]);
  QTest::keyClick(this->isOn, Qt::Key_Space);
  EXPECT_TRUE(this->Regions().empty());
  QTest::keyClick(this->isOn, Qt::Key_Space);
  EXPECT_EQ(this->Regions()[0].values, first.values) << "remembered";
  EXPECT_EQ(this->Steps(), 3);
  this->model.History()->undo();
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_TRUE(this->Regions().empty());
  EXPECT_FALSE(this->isOn->isChecked());
}

TEST_F(RegionsOfAModel, ADragMovesOneInOneStep)
{
  this->MakeSmall();
  const LookRegion before = this->Regions()[0];
  const RegionLayout& layout = this->editor->Picture().layout;
  const QPointF middle = this->Rect(0).center();
  this->Drag(middle, { 30.0, -20.0 });
  const LookRegion after = this->Regions()[0];
  const double perPixel = layout.ToValue(1.0) - layout.ToValue(0.0);
  EXPECT_NEAR(after.values[0] - before.values[0], 30.0 * perPixel, perPixel);
  EXPECT_NEAR(after.values[1] - after.values[0], before.values[1] - before.values[0], 1e-9);
  EXPECT_GT(after.gradients[0], before.gradients[0]);
  EXPECT_EQ(this->Steps(), 1);
  this->model.History()->undo();
  EXPECT_EQ(this->Regions()[0].values, before.values);
}

TEST_F(RegionsOfAModel, HandlesChangeTheSizeAndStopAtTheOtherSide)
{
  this->MakeSmall();
  this->editor->Select(0);
  const LookRegion before = this->Regions()[0];
  this->Drag(this->Rect(0).topRight(), { 25.0, -15.0 });
  EXPECT_GT(this->Regions()[0].values[1], before.values[1]);
  EXPECT_GT(this->Regions()[0].gradients[1], before.gradients[1]);
  EXPECT_EQ(this->Regions()[0].values[0], before.values[0]);
  EXPECT_EQ(this->Regions()[0].gradients[0], before.gradients[0]);
  const QRectF rect = this->Rect(0);
  this->Drag({ rect.left(), rect.center().y() }, { 300.0, 40.0 });
  EXPECT_LT(this->Regions()[0].values[0], this->Regions()[0].values[1]);
  EXPECT_EQ(this->Regions()[0].gradients[0], before.gradients[0]) << "a side moves along values";
  EXPECT_EQ(this->Steps(), 2);
}

TEST_F(RegionsOfAModel, EscapeTakesADragBack)
{
  this->MakeSmall();
  const LookRegion before = this->Regions()[0];
  const QPointF middle = this->Rect(0).center();
  QTest::mousePress(this->editor, Qt::LeftButton, {}, middle.toPoint());
  this->MoveTo(middle + QPointF(40.0, 0.0));
  EXPECT_NE(this->Regions()[0].values, before.values);
  this->Key(Qt::Key_Escape);
  this->MoveTo(middle + QPointF(60.0, 0.0));
  EXPECT_EQ(this->Regions()[0].values, before.values);
  EXPECT_EQ(this->Steps(), 0) << "nothing to undo";
}

TEST_F(RegionsOfAModel, KeysAddMoveResizeAndDelete)
{
  this->MakeSmall();
  this->editor->setFocus();
  this->Key(Qt::Key_Insert, Qt::ShiftModifier);
  ASSERT_EQ(this->Regions().size(), 2u);
  EXPECT_EQ(this->Regions()[1].shape, RegionShape::Ellipse);
  EXPECT_EQ(this->editor->Picture().selected, 1) << "the new one";
  const LookRegion added = this->Regions()[1];
  this->Key(Qt::Key_Left);
  const double step = added.values[0] - this->Regions()[1].values[0];
  EXPECT_GT(step, 0.0);
  this->Key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(added.values[0] - this->Regions()[1].values[0], 11.0 * step, 1e-6);
  this->Key(Qt::Key_Up, Qt::ControlModifier);
  EXPECT_GT(this->Regions()[1].gradients[1], added.gradients[1]);
  EXPECT_EQ(this->Regions()[1].gradients[0], added.gradients[0]);
  this->Key(Qt::Key_Delete);
  EXPECT_EQ(this->Regions().size(), 1u);
  EXPECT_EQ(this->Steps(), 5);
  this->model.History()->undo();
  EXPECT_EQ(this->Regions().size(), 2u);
}

TEST_F(RegionsOfAModel, TabGoesFromOneToTheNext)
{
  this->MakeSmall();
  this->Key(Qt::Key_Insert);
  this->editor->Select(0);
  this->editor->setFocus();
  this->Key(Qt::Key_Tab);
  EXPECT_EQ(this->editor->Picture().selected, 1);
}

TEST_F(RegionsOfAModel, ColourIsShownWhileItIsChosen)
{
  this->MakeSmall();
  QTest::mouseDClick(this->editor, Qt::LeftButton, {}, this->Rect(0).center().toPoint());
  auto* const dialog = this->editor->findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  const glm::dvec3 before = this->Regions()[0].rgb;
  dialog->setCurrentColor(Qt::blue);
  EXPECT_EQ(this->Regions()[0].rgb, glm::dvec3(0.0, 0.0, 1.0));
  dialog->reject();
  EXPECT_EQ(this->Regions()[0].rgb, before);
}

TEST_F(RegionsOfAModel, OpacityAndSoftEdgeAreThoseOfTheSelectedOne)
{
  this->MakeSmall();
  this->editor->Select(-1);
  EXPECT_FALSE(this->Digits("regionOpacity")->isEnabled());
  QTest::mouseClick(this->editor, Qt::LeftButton, {}, this->Rect(0).center().toPoint());
  ASSERT_TRUE(this->Digits("regionOpacity")->isEnabled());
  this->Digits("regionOpacity")->setValue(0.75);
  this->Digits("regionSoftness")->setValue(1.0);
  EXPECT_EQ(this->Regions()[0].opacity, 0.75);
  EXPECT_EQ(this->Regions()[0].softness, 1.0);
  this->model.History()->undo();
  EXPECT_EQ(this->Digits("regionSoftness")->value(), 0.25);
}

TEST_F(RegionsOfAModel, TheReadoutNamesValueGradientAndCount)
{
  this->MakeSmall();
  this->MoveTo(this->editor->Picture().layout.ToPoint(
    this->editor->Picture().histogram->values[0] + 1.0, 0.0));
  EXPECT_TRUE(this->editor->Picture().reading.contains("voxels"))
    << this->editor->Picture().reading.toStdString();
}

TEST_F(RegionsOfAModel, AreHiddenWhereTheyCannotBeDrawn)
{
  this->SwitchOn();
  Look look = this->model.CurrentScene().look;
  look.blend = Blend::MaximumIntensity;
  this->model.SetLook(look, "maximum");
  EXPECT_FALSE(this->isOn->isVisible());
}
