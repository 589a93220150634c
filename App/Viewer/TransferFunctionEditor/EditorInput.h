#ifndef Varimarch_Viewer_EditorInput_h
#define Varimarch_Viewer_EditorInput_h

#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QFrame>
#include <QKeySequence>
#include <QPointF>
#include <QString>

class QAction;
class QDoubleSpinBox;
class QFormLayout;
class QKeyEvent;
class QMouseEvent;
class QPushButton;
class QWidget;

namespace varimarch
{

// Keys of the editors of transfer functions: each command is an action of the editor, so that
// menus, buttons and keys share it.

/// Factor by which one key zooms.
constexpr double ZoomPerKey = 1.25;

bool IsArrowKey(int key);

/// Adds a command that a key starts while the editor has the focus.
QAction* AddKeyAction(QWidget* editor, const QString& text, const QKeySequence& key);

/// The command of a key; null if it has none. Enter counts as Return, and Backspace as Delete.
QAction* ActionOfKey(const QWidget& editor, const QKeyEvent& event);

class TransferFunctionEditor;

/// Translates mouse events of an editor into edits. One gesture lasts from press to release.
class EditorMouse
{
public:
  explicit EditorMouse(TransferFunctionEditor* editor);

  void Press(const QMouseEvent& event);
  void Move(const QMouseEvent& event);
  void Release(const QMouseEvent& event);

  bool IsDragging() const { return this->drag != Drag::None; }

  /// Reverts the gesture and ignores the pointer until the next press.
  void Cancel();

  /// Ends the gesture without reverting it, because the look was changed elsewhere.
  void Forget() { this->drag = Drag::None; }

private:
  enum class Drag
  {
    None,
    Begun, ///< pressed on an empty place; a click or the start of a drag
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
  QString name;       ///< name of the undo step
  QPointF pressed;    ///< position of the press
  QPointF last;       ///< last position of the pointer
  QPointF travelled;  ///< distance since the press; less than the pointer's in fine mode
  bool moved = false; ///< true if it moved farther than a click may
  Look atPress;
  NodeSet selectedAtPress;
  NodeSet selectedByClick; ///< selection if the press turns out to be a click

  // State of a drag of nodes.
  Look base; ///< look that the motion is applied to
  NodeSet grabbed;
  bool horizontal = false;  ///< true: only the values change
  double anchorValue = 0.0; ///< value of the grabbed node
  double anchorOpacity = 0.0;
};

/// Edits the numbers of a node. Every change is emitted at once; Escape restores the old look.
class NodePopover : public QFrame
{
  Q_OBJECT

public:
  /// @param decimals  of the value
  NodePopover(const Look& look, const NodeId& node, const QString& unit, int decimals,
    QWidget* parent = nullptr);

signals:
  void Edited(const varimarch::Look& look);
  void ColorWanted();
  void DeleteWanted();

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  QDoubleSpinBox* AddNumber(const QString& name, const char* objectName, double number);
  void AddShape();
  void AddButtons();
  void Apply(const Look& edited);
  void ShowNumbers();
  NodeShape EnteredShape() const;

  const Look before;
  Look look;
  const NodeId node;
  QFormLayout* form;
  QDoubleSpinBox* value;
  QDoubleSpinBox* opacity = nullptr;  ///< null for a colour node
  QDoubleSpinBox* midpoint = nullptr; ///< null for an isosurface
  QDoubleSpinBox* sharpness = nullptr;
};

}

#endif
