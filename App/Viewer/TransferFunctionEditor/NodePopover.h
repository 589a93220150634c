#ifndef Varimarch_Viewer_NodePopover_h
#define Varimarch_Viewer_NodePopover_h

#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QFrame>

class QDoubleSpinBox;
class QFormLayout;
class QPushButton;

namespace varimarch
{

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
