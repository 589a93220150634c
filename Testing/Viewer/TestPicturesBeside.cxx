// A thread draws the pictures of a window, which never waits for them.

#include "Answers.h"
#include "LoopGaps.h"
#include "TorsoWindow.h"

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
  this->View()->DrawInThread();
  this->Open("beside, open", "torso.vti");
  this->Open("beside, open", "large.vti");
  const Waiting sharpenedBeside = this->Sharpen("beside, sharpen", 1.0 / 150.0);
  const Waiting brightenedBeside = this->Brighten("beside, edit the look");
  this->Turn("beside, turn");
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
