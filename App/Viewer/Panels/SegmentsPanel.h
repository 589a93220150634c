#ifndef Varimarch_Viewer_SegmentsPanel_h
#define Varimarch_Viewer_SegmentsPanel_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SegmentEditor.h"

#include <QGroupBox>
#include <QWidget>

#include <functional>

class QButtonGroup;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace varimarch
{

class NumberSlider;

/// The segments of the segmentation over the volume that the model edits: their names, colours and
/// opacities, which of them are shown, and the values of the volume in each.
class SegmentsPanel : public QWidget
{
  Q_OBJECT

public:
  explicit SegmentsPanel(SceneModel* model, QWidget* parent = nullptr);

signals:
  void OpenWanted();
  /// @param row  the current segment; -1 without one
  void Selected(int row);
  /// The statistics are in a file.
  void Saved(const QString& path);

private:
  void MakeTable();
  QWidget* MakeControls();
  void Show(ScenePart part);
  void ShowHeader();
  void ShowRows();
  void ShowStatistics(int row);
  void ShowSelected();
  void ShowVolume();
  void ShowNote();
  QTableWidgetItem* Item(int row, int column);
  void TakeItem(const QTableWidgetItem* item);
  void Edit(const QString& step, const std::function<void(Segment&, int row)>& change,
    int gesture = SceneModel::NoGesture);
  void SetVisible(bool visible);
  void SetOpacity(double opacity, int gesture);
  void ChooseColor();
  void SaveStatistics();

  SceneModel* model;
  QLabel* volume; ///< names the volume if there are several
  QLabel* hint;   ///< shown without segments
  QWidget* all;   ///< everything else
  QLabel* note;   ///< says why the 3D view shows no segments
  QTableWidget* table;
  NumberSlider* opacity;
  QPushButton* color;
};

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
