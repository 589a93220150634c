#ifndef Varimarch_Viewer_ClippingRangeBox_h
#define Varimarch_Viewer_ClippingRangeBox_h

#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>

namespace varimarch
{

class NumberSlider;

/// The distances from the eye between which the volume is visible. They stay while the camera
/// moves, so that an eye in the volume sees a room around it.
class ClippingRangeBox : public QGroupBox
{
  Q_OBJECT

public:
  explicit ClippingRangeBox(SceneModel* model, QWidget* parent = nullptr);

private:
  NumberSlider* MakeDistance(const char* name, int end);
  void Switch(bool on);
  void Edit(const std::optional<std::array<double, 2>>& range, const QString& name, int gesture);
  void Show(ScenePart part);

  SceneModel* model;
  std::array<NumberSlider*, 2> distances; ///< the nearest and the farthest
};

}

#endif
