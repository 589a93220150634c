#ifndef Varimarch_Testing_RandomUser_h
#define Varimarch_Testing_RandomUser_h

#include "Module/Scenes/Dice.h"
#include "Viewer/MainWindow.h"

#include <QList>
#include <QString>

#include <cstdint>

class QAction;
class QWidget;

namespace varimarch
{

/// Files that a random user opens.
struct RandomFiles
{
  QString scan;
  QString times;        ///< a scan of several times
  QString further;      ///< a scan to draw over another
  QString segmentation; ///< a segmentation of the scan
};

/// A user without a plan: clicks, drags, wheels, keys, words, menus, lists and sliders at random,
/// in everything that the window shows at that moment. Dialogs are left to others.
class RandomUser
{
public:
  RandomUser(MainWindow* window, const RandomFiles& files, std::uint64_t seed);

  /// Does something, and returns its name.
  QString Act();

  /// Opens a scan without waiting for it, and without work that a question would protect.
  QString Open();

private:
  QPoint PlaceIn(const QWidget* widget);
  template <class Thing>
  Thing AnyOf(const QList<Thing>& things);
  QList<QWidget*> Views() const;
  QWidget* Dragged();

  QString OpenSomething();
  QString Drop();
  QString Drag();
  QString DragIn(QWidget* widget);
  QString Turn();
  QString Annotate();
  QString Key();
  QString Type(QWidget* line);
  QString Trigger();
  QString Undo();
  QString Resize();
  QString RaisePanel();
  QString ChooseItem();
  QString Operate();
  void Set(QWidget* control);

  MainWindow* window;
  RandomFiles files;
  Dice dice;
};

}

#endif
