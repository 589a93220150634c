// The whole window with real events, on a virtual display.

#include "Scene/Looks/Presets.h"
#include "TorsoWindow.h"
#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/View/VolumeView.h"

#include <QAction>
#include <QApplication>
#include <QColorDialog>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTest>

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace varimarch;

TEST_F(Window, OpensAFile)
{
  this->OpenTorso();
  EXPECT_EQ(this->Model()->CurrentScene().look.name, "ct-bone");
  EXPECT_FALSE(this->Model()->History()->canUndo());
}

TEST_F(Window, KeepsTheVolumeWhenAFileIsBad)
{
  this->OpenTorso();
  const auto study = this->Model()->CurrentStudy();
  std::ofstream(this->Path("bad.nrrd").toStdString()) << "NRRD0004\ntype: nonsense\n\n";
  QSignalSpy failed(this->window.Loader(), &LoadController::Failed);
  this->window.Open(this->Path("bad.nrrd"));
  ASSERT_TRUE(failed.wait(MostMilliseconds));
  EXPECT_EQ(this->Model()->CurrentStudy(), study);
  auto* const box = this->window.findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("bad.nrrd"));
}

TEST_F(Window, CutsMeasuresAndUndoes)
{
  this->OpenTorso();
  const QPoint middle = this->View()->rect().center();
  ASSERT_TRUE(this->View()->PointAt(middle)) << "the spine";

  // Drag from the bone at the centre of the view 30 pixels up and back down beside it.
  this->View()->SetTool(LeftButton::Distance);
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(this->View(), middle + QPoint(0, -20));
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + QPoint(0, -20));
  ASSERT_EQ(this->Model()->CurrentScene().measures.size(), 1);
  EXPECT_EQ(this->Model()->CurrentScene().measures[0].pointsMm[0], *this->View()->PointAt(middle));
  EXPECT_EQ(this->Model()->History()->count(), 1) << "a drag is a step";
  this->View()->SetTool(LeftButton::Turn);

  // Crop the front: a ray through the centre hits nothing before the centre of the volume.
  const double before = (*this->View()->PointAt(middle))[1];
  this->Model()->Edit(ScenePart::Cuts, "cut", [](Scene& scene) { scene.cuts.box[2] = 0.75; });
  const auto behind = this->View()->PointAt(middle);
  EXPECT_TRUE(!behind || (*behind)[1] > before);
  this->Model()->History()->undo();
  this->Model()->History()->undo();
  EXPECT_TRUE(this->Model()->CurrentScene().measures.empty());

  // Turning with the mouse is an undo step as well.
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle);
  for (int step = 1; step <= 3; ++step)
  {
    QTest::mouseMove(this->View(), middle + QPoint(20 * step, 0));
    QTest::qWait(20);
  }
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + QPoint(60, 0));
  EXPECT_TRUE(this->Model()->CurrentScene().camera.pose);
  EXPECT_EQ(this->Model()->History()->count(), 1);
}

TEST_F(Window, DrawsAnEditQuicklyThenFinely)
{
  this->OpenTorso();
  QTest::qWait(500);
  std::vector<double> rates;
  QObject::connect(this->View(), &VolumeView::Drawn, this->View(),
    [&] { rates.push_back(this->View()->RenderWindow()->GetDesiredUpdateRate()); });
  this->Model()->Edit(ScenePart::Background, "gray",
    [](Scene& scene) {
      scene.background = { 0.5, 0.5, 0.5 };
    });
  ASSERT_TRUE(QTest::qWaitFor([&] { return rates.size() >= 2; }, MostMilliseconds));
  EXPECT_GT(rates.front(), 5.0);
  EXPECT_LT(rates.back(), 0.1);
}

TEST_F(Window, KeepsTheClippingRangeWhileItIsTurned)
{
  this->OpenTorso();
  const std::array<double, 2> limits = { 400.0, 1000.0 };
  const auto range = [this]
  {
    std::array<double, 2> found;
    this->View()->Pipeline()->Renderer()->GetActiveCamera()->GetClippingRange(found.data());
    return found;
  };
  const std::array<double, 2> whole = range();
  this->Model()->Edit(
    ScenePart::Camera, "limits", [&](Scene& scene) { scene.camera.clippingRangeMm = limits; });
  EXPECT_EQ(range(), limits);
  const QPoint middle = this->View()->rect().center();
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(this->View(), middle + QPoint(50, 10));
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + QPoint(50, 10));
  EXPECT_TRUE(this->Model()->CurrentScene().camera.pose);
  EXPECT_EQ(range(), limits);
  this->Model()->History()->undo();
  this->Model()->History()->undo();
  EXPECT_NEAR(range()[0], whole[0], 1e-6);
}

TEST_F(Window, CutsByHand)
{
  this->OpenTorso();
  // Scissors remove the centre of the image and nothing else.
  const QPoint middle = this->View()->rect().center();
  ASSERT_TRUE(this->View()->PointAt(middle)) << "the spine";
  this->View()->SetTool(LeftButton::CutOut);
  const QPoint corners[] = { { -30, -30 }, { 30, -30 }, { 30, 30 }, { -30, 30 } };
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle + corners[0]);
  for (const QPoint& corner : corners)
  {
    QTest::mouseMove(this->View(), middle + corner);
  }
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + corners[3]);
  EXPECT_FALSE(this->View()->PointAt(middle));
  EXPECT_FALSE(this->Model()->CurrentScene().camera.pose) << "the camera stays";
  this->Model()->History()->undo();
  EXPECT_TRUE(this->View()->PointAt(middle));

  // Handles are visible while the panel of the cuts is raised.
  this->View()->SetTool(LeftButton::Turn);
  this->window.findChild<QDockWidget*>("cuts")->raise();
  QTest::qWait(100);
  const SceneCuts& cuts = this->Model()->CurrentScene().cuts;
  const auto handles =
    HandlesOf(cuts, this->Model()->CurrentStudy()->volume.image, this->View()->Frame());
  const QPoint face = this->View()->Frame().pixelOf(handles.at(1).pointMm)->toPoint();
  QTest::mousePress(this->View(), Qt::LeftButton, {}, face);
  QTest::mouseMove(this->View(), 0.5 * (face + middle));
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, 0.5 * (face + middle));
  EXPECT_NEAR(cuts.box[1], 0.75, 0.05);
  EXPECT_EQ(this->Model()->History()->count(), 1);
}

TEST_F(Window, FindsAClosedPanelAndRestoresTheLayout)
{
  auto* const look = this->window.findChild<QDockWidget*>("look");
  auto* const quality = this->window.findChild<QDockWidget*>("quality");
  const QRect before = quality->geometry();
  look->close();
  quality->setFloating(true);
  auto* const panels = this->window.findChild<QMenu*>("panels");
  const QList<QAction*> actions = panels->actions();
  const auto entry = std::find_if(
    actions.begin(), actions.end(), [](const QAction* action) { return action->text() == "Look"; });
  ASSERT_NE(entry, actions.end());
  EXPECT_FALSE((*entry)->isChecked());
  (*entry)->trigger();
  EXPECT_FALSE(look->isHidden());
  for (QDockWidget* const panel : this->window.findChildren<QDockWidget*>())
  {
    panel->close();
  }
  this->window.findChild<QAction*>("resetLayout")->trigger();
  QTest::qWait(100);
  for (const QDockWidget* const panel : this->window.findChildren<QDockWidget*>())
  {
    const bool comesWithACurve = panel->objectName() == "curve";
    EXPECT_EQ(panel->isHidden(), comesWithACurve) << panel->objectName().toStdString();
    EXPECT_FALSE(panel->isFloating()) << panel->objectName().toStdString();
  }
  EXPECT_FALSE(this->window.findChild<QDockWidget*>("presets")->visibleRegion().isEmpty());
  EXPECT_EQ(this->window.tabifiedDockWidgets(look).size(), 6);
  EXPECT_NEAR(quality->geometry().top(), before.top(), 60);
}

TEST_F(Window, GivesTheReasonForALookUntilAnotherIsChosen)
{
  this->OpenTorso();
  EXPECT_TRUE(this->window.statusBar()->currentMessage().startsWith("Look \"CT bone\""));
  this->Model()->SetPreset(BuiltInPreset("ct-vessels"), "choose");
  EXPECT_TRUE(this->window.statusBar()->currentMessage().isEmpty());
}

TEST_F(Window, RefinesAPictureThatStays)
{
  this->OpenTorso();
  QSignalSpy refined(this->View(), &VolumeView::Refined);
  QSignalSpy drawn(this->View(), &VolumeView::Drawn);
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return !refined.isEmpty() && refined.last().first().toDouble() == 8.0; },
      MostMilliseconds));
  drawn.clear();
  // An edit starts over, and a comparison uses single frames.
  this->Model()->Edit(ScenePart::Cuts, "cut", [](Scene& scene) { scene.cuts.box[2] = 0.3; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return drawn.count() == 2; }, MostMilliseconds));
  refined.clear();
  ASSERT_TRUE(refined.wait(MostMilliseconds));
  EXPECT_LE(refined.first().first().toDouble(), 2.0);
  this->View()->SetRefining(false);
  refined.clear();
  QTest::qWait(1000);
  EXPECT_TRUE(refined.isEmpty());
}

// A screen with two pixels per logical pixel in each direction.
class LargeScreen : public Window
{
};

TEST_F(LargeScreen, ShowsAVolumeCoarselyAtOnceAndThenInFull)
{
  this->window.resize(1920, 1080);
  std::vector<double> distances; // ray spacing of each frame with a volume
  QObject::connect(this->View(), &VolumeView::Drawn, this->View(),
    [&]
    {
      if (ScenePipeline* const pipeline = this->View()->Pipeline())
      {
        auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(pipeline->Mapper());
        distances.push_back(mapper->GetUsedImageSampleDistance());
      }
    });
  QSignalSpy refined(this->View(), &VolumeView::Refined);
  this->OpenTorso();
  ASSERT_FALSE(distances.empty());
  EXPECT_GT(distances.front(), 3.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return distances.back() == 1.0; }, MostMilliseconds));
  ASSERT_FALSE(refined.isEmpty());
  EXPECT_LE(refined.first().first().toDouble(), 1.0) << "the image is rendered in parts";
  EXPECT_EQ(this->View()->RenderWindow()->GetSize()[0], 2 * this->View()->width());
}

TEST_F(Window, ClosesWhileItLoads)
{
  this->window.Open(this->Path("torso.vti"));
  this->window.close();
}

TEST_F(Window, SwitchesBetweenPerspectiveAndParallelProjection)
{
  this->OpenTorso();
  auto* const action = this->window.findChild<QAction*>("parallelProjection");
  vtkCamera* const camera = this->View()->Pipeline()->Renderer()->GetActiveCamera();
  for (const bool parallel : { true, false, true })
  {
    action->trigger();
    EXPECT_EQ(camera->GetParallelProjection() != 0, parallel);
  }
  this->Model()->History()->undo();
  EXPECT_EQ(camera->GetParallelProjection(), 0);
  EXPECT_FALSE(action->isChecked());
}

TEST_F(Window, ShowsABackgroundWhileItIsChosen)
{
  this->OpenTorso();
  const std::array<double, 3> before = this->Model()->CurrentScene().background;
  const auto choose = [&](const QColor& color)
  {
    this->window.findChild<QAction*>("background")->trigger();
    auto* const dialog = this->window.findChild<QColorDialog*>();
    dialog->setCurrentColor(Qt::white);
    dialog->setCurrentColor(color);
    return dialog;
  };
  vtkRenderer* const renderer = this->View()->Pipeline()->Renderer();
  delete choose(Qt::green);
  EXPECT_EQ(renderer->GetBackground()[1], 1.0);
  EXPECT_EQ(renderer->GetBackground()[0], 0.0);
  EXPECT_EQ(this->Model()->History()->count(), 1) << "one visit to the dialog is a step";
  this->Model()->History()->undo();
  EXPECT_EQ(renderer->GetBackground()[1], before[1]);

  choose(Qt::red)->reject();
  EXPECT_EQ(this->Model()->CurrentScene().background, before);
  EXPECT_FALSE(this->Model()->History()->canUndo());
}

// The window and offscreen rendering share a thread, which has only one current context.
TEST_F(Window, DrawsOnWhileABenchmarkRuns)
{
  this->OpenTorso();
  this->window.findChild<QAction*>("benchmark")->trigger();
  auto* const dialog = this->window.findChild<BenchmarkDialog*>();
  ASSERT_NE(dialog, nullptr);
  QSignalSpy ended(dialog, &BenchmarkDialog::Ended);
  QSignalSpy drawn(this->View(), &VolumeView::Drawn);
  dialog->findChild<QSpinBox*>("count")->setValue(3);
  dialog->Start();
  ASSERT_TRUE(QTest::qWaitFor(
    [&]
    {
      this->View()->update();
      this->View()->RenderWindow()->Render();
      return !ended.isEmpty();
    },
    MostMilliseconds));
  EXPECT_GT(drawn.count(), 1);
}
