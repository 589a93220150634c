#ifndef Varimarch_Viewer_RegionEditor_h
#define Varimarch_Viewer_RegionEditor_h

#include "Viewer/RegionEditor/RegionPainter.h"

#include <QWidget>

class QAction;

namespace varimarch
{

/// Edits the regions of a look over the histogram of values and gradient magnitudes. It keeps no
/// history; its owner applies the edits and passes the resulting regions back.
class RegionEditor : public QWidget
{
  Q_OBJECT

public:
  explicit RegionEditor(QWidget* parent = nullptr);

  /// Shows a histogram and all of the plane that it covers.
  void SetHistogram(std::shared_ptr<const ValueGradientHistogram> histogram);

  /// Sets the unit of the values: "HU", or another word.
  void SetUnit(const QString& unit);

  /// @param regions  in units of the data; the selected one stays selected by its number
  void SetRegions(const std::vector<LookRegion>& regions);

  const RegionPicture& Picture() const { return this->picture; }

  /// The selected region; null without one.
  const LookRegion* Selected() const;

  void Select(int index);

  /// Changes the selected region.
  void EditSelected(
    const QString& stepName, const std::function<void(LookRegion&)>& change, int gesture);

  /// Actions that change the regions, for buttons. All actions are in actions().
  const QList<QAction*>& EditActions() const { return this->editActions; }

  QSize sizeHint() const override { return { 420, 280 }; }
  QSize minimumSizeHint() const override { return { 280, 200 }; }

signals:
  /// Emitted at every change. All changes of one gesture share its number.
  void RegionsEdited(
    const std::vector<varimarch::LookRegion>& regions, const QString& stepName, int gesture);
  void SelectionChanged();

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  enum class Drag
  {
    None,
    Region, ///< a handle, or the region itself
    Plane,  ///< the visible part of the plane
  };

  void MakeActions();
  RegionPlane Plane() const;
  void Edit(const std::vector<LookRegion>& regions, const QString& stepName, int gesture);
  void Add(RegionShape shape, const QPointF& position);
  void DeleteSelected();
  void ChooseColor();
  void ShowAll();
  void Zoom(const QPointF& position, double factor);
  void DragTo(const QPointF& position);
  void CancelDrag();
  void Nudge(const QKeyEvent& event);
  void Hover(const QPointF& position);

  RegionPicture picture;
  Drag drag = Drag::None;
  RegionHandle handle; ///< handle of the region that is dragged
  LookRegion atPress;  ///< the region before the drag
  QPointF pressed;     ///< place where the drag began
  QPointF last;        ///< last place of the pointer
  int gesture = 0;     ///< gesture of a drag, or of a key that is held down
  QList<QAction*> editActions;
};

}

#endif
