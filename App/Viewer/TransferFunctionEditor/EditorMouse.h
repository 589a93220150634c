#ifndef Varimarch_Viewer_EditorMouse_h
#define Varimarch_Viewer_EditorMouse_h

#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QPointF>
#include <QString>

class QMouseEvent;

namespace varimarch
{

class TransferFunctionEditor;

/// What the mouse's buttons and motions mean to the editor that it belongs to: from a press to the
/// release is one gesture.
class EditorMouse
{
public:
  explicit EditorMouse(TransferFunctionEditor* editor);

  void Press(const QMouseEvent& event);
  void Move(const QMouseEvent& event);
  void Release(const QMouseEvent& event);

  bool IsDragging() const { return this->drag != Drag::None; }

  /// Puts back what was there at the press, and ignores the pointer until the next one.
  void Cancel();

  /// Ends the gesture where it is: the look has been changed by somebody else.
  void Forget() { this->drag = Drag::None; }

private:
  enum class Drag
  {
    None,
    Begun, ///< on an empty place: a click, or the beginning of a drag
    Nodes,
    NewPoint, ///< pulled out of the curve
    Axis,
    RubberBand,
  };

  void PressNode(const NodeId& node, bool toggles);
  void PressWholeCurve();
  void Grab(const NodeSet& grabbed, double value, double opacity);
  void BeginFromEmpty();
  bool AddAt(const QPointF& position);
  void MoveNodes(const QPointF& travelledNow, bool fine);
  void SelectInBand();

  TransferFunctionEditor* editor;
  Drag drag = Drag::None;
  int gesture = 0;
  QString name;       ///< of the step
  QPointF pressed;    ///< where
  QPointF last;       ///< where the pointer was
  QPointF travelled;  ///< since the press; less than the pointer while it is slowed down
  bool moved = false; ///< by more than a click
  Look atPress;
  NodeSet selectedAtPress;
  NodeSet selectedByClick; ///< if the press on a node turns out to be a click

  // Of a drag of nodes.
  Look base; ///< what the motion is added to
  NodeSet grabbed;
  bool horizontal = false;  ///< values alone move
  double anchorValue = 0.0; ///< of what was grabbed
  double anchorOpacity = 0.0;
};

}

#endif
