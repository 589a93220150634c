#ifndef Varimarch_Viewer_SegmentEditingBox_h
#define Varimarch_Viewer_SegmentEditingBox_h

#include "Viewer/Model/SegmentEditor.h"

#include <QGroupBox>

class QButtonGroup;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace varimarch
{

/// Makes segments by hand: new ones, regions of a range of values, a brush, and what cleans up
/// after them.
class SegmentEditingBox : public QGroupBox
{
  Q_OBJECT

public:
  SegmentEditingBox(SceneModel* model, SegmentEditor* editor, QWidget* parent = nullptr);

signals:
  void SaveWanted();

private:
  void MakeTools(QGridLayout* grid);
  void MakeNumbers(QGridLayout* grid);
  void MakeActions(QGridLayout* grid);
  QWidget* MakeWorking();
  QPushButton* Button(const char* name, const QString& text);
  QDoubleSpinBox* Number(const char* name, const QString& meaning, double value);
  void Show(ScenePart part);
  void TakeRange();

  SceneModel* model;
  SegmentEditor* editor;
  QButtonGroup* tools;
  QDoubleSpinBox* smallest;
  QDoubleSpinBox* largest;
  QDoubleSpinBox* radius;
  QDoubleSpinBox* island;
  QDoubleSpinBox* deviation;
  QWidget* working; ///< shown while the editor works
  QLabel* hint;
  QWidget* edits; ///< all that needs a segment
};

}

#endif
