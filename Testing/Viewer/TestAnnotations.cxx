// Regions, arrows and curves drawn in slices by the mouse, and the view along a curve.

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/WorldVector.h"
#include "SmallStudy.h"
#include "Viewer/View/CurvedView.h"
#include "Viewer/View/SliceView.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

class Annotations : public testing::Test
{
protected:
  Annotations()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    for (SliceView* const view : { &this->axial, &this->coronal })
    {
      view->resize(200, 160);
      view->show();
    }
  }

  // Presses at the first place, moves to the others, and releases at the last.
  static void DragAlong(QWidget& view, const std::vector<QPoint>& places)
  {
    QTest::mousePress(&view, Qt::LeftButton, {}, places.front());
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      QMouseEvent move(QEvent::MouseMove, places[i], Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, places.back());
  }

  const std::vector<Measure>& All() const { return this->model.CurrentScene().measures; }
  MeasureValues Values() const
  {
    return ValuesOf(this->All().at(0), this->model.CurrentStudy()->volume.image);
  }
  double MmBetween(const QPoint& a, const QPoint& b) const
  {
    return glm::distance(VectorOf(*this->axial.PointAt(a)), VectorOf(*this->axial.PointAt(b)));
  }

  SceneModel model;
  SliceView axial{ &this->model, SlicePlane::Axial };
  SliceView coronal{ &this->model, SlicePlane::Coronal };
};

}

TEST_F(Annotations, AnEllipseTouchesTheSidesOfTheDraggedRectangle)
{
  this->axial.SetTool(LeftButton::Ellipse);
  DragAlong(this->axial, { { 60, 50 }, { 100, 60 }, { 120, 90 } });
  ASSERT_EQ(this->All().size(), 1);
  EXPECT_EQ(this->model.History()->count(), 1);
  const double a = 0.5 * this->MmBetween({ 60, 50 }, { 120, 50 });
  const double b = 0.5 * this->MmBetween({ 60, 50 }, { 60, 90 });
  EXPECT_NEAR(*this->Values().areaMm2, M_PI * a * b, 1e-6);
  EXPECT_GT(this->Values().statistics->voxels, 3);
  // Its middle moves it as a whole.
  const Measure before = this->All()[0];
  DragAlong(this->axial, { { 90, 70 }, { 95, 80 } });
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(this->axial.PlaceOf(this->All()[0].pointsMm[i]).x(),
      this->axial.PlaceOf(before.pointsMm[i]).x() + 5.0, 1e-6);
  }
  // An end of a half-diameter moves alone.
  DragAlong(this->axial, { { 125, 80 }, { 135, 80 } });
  EXPECT_NEAR(*this->Values().areaMm2, M_PI * a * b * 40.0 / 30.0, 1e-6);
}

TEST_F(Annotations, AFreehandRegionIsTheAreaWithinItsOutline)
{
  this->axial.SetTool(LeftButton::Freehand);
  DragAlong(this->axial, { { 60, 50 }, { 120, 50 }, { 120, 90 }, { 60, 90 } });
  ASSERT_EQ(this->All().size(), 1);
  const double area =
    this->MmBetween({ 60, 50 }, { 120, 50 }) * this->MmBetween({ 60, 50 }, { 60, 90 });
  EXPECT_NEAR(*this->Values().areaMm2, area, 1e-6);
  this->model.History()->undo();
  EXPECT_TRUE(this->All().empty());
  DragAlong(this->axial, { { 60, 50 }, { 60, 50 } });
  EXPECT_TRUE(this->All().empty()) << "a click draws no region";
}

TEST_F(Annotations, AnUndoDuringADragTakesTheMeasurementAway)
{
  this->axial.SetTool(LeftButton::Distance);
  QTest::mousePress(&this->axial, Qt::LeftButton, {}, { 60, 50 });
  this->model.History()->undo();
  QMouseEvent move(QEvent::MouseMove, QPointF(90, 60), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&this->axial, &move);
  QTest::mouseRelease(&this->axial, Qt::LeftButton, {}, { 90, 60 });
  EXPECT_TRUE(this->All().empty());
}

TEST_F(Annotations, ARegionIsSeenInItsSliceOnly)
{
  this->axial.setFocus(); // which a click would give it
  const QImage empty = this->axial.grab().toImage();
  this->axial.SetTool(LeftButton::Ellipse);
  DragAlong(this->axial, { { 60, 50 }, { 120, 90 } });
  EXPECT_NE(this->axial.grab().toImage(), empty);
  this->model.Edit(
    ScenePart::Measures, "hide", [](Scene& scene) { scene.measures[0].visible = false; });
  EXPECT_EQ(this->axial.grab().toImage(), empty);
  this->model.History()->undo();
  const auto at = [this](double z)
  {
    auto crosshair = VectorOf(*this->axial.PointAt({ 100, 80 }));
    crosshair.z += z;
    this->model.Edit(ScenePart::Slices, "go",
      [&](Scene& scene) { scene.slices.crosshairMm = NumbersOf(crosshair); });
    return this->axial.grab().toImage();
  };
  const QImage here = at(0.0);
  const QImage there = at(60.0);
  this->model.Edit(ScenePart::Measures, "remove", [](Scene& scene) { scene.measures.clear(); });
  EXPECT_EQ(this->axial.grab().toImage(), there);
  EXPECT_NE(at(-60.0), here);
}

TEST_F(Annotations, AreInAViewThatIsMadeLater)
{
  this->axial.SetTool(LeftButton::Ellipse);
  DragAlong(this->axial, { { 60, 50 }, { 120, 90 } });
  const auto picture = [this]
  {
    SliceView later(&this->model, SlicePlane::Axial); // as for a report
    later.resize(200, 160);
    return later.grab().toImage();
  };
  const QImage withEllipse = picture();
  this->model.History()->undo();
  EXPECT_NE(picture(), withEllipse);
}

TEST_F(Annotations, AnArrowHasTheWordsThatAreTypedIntoTheView)
{
  this->axial.SetTool(LeftButton::Arrow);
  DragAlong(this->axial, { { 60, 50 }, { 120, 90 } });
  auto* line = this->axial.findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  QTest::keyClicks(line, "node 3");
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(this->All().size(), 1);
  EXPECT_EQ(this->All()[0].name, "node 3");
  EXPECT_EQ(this->model.History()->count(), 1);
  QTest::qWait(1); // the line is deleted
  EXPECT_FALSE(this->axial.findChild<QLineEdit*>());

  // A text that is given up is not made.
  this->axial.SetTool(LeftButton::Text);
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 40, 40 });
  line = this->axial.findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  QTest::keyClicks(line, "no");
  QTest::keyClick(line, Qt::Key_Return, Qt::NoModifier);
  ASSERT_EQ(this->All().size(), 2);
  QTest::qWait(1);
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 150, 120 });
  line = this->axial.findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(this->All().size(), 2);
}

TEST_F(Annotations, ACurveGoesOnInAnotherSlice)
{
  for (SliceView* const view : { &this->axial, &this->coronal })
  {
    view->SetTool(LeftButton::Curve);
  }
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 60, 50 });
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 100, 60 });
  QTest::mouseClick(&this->coronal, Qt::LeftButton, {}, { 150, 60 });
  ASSERT_EQ(this->All().size(), 1);
  EXPECT_EQ(this->All()[0].pointsMm.size(), 3);
  EXPECT_EQ(this->All()[0].pointsMm[2], *this->coronal.PointAt({ 150, 60 }));
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 60, 50 });
  EXPECT_EQ(this->All()[0].pointsMm.size(), 3) << "a click on a point adds none";
}

TEST_F(Annotations, ACurveThatIsOpenedOrHiddenDoesNotGoOn)
{
  this->axial.SetTool(LeftButton::Curve);
  Scene saved = this->model.CurrentScene();
  saved.measures = { { MeasureKind::Curve, { { 0, 0, 0 }, { 9, 9, 9 } } } };
  this->model.Restore(saved, this->model.CurrentStudy());
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 60, 50 });
  ASSERT_EQ(this->All().size(), 2);
  this->model.Edit(
    ScenePart::Measures, "hide", [](Scene& scene) { scene.measures[1].visible = false; });
  QTest::mouseClick(&this->axial, Qt::LeftButton, {}, { 150, 110 });
  EXPECT_EQ(this->All().size(), 3);
}

namespace
{

class PaintCounter : public QObject
{
public:
  int count = 0;

  bool eventFilter(QObject*, QEvent* event) override
  {
    this->count += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }
};

class Curved : public Annotations
{
protected:
  Curved()
  {
    this->view.resize(400, 320);
    this->view.show();
  }

  void AddCurve()
  {
    this->model.Edit(ScenePart::Measures, "curve",
      [](Scene& scene)
      {
        scene.measures.push_back(
          { MeasureKind::Curve, { { -40, 0, 0 }, { 0, 10, 0 }, { 40, 0, 0 } } });
      });
  }

  /// The text of the view for a column.
  QString PointedAt(double x)
  {
    QSignalSpy pointed(&this->view, &CurvedView::Pointed);
    QMouseEvent move(QEvent::MouseMove, QPointF(x, 160), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&this->view, &move);
    return pointed.last().first().toString();
  }

  CurvedView view{ &this->model };
};

}

TEST_F(Curved, ShowsTheLastVisibleCurve)
{
  EXPECT_FALSE(this->view.Path());
  this->view.grab(); // the hint
  this->AddCurve();
  ASSERT_TRUE(this->view.Path());
  const QImage picture = this->view.grab().toImage();
  int bright = 0;
  for (int x = 0; x < picture.width(); ++x)
  {
    bright += qGray(picture.pixel(x, 60)) > 20 ? 1 : 0;
  }
  EXPECT_GT(bright, 100) << "the body is seen";
  this->model.Edit(
    ScenePart::Measures, "hide", [](Scene& scene) { scene.measures[0].visible = false; });
  EXPECT_FALSE(this->view.Path());
  this->model.History()->undo();
  EXPECT_TRUE(this->view.Path());
}

TEST_F(Curved, HasAWholeTickAtItsBeginning)
{
  this->AddCurve();
  const QImage picture = this->view.grab().toImage();
  const int inTick = this->view.height() - 6;
  EXPECT_GT(qGray(picture.pixel(0, inTick)), 240);
  EXPECT_LT(qGray(picture.pixel(2, inTick)), 200);
}

TEST_F(Curved, PutsTheCrosshairOnTheCurveAtItsDistance)
{
  this->AddCurve();
  QTest::mouseClick(&this->view, Qt::LeftButton, {}, { 100, 160 });
  const CurvePath& path = *this->view.Path();
  const glm::dvec3 crosshair = VectorOf(*this->model.CurrentScene().slices.crosshairMm);
  const glm::dvec3 expected = path.At(0.25 * path.LengthMm(), 0.0).pointMm;
  EXPECT_NEAR(glm::distance(crosshair, expected), 0.0, 0.01);
  const QString half = QString::number(0.5 * path.LengthMm(), 'f', 1);
  EXPECT_TRUE(this->PointedAt(200.0).startsWith(half + " mm along the curve"))
    << this->PointedAt(200.0).toStdString();
}

TEST_F(Curved, ShowsSixCentimetresAcrossACurveInALowView)
{
  this->view.resize(800, 120);
  this->AddCurve();
  const auto top = this->view.PointAt({ 0.0, 0.0 });
  const auto bottom = this->view.PointAt({ 0.0, 120.0 });
  EXPECT_NEAR(glm::distance(*top, *bottom), 60.0, 0.01);
  EXPECT_FALSE(this->view.PointAt({ 799.0, 60.0 })) << "the curve ends before";
  const QImage picture = this->view.grab().toImage();
  EXPECT_EQ(picture.pixelColor(799, 60), QColor(Qt::black));
}

TEST_F(Curved, IsTurnedByTheWheelAndTheKeys)
{
  this->AddCurve();
  const QImage before = this->view.grab().toImage();
  QWheelEvent wheel({ 100, 100 }, this->view.mapToGlobal({ 100, 100 }), {}, { 0, 240 }, {}, {},
    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&this->view, &wheel);
  EXPECT_EQ(this->model.CurrentScene().slices.curveTurnDegrees, 10.0);
  QTest::keyClick(&this->view, Qt::Key_Down);
  EXPECT_EQ(this->model.CurrentScene().slices.curveTurnDegrees, 5.0);
  EXPECT_NE(this->view.grab().toImage(), before);
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().slices.curveTurnDegrees, 0.0);
  EXPECT_EQ(this->view.grab().toImage(), before);
}

TEST_F(Curved, IsStretchedByTheContextMenuUntilItIsStraightened)
{
  this->AddCurve();
  this->model.Edit(
    ScenePart::Slices, "turn", [](Scene& scene) { scene.slices.curveTurnDegrees = 90.0; });
  const QImage straightened = this->view.grab().toImage();
  this->view.findChild<QAction*>("stretchedCurve")->trigger();
  EXPECT_NE(this->view.grab().toImage(), straightened);
  // The bend lies in the picture, so it ends after the chord of 80 mm.
  const auto last = this->view.PointAt({ this->view.width() - 0.001, 0.5 * this->view.height() });
  const auto first = this->view.PointAt({ 0.0, 0.5 * this->view.height() });
  EXPECT_NEAR(glm::distance(*last, *first), 80.0, 0.01);
  const double lengthMm = this->view.Path()->LengthMm();
  ASSERT_GT(lengthMm, 81.0);
  EXPECT_TRUE(this->PointedAt(this->view.width() - 0.001)
                .startsWith(QString::number(lengthMm, 'f', 1) + " mm along the curve"));
  EXPECT_TRUE(CurvedView(&this->model).findChild<QAction*>("stretchedCurve")->isChecked())
    << "the next one begins so";
  this->view.findChild<QAction*>("straightenedCurve")->trigger();
  EXPECT_EQ(this->view.grab().toImage(), straightened);
  EXPECT_FALSE(CurvedView(&this->model).findChild<QAction*>("stretchedCurve")->isChecked());
}

TEST_F(Curved, IsDrawnAnewWithTheVoxelsOfAnotherTime)
{
  this->AddCurve();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&this->view));
  QTest::qWait(50); // until it has been drawn
  PaintCounter paints;
  this->view.installEventFilter(&paints);
  this->model.ShowTime(this->model.CurrentStudy()->volume);
  EXPECT_TRUE(QTest::qWaitFor([&] { return paints.count > 0; }));
}
