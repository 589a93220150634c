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

/// Opacity by gradient magnitude, edited over a histogram of the gradients. A thread computes the
/// histogram while the volume is already shown. Switched off, the curve is removed from the scene
/// and remembered here. For composites only.
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
  std::vector<OpacityNode>
    remembered; ///< curve for the next time; empty: one that suits the volume
};

}

#endif
