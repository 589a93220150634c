#ifndef Varimarch_Viewer_MeasuresPanel_h
#define Varimarch_Viewer_MeasuresPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace varimarch
{

/// A list of the measurements with editable names and their values.
class MeasuresPanel : public QWidget
{
  Q_OBJECT

public:
  explicit MeasuresPanel(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show(ScenePart part);
  void AddRow(const std::string& name, const QString& kind, const QString& text);
  void Rename(QTableWidgetItem* item);
  void RemoveSelected();
  void RemoveAll();

  SceneModel* model;
  QTableWidget* table; ///< distances, then angles, then boxes
  QPushButton* remove;
  QPushButton* removeAll;
};

}

#endif
