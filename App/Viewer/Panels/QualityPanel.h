#ifndef Varimarch_Viewer_QualityPanel_h
#define Varimarch_Viewer_QualityPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace varimarch
{

class NumberSlider;

/// The error tolerance of the rendered image, or none; the interpolation between voxels; and the
/// jitter and the end of rays; for a volume that stays in its file, what is read of it.
class QualityPanel : public QWidget
{
  Q_OBJECT

public:
  explicit QualityPanel(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeError();
  void MakePromise();
  void MakeInterpolation();
  void MakeDetail();
  void Edit(const QString& name, const std::function<void(RenderOptions&)>& change,
    int gesture = SceneModel::NoGesture);
  void Show();

  SceneModel* model;
  QFormLayout* form;
  QSlider* error;
  QLabel* text;
  QCheckBox* promises;
  NumberSlider* end;
  QComboBox* interpolation;
  QCheckBox* jitter;
  QCheckBox* refined;
};

}

#endif
