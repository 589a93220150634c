#ifndef Varimarch_Viewer_QualityPanel_h
#define Varimarch_Viewer_QualityPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QLabel;
class QSlider;

namespace varimarch
{

/// The error tolerance of the rendered image.
class QualityPanel : public QWidget
{
  Q_OBJECT

public:
  explicit QualityPanel(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show();

  SceneModel* model;
  QSlider* error;
  QLabel* text;
};

}

#endif
