#ifndef Varimarch_Viewer_SlabBar_h
#define Varimarch_Viewer_SlabBar_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace varimarch
{

/// Slab thickness of the slices, its blend mode, and the way back from turned slices.
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
  QToolButton* straighten;
};

}

#endif
