// A thread draws the pictures of a window, which never waits for them.

#include "Answers.h"
#include "LoopGaps.h"
#include "TorsoWindow.h"
#include "Viewer/View/SliceView.h"

#include <QDoubleSpinBox>
#include <QTimer>

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <set>

using namespace varimarch;

namespace
{

// Counts the slices that are painted for the first time in each turn of the event loop.
class SlicesPerTurn : public QObject
{
public:
  explicit SlicesPerTurn(const QWidget& window)
    : turns(window.findChild<DrawingTurns*>())
  {
    for (SliceView* const slice : window.findChildren<SliceView*>())
    {
      slice->installEventFilter(this);
    }
    QObject::connect(&this->turn, &QTimer::timeout, this, [this] { this->inTurn = 0; });
    this->turn.start(0);
  }

  int Painted() const { return int(this->painted.size()); }
  int MostInATurn() const { return this->most; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    const bool isPainted =
      event->type() == QEvent::Paint && !this->turns->Awaits(static_cast<QWidget*>(watched));
    if (isPainted && this->painted.insert(watched).second)
    {
      this->most = std::max(this->most, ++this->inTurn);
    }
    return false;
  }

private:
  const DrawingTurns* turns;
  QTimer turn;
  std::set<QObject*> painted;
  int inTurn = 0;
  int most = 0;
};

// Counts how often a widget is painted.
class PaintCount : public QObject
{
public:
  explicit PaintCount(QWidget* widget) { widget->installEventFilter(this); }

  int count = 0;

protected:
  bool eventFilter(QObject*, QEvent* event) override
  {
    this->count += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }
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
  // Does something, and watches the loop until the picture that follows is refined. Prints how long
  // the loop waited, and returns how many images the window's thread drew.
  int While(const char* name, const std::function<void()>& something)
  {
    double pictures = 0.0;
    const auto connection =
      QObject::connect(this->View(), &VolumeView::Refined, [&](double now) { pictures = now; });
    int images = 0;
    vtkNew<vtkCallbackCommand> counting;
    counting->SetClientData(&images);
    counting->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    const auto observer =
      this->View()->RenderWindow()->AddObserver(vtkCommand::StartEvent, counting);
    LoopGaps gaps;
    something();
    EXPECT_TRUE(QTest::qWaitFor([&] { return pictures >= 8.0; }, MostMilliseconds)) << name;
    QObject::disconnect(connection);
    this->View()->RenderWindow()->RemoveObserver(observer);
    std::cout << name << ": longest gap " << gaps.LongestMilliseconds() << " ms, most work "
              << gaps.MostWorkMilliseconds() << " ms, images of the window's thread " << images
              << '\n';
    return images;
  }

  int Open(const char* name, const QString& file)
  {
    const Answers discard(QMessageBox::Discard, {});
    return this->While(name, [&] { this->window.Open(this->Path(file)); });
  }

  // Asks for less error, which takes a search and a fine picture.
  int Sharpen(const char* name, double tolerance)
  {
    return this->While(name,
      [&]
      {
        this->Model()->Edit(ScenePart::Render, "quality",
          [&](Scene& scene) { scene.render.errorTolerance = tolerance; });
      });
  }

  int Brighten(const char* name)
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

  int RemoveTable(const char* name, bool isRemoved)
  {
    return this->While(name,
      [&]
      {
        this->Model()->Edit(
          ScenePart::Cuts, "table", [&](Scene& scene) { scene.cuts.bodyOnly = isRemoved; });
      });
  }

  // Clicks into a slice, so that a region grows and its segment is counted.
  int GrowRegion(const char* name)
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

  int Turn(const char* name)
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

// The window's thread draws images of the same window without the thread, so the test can tell.
TEST_F(PicturesBeside, LeaveTheEventLoopFree)
{
  this->WriteTorso("large.vti", { 64, 56, 40 });
  EXPECT_GT(this->Open("window's thread, open", "large.vti"), 0);
  EXPECT_GT(this->Sharpen("window's thread, sharpen", 1.0 / 150.0), 0);
  EXPECT_GT(this->Brighten("window's thread, edit the look"), 0);
  EXPECT_GT(this->Turn("window's thread, turn"), 0);
  EXPECT_GT(this->RemoveTable("window's thread, remove the table", true), 0);
  this->View()->DrawInThread();
  EXPECT_EQ(this->Open("beside, open", "torso.vti"), 0);
  EXPECT_EQ(this->Open("beside, open", "large.vti"), 0);
  EXPECT_EQ(this->Sharpen("beside, sharpen", 1.0 / 150.0), 0);
  EXPECT_EQ(this->Brighten("beside, edit the look"), 0);
  EXPECT_EQ(this->Turn("beside, turn"), 0);
  EXPECT_EQ(this->RemoveTable("beside, remove the table", true), 0);
  EXPECT_EQ(this->GrowRegion("beside, grow a region and count it"), 0);
}

// On a large screen the slices of a new volume are the longest work of the window's thread.
TEST_F(PicturesBeside, ComeWithOneSliceInATurnOfTheLoop)
{
  this->View()->DrawInThread();
  for (const char* const name : { "open the first scan", "open another scan" })
  {
    const SlicesPerTurn slices(this->window);
    this->Open(name, "torso.vti");
    EXPECT_EQ(slices.Painted(), 3) << name;
    EXPECT_EQ(slices.MostInATurn(), 1) << name;
  }
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

TEST_F(PicturesBeside, AreComparedToo)
{
  this->View()->DrawInThread();
  this->OpenTorso();
  this->Turn("turn");
  const QImage before = this->Middle();
  QSignalSpy compared(this->window.CentralView(), &ComparisonView::Compared);
  this->window.Compare(MapperKind::VtkGpu);
  ASSERT_TRUE(compared.wait(MostMilliseconds));
  EXPECT_LT(this->window.CentralView()->LastDifference()->rootMeanSquare, 20.0) << "of one scene";
  EXPECT_GT(ColorCount(this->Middle()), 10) << "our image is seen";
  EXPECT_FALSE(this->Surface()->isVisible()) << "the thread draws it";
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
}

// The corner tells the truth at any moment, also before the thread has drawn anything new.
TEST_F(PicturesBeside, AreMarkedTheMomentTheyAreOutOfDate)
{
  this->View()->DrawInThread();
  this->Open("open", "torso.vti");
  const auto line = [this] { return this->View()->Report().section('\n', 1, 1); };
  EXPECT_EQ(line(), "error at most 1/64");
  Look look = this->Model()->CurrentScene().look;
  look.opacities.back().opacity *= 0.5;
  this->Model()->SetLook(look, "look");
  EXPECT_EQ(line(), "out of date") << "before the program goes on";
  EXPECT_TRUE(QTest::qWaitFor([&] { return line() == "error at most 1/64"; }, MostMilliseconds));
  this->window.resize(this->window.size() - QSize(40, 40));
  QApplication::processEvents();
  EXPECT_NE(line(), "error at most 1/64") << "a picture of another size is stretched";
}

TEST_F(PicturesBeside, LeaveNoImageOfAnotherScan)
{
  this->View()->DrawInThread();
  this->Open("open", "torso.vti");
  PaintCount paints(this->View()->findChild<QWidget*>("overlay"));
  int paintsOfNothing = -1; // between the new scan and its first image
  QObject::connect(this->Model(), &SceneModel::Changed, &paints,
    [&](ScenePart part)
    {
      if (part == ScenePart::Volume)
      {
        EXPECT_EQ(ColorCount(this->Middle()), 1) << "the background";
        paints.count = 0;
      }
    });
  QObject::connect(this->View(), &VolumeView::Drawn, &paints,
    [&] { paintsOfNothing = paintsOfNothing < 0 ? paints.count : paintsOfNothing; });
  this->Open("open another scan", "torso.vti");
  EXPECT_GT(paintsOfNothing, 0) << "the last image goes at once";
}

TEST_F(PicturesBeside, AreMovingWhileTheUserTurnsTheView)
{
  this->WriteTorso("large.vti", { 96, 84, 60 });
  this->View()->DrawInThread();
  this->Open("open", "large.vti");
  QStringList told;
  const QPoint middle = this->View()->rect().center();
  QTest::mousePress(this->View(), Qt::LeftButton, {}, middle);
  for (int x = 1; x <= 40; ++x)
  {
    QTest::mouseMove(this->View(), middle + QPoint(2 * x, x));
    QTest::qWait(10);
    told << this->View()->Report().section('\n', 1, 1);
  }
  QTest::mouseRelease(this->View(), Qt::LeftButton, {}, middle + QPoint(80, 40));
  EXPECT_EQ(told.filter("moving").size(), told.size()) << told.join("; ").toStdString();
}
