#ifndef Varimarch_Viewer_MeasuresPanel_h
#define Varimarch_Viewer_MeasuresPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace varimarch
{

/// A list of the measurements and annotations with editable names and their values. The box before
/// a name shows or hides one; a double-click on a value goes there.
class MeasuresPanel : public QWidget
{
  Q_OBJECT

public:
  explicit MeasuresPanel(SceneModel* model, QWidget* parent = nullptr);

signals:
  void Saved(const QString& path);

private:
  void Show(ScenePart part);
  void ShowValues();
  void AddRow(const Measure& measure, const QString& text);
  void Change(QTableWidgetItem* item);
  void GoToSelected();
  void RemoveSelected();
  void RemoveAll();
  void Save();

  SceneModel* model;
  QTableWidget* table; ///< in the order of the scene
  QPushButton* goTo;
  QPushButton* remove;
  QPushButton* removeAll;
  QPushButton* save;
};

}

#endif
