// The comparison with VTK's mappers in the window.

#include "TorsoWindow.h"
#include "Viewer/View/VtkPictures.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>

#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

using namespace varimarch;

TEST_F(Window, ComparesWithVtk)
{
  this->OpenTorso();
  ComparisonView* const view = this->window.CentralView();
  const QSize alone = this->View()->size();
  QSignalSpy compared(view, &ComparisonView::Compared);
  view->CompareWith(MapperKind::VtkGpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  ASSERT_TRUE(view->LastDifference());
  EXPECT_GT(view->LastDifference()->rootMeanSquare, 0.0);
  EXPECT_LT(view->LastDifference()->rootMeanSquare, 20.0) << "of one scene";
  const auto* const difference = view->findChild<QLabel*>("difference");
  QApplication::processEvents();
  EXPECT_LE(difference->pixmap(Qt::ReturnByValue).height(), difference->height())
    << "its scale is at the bottom";

  // Both turn together, and the difference of the earlier view is marked.
  const QList<VolumeView*> pictures = view->findChildren<VolumeView*>();
  ASSERT_EQ(pictures.size(), 2);
  VolumeView* const theirs = pictures[0] == this->View() ? pictures[1] : pictures[0];
  EXPECT_NEAR(
    double(theirs->width()) / theirs->height(), double(alone.width()) / alone.height(), 0.02)
    << "the shape of the view alone, so that nothing is cropped";
  EXPECT_TRUE(difference->isEnabled());
  QSignalSpy drawnByThem(theirs, &VolumeView::Drawn);
  this->Model()->Edit(
    ScenePart::Camera, "turn", [](Scene& scene) { scene.camera.azimuthDegrees = 40.0; });
  EXPECT_EQ(drawnByThem.count(), 1) << "before the program goes on";
  EXPECT_FALSE(difference->isEnabled());
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_TRUE(difference->isEnabled());
  view->CompareWith(std::nullopt);
  EXPECT_FALSE(view->LastDifference());
  EXPECT_EQ(this->View()->size(), alone);
}

// VTK's CPU mapper has no masks, so the images show different scenes.
TEST_F(Window, TellsNoDifferenceToAnImageOfLessThanTheScene)
{
  this->OpenTorso();
  ComparisonView* const view = this->window.CentralView();
  QSignalSpy compared(view, &ComparisonView::Compared);
  view->CompareWith(MapperKind::VtkCpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  ASSERT_TRUE(view->LastDifference());
  const auto* const difference = view->findChild<QLabel*>("difference");
  EXPECT_FALSE(difference->pixmap(Qt::ReturnByValue).isNull());
  this->Model()->Edit(ScenePart::Cuts, "table", [](Scene& scene) { scene.cuts.bodyOnly = true; });
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_FALSE(view->LastDifference());
  EXPECT_TRUE(difference->pixmap(Qt::ReturnByValue).isNull());
  this->Model()->Edit(ScenePart::Cuts, "table", [](Scene& scene) { scene.cuts.bodyOnly = false; });
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_TRUE(view->LastDifference());
}

TEST_F(Window, DrawsAFinePictureOfVtkInBands)
{
  this->OpenTorso();
  ComparisonView* const view = this->window.CentralView();
  QSignalSpy compared(view, &ComparisonView::Compared);
  view->CompareWith(MapperKind::VtkGpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  const QList<VolumeView*> pictures = view->findChildren<VolumeView*>();
  VolumeView* const theirs = pictures[0] == this->View() ? pictures[1] : pictures[0];
  ASSERT_TRUE(theirs->FloatPicture());
  // A change forgets the image, which the window then draws again.
  this->Model()->Edit(
    ScenePart::Camera, "turn", [](Scene& scene) { scene.camera.azimuthDegrees = 40.0; });
  EXPECT_FALSE(theirs->FloatPicture());
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  const vtkSmartPointer<vtkImageData> shown = theirs->FloatPicture();
  ASSERT_TRUE(shown);

  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(theirs->RenderWindow());
  vtkRenderer* const renderer = theirs->Pipeline()->Renderer();
  StillPicture still;
  still.Begin(window, renderer);
  int bands = 1;
  while (!still.Continue())
  {
    ++bands;
  }
  EXPECT_GT(bands, 1);
  const vtkSmartPointer<vtkImageData> inOnePiece = CaptureFloatImage(window, renderer);
  const auto count = std::size_t(inOnePiece->GetNumberOfPoints());
  for (vtkImageData* const picture : { shown.Get(), still.Picture() })
  {
    ASSERT_EQ(std::size_t(picture->GetNumberOfPoints()), count);
    const ImageError error = CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
      static_cast<const float*>(inOnePiece->GetScalarPointer()), count);
    EXPECT_LT(error.largest, 0.01) << "of 255";
  }
}

TEST_F(Window, WipesBetweenOursAndVtks)
{
  this->OpenTorso();
  ComparisonView* const view = this->window.CentralView();
  QSignalSpy compared(view, &ComparisonView::Compared);
  view->SetWipe(true);
  view->CompareWith(MapperKind::VtkGpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_GT(view->LastDifference()->rootMeanSquare, 0.0);
  EXPECT_LT(view->LastDifference()->rootMeanSquare, 20.0) << "both lie over each other";
  const QList<VolumeView*> pictures = view->findChildren<VolumeView*>();
  ASSERT_EQ(pictures.size(), 2);
  EXPECT_EQ(pictures[0]->size(), pictures[1]->size());
  const auto leftEdgeOfTheirs = [&]
  {
    VolumeView* const theirs = pictures[0] == this->View() ? pictures[1] : pictures[0];
    EXPECT_EQ(theirs->mapTo(view, QPoint()), this->View()->mapTo(view, QPoint()));
    return theirs->parentWidget()->x();
  };
  EXPECT_NEAR(leftEdgeOfTheirs(), view->width() / 2, 1);
  // The divider can be dragged and moved by keys.
  QWidget* const divider = view->childAt(view->width() / 2, 20);
  ASSERT_NE(divider, this->View());
  QTest::mousePress(divider, Qt::LeftButton, {}, divider->rect().center());
  QMouseEvent move(
    QEvent::MouseMove, divider->rect().center() + QPoint(60, 0), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(divider, &move);
  QTest::mouseRelease(divider, Qt::LeftButton);
  EXPECT_NEAR(leftEdgeOfTheirs(), view->width() / 2 + 60, 6);
  const int before = leftEdgeOfTheirs();
  QTest::keyClick(divider, Qt::Key_Left);
  EXPECT_LT(leftEdgeOfTheirs(), before);
}
