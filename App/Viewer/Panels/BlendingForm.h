#ifndef Varimarch_Viewer_BlendingForm_h
#define Varimarch_Viewer_BlendingForm_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace varimarch
{

class NumberSlider;

/// Blend mode of the rays, with the parameters that it needs.
class BlendingForm : public QWidget
{
  Q_OBJECT

public:
  explicit BlendingForm(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeBlend();
  void MakeUnitDistance();
  void MakeAveragedRange();
  void ChooseBlend(Blend blend);
  void ChooseAveragedRange();
  void ShowUnitDistance(double millimetres, double lengthFactor);
  void Update(ScenePart part);
  void ShowRow(QWidget* field, bool shown);

  SceneModel* model;
  QFormLayout* form;
  QComboBox* blend;
  NumberSlider* unitDistance;
  QWidget* averagedRange;
  QDoubleSpinBox* averagedFirst;
  QDoubleSpinBox* averagedLast;
};

}

#endif
