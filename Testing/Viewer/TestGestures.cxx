// Gestures in the views keep every point of the hand, however long the program takes to draw.

#include "Readers/Parsing/VtkMessages.h"
#include "Scene/Model/SceneCamera.h"
#include "TorsoWindow.h"

#include <QAction>
#include <QCursor>
#include <QStatusBar>

#include <vtkCamera.h>
#include <vtkVariationFieldVolumeMapper.h>

using namespace varimarch;

// The pointer is moved by the X server, since Qt thins out only events from outside.
TEST_F(Window, CutsAlongEveryPointOfAnOutline)
{
  this->OpenTorso();
  this->View()->SetTool(LeftButton::CutOut);
  const QPoint middle = this->View()->rect().center();
  const QPoint corners[] = { { -60, -60 }, { 60, -60 }, { 60, 60 }, { -60, 60 } };
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle + corners[0]);
  // All moves wait at once, as after a frame that took long.
  for (const QPoint& corner : corners)
  {
    QCursor::setPos(this->View()->mapToGlobal(middle + corner));
  }
  QTest::qWait(300);
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + corners[3]);
  const std::vector<ScissorsCut>& cuts = this->Model()->CurrentScene().cuts.scissors;
  ASSERT_EQ(cuts.size(), 1u);
  ASSERT_EQ(cuts[0].outline.size(), 4u);
  EXPECT_NEAR(cuts[0].outline[0][0], -cuts[0].outline[1][0], 0.02) << "a rectangle";
  EXPECT_NEAR(cuts[0].outline[1][1], -cuts[0].outline[2][1], 0.02);
}

TEST_F(Window, RefinesNothingWhileAMouseButtonIsHeld)
{
  this->OpenTorso();
  this->View()->SetTool(LeftButton::CutOut);
  this->Model()->Edit(ScenePart::Cuts, "cut", [](Scene& scene) { scene.cuts.box[2] = 0.3; });
  QTest::mousePress(this->View(), Qt::LeftButton, {}, { 10, 10 });
  QSignalSpy refined(this->View(), &VolumeView::Refined);
  QTest::qWait(1500);
  EXPECT_TRUE(refined.isEmpty());
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, { 10, 10 });
  EXPECT_TRUE(refined.wait(MostMilliseconds));
}

TEST_F(Window, PrintsNothingInNormalUse)
{
  VtkMessages printed;
  printed.ObserveOutput();
  // Without a volume there is no renderer to turn.
  QTest::mousePress(this->View(), Qt::LeftButton, {}, { 50, 50 });
  QTest::mouseMove(this->View(), { 90, 60 });
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, { 90, 60 });
  QTest::keyClick(this->View(), Qt::Key_P);
  this->OpenTorso();
  this->Model()->Edit(
    ScenePart::Render, "quality", [](Scene& scene) { scene.render.errorTolerance = 1e-6; });
  QSignalSpy drawn(this->View(), &VolumeView::Drawn);
  ASSERT_TRUE(QTest::qWaitFor([&] { return drawn.count() >= 2; }, MostMilliseconds));
  EXPECT_FALSE(vtkVariationFieldVolumeMapper::SafeDownCast(this->View()->Pipeline()->Mapper())
                 ->GetErrorToleranceIsKept())
    << "the mapper has reason to warn";
  EXPECT_TRUE(printed.All().empty()) << printed.FirstSentence();
}

TEST_F(Window, WalksByKeysThatAreShortcutsOtherwise)
{
  this->OpenTorso();
  this->View()->SetTool(LeftButton::Walk);
  const auto camera = [this]() -> const Camera& { return this->Model()->CurrentScene().camera; };
  QTest::keyPress(this->View(), Qt::Key_W);
  ASSERT_TRUE(QTest::qWaitFor([&] { return camera().pose.has_value(); }, MostMilliseconds));
  QTest::keyRelease(this->View(), Qt::Key_W);
  EXPECT_FALSE(camera().parallel);
  EXPECT_EQ(PoseOf(this->View()->Pipeline()->Renderer()->GetActiveCamera()), *camera().pose);
}
