// Slices: the mouse moves their common crosshair, and every gesture is an undo step.

#include "LabelledStudy.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/View/SliceCorners.h"
#include "Viewer/View/SliceView.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

class Slices : public testing::Test
{
protected:
  Slices()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    for (SliceView* view : { &this->axial, &this->coronal })
    {
      view->resize(200, 160);
      view->show();
    }
  }

  std::array<double, 3> Crosshair() const
  {
    return this->model.CurrentScene().slices.crosshairMm.value();
  }

  void DragInAxial(const QPoint& from, const QPoint& to)
  {
    QTest::mousePress(&this->axial, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&this->axial, &move);
    QTest::mouseRelease(&this->axial, Qt::LeftButton, {}, to);
  }

  SceneModel model;
  SliceView axial{ &this->model, SlicePlane::Axial };
  SliceView coronal{ &this->model, SlicePlane::Coronal };
};

}

TEST_F(Slices, ShareTheCrosshairThatTheMousePuts)
{
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 120, 70 });
  const std::array<double, 3> expected = *this->axial.PointAt({ 120, 70 });
  EXPECT_EQ(this->Crosshair(), expected);
  const QPointF place = this->axial.PlaceOf(expected);
  EXPECT_NEAR(place.x(), 120.0, 1e-6);
  EXPECT_NEAR(place.y(), 70.0, 1e-6);
  // The other view shows the slice whose centre has the crosshair's depth.
  EXPECT_NEAR((*this->coronal.PointAt({ 3, 5 }))[1], expected[1], 1e-9);
}

TEST_F(Slices, MakeADragOneStep)
{
  QTest::mousePress(&this->axial, Qt::LeftButton, {}, { 100, 80 });
  QTest::mouseMove(&this->axial, { 110, 80 });
  QTest::mouseMove(&this->axial, { 130, 80 });
  QTest::mouseRelease(&this->axial, Qt::LeftButton, {}, { 130, 80 });
  EXPECT_EQ(this->model.History()->count(), 1);
  this->model.History()->undo();
  EXPECT_FALSE(this->model.CurrentScene().slices.crosshairMm);
}

TEST_F(Slices, ChangeWindowAndLevelByTheRightButton)
{
  QTest::mousePress(&this->axial, Qt::RightButton, {}, { 100, 80 });
  QMouseEvent move(QEvent::MouseMove, QPointF(150, 60), Qt::NoButton, Qt::RightButton, {});
  QApplication::sendEvent(&this->axial, &move);
  const auto first = this->model.CurrentScene().slices.windowLevel.value();
  QMouseEvent further(QEvent::MouseMove, QPointF(190, 60), Qt::NoButton, Qt::RightButton, {});
  QApplication::sendEvent(&this->axial, &further);
  const auto second = this->model.CurrentScene().slices.windowLevel.value();
  EXPECT_GT(second[0], first[0]) << "wider to the right";
  EXPECT_EQ(second[1], first[1]);
  EXPECT_EQ(this->model.History()->count(), 1);
}

TEST_F(Slices, OpenWithTheWindowAndLevelOfTheFile)
{
  auto study = std::make_shared<Study>(*SmallStudy());
  study->volume.windowLevel = { 400.0, 60.0 };
  this->model.Open(ProceduralSource(), study);
  const auto windowLevel = [this]
  {
    // A drag that goes nowhere keeps the values that are shown.
    QTest::mousePress(&this->axial, Qt::RightButton, {}, { 100, 80 });
    QMouseEvent move(QEvent::MouseMove, QPointF(100, 80), Qt::NoButton, Qt::RightButton, {});
    QApplication::sendEvent(&this->axial, &move);
    return this->model.CurrentScene().slices.windowLevel.value();
  };
  EXPECT_EQ(windowLevel(), (std::array<double, 2>{ 400.0, 60.0 }));
  // A restored session keeps its own.
  Scene session = this->model.CurrentScene();
  session.slices.windowLevel = { 100.0, 40.0 };
  this->model.Restore(session, study);
  EXPECT_EQ(windowLevel(), (std::array<double, 2>{ 100.0, 40.0 }));
}

TEST_F(Slices, AreScrolledASlicePerNotchAndKey)
{
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 100, 80 });
  const double before = this->Crosshair()[2];
  const double stepMm = this->model.CurrentStudy()->volume.image->GetSpacing()[2];
  QWheelEvent wheel(QPointF(100, 80), QPointF(), {}, { 0, 120 }, {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&this->axial, &wheel);
  EXPECT_NEAR(this->Crosshair()[2], before + stepMm, 1e-9);
  QTest::keyClick(&this->axial, Qt::Key_PageDown);
  EXPECT_NEAR(this->Crosshair()[2], before - 9.0 * stepMm, 1e-9);
  QTest::keyClick(&this->axial, Qt::Key_Up);
  EXPECT_NEAR(this->Crosshair()[2], before - 8.0 * stepMm, 1e-9);
}

TEST_F(Slices, AreTurnedByTheArmsOfTheCrosshair)
{
  // From the right arm by 30 degrees upwards, about the head's axis.
  const auto corner = *this->axial.PointAt({ 0, 0 });
  this->DragInAxial({ 170, 80 }, { 100 + 61, 80 - 35 });
  const SliceTurn turn = this->model.CurrentScene().slices.turn;
  EXPECT_NEAR(turn[0], 0.0, 1e-9);
  EXPECT_NEAR(turn[1], 0.0, 1e-9);
  EXPECT_NEAR(turn[2], -30.0, 0.5);
  EXPECT_EQ(*this->axial.PointAt({ 0, 0 }), corner) << "the plane of the gesture stays";
  const auto right = *this->coronal.PointAt({ 150, 80 });
  const auto middle = *this->coronal.PointAt({ 100, 80 });
  EXPECT_NEAR(std::atan2(right[1] - middle[1], right[0] - middle[0]), -0.5236, 0.01);
  EXPECT_EQ(this->model.History()->count(), 1);
  // The arm has followed the pointer.
  this->DragInAxial({ 100 + 61, 80 - 35 }, { 170, 80 });
  EXPECT_NEAR(this->model.CurrentScene().slices.turn[2], 0.0, 1e-6);
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().slices.turn, SliceTurn());
}

TEST_F(Slices, AreStraightenedByAButton)
{
  SlabBar bar(&this->model);
  auto* const button = bar.findChild<QToolButton*>();
  ASSERT_TRUE(button);
  this->DragInAxial({ 170, 80 }, { 161, 45 });
  EXPECT_TRUE(button->isEnabled());
  button->click();
  EXPECT_EQ(this->model.CurrentScene().slices.turn, SliceTurn());
  EXPECT_FALSE(button->isEnabled());
}

TEST_F(Slices, AreZoomedByKeysAndMovedByTheMiddleButton)
{
  const auto corner = *this->axial.PointAt({ 0, 0 });
  const auto middle = *this->axial.PointAt({ 100, 80 });
  QTest::keyClick(&this->axial, Qt::Key_Plus);
  EXPECT_GT((*this->axial.PointAt({ 0, 0 }))[0], corner[0]);
  EXPECT_NEAR((*this->axial.PointAt({ 100, 80 }))[0], middle[0], 1e-9);
  const auto grabbed = *this->axial.PointAt({ 90, 60 });
  QTest::mousePress(&this->axial, Qt::MiddleButton, {}, { 90, 60 });
  QMouseEvent move(QEvent::MouseMove, QPointF(130, 85), Qt::NoButton, Qt::MiddleButton, {});
  QApplication::sendEvent(&this->axial, &move);
  QTest::mouseRelease(&this->axial, Qt::MiddleButton, {}, { 130, 85 });
  const auto dropped = *this->axial.PointAt({ 130, 85 });
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(dropped[i], grabbed[i], 1e-9) << "the point follows the pointer";
  }
  EXPECT_EQ(this->model.History()->count(), 0) << "how a slice is looked at is not work";
  QTest::keyClick(&this->axial, Qt::Key_Home);
  EXPECT_EQ(*this->axial.PointAt({ 0, 0 }), corner);
}

TEST_F(Slices, HaveTheUsualWindowsOfCtOnTheNumbers)
{
  auto study = std::make_shared<Study>(*SmallStudy());
  study->volume.modality = "CT";
  this->model.Open(ProceduralSource(), study);
  const auto windowLevel = [this] { return this->model.CurrentScene().slices.windowLevel; };
  QTest::keyClick(&this->axial, Qt::Key_2);
  EXPECT_EQ(windowLevel().value(), (std::array<double, 2>{ 1500.0, -600.0 })) << "lungs";
  QTest::keyClick(&this->coronal, Qt::Key_5);
  EXPECT_EQ(windowLevel().value(), (std::array<double, 2>{ 80.0, 40.0 })) << "brain";
  QTest::keyClick(&this->axial, Qt::Key_0);
  EXPECT_FALSE(windowLevel()) << "as in the file";
  EXPECT_EQ(this->model.History()->count(), 3);
  study->volume.modality = "MR";
  QTest::keyClick(&this->axial, Qt::Key_2);
  EXPECT_FALSE(windowLevel()) << "values of MR have no unit";
}

TEST_F(Slices, ShowTheTextsThatTheUserChooses)
{
  const auto picture = [this](const CornerTexts& shown)
  {
    this->axial.SetCornerTexts(shown);
    return this->axial.grab().toImage();
  };
  std::vector<QImage> pictures = { picture({}) };
  // There is no slab, so its text is empty.
  for (const CornerText text : { CornerText::Window, CornerText::Number, CornerText::Position,
         CornerText::Scale, CornerText::Directions })
  {
    pictures.push_back(picture({ text }));
  }
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_NE(pictures[i], pictures[j]) << i << ' ' << j;
    }
  }
  EXPECT_EQ(picture({ CornerText::Slab }), pictures[0]);
}

// Scale bars have round lengths.
TEST(ScaleBar, IsTheLargestRoundLengthThatFits)
{
  EXPECT_DOUBLE_EQ(ScaleBarMm(99.0), 50.0);
  EXPECT_DOUBLE_EQ(ScaleBarMm(100.0), 100.0);
  EXPECT_DOUBLE_EQ(ScaleBarMm(4.9), 2.0);
  EXPECT_DOUBLE_EQ(ScaleBarMm(0.19), 0.1);
}

TEST_F(Slices, MeasureABoxAsDeepAsItIsNarrow)
{
  this->axial.SetTool(LeftButton::Box);
  const auto from = *this->axial.PointAt({ 60, 50 });
  const auto to = *this->axial.PointAt({ 120, 80 });
  this->DragInAxial({ 60, 50 }, { 120, 80 });
  ASSERT_EQ(this->model.CurrentScene().measures.size(), 1);
  EXPECT_EQ(this->model.History()->count(), 1);
  const auto corner = [this](int i)
  { return this->model.CurrentScene().measures.at(0).pointsMm[i]; };
  EXPECT_NEAR(corner(0)[0], from[0], 1e-9);
  EXPECT_NEAR(corner(1)[1], to[1], 1e-9);
  EXPECT_NEAR(corner(1)[2] - corner(0)[2], to[1] - from[1], 1e-9);
  EXPECT_FALSE(this->model.CurrentScene().slices.crosshairMm) << "the crosshair stays";

  // A corner dragged within the slice keeps its depth.
  const double depth = corner(1)[2];
  this->DragInAxial({ 120, 80 }, { 150, 80 });
  EXPECT_NEAR(corner(1)[0], (*this->axial.PointAt({ 150, 80 }))[0], 1e-9);
  EXPECT_NEAR(corner(1)[2], depth, 1e-9);
}

TEST_F(Slices, NameTheSegmentUnderThePointer)
{
  this->model.ShowLabels({ "labels.nrrd" }, LabelledStudy(), "open");
  std::array<double, 3> lower; // in the half of label 3
  const int voxel[3] = { 16, 14, 4 };
  this->model.CurrentStudy()->volume.image->TransformIndexToPhysicalPoint(voxel, lower.data());
  this->model.Edit(
    ScenePart::Slices, "move", [&](Scene& scene) { scene.slices.crosshairMm = lower; });
  QSignalSpy pointed(&this->axial, &SliceView::Pointed);
  const auto textAt = [&](const QPointF& place, Qt::MouseButtons buttons)
  {
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, buttons, {});
    QApplication::sendEvent(&this->axial, &move);
    return pointed.last().first().toString();
  };
  const QPointF place = this->axial.PlaceOf(lower);
  const QString text = textAt(place, Qt::NoButton);
  EXPECT_TRUE(text.startsWith("HU ") && text.endsWith(" mm, Label 3")) << text.toStdString();
  // A measurement in progress names it too.
  this->axial.SetTool(LeftButton::Distance);
  QTest::mousePress(&this->axial, Qt::LeftButton, {}, place.toPoint() - QPoint(30, 0));
  EXPECT_EQ(textAt(place, Qt::LeftButton), text);
  QTest::mouseRelease(&this->axial, Qt::LeftButton, {}, place.toPoint());
  EXPECT_EQ(textAt({ 1.0, 1.0 }, Qt::NoButton), "") << "beside the volume";
  this->model.Edit(
    ScenePart::Segments, "hide", [](Scene& scene) { scene.labels->segments[0].visible = false; });
  EXPECT_TRUE(textAt(place, Qt::NoButton).endsWith(" mm"));
}
