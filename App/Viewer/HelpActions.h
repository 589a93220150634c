#ifndef Varimarch_Viewer_HelpActions_h
#define Varimarch_Viewer_HelpActions_h

#include <QDialog>
#include <QPointer>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QMainWindow;
class QMenu;
class QPushButton;

namespace varimarch
{

/// A place of the window that the tour shows.
struct TourStep
{
  QString title;
  QString text;                     ///< says what can be tried there
  std::function<QWidget*()> target; ///< makes the place visible, and returns it
};

/// A tour of the window for newcomers: a small dialog beside a frame around one place after the
/// other, which may be tried out meanwhile.
class Tour : public QDialog
{
  Q_OBJECT

public:
  /// @param steps   at least one
  /// @param window  the window that is shown
  Tour(std::vector<TourStep> steps, QWidget* window);
  ~Tour() override;

protected:
  /// The frame follows its place.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  class Frame;

  void Show(int step);
  void PlaceFrame();

  std::vector<TourStep> steps;
  int current = 0;
  QPointer<QWidget> target; ///< the place that is shown
  Frame* frame;
  QLabel* title;
  QLabel* text;
  QPushButton* back;
  QPushButton* next;
};

/// The Help menu: commands, keys, the tour, languages, the log, and the notice that the program is
/// not for diagnostic use.
class HelpActions : public QObject
{
  Q_OBJECT

public:
  /// Views that the tour shows, beside panels.
  struct TourPlaces
  {
    QWidget* volume;
    QWidget* slice;
  };

  HelpActions(const TourPlaces& places, QMainWindow* window);

  void AddTo(QMenu* menu);
  void ShowTour();

  /// Shows the notice, once per user.
  void ShowNoticeOnce();

signals:
  /// The tour needs a volume.
  void TourBegins();

private:
  void FillLanguages(QMenu* menu);
  std::vector<TourStep> TourSteps();
  void ShowAbout();

  TourPlaces places;
  QMainWindow* window;
};

}

#endif
