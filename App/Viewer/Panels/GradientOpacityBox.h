#ifndef Varimarch_Viewer_GradientOpacityBox_h
#define Varimarch_Viewer_GradientOpacityBox_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <vector>

class QCheckBox;

namespace varimarch
{

class GradientCounting;
class TransferFunctionEditor;

/// Opacity by gradient magnitude, edited over a histogram of the gradients. Switched off, the curve
/// is removed from the scene and remembered here. For composites only.
class GradientOpacityBox : public QWidget
{
  Q_OBJECT

public:
  /// @param counting  of the same model; outlives this
  GradientOpacityBox(
    SceneModel* model, const GradientCounting* counting, QWidget* parent = nullptr);

private:
  void Switch(bool on);
  void Edit(const std::vector<OpacityNode>& nodes, const QString& name, int gesture);
  void Update(ScenePart part);
  void TakeCounts();

  SceneModel* model;
  const GradientCounting* counting;
  QCheckBox* isOn;
  TransferFunctionEditor* editor;
  std::vector<OpacityNode>
    remembered; ///< curve for the next time; empty: one that suits the volume
};

}

#endif
