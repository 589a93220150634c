#ifndef Varimarch_Viewer_CutsPanel_h
#define Varimarch_Viewer_CutsPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>
#include <QWidget>

#include <array>
#include <vector>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;
class QToolButton;

namespace varimarch
{

/// Cuts through the volume: a box along its axes, planes in any direction, and scissors.
class CutsPanel : public QWidget
{
  Q_OBJECT

public:
  explicit CutsPanel(SceneModel* model, QWidget* parent = nullptr);

private:
  QCheckBox* MakeBodyOnly();
  QCheckBox* MakeNoFace();
  QToolButton* MakeAddButton();
  QSlider* MakeSlider(const QString& name);
  QWidget* MakePlanes();
  QWidget* MakeBox();
  QWidget* MakeScissors();
  void Show(ScenePart part);
  void ShowPlanes();
  void NameFaces();
  void ShowBox();
  void ShowScissors();
  void AddPlane(const std::array<double, 3>& normal, const QString& stepName);
  void AddFacingPlane();
  void MovePlane(int position);
  void EditPlane(const QString& stepName, const std::function<void(CutPlane&)>& change);
  void FlipPlane();
  void RemovePlane();
  void MoveFace(int face, int position);

  SceneModel* model;
  QCheckBox* bodyOnly;
  QCheckBox* noFace;
  QToolButton* add;
  QListWidget* planes;
  std::vector<CutPlane> shown; ///< the planes in the list
  QSlider* depth;
  QPushButton* flip;
  QPushButton* remove;
  std::array<QSlider*, 6> faces;
  std::array<QLabel*, 6> faceNames; ///< such as "Left", from the first volume on
  QLabel* scissors;
  QPushButton* bringBack;
  int gesture = SceneModel::NoGesture; ///< drag of a slider in progress
};

class NumberSlider;

/// The distances from the eye between which the volume is visible. They stay while the camera
/// moves, so that an eye in the volume sees a room around it.
class ClippingRangeBox : public QGroupBox
{
  Q_OBJECT

public:
  explicit ClippingRangeBox(SceneModel* model, QWidget* parent = nullptr);

private:
  NumberSlider* MakeDistance(const char* name, int end);
  void Switch(bool on);
  void Edit(const std::optional<std::array<double, 2>>& range, const QString& name, int gesture);
  void Show(ScenePart part);

  SceneModel* model;
  std::array<NumberSlider*, 2> distances; ///< the nearest and the farthest
};

}

#endif
