#include "Viewer/View/DrawingTurns.h"

#include <QWidget>

#include <algorithm>

namespace varimarch
{

DrawingTurns::DrawingTurns(QObject* parent)
  : QObject(parent)
{
  this->turn.setSingleShot(true);
  connect(&this->turn, &QTimer::timeout, this, &DrawingTurns::PaintNext);
}

void DrawingTurns::Await(QWidget* widget)
{
  if (!this->Awaits(widget))
  {
    this->queue.push_back(widget);
    this->turn.start(0);
  }
}

bool DrawingTurns::Awaits(const QWidget* widget) const
{
  return std::find(this->queue.begin(), this->queue.end(), widget) != this->queue.end();
}

void DrawingTurns::PaintNext()
{
  const QPointer<QWidget> next = this->queue.front();
  this->queue.pop_front();
  if (!this->queue.empty())
  {
    this->turn.start(0);
  }
  if (next)
  {
    next->repaint();
  }
}

}
