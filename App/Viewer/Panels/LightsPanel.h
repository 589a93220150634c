#ifndef Varimarch_Viewer_LightsPanel_h
#define Varimarch_Viewer_LightsPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <array>
#include <functional>
#include <vector>

class QDoubleSpinBox;
class QFormLayout;
class QListWidget;
class QPushButton;
class QToolButton;

namespace varimarch
{

class NumberSlider;

/// The lights on a shaded volume: a list, and the colour, intensity and place of the selected one;
/// below them, the effects that matter has on light. A scene without lights has the one at the eye.
class LightsPanel : public QWidget
{
  Q_OBJECT

public:
  explicit LightsPanel(SceneModel* model, QWidget* parent = nullptr);

private:
  QToolButton* MakeAddButton();
  void MakeColorAndIntensity();
  void MakeDirection();
  void MakePosition();
  std::vector<SceneLight> Shown() const;
  void Replace(const std::vector<SceneLight>& lights, const QString& name, int gesture);
  void EditSelected(const QString& name, const std::function<void(SceneLight&)>& change,
    int gesture = SceneModel::NoGesture);
  void Add(LightKind kind);
  void Remove();
  void ChooseColor();
  void MoveToCrosshair();
  void Show(ScenePart part);
  void ShowSelected();
  void ShowRow(QWidget* field, bool shown);

  SceneModel* model;
  QToolButton* add;
  QPushButton* remove;
  QListWidget* list;
  QFormLayout* form;
  QPushButton* color;
  NumberSlider* intensity;
  NumberSlider* softness;
  NumberSlider* azimuth;
  NumberSlider* elevation;
  QWidget* position;
  std::array<QDoubleSpinBox*, 3> coordinates;
};

class NumberSlider;

/// The effects that matter has on light: the shadows that it casts, how it scatters light, and its
/// ambient occlusion. A button takes the light that suits the preset.
class LightEffectsBox : public QWidget
{
  Q_OBJECT

public:
  explicit LightEffectsBox(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeSuited();
  /// A slider that edits a number of the scene's light.
  NumberSlider* MakeSlider(const char* name, const std::array<double, 2>& range,
    const QString& step, const std::function<double&(Scene&)>& numberOf);
  QFormLayout* MakeShadows();
  QFormLayout* MakeScattering();
  QFormLayout* MakeOcclusion();
  void Show(ScenePart part);

  SceneModel* model;
  QPushButton* suited;
  NumberSlider* shadows;
  NumberSlider* scattering;
  NumberSlider* anisotropy;
  NumberSlider* scatteringReach;
  NumberSlider* occlusion;
  NumberSlider* reach;
};

}

#endif
