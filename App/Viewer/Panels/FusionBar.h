#ifndef Varimarch_Viewer_FusionBar_h
#define Varimarch_Viewer_FusionBar_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QCheckBox;

namespace varimarch
{

class NumberSlider;

/// How slices show the volumes over the first one; hidden while there are none.
class FusionBar : public QWidget
{
  Q_OBJECT

public:
  explicit FusionBar(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show(ScenePart part);

  SceneModel* model;
  NumberSlider* blend;
  QCheckBox* checkerboard;
};

}

#endif
