// Measures how many images a second a window shows while the mouse turns the volume, and how long
// its event loop waits meanwhile.
//
// Usage: ViewerTurnSpeed [--layout large|equal|alone] [--seconds NUMBER] [FILE], on a display that
// the window fills. Without a file, it turns a torso of 256 x 224 x 160 voxels.

#include "LoopGaps.h"
#include "PrivateSettings.h"
#include "Viewer/MainWindow.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/ViewLayout.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/View/VtkPictures.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QScreen>
#include <QSurfaceFormat>
#include <QTest>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

/// The times of the images that a window showed.
class ShownImages : public QObject
{
public:
  explicit ShownImages(VolumeView* view)
  {
    QObject::connect(view, &VolumeView::Drawn, this, [this] { this->isNew = true; });
    view->findChild<QWidget*>("overlay")->installEventFilter(this);
    this->clock.start();
  }

  // The window is on the screen when Qt has gone through all that it paints.
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::Paint)
    {
      QTimer::singleShot(0, this, [this] { this->Note(); });
    }
    return QObject::eventFilter(watched, event);
  }

  void Forget() { this->seconds.clear(); }
  int Count() const { return int(this->seconds.size()); }

  /// Times between two images, the shortest first [s].
  std::vector<double> Pauses() const
  {
    std::vector<double> pauses;
    for (std::size_t i = 1; i < this->seconds.size(); ++i)
    {
      pauses.push_back(this->seconds[i] - this->seconds[i - 1]);
    }
    std::sort(pauses.begin(), pauses.end());
    return pauses;
  }

private:
  void Note()
  {
    if (this->isNew)
    {
      this->isNew = false;
      this->seconds.push_back(1e-9 * double(this->clock.nsecsElapsed()));
    }
  }

  QElapsedTimer clock;
  bool isNew = false;
  std::vector<double> seconds;
};

void Open(MainWindow& window, const QString& file)
{
  if (file.isEmpty())
  {
    const ProceduralSource source{ ProceduralKind::Torso, { 256, 224, 160 }, 1 };
    LoadedVolume volume = LoadVolume(source);
    ImageStatistics statistics(volume.image);
    window.Model()->Open(
      source, std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) }));
  }
  else
  {
    window.Open(file);
  }
  bool isDrawn = false;
  const auto connection = QObject::connect(window.CentralView()->Ours(), &VolumeView::Drawn,
    window.CentralView(), [&] { isDrawn = true; });
  constexpr int MostMilliseconds = 120000;
  if (!QTest::qWaitFor([&] { return isDrawn && window.Model()->CurrentStudy(); }, MostMilliseconds))
  {
    throw std::runtime_error("the volume is not drawn");
  }
  QObject::disconnect(connection);
}

void Arrange(MainWindow& window, const QString& layout)
{
  auto* const views = window.findChild<ViewLayout*>();
  if (layout == "equal")
  {
    views->Arrange(ViewLayout::Arrangement::Equal);
  }
  else if (layout == "alone")
  {
    views->ShowAlone(window.CentralView());
  }
  QTest::qWait(500);
}

// Moves the mouse a little every 10 ms, as a hand does.
void Turn(VolumeView* view, ShownImages& images, std::optional<LoopGaps>& gaps, double seconds)
{
  const QPoint middle = view->rect().center();
  QTest::mousePress(view, Qt::LeftButton, {}, middle);
  QElapsedTimer clock;
  clock.start();
  // The first images find the size that is drawn in time.
  constexpr double WarmSeconds = 2.0;
  bool isWarm = false;
  for (int step = 0; 1e-3 * double(clock.elapsed()) < WarmSeconds + seconds; ++step)
  {
    if (!isWarm && 1e-3 * double(clock.elapsed()) > WarmSeconds)
    {
      isWarm = true;
      images.Forget();
      gaps.emplace();
    }
    const QPointF place = middle + QPoint(step % 200 < 100 ? step % 100 : 100 - step % 100, 0);
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
    QTest::qWait(10);
  }
}

int Run(const QCommandLineParser& options)
{
  MainWindow window;
  VolumeView* const view = window.CentralView()->Ours();
  if (IsOpenGLOnProcessor())
  {
    view->DrawInThread(); // as the program does
  }
  window.setGeometry(QApplication::primaryScreen()->availableGeometry());
  window.show();
  Open(window, options.positionalArguments().value(0));
  Arrange(window, options.value("layout"));
  ShownImages images(view);
  std::optional<LoopGaps> gaps;
  Turn(view, images, gaps, options.value("seconds").toDouble());
  const std::vector<double> pauses = images.Pauses();
  if (pauses.empty())
  {
    throw std::runtime_error("the window shows no images");
  }
  const auto print = [](const QSize& size)
  { return std::to_string(size.width()) + 'x' + std::to_string(size.height()); };
  const double ratio = view->devicePixelRatioF();
  std::cout << options.value("layout").toStdString() << ": window " << print(window.size() * ratio)
            << ", view " << print(view->size() * ratio) << ", images while turning "
            << print(view->PicturePixels()) << ", " << images.Count() << " images, median "
            << 1.0 / pauses[pauses.size() / 2] << " and slowest " << 1.0 / pauses.back()
            << " images a second; the event loop waited for at most " << gaps->LongestMilliseconds()
            << " ms, its thread worked for at most " << gaps->MostWorkMilliseconds() << " ms\n";
  QTest::mouseRelease(view, Qt::LeftButton, {}, view->rect().center());
  return 0;
}

}

int main(int argumentCount, char** arguments)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const PrivateSettings settings;
  QApplication application(argumentCount, arguments);
  QCommandLineParser options;
  options.addHelpOption();
  options.addPositionalArgument("file", "a volume to turn", "[file]");
  options.addOption({ "layout", "large, equal, or alone", "name", "large" });
  options.addOption({ "seconds", "of turning that are counted", "number", "5" });
  options.process(application);
  try
  {
    return Run(options);
  }
  catch (const std::exception& problem)
  {
    std::cerr << "ViewerTurnSpeed: " << problem.what() << '\n';
    return 1;
  }
}
