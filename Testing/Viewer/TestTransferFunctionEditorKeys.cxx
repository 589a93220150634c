// The editor with keys, menu and numbers, which can do everything that the mouse can.

#include "EditorOfAModel.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>

using namespace varimarch;

TEST_F(EditorOfAModel, KeysFitTheAxisAndChooseTheCounts)
{
  const ImageStatistics& statistics = this->model.CurrentStudy()->statistics;
  const ValueAxis& axis = this->Layout().axis;
  QTest::keyClick(&this->editor, Qt::Key_E);
  EXPECT_NEAR(0.5 * (axis.First() + axis.Last()), 825.0, 1e-6);
  QTest::keyClick(&this->editor, Qt::Key_F);
  EXPECT_LE(axis.First(), statistics.Smallest());
  EXPECT_GE(axis.Last(), statistics.Largest());
  const double allOf = axis.Last();
  QTest::keyClick(&this->editor, Qt::Key_H);
  EXPECT_LT(axis.Last(), allOf);
  QTest::keyClick(&this->editor, Qt::Key_H);
  EXPECT_EQ(axis.Last(), allOf);
  EXPECT_TRUE(this->editor.Picture().logarithmicCounts);
  QTest::keyClick(&this->editor, Qt::Key_L);
  EXPECT_FALSE(this->editor.Picture().logarithmicCounts);
}

TEST_F(EditorOfAModel, ArrowsNudgeByOneUnitAndShiftByTen)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  QTest::keyClick(&this->editor, Qt::Key_Right);
  EXPECT_EQ(this->Edited().opacities[1].value, 301.0);
  QTest::keyClick(&this->editor, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(this->Edited().opacities[1].value, 291.0);
  QTest::keyClick(&this->editor, Qt::Key_Up);
  EXPECT_NEAR(this->Edited().opacities[1].opacity, 0.36, 1e-12);
  QTest::keyClick(&this->editor, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(this->Edited().opacities[1].opacity, 0.26, 1e-12);
  EXPECT_EQ(this->Steps(), 4);
}

TEST_F(EditorOfAModel, AKeyThatIsHeldIsOneStep)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  for (const bool repeated : { false, true, true })
  {
    QKeyEvent event(QEvent::KeyPress, Qt::Key_Right, {}, {}, repeated);
    QApplication::sendEvent(&this->editor, &event);
  }
  EXPECT_EQ(this->Edited().opacities[1].value, 303.0);
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, TabGoesFromNodeToNodeAndThenOn)
{
  QWidget window;
  QLineEdit before(&window);
  this->editor.setParent(&window);
  QLineEdit after(&window);
  window.show();
  QApplication::setActiveWindow(&window);
  before.setFocus();
  QTest::keyClick(&before, Qt::Key_Tab);
  EXPECT_TRUE(this->editor.hasFocus());
  EXPECT_EQ(*this->editor.Picture().focused, (NodeId{ NodeKind::Opacity, 0 }));
  for (int i = 1; i < 8; ++i)
  {
    QTest::keyClick(&this->editor, Qt::Key_Tab);
  }
  EXPECT_EQ(*this->editor.Picture().focused, (NodeId{ NodeKind::Color, 3 }));
  EXPECT_TRUE(this->editor.accessibleDescription().contains("colour 4 of 4"));
  QTest::keyClick(&this->editor, Qt::Key_Tab);
  EXPECT_TRUE(after.hasFocus());
  this->editor.setParent(nullptr);
}

TEST_F(EditorOfAModel, TheKeyboardAloneAddsAPoint)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->At(2));
  QTest::keyClick(&this->editor, Qt::Key_Insert);
  ASSERT_EQ(this->Edited().opacities.size(), 5u);
  EXPECT_EQ(this->Edited().opacities[3].value, 1050.0);
  EXPECT_EQ(*this->editor.Picture().focused, (NodeId{ NodeKind::Opacity, 3 }));
}

TEST_F(EditorOfAModel, ADoubleClickEditsAPointInNumbers)
{
  QTest::mouseDClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  auto* const value = this->InPopover<QDoubleSpinBox>("value");
  ASSERT_TRUE(value);
  EXPECT_EQ(value->value(), 300.0);
  value->setValue(320.0);
  this->InPopover<QDoubleSpinBox>("opacity")->setValue(0.5);
  this->InPopover<QDoubleSpinBox>("sharpness")->setValue(0.25);
  this->InPopover<QDoubleSpinBox>("midpoint")->setValue(0.75);
  const OpacityNode& edited = this->Edited().opacities[1];
  EXPECT_EQ(edited.value, 320.0);
  EXPECT_EQ(this->Edited().colors[1].value, 320.0);
  EXPECT_EQ(edited.opacity, 0.5);
  EXPECT_EQ(edited.shape.sharpness, 0.25);
  EXPECT_EQ(edited.shape.midpoint, 0.75);
  EXPECT_EQ(this->Steps(), 1);
  this->model.History()->undo();
  EXPECT_EQ(this->Edited().opacities[1].value, 300.0);
}

TEST_F(EditorOfAModel, AValueBeyondANeighbourIsShownAsApplied)
{
  QTest::mouseDClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  auto* const value = this->InPopover<QDoubleSpinBox>("value");
  ASSERT_TRUE(value);
  value->setValue(5000.0);
  emit value->editingFinished();
  EXPECT_EQ(this->Edited().opacities[1].value, 600.0);
  EXPECT_EQ(value->value(), 600.0);
}

TEST_F(EditorOfAModel, EscapeInThePopoverPutsThePointBack)
{
  const Look before = this->Edited();
  QTest::mouseDClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  auto* const opacity = this->InPopover<QDoubleSpinBox>("opacity");
  ASSERT_TRUE(opacity);
  opacity->setValue(0.9);
  EXPECT_EQ(this->Edited().opacities[1].opacity, 0.9);
  QTest::keyClick(opacity, Qt::Key_Escape);
  EXPECT_TRUE(SameCurves(this->Edited(), before));
  EXPECT_EQ(this->Steps(), 0);
}

TEST_F(EditorOfAModel, EveryCommandOfTheMenuHasItsKey)
{
  QContextMenuEvent event(QContextMenuEvent::Mouse, this->At(1), QPoint(10, 10));
  QApplication::sendEvent(&this->editor, &event);
  auto* const menu = this->editor.findChild<QMenu*>();
  ASSERT_TRUE(menu);
  EXPECT_EQ(this->editor.Picture().selected, (NodeSet{ { NodeKind::Opacity, 1 } }));
  for (const QAction* const action : menu->actions())
  {
    EXPECT_TRUE(action->isSeparator() || !action->shortcut().isEmpty());
  }
  menu->close();
}
