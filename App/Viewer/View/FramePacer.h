#ifndef Varimarch_Viewer_FramePacer_h
#define Varimarch_Viewer_FramePacer_h

#include <QObject>
#include <QTimer>

namespace varimarch
{

/// Decides when a view draws. Changes that arrive together cause one quick frame; when they stop, a
/// fine frame follows, then its refinement while the program is idle. Fine frames and refinement
/// take long, so they wait while a mouse button is held: gestures stay smooth.
class FramePacer : public QObject
{
  Q_OBJECT

public:
  explicit FramePacer(QObject* parent = nullptr);

  /// Requests a quick frame and a fine one after it, instead of further refinement.
  void Request();

  /// Requests the fine frame only, for a view whose quick frames are drawn by others.
  void RequestFine();

  /// Requests another step of refinement.
  void RequestRefinement() { this->refinement.start(); }

  void StopRefinement() { this->refinement.stop(); }

signals:
  void QuickFrameDue();
  void FineFrameDue(); ///< the first step of refinement follows by itself
  void RefinementDue();

private:
  QTimer quickFrame;
  QTimer fineFrame;
  QTimer refinement;
};

}

#endif
