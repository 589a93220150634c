#include "Viewer/View/FramePacer.h"

#include <QGuiApplication>

namespace varimarch
{

namespace
{

constexpr int StillMilliseconds = 250;
constexpr int RefinementMilliseconds = 20; // between the parts, for other events

void Prepare(QTimer& timer, int milliseconds)
{
  timer.setSingleShot(true);
  timer.setInterval(milliseconds);
}

// Calls an action when the timer ends and no mouse button is held.
template <class Action>
void WhenReleased(QTimer& timer, const Action& action)
{
  QObject::connect(&timer, &QTimer::timeout, &timer,
    [&timer, action]
    {
      if (QGuiApplication::mouseButtons() == Qt::NoButton)
      {
        action();
      }
      else
      {
        timer.start();
      }
    });
}

}

FramePacer::FramePacer(QObject* parent)
  : QObject(parent)
{
  Prepare(this->quickFrame, 0);
  Prepare(this->fineFrame, StillMilliseconds);
  Prepare(this->refinement, RefinementMilliseconds);
  connect(&this->quickFrame, &QTimer::timeout, this, &FramePacer::QuickFrameDue);
  WhenReleased(this->fineFrame,
    [this]
    {
      emit this->FineFrameDue();
      this->refinement.start();
    });
  WhenReleased(this->refinement, [this] { emit this->RefinementDue(); });
}

void FramePacer::Request()
{
  this->quickFrame.start();
  this->RequestFine();
}

void FramePacer::RequestFine()
{
  this->refinement.stop();
  this->fineFrame.start();
}

}
