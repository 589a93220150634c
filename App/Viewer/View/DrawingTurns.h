#ifndef Varimarch_Viewer_DrawingTurns_h
#define Varimarch_Viewer_DrawingTurns_h

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <deque>

class QWidget;

namespace varimarch
{

/// Paints widgets whose images take long, each in a turn of the event loop of its own, so that the
/// window reacts between them. Qt paints all widgets that have changed in one turn. A widget that
/// awaits its turn should paint nothing that takes long.
class DrawingTurns : public QObject
{
  Q_OBJECT

public:
  explicit DrawingTurns(QObject* parent = nullptr);

  /// Puts a widget at the end of the queue, unless it is in it.
  void Await(QWidget* widget);

  /// True until the turn of the widget begins.
  bool Awaits(const QWidget* widget) const;

private:
  void PaintNext();

  std::deque<QPointer<QWidget>> queue;
  QTimer turn;
};

}

#endif
