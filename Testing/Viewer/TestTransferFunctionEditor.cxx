// The editor with the mouse: real events on the widget, with a model that keeps the history.

#include "EditorOfAModel.h"

#include <QAction>
#include <QColorDialog>
#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <algorithm>

using namespace varimarch;

TEST_F(EditorOfAModel, AClickOnAnEmptyPlaceAddsAPointWithTheColorUnderIt)
{
  const glm::dvec3 color = FunctionOf(this->Edited()).Color(1000.0);
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->Empty());
  ASSERT_EQ(this->Edited().opacities.size(), 5u);
  const double pixel = this->Layout().axis.ValuePerPixel();
  EXPECT_NEAR(this->Edited().opacities[3].value, 1000.0, pixel);
  EXPECT_NEAR(this->Edited().opacities[3].opacity, 0.25, 0.01);
  const ColorNode& added = this->Edited().colors[3];
  EXPECT_EQ(added.value, this->Edited().opacities[3].value);
  EXPECT_LT(glm::distance(added.rgb, color), 0.01);
  EXPECT_EQ(this->editor.Picture().selected, (NodeSet{ { NodeKind::Opacity, 3 } }));
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, ADragIsSeenAtOnceAndIsOneStep)
{
  const Look before = this->Edited();
  QSignalSpy edits(&this->editor, &TransferFunctionEditor::LookEdited);
  this->Drag(this->At(1), { 12, -20 });
  EXPECT_EQ(edits.count(), 4);
  EXPECT_EQ(this->Steps(), 1);
  const double pixel = this->Layout().axis.ValuePerPixel();
  EXPECT_NEAR(this->Edited().opacities[1].value, 300.0 + 12.0 * pixel, pixel);
  EXPECT_NEAR(
    this->Edited().opacities[1].opacity, 0.35 + 20.0 / this->Layout().plot.height(), 0.002);
  EXPECT_EQ(this->Edited().colors[1].value, this->Edited().opacities[1].value);
  EXPECT_EQ(this->Edited().opacities[2].value, 600.0);
  this->model.History()->undo();
  EXPECT_TRUE(SameCurves(this->Edited(), before));
  EXPECT_TRUE(SameCurves(this->editor.Picture().look, before));
  EXPECT_EQ(this->editor.Picture().selected, (NodeSet{ { NodeKind::Opacity, 1 } }));
}

TEST_F(EditorOfAModel, APointStopsAtItsNeighbour)
{
  this->Drag(this->At(1), { 5000, 0 });
  EXPECT_EQ(this->Edited().opacities[1].value, 600.0);
  EXPECT_EQ(this->Edited().colors[1].value, 600.0);
}

TEST_F(EditorOfAModel, ShiftLocksTheAxisThatIsMovedAlongLess)
{
  this->Drag(this->At(1), { 12, -4 }, Qt::ShiftModifier);
  EXPECT_GT(this->Edited().opacities[1].value, 300.0);
  EXPECT_EQ(this->Edited().opacities[1].opacity, 0.35);
  this->Drag(this->At(2), { 4, -20 }, Qt::ShiftModifier);
  EXPECT_EQ(this->Edited().opacities[2].value, 600.0);
  EXPECT_GT(this->Edited().opacities[2].opacity, 0.80);
}

TEST_F(EditorOfAModel, ControlMakesADragTenTimesFiner)
{
  this->Drag(this->At(1), { 0, -20 }, Qt::ControlModifier);
  EXPECT_NEAR(
    this->Edited().opacities[1].opacity, 0.35 + 2.0 / this->Layout().plot.height(), 0.0011);
}

TEST_F(EditorOfAModel, EscapeDuringADragPutsEverythingBack)
{
  const Look before = this->Edited();
  this->Press(this->At(1));
  this->MoveTo(this->At(1) + QPoint(10, -30));
  EXPECT_FALSE(SameCurves(this->Edited(), before));
  QTest::keyClick(&this->editor, Qt::Key_Escape);
  EXPECT_TRUE(SameCurves(this->Edited(), before));
  EXPECT_EQ(this->Steps(), 0);
  this->MoveTo(this->At(1) + QPoint(60, -60));
  this->Release(this->At(1) + QPoint(60, -60));
  EXPECT_TRUE(SameCurves(this->Edited(), before));
}

TEST_F(EditorOfAModel, ADragFromTheCurvePullsANewPointOutOfIt)
{
  const double opacity = FunctionOf(this->Edited()).Opacity(1000.0);
  const QPoint onCurve(int(this->Layout().axis.ToPixel(1000.0)), int(this->Layout().ToY(opacity)));
  this->Drag(onCurve, { 0, 40 });
  ASSERT_EQ(this->Edited().opacities.size(), 5u);
  EXPECT_NEAR(
    this->Edited().opacities[3].opacity, opacity - 40.0 / this->Layout().plot.height(), 0.01);
  EXPECT_EQ(this->Steps(), 1);
}

// The drag starts on the flat line before the first point. Values left of the pointer stay
// transparent, in one step.
TEST_F(EditorOfAModel, ADragFromTheDarkEndLightsOnlyWhereThePointIs)
{
  const QPoint onLine(int(this->Layout().axis.ToPixel(-300.0)), int(this->Layout().ToY(0.0)) - 1);
  this->Drag(onLine, { 10, -60 });
  ASSERT_EQ(this->Edited().opacities.size(), 6u);
  const double value = this->Layout().axis.ToValue(onLine.x() + 10);
  const double pixel = this->Layout().axis.ValuePerPixel();
  EXPECT_EQ(this->Edited().opacities[0].opacity, 0.0);
  EXPECT_NEAR(this->Edited().opacities[1].value, value, 1.5 * pixel);
  EXPECT_NEAR(this->Edited().opacities[1].opacity, 60.0 / this->Layout().plot.height(), 0.01);
  EXPECT_EQ(FunctionOf(this->Edited()).Opacity(-1000.0), 0.0);
  EXPECT_EQ(this->editor.Picture().selected, (NodeSet{ { NodeKind::Opacity, 1 } }));
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, IsosurfacesAreAddedMovedAndRemoved)
{
  Look look = WithSurface(this->Edited());
  look.blend = Blend::Isosurface;
  this->model.SetLook(look, "isosurfaces");
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->Empty());
  ASSERT_EQ(this->Edited().isosurfaces.size(), 2u);
  const double pixel = this->Layout().axis.ValuePerPixel();
  EXPECT_NEAR(this->Edited().isosurfaces[1].value, 1000.0, pixel);
  const QPoint at = this->Layout().PositionOf(this->Edited(), { NodeKind::Surface, 1 }).toPoint();
  this->Drag(at, { 20, -30 });
  EXPECT_NEAR(this->Edited().isosurfaces[1].value, 1000.0 + 20.0 * pixel, 2.0 * pixel);
  EXPECT_GT(this->Edited().isosurfaces[1].opacity, 0.3);
  QTest::keyClick(&this->editor, Qt::Key_Delete);
  EXPECT_EQ(this->Edited().isosurfaces.size(), 1u);
  EXPECT_EQ(this->Edited().opacities.size(), 4u) << "the curve is unchanged";
  EXPECT_EQ(this->Steps(), 4);
}

TEST_F(EditorOfAModel, DeleteRemovesWhatIsSelected)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  EXPECT_EQ(this->Steps(), 0);
  QTest::keyClick(&this->editor, Qt::Key_Delete);
  ASSERT_EQ(this->Edited().opacities.size(), 3u);
  EXPECT_EQ(this->Edited().opacities[1].value, 600.0);
  EXPECT_EQ(this->Edited().colors.size(), 3u);
  this->model.History()->undo();
  EXPECT_EQ(this->Edited().opacities.size(), 4u);
}

TEST_F(EditorOfAModel, ARubberBandSelectsWhatIsInIt)
{
  const QPoint corner = this->At(2) + QPoint(10, -12);
  const QPoint other = this->At(1) + QPoint(-6, 20);
  this->Drag(corner, other - corner);
  EXPECT_EQ(this->editor.Picture().selected,
    (NodeSet{ { NodeKind::Opacity, 1 }, { NodeKind::Opacity, 2 } }));
  EXPECT_EQ(this->Edited().opacities.size(), 4u);
  EXPECT_TRUE(this->editor.Picture().rubberBand.isNull());
  // Dragging one of them moves both.
  this->Drag(this->At(1), { 0, 20 });
  EXPECT_LT(this->Edited().opacities[1].opacity, 0.35);
  EXPECT_LT(this->Edited().opacities[2].opacity, 0.80);
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, ControlAndAClickSelectOneMoreOrOneLess)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->At(1));
  QTest::mouseClick(&this->editor, Qt::LeftButton, Qt::ControlModifier, this->At(3));
  EXPECT_EQ(this->editor.Picture().selected,
    (NodeSet{ { NodeKind::Opacity, 1 }, { NodeKind::Opacity, 3 } }));
  QTest::mouseClick(&this->editor, Qt::LeftButton, Qt::ControlModifier, this->At(1));
  EXPECT_EQ(this->editor.Picture().selected, (NodeSet{ { NodeKind::Opacity, 3 } }));
}

TEST_F(EditorOfAModel, AltAndADragShiftTheWholeCurve)
{
  this->Drag(this->Empty(), { 20, -30 }, Qt::AltModifier);
  const double pixel = this->Layout().axis.ValuePerPixel();
  const double shift = this->Edited().opacities[0].value - 150.0;
  EXPECT_NEAR(shift, 20.0 * pixel, pixel);
  const Look preset = this->model.CurrentScene().look;
  EXPECT_NEAR(preset.opacities[3].value, 1500.0 + shift, 1e-9);
  EXPECT_EQ(preset.opacities[1].opacity, 0.35);
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, AltAndTheWheelScaleTheCurveAtThePointer)
{
  const double pixel = this->Layout().axis.ToPixel(150.0);
  this->Wheel({ pixel, 100.0 }, 1, Qt::AltModifier);
  this->Wheel({ pixel, 100.0 }, 1, Qt::AltModifier);
  EXPECT_NEAR(this->Edited().opacities[0].value, 150.0, 1e-6);
  EXPECT_NEAR(this->Edited().opacities[3].value, 150.0 + 1.05 * 1.05 * 1350.0, 1e-6);
  EXPECT_EQ(this->Steps(), 1);
}

TEST_F(EditorOfAModel, TheWheelZoomsAndKeepsTheValueUnderThePointer)
{
  const QPointF at(333.0, 100.0);
  const double value = this->Layout().axis.ToValue(at.x());
  const double width = this->Layout().axis.Last() - this->Layout().axis.First();
  this->Wheel(at, 3);
  EXPECT_NEAR(this->Layout().axis.ToValue(at.x()), value, 1e-9);
  EXPECT_LT(this->Layout().axis.Last() - this->Layout().axis.First(), 0.6 * width);
  EXPECT_EQ(this->Steps(), 0);
}

TEST_F(EditorOfAModel, TheMiddleButtonMovesTheAxis)
{
  const double value = this->Layout().axis.ToValue(200.0);
  this->Drag({ 200, 100 }, { 40, 5 }, {}, Qt::MiddleButton);
  EXPECT_NEAR(this->Layout().axis.ToPixel(value), 240.0, 1e-6);
  EXPECT_EQ(this->Steps(), 0);
}

TEST_F(EditorOfAModel, HoverTellsValueOpacityAndVoxels)
{
  QSignalSpy hovers(&this->editor, &TransferFunctionEditor::Hovered);
  this->MoveTo(this->At(1));
  ASSERT_FALSE(hovers.isEmpty());
  const QString reading = hovers.last().first().toString();
  EXPECT_TRUE(reading.startsWith("HU 300, opacity 0.35, ")) << reading.toStdString();
  // All voxels lie above the start of the axis.
  this->MoveTo({ int(this->Layout().plot.left()) + 1, 50 });
  const ImageStatistics& statistics = this->model.CurrentStudy()->statistics;
  ASSERT_LT(this->Layout().axis.First(), statistics.Smallest());
  EXPECT_TRUE(hovers.last().first().toString().endsWith(", 0.00 % of voxels, 100 % above"))
    << hovers.last().first().toString().toStdString();
}

TEST_F(EditorOfAModel, LowOpacitiesCanBeEnlarged)
{
  const double low = this->Layout().plot.bottom() - this->Layout().ToY(0.01);
  QTest::keyClick(&this->editor, Qt::Key_O);
  EXPECT_GT(this->Layout().plot.bottom() - this->Layout().ToY(0.01), 5.0 * low);
  this->Drag(this->At(0), { 0, -20 });
  EXPECT_NEAR(this->Layout().ToY(this->Edited().opacities[0].opacity),
    this->Layout().plot.bottom() - 20.0, 1.0);
}

TEST_F(EditorOfAModel, ADragEndsWhenTheLookIsChangedElsewhere)
{
  this->Press(this->At(1));
  this->MoveTo(this->At(1) + QPoint(10, 0));
  this->model.History()->undo();
  const Look undone = this->Edited();
  this->MoveTo(this->At(1) + QPoint(30, 0));
  EXPECT_TRUE(SameCurves(this->Edited(), undone));
}

// A panel of a small screen is hardly wider than this.
TEST_F(EditorOfAModel, ShowsTheWholeReadingInANarrowPanel)
{
  this->editor.resize(300, 300);
  this->MoveTo({ 150, 120 });
  const QString reading = this->editor.Picture().reading;
  ASSERT_TRUE(reading.contains("above")) << reading.toStdString();
  const QRectF& room = this->Layout().reading;
  const QRectF needed = QFontMetricsF(this->editor.font())
                          .boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, reading);
  EXPECT_LE(needed.height(), room.height());
  EXPECT_LE(needed.width(), room.width());
  EXPECT_LT(room.bottom(), this->Layout().plot.top());
}

TEST_F(EditorOfAModel, AClickAsksForTheColourOnlyIfTheUserWantsThat)
{
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->Empty());
  EXPECT_EQ(this->Edited().opacities.size(), 5u);
  EXPECT_FALSE(this->editor.findChild<QColorDialog*>());
  const QList<QAction*> actions = this->editor.actions();
  const auto ask = std::find_if(actions.begin(), actions.end(),
    [](const QAction* action) { return action->text() == "Ask for the colour of a new point"; });
  ASSERT_NE(ask, actions.end());
  (*ask)->trigger();
  QTest::mouseClick(&this->editor, Qt::LeftButton, {}, this->Empty() + QPoint(40, 0));
  auto* const dialog = this->editor.findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  const int added = this->editor.Picture().selected.begin()->index;
  dialog->setCurrentColor(Qt::green);
  EXPECT_EQ(ColorOf(this->Edited(), { NodeKind::Opacity, added }), glm::dvec3(0.0, 1.0, 0.0));
  dialog->accept();
  (*ask)->trigger();
}
