#ifndef Varimarch_Viewer_TransferFunctionEditor_h
#define Varimarch_Viewer_TransferFunctionEditor_h

#include "Viewer/TransferFunctionEditor/EditorInput.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QWidget>

class QAction;

namespace varimarch
{

/// Edits the transfer function of a look over the histogram of its volume. It keeps no history; its
/// owner applies the edits and passes the resulting look back.
class TransferFunctionEditor : public QWidget
{
  Q_OBJECT

public:
  explicit TransferFunctionEditor(QWidget* parent = nullptr);

  /// Zooms to nearly all voxels and the whole curve.
  void SetStatistics(std::shared_ptr<const ImageStatistics> statistics);

  /// Edits only a curve, such as that of the gradient opacity.
  void LeaveOutColors();

  /// Sets the unit of the values: "HU", or another word.
  void SetUnit(const QString& unit);

  /// @param look  in units of the data; nodes that still exist stay selected
  void SetLook(const Look& look);

  const EditorPicture& Picture() const { return this->picture; }

  /// Actions that change the display, for buttons. All actions are in actions().
  const QList<QAction*>& ViewActions() const { return this->viewActions; }

  void Select(const NodeSet& nodes);

  /// Shows an edited look and emits LookEdited.
  void Edit(const Look& edited, const QString& stepName, int gesture);

  /// The same, and selects the new node.
  void Add(const Insertion& insertion, const QString& stepName, int gesture);

  /// Lets the user choose the colour of the selected node, if the user has asked for that at each
  /// click that adds one.
  void AskForColorIfWanted();

  void PanAxis(double pixels);

  /// @param band  null rectangle: none
  void ShowRubberBand(const QRectF& band);

  QSize sizeHint() const override { return { 420, this->picture.layout.hasColors ? 320 : 180 }; }
  QSize minimumSizeHint() const override
  {
    return { 280, this->picture.layout.hasColors ? 220 : 150 };
  }

signals:
  /// Emitted at every change. All changes of one gesture share its number.
  void LookEdited(const varimarch::Look& look, const QString& stepName, int gesture);

  /// Readout under the pointer; empty when the pointer leaves.
  void Hovered(const QString& reading);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  void MakeEditActions();
  void MakeAxisActions();
  void MakeScaleActions();

  void DeleteSelected();
  void ChooseColor();
  void AddBesideSelected();
  void OpenPopover(const NodeId& node);
  void Nudge(const QKeyEvent& event);
  void ScaleCurve(double pixel, double notches);
  void Focus(const NodeId& node);
  void FitToVoxels(double percent);
  void FitToCurve();
  void Hover(const QPointF& position);
  void ShowCursor(const QPointF& position);
  double NudgeStep() const;

  EditorPicture picture;
  EditorMouse mouse;
  QAction* chooseColor;
  QAction* asksForColor; ///< checked: a click that adds a point asks for its colour
  QAction* showMost;
  QList<QAction*> viewActions;
  int keyGesture = 0;   ///< lasts while a key is held down
  int wheelGesture = 0; ///< lasts until the pointer moves; 0: none
};

}

Q_DECLARE_METATYPE(varimarch::Look)

#endif
