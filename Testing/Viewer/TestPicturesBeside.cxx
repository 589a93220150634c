// A thread draws the pictures of a window, which never waits for them.

#include "Answers.h"
#include "LoopGaps.h"
#include "TorsoWindow.h"
#include "Viewer/View/SliceView.h"

#include <QDoubleSpinBox>

#include <functional>
#include <iostream>
#include <set>

using namespace varimarch;

namespace
{

// How the event loop went on while something was drawn.
struct Waiting
{
  double longestMilliseconds;
  double feltPart;
};

int ColorCount(const QImage& image)
{
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      colors.insert(image.pixel(x, y));
    }
  }
  return int(colors.size());
}

class PicturesBeside : public Window
{
protected:
  // Does something, and watches the loop until the picture that follows is refined.
  Waiting While(const char* name, const std::function<void()>& something)
  {
    double pictures = 0.0;
    const auto connection =
      QObject::connect(this->View(), &VolumeView::Refined, [&](double now) { pictures = now; });
    LoopGaps gaps;
    something();
    EXPECT_TRUE(QTest::qWaitFor([&] { return pictures >= 8.0; }, MostMilliseconds)) << name;
    QObject::disconnect(connection);
    const Waiting waiting = { gaps.LongestMilliseconds(), gaps.FeltPart() };
    std::cout << name << ": longest gap " << waiting.longestMilliseconds << " ms, "
              << 100.0 * waiting.feltPart << " % of the time in gaps above "
              << LoopGaps::FeltMilliseconds << " ms\n";
    return waiting;
  }

  Waiting Open(const char* name, const QString& file)
  {
    const Answers discard(QMessageBox::Discard, {});
    return this->While(name, [&] { this->window.Open(this->Path(file)); });
  }

  // Asks for less error, which takes a search and a fine picture.
  Waiting Sharpen(const char* name, double tolerance)
  {
    return this->While(name,
      [&]
      {
        this->Model()->Edit(ScenePart::Render, "quality",
          [&](Scene& scene) { scene.render.errorTolerance = tolerance; });
      });
  }

  Waiting Brighten(const char* name)
  {
    return this->While(name,
      [&]
      {
        Look look = this->Model()->CurrentScene().look;
        for (OpacityNode& node : look.opacities)
        {
          node.opacity *= 0.9;
        }
        this->Model()->SetLook(look, "look");
      });
  }

  Waiting RemoveTable(const char* name, bool isRemoved)
  {
    return this->While(name,
      [&]
      {
        this->Model()->Edit(
          ScenePart::Cuts, "table", [&](Scene& scene) { scene.cuts.bodyOnly = isRemoved; });
      });
  }

  // Clicks into a slice, so that a region grows and its segment is counted.
  Waiting GrowRegion(const char* name)
  {
    return this->While(name,
      [&]
      {
        for (const char* const button : { "newSegment", "toolRegion" })
        {
          this->window.findChild<QPushButton*>(button)->click();
        }
        this->window.findChild<QDoubleSpinBox*>("smallestValue")->setValue(-200.0);
        auto* const slice = this->window.findChild<SliceView*>();
        QTest::mouseClick(slice, Qt::LeftButton, {}, slice->rect().center());
        EXPECT_TRUE(QTest::qWaitFor(
          [&]
          {
            const auto study = this->Model()->CurrentStudy();
            return study->labels && study->areSegmentsCounted &&
              study->segmentStatistics.front().voxels > 100;
          },
          MostMilliseconds))
          << name;
      });
  }

  void Drag()
  {
    const QPoint middle = this->View()->rect().center();
    QTest::mousePress(this->View(), Qt::LeftButton, {}, middle);
    for (int x = 1; x <= 40; ++x)
    {
      QTest::mouseMove(this->View(), middle + QPoint(4 * x, x));
      QTest::qWait(10);
    }
    QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + QPoint(160, 40));
  }

  Waiting Turn(const char* name)
  {
    return this->While(name, [&] { this->Drag(); });
  }

  // The middle of the view. The corners have the time of a picture.
  QImage Middle()
  {
    const QRect all = this->View()->rect();
    return this->View()
      ->grab(all.adjusted(all.width() / 4, all.height() / 4, -all.width() / 4, -all.height() / 4))
      .toImage();
  }

  void WriteTorso(const QString& name, const std::array<int, 3>& dimensions)
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(
      LoadVolume(ProceduralSource{ ProceduralKind::Torso, dimensions, 1 }).image);
    writer->SetFileName(this->Path(name).toUtf8());
    writer->Write();
  }
};

}

// The measure of the same window without the thread shows that the test can tell.
TEST_F(PicturesBeside, LeaveTheEventLoopFree)
{
  this->WriteTorso("large.vti", { 64, 56, 40 });
  this->Open("window's thread, open", "large.vti");
  const Waiting sharpened = this->Sharpen("window's thread, sharpen", 1.0 / 150.0);
  const Waiting brightened = this->Brighten("window's thread, edit the look");
  this->Turn("window's thread, turn");
  const Waiting removed = this->RemoveTable("window's thread, remove the table", true);
  this->View()->DrawInThread();
  this->Open("beside, open", "torso.vti");
  this->Open("beside, open", "large.vti");
  const Waiting sharpenedBeside = this->Sharpen("beside, sharpen", 1.0 / 150.0);
  const Waiting brightenedBeside = this->Brighten("beside, edit the look");
  this->Turn("beside, turn");
  const Waiting removedBeside = this->RemoveTable("beside, remove the table", true);
  this->GrowRegion("beside, grow a region and count it");
  EXPECT_LT(removedBeside.feltPart, 0.5 * removed.feltPart);
  EXPECT_LT(sharpenedBeside.feltPart, 0.5 * sharpened.feltPart);
  EXPECT_LT(brightenedBeside.feltPart, 0.5 * brightened.feltPart);
}

TEST_F(PicturesBeside, FollowTheCameraOfTheWindow)
{
  this->View()->DrawInThread();
  this->OpenTorso();
  const QImage before = this->Middle();
  EXPECT_GT(ColorCount(before), 10) << "there is a torso";
  this->Turn("turn");
  EXPECT_TRUE(this->Model()->CurrentScene().camera.pose.has_value());
  EXPECT_NE(this->Middle(), before);
}

TEST_F(PicturesBeside, GiveWayToComparisons)
{
  this->View()->DrawInThread();
  this->OpenTorso();
  this->Turn("turn");
  const QImage before = this->Middle();
  QSignalSpy compared(this->window.CentralView(), &ComparisonView::Compared);
  this->window.Compare(MapperKind::VtkGpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_LT(this->window.CentralView()->LastDifference()->rootMeanSquare, 20.0) << "of one scene";
  this->Drag();
  this->While("after a comparison", [&] { this->window.Compare(std::nullopt); });
  EXPECT_NE(this->Middle(), before) << "the camera was turned during the comparison";
}

// The window has no mask of its own while the thread draws; what is removed is not pointed at.
TEST_F(PicturesBeside, LeaveOutWhatIsRemovedForThePointerToo)
{
  this->View()->DrawInThread();
  this->OpenTorso();
  const QPointF middle = this->View()->rect().center();
  this->Brighten("look");
  ASSERT_TRUE(this->View()->PointAt(middle));
  // Scissors around the whole image remove everything.
  const auto cutAll = [](Scene& scene)
  {
    ScissorsCut cut;
    cut.camera = scene.camera;
    cut.outline = { { -9.0, -9.0 }, { 9.0, -9.0 }, { 9.0, 9.0 }, { -9.0, 9.0 } };
    scene.cuts.scissors = { cut };
  };
  this->Turn("turn"); // the camera has a pose
  this->While("cut", [&] { this->Model()->Edit(ScenePart::Cuts, "cut", cutAll); });
  EXPECT_FALSE(this->View()->PointAt(middle));
  EXPECT_EQ(this->View()->Pipeline()->Mask(), nullptr) << "made in the thread only";
  this->View()->SetRefining(false);
  EXPECT_TRUE(this->View()->Pipeline()->Mask()) << "the window draws again";
  EXPECT_FALSE(this->View()->PointAt(middle));
}
