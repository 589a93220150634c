#ifndef Varimarch_Viewer_LightEffectsBox_h
#define Varimarch_Viewer_LightEffectsBox_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <array>
#include <functional>

class QFormLayout;
class QPushButton;

namespace varimarch
{

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
