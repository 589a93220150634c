#ifndef Varimarch_Viewer_VolumesPanel_h
#define Varimarch_Viewer_VolumesPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <array>
#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace varimarch
{

class NumberSlider;

/// The volumes of the scene: the first, and those over it. The selected one is the volume whose
/// look the other panels edit. Volumes over the first have an opacity, colours in slices and a
/// place.
class VolumesPanel : public QWidget
{
  Q_OBJECT

public:
  explicit VolumesPanel(SceneModel* model, QWidget* parent = nullptr);

  /// The name of a volume of a scene, or that of its file.
  static QString TitleOf(const Scene& scene, int volume);

signals:
  void AddWanted();
  /// A volume has been registered with the first one.
  void Registered();

private:
  QWidget* MakeButtons();
  QWidget* MakeAppearance();
  QWidget* MakePlace();
  void Show(ScenePart part);
  void ShowRows();
  void ShowRow(int volume, const QString& title);
  void ShowSelected();
  int Selected() const; ///< index of the selected overlay; -1 for the first volume
  void TakeItem(const QListWidgetItem* item);
  void ConnectPlace(const QDoubleSpinBox* box, std::array<double, 3> Placement::*part, int axis);
  void Move(int step);
  void Remove();
  /// Looks, in a thread, for the place of an overlay over the first volume.
  void Register(int overlay);
  void Edit(const QString& step, const std::function<void(OverlaidVolume&)>& change,
    int gesture = SceneModel::NoGesture);

  SceneModel* model;
  QListWidget* list;
  QLabel* note; ///< says what several volumes are drawn without
  QPushButton* add;
  QPushButton* up;
  QPushButton* down;
  QPushButton* remove;
  QWidget* appearance;
  QGroupBox* place;
  NumberSlider* opacity;
  QComboBox* colors;
  std::array<QDoubleSpinBox*, 3> moves;
  std::array<QDoubleSpinBox*, 3> turns;
};

}

#endif
