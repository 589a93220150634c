#ifndef Varimarch_Viewer_MeasuresPanel_h
#define Varimarch_Viewer_MeasuresPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>
#include <QWidget>

#include <optional>

class QListWidget;
class QListWidgetItem;
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

/// A list of the views that the user has marked, for the report. A double-click goes to one, as
/// far as camera, slices and time are concerned; F2 renames it.
class KeyImagesBox : public QGroupBox
{
  Q_OBJECT

public:
  explicit KeyImagesBox(SceneModel* model, QWidget* parent = nullptr);

  /// Marks a view as the model has it now. This is an undo step.
  void Mark(KeyView view);

private:
  /// The time of the voxels that are shown; empty for a volume with only one.
  std::optional<int> ShownTime() const;
  void Show(ScenePart part);
  void Rename(QListWidgetItem* item);
  void GoToCurrent();
  void RemoveCurrent();

  SceneModel* model;
  QListWidget* list;
  QPushButton* goTo;
  QPushButton* remove;
};

}

#endif
