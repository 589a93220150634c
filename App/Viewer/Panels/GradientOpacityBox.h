#ifndef Varimarch_Viewer_GradientOpacityBox_h
#define Varimarch_Viewer_GradientOpacityBox_h

#include "Viewer/Model/SceneModel.h"

#include <QFutureWatcher>
#include <QWidget>

#include <memory>
#include <vector>

class QCheckBox;

namespace varimarch
{

class TransferFunctionEditor;

/// Opacity by the magnitude of the gradient, over a histogram of its own, which a thread counts
/// while the volume is already seen. Switched off it is not in the scene; the curve is remembered
/// here until it is switched on again. Of composites only.
class GradientOpacityBox : public QWidget
{
  Q_OBJECT

public:
  explicit GradientOpacityBox(SceneModel* model, QWidget* parent = nullptr);

private:
  using Statistics = std::shared_ptr<const ImageStatistics>;

  void Switch(bool on);
  void Edit(const std::vector<OpacityNode>& nodes, const QString& name, int gesture);
  void Update(ScenePart part);
  void BeginToCount();
  void TakeCounts();

  SceneModel* model;
  QCheckBox* isOn;
  TransferFunctionEditor* editor;
  QFutureWatcher<Statistics> counting;
  std::vector<OpacityNode> remembered; ///< for the next time; none: what suits the volume
};

}

#endif
