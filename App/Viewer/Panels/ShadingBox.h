#ifndef Varimarch_Viewer_ShadingBox_h
#define Varimarch_Viewer_ShadingBox_h

#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>

#include <utility>
#include <vector>

class QComboBox;
class QFormLayout;

namespace varimarch
{

class NumberSlider;

/// The shading, chosen by name or by coefficients. Hidden for blend modes without shading.
class ShadingBox : public QGroupBox
{
  Q_OBJECT

public:
  explicit ShadingBox(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeKinds();
  void MakeDamping();
  void ShowDampingOf(const Study& study);
  void AddCoefficient(const QString& name, double Shading::*coefficient, NumberSlider* slider);
  void Edit(const QString& name, const Shading& shading, int gesture);
  void Update(ScenePart part);

  SceneModel* model;
  QFormLayout* form;
  QComboBox* kinds;
  NumberSlider* damping;
  std::vector<std::pair<NumberSlider*, double Shading::*>> sliders;
};

}

#endif
