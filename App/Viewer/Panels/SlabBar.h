#ifndef Varimarch_Viewer_SlabBar_h
#define Varimarch_Viewer_SlabBar_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;

namespace varimarch
{

/// Slab thickness of the slices and its blend mode.
class SlabBar : public QWidget
{
  Q_OBJECT

public:
  explicit SlabBar(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show(ScenePart part);

  SceneModel* model;
  QDoubleSpinBox* thickness; ///< [mm]
  QComboBox* blend;
};

}

#endif
