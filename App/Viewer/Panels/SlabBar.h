#ifndef Varimarch_Viewer_SlabBar_h
#define Varimarch_Viewer_SlabBar_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;

namespace varimarch
{

/// How thick the slices are, and what of their thickness they show.
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
