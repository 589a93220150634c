// Tools of the left button: handles of cuts, measuring, scissors, window and level.

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "SmallStudy.h"
#include "Viewer/Panels/CutsPanel.h"
#include "Viewer/Tools/MouseTools.h"
#include "Waiting.h"

#include <QKeyEvent>
#include <QListWidget>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// A view of 400 x 300 pixels whose visible points lie on a plane through the volume's centre.
class Sheet : public ToolSurface
{
public:
  explicit Sheet(SceneModel* model)
    : model(model)
  {
  }

  PictureFrame Frame() const override
  {
    vtkNew<vtkCamera> camera;
    vtkImageData* const image = this->model->CurrentStudy()->volume.image;
    PlaceCamera(this->model->CurrentScene().camera, image->GetBounds(), 4.0 / 3.0, camera);
    camera->SetClippingRange(1.0, 5000.0);
    return FrameOf(camera, { 400.0, 300.0 });
  }

  std::optional<std::array<double, 3>> PointAt(const QPointF& place) const override
  {
    const PictureFrame frame = this->Frame();
    const SightLine sight = frame.sightLineAt(place);
    const glm::dvec3 along = glm::normalize(sight.farthest - sight.nearest);
    const glm::dvec3 towardsEye = VectorOf(frame.towardsEyeWorld);
    const glm::dvec3 middle = VectorOf(MiddleOf(this->model->CurrentStudy()->volume.image));
    const double distance =
      glm::dot(middle - sight.nearest, towardsEye) / glm::dot(along, towardsEye);
    return NumbersOf(sight.nearest + distance * along);
  }

  void AskForWords(const QPointF&, const std::function<void(const QString&)>& take) override
  {
    take(this->words);
  }

  QString words; ///< that the user types

private:
  SceneModel* model;
};

class Tools : public testing::Test
{
protected:
  Tools()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->tools.ShowCutHandles(true);
  }

  bool Send(QEvent::Type type, const QPointF& place, Qt::KeyboardModifiers keys = {})
  {
    QMouseEvent event(type, place, Qt::LeftButton, Qt::LeftButton, keys);
    return this->tools.Take(&event);
  }

  void DragAlong(const std::vector<QPointF>& places, Qt::KeyboardModifiers keys = {})
  {
    this->Send(QEvent::MouseButtonPress, places.front(), keys);
    for (const QPointF& place : places)
    {
      this->Send(QEvent::MouseMove, place);
    }
    this->Send(QEvent::MouseButtonRelease, places.back());
  }

  QPointF PlaceOf(const glm::dvec3& point) const
  {
    return *this->sheet.Frame().pixelOf(NumbersOf(point));
  }

  QPointF PlaceOf(CutHandleKind kind, int index) const
  {
    for (const CutHandle& handle : HandlesOf(this->Cuts(), this->Image(), this->sheet.Frame()))
    {
      if (handle.kind == kind && handle.index == index)
      {
        return *this->sheet.Frame().pixelOf(handle.pointMm);
      }
    }
    throw std::logic_error("no such handle");
  }

  void AddPlane(const std::array<double, 3>& normal)
  {
    this->model.Edit(ScenePart::Cuts, "cut",
      [&](Scene& scene) {
        scene.cuts.planes.push_back({ MiddleOf(this->Image()), normal });
      });
  }

  double Degrees() const
  {
    return *ValuesOf(this->model.CurrentScene().measures[0], this->Image()).degrees;
  }

  const SceneCuts& Cuts() const { return this->model.CurrentScene().cuts; }
  vtkImageData* Image() const { return this->model.CurrentStudy()->volume.image; }
  int Steps() { return this->model.History()->count(); }

  bool SendKey(QEvent::Type type, int key, Qt::KeyboardModifiers modifiers = {})
  {
    QKeyEvent event(type, key, modifiers);
    return this->tools.Take(&event);
  }

  Camera PresentCamera() const
  {
    Camera camera = this->model.CurrentScene().camera;
    camera.pose =
      camera.pose.value_or(CameraPose{ { 0, -500, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 100.0 });
    return camera;
  }

  CameraPose Pose() const { return *this->PresentCamera().pose; }

  SceneModel model;
  Sheet sheet{ &this->model };
  MouseTools tools{ &this->model, this->sheet, [this] { return this->PresentCamera(); } };
};

}

TEST_F(Tools, PushAPlaneByItsDiscInOneStep)
{
  CutsPanel panel(&this->model);
  this->AddPlane({ -1.0, 0.0, 0.0 });
  const glm::dvec3 target = VectorOf(MiddleOf(this->Image())) + glm::dvec3(30.0, 0.0, 0.0);
  const QPointF disc = this->PlaceOf(CutHandleKind::PushPlane, 0);
  const int steps = this->Steps();
  this->DragAlong({ disc, 0.5 * (disc + this->PlaceOf(target)), this->PlaceOf(target) });
  EXPECT_NEAR(this->Cuts().planes[0].pointMm[0], target.x, 1e-6);
  EXPECT_EQ(this->Cuts().planes[0].normal, (std::array<double, 3>{ -1.0, 0.0, 0.0 }));
  EXPECT_EQ(this->Steps(), steps + 1);
  // The panel shows the new depth.
  const double depth = DepthOf(this->Cuts().planes[0], this->Image());
  EXPECT_NEAR(panel.findChild<QSlider*>()->value(), 1000.0 * depth, 0.51);
  EXPECT_EQ(panel.findChild<QListWidget*>()->currentRow(), 0);
  // A plane cannot leave the volume.
  this->DragAlong({ this->PlaceOf(CutHandleKind::PushPlane, 0), { 399.0, 150.0 } });
  EXPECT_NEAR(DepthOf(this->Cuts().planes[0], this->Image()), 0.0, 1e-9);
}

TEST_F(Tools, TurnAPlaneByItsArrow)
{
  this->AddPlane({ -1.0, 0.0, 0.0 });
  const QPointF foot = this->PlaceOf(CutHandleKind::PushPlane, 0);
  const QPointF tip = this->PlaceOf(CutHandleKind::TurnPlane, 0);
  EXPECT_GT(tip.x(), foot.x() + 50.0) << "towards the side that is cut away";
  // Drag up, towards the head, and far beyond the arrow's reach.
  this->DragAlong({ tip, foot + QPointF(0.0, -140.0) });
  const CutPlane& plane = this->Cuts().planes[0];
  EXPECT_LT(plane.normal[2], -0.95);
  EXPECT_NEAR(plane.normal[0], 0.0, 1e-3);
  EXPECT_EQ(plane.pointMm, MiddleOf(this->Image())) << "the foot of the arrow stays in place";
}

TEST_F(Tools, PushAPlaneThatFacesTheEyeByGoingUp)
{
  this->AddPlane({ 0.0, 1.0, 0.0 }); // removes the part in front of it
  const QPointF disc = this->PlaceOf(CutHandleKind::PushPlane, 0);
  this->DragAlong({ disc, disc - QPointF(0.0, 20.0) });
  EXPECT_GT(this->Cuts().planes[0].pointMm[1], MiddleOf(this->Image())[1] + 1.0);
}

TEST_F(Tools, CropByAFaceAndMoveTheBox)
{
  const QPointF face = this->PlaceOf(CutHandleKind::MoveFace, 1);
  const QPointF middle = this->PlaceOf(VectorOf(MiddleOf(this->Image())));
  this->DragAlong({ face, 0.5 * (face + middle) });
  EXPECT_NEAR(this->Cuts().box[1], 0.75, 1e-6);
  EXPECT_EQ(this->Steps(), 1);
  // A cropped box has room to move.
  const QPointF box = this->PlaceOf(CutHandleKind::MoveBox, 0);
  this->DragAlong({ box, box + QPointF(300.0, 0.0) });
  EXPECT_NEAR(this->Cuts().box[0], 0.25, 1e-9);
  EXPECT_NEAR(this->Cuts().box[1], 1.0, 1e-9) << "as far as the volume goes";
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_EQ(this->Cuts().box, SceneCuts().box);
}

TEST_F(Tools, IgnoreEventsForTheCamera)
{
  EXPECT_FALSE(this->Send(QEvent::MouseButtonPress, { 3.0, 3.0 }));
  const QPointF face = this->PlaceOf(CutHandleKind::MoveFace, 1);
  this->tools.ShowCutHandles(false);
  EXPECT_FALSE(this->Send(QEvent::MouseButtonPress, face)) << "hidden";
}

TEST_F(Tools, CancelAGestureWithEscape)
{
  this->AddPlane({ -1.0, 0.0, 0.0 });
  const QPointF disc = this->PlaceOf(CutHandleKind::PushPlane, 0);
  this->Send(QEvent::MouseButtonPress, disc);
  this->Send(QEvent::MouseMove, disc + QPointF(40.0, 0.0));
  QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, {});
  EXPECT_TRUE(this->tools.Take(&escape));
  EXPECT_NEAR(this->Cuts().planes[0].pointMm[0], MiddleOf(this->Image())[0], 1e-9);
  EXPECT_FALSE(this->tools.Take(&escape)) << "nothing is left to cancel";
}

TEST_F(Tools, CancelNoEarlierStepWithEscape)
{
  this->tools.Choose(LeftButton::Distance);
  this->DragAlong({ { 260, 150 }, { 200, 150 } });
  QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, {});
  this->Send(QEvent::MouseButtonPress, { 200, 150 });
  EXPECT_TRUE(this->tools.Take(&escape));
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 1) << "its end was only pressed";
}

TEST_F(Tools, CutOutTheInsideOfAnOutline)
{
  this->tools.Choose(LeftButton::CutOut);
  this->DragAlong({ { 100, 100 }, { 300, 100 }, { 300, 250 }, { 100, 250 } });
  ASSERT_EQ(this->Cuts().scissors.size(), 1);
  const ScissorsCut& cut = this->Cuts().scissors[0];
  EXPECT_FALSE(cut.keepsInside);
  ASSERT_EQ(cut.outline.size(), 4);
  // Outlines are measured from the centre of the image in units of half its height.
  EXPECT_DOUBLE_EQ(cut.outline[0][0], -100.0 / 150.0);
  EXPECT_DOUBLE_EQ(cut.outline[0][1], 50.0 / 150.0);
  EXPECT_DOUBLE_EQ(cut.outline[2][1], -100.0 / 150.0);
  EXPECT_TRUE(cut.camera.pose);
  this->model.History()->undo();
  EXPECT_TRUE(this->Cuts().scissors.empty());
  this->tools.Choose(LeftButton::KeepOnly);
  this->DragAlong({ { 100, 100 }, { 300, 100 }, { 300, 250 } });
  EXPECT_TRUE(this->Cuts().scissors.at(0).keepsInside);
  this->DragAlong({ { 100, 100 }, { 102, 100 } });
  EXPECT_EQ(this->Cuts().scissors.size(), 1) << "a click is no outline";
}

TEST_F(Tools, MeasureAnAngleInTwoDrags)
{
  this->tools.Choose(LeftButton::Angle);
  this->DragAlong({ { 260, 150 }, { 200, 150 } });
  EXPECT_TRUE(this->model.CurrentScene().measures.empty()) << "one arm is no angle";
  this->DragAlong({ { 210, 60 }, { 200, 90 } });
  ASSERT_EQ(this->model.CurrentScene().measures.size(), 1);
  EXPECT_NEAR(this->Degrees(), 90.0, 1e-6);
  EXPECT_EQ(this->Steps(), 1);
  // The end of the angle can be dragged later.
  this->DragAlong({ { 200, 90 }, { 260, 90 } });
  EXPECT_NEAR(this->Degrees(), 45.0, 1e-6);
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 1);
}

TEST_F(Tools, MeasureACobbAngleBetweenTwoLinesInOneStep)
{
  this->tools.Choose(LeftButton::CobbAngle);
  this->DragAlong({ { 150, 100 }, { 250, 100 } });
  EXPECT_TRUE(this->model.CurrentScene().measures.empty()) << "one line is no angle";
  this->DragAlong({ { 250, 250 }, { 200, 200 } });
  ASSERT_EQ(this->model.CurrentScene().measures.size(), 1);
  EXPECT_EQ(this->Steps(), 1);
  EXPECT_NEAR(this->Degrees(), 45.0, 1e-6) << "lines have no direction";
}

TEST_F(Tools, MakeAnArrowAndATextWithTheWordsThatTheUserTypes)
{
  this->tools.Choose(LeftButton::Arrow);
  this->sheet.words = "node";
  this->DragAlong({ { 150, 100 }, { 250, 100 } });
  ASSERT_EQ(this->model.CurrentScene().measures.size(), 1);
  EXPECT_EQ(this->model.CurrentScene().measures[0].name, "node");
  EXPECT_EQ(this->Steps(), 1) << "the words belong to the arrow";
  this->tools.Choose(LeftButton::Text);
  this->DragAlong({ { 200, 200 } });
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 2);
  this->sheet.words = "";
  this->DragAlong({ { 100, 200 } });
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 2) << "a text without words is none";
  EXPECT_EQ(this->Steps(), 2);
}

TEST_F(Tools, DrawACurveByClicksEachOfWhichCanBeUndone)
{
  this->tools.Choose(LeftButton::Curve);
  this->DragAlong({ { 150, 100 } });
  this->DragAlong({ { 250, 100 } });
  this->DragAlong({ { 250, 200 }, { 260, 210 } });
  const auto points = [this](int i) { return this->model.CurrentScene().measures.at(i).pointsMm; };
  ASSERT_EQ(this->model.CurrentScene().measures.size(), 1);
  ASSERT_EQ(points(0).size(), 3);
  EXPECT_EQ(points(0)[2], *this->sheet.PointAt({ 260, 210 }));
  this->model.History()->undo();
  EXPECT_EQ(points(0).size(), 2);
  this->tools.Choose(LeftButton::Curve);
  this->DragAlong({ { 300, 100 } });
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 2) << "chosen again, it begins another";
}

TEST_F(Tools, DrawNoEllipseInTheVolume)
{
  this->tools.Choose(LeftButton::Ellipse);
  this->DragAlong({ { 150, 100 }, { 250, 150 } });
  EXPECT_TRUE(this->model.CurrentScene().measures.empty());
}

TEST_F(Tools, MoveTheLookWithControlWhateverIsChosen)
{
  this->tools.Choose(LeftButton::Distance);
  const Look before = this->model.CurrentScene().look;
  this->DragAlong({ { 200, 150 }, { 200, 170 }, { 200, 180 } }, Qt::ControlModifier);
  const Look& moved = this->model.CurrentScene().look;
  EXPECT_LT(moved.opacities[1].value, before.opacities[1].value) << "down is brighter";
  const auto width = [](const Look& look)
  { return look.opacities.back().value - look.opacities.front().value; };
  EXPECT_NEAR(width(moved), width(before), 1e-9);
  EXPECT_EQ(this->Steps(), 1);
  this->DragAlong({ { 200, 150 }, { 260, 150 } }, Qt::ControlModifier);
  EXPECT_NEAR(width(this->model.CurrentScene().look), std::exp(60.0 / 300.0) * width(before), 1e-6)
    << "wider to the right";
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().look.opacities[1].value, before.opacities[1].value);
}

TEST_F(Tools, WalkWhileKeysAreHeldAndUndoIt)
{
  this->tools.Choose(LeftButton::Walk);
  const CameraPose before = this->Pose();
  EXPECT_TRUE(this->SendKey(QEvent::ShortcutOverride, Qt::Key_W)) << "W is no shortcut";
  EXPECT_TRUE(this->SendKey(QEvent::KeyPress, Qt::Key_W));
  ASSERT_TRUE(QTest::qWaitFor([this] { return this->Steps() > 0; }, MostMilliseconds));
  EXPECT_TRUE(this->SendKey(QEvent::KeyRelease, Qt::Key_W));
  const CameraPose walked = this->Pose();
  const glm::dvec3 moved = VectorOf(walked.positionMm) - VectorOf(before.positionMm);
  const glm::dvec3 forward =
    glm::normalize(VectorOf(before.focalPointMm) - VectorOf(before.positionMm));
  EXPECT_GT(glm::dot(moved, forward), 0.0);
  EXPECT_LT(glm::length(glm::cross(moved, forward)), 1e-6);
  QTest::qWait(100);
  EXPECT_EQ(this->Pose(), walked) << "no key is held";
  EXPECT_EQ(this->Steps(), 1);
  this->model.History()->undo();
  EXPECT_EQ(this->Pose(), before);
}

TEST_F(Tools, LeaveKeysToShortcutsUnlessTheUserWalks)
{
  EXPECT_FALSE(this->SendKey(QEvent::ShortcutOverride, Qt::Key_W));
  this->tools.Choose(LeftButton::Walk);
  EXPECT_FALSE(this->SendKey(QEvent::ShortcutOverride, Qt::Key_X));
  EXPECT_FALSE(this->SendKey(QEvent::ShortcutOverride, Qt::Key_S, Qt::ControlModifier));
}

TEST_F(Tools, LookAroundFromWhereTheEyeIs)
{
  this->tools.ShowCutHandles(false);
  this->tools.Choose(LeftButton::Walk);
  const CameraPose before = this->Pose();
  // A drag over the height of the view is its angle.
  this->DragAlong({ { 50.0, 150.0 }, { 350.0, 150.0 } });
  const CameraPose turned = this->Pose();
  EXPECT_EQ(turned.positionMm, before.positionMm);
  const auto direction = [](const CameraPose& pose)
  { return glm::normalize(VectorOf(pose.focalPointMm) - VectorOf(pose.positionMm)); };
  const double degrees = this->model.CurrentScene().camera.viewAngleDegrees;
  EXPECT_NEAR(
    glm::dot(direction(turned), direction(before)), std::cos(glm::radians(degrees)), 1e-6);
  const glm::dvec3 right = glm::cross(direction(before), VectorOf(before.viewUp));
  EXPECT_GT(glm::dot(direction(turned), right), 0.0);
}
