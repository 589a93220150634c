#ifndef Varimarch_Viewer_KeyImagesBox_h
#define Varimarch_Viewer_KeyImagesBox_h

#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>

#include <optional>

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace varimarch
{

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
