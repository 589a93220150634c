#ifndef Varimarch_Viewer_RegionsBox_h
#define Varimarch_Viewer_RegionsBox_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <vector>

class QCheckBox;

namespace varimarch
{

class GradientCounting;
class NumberSlider;
class RegionEditor;

/// The regions of value and gradient of a look, in place of its curves: a switch, the editor, and
/// the opacity and the soft edge of the selected region. Switched off, the regions are removed from
/// the scene and remembered here. For composites of one component only.
class RegionsBox : public QWidget
{
  Q_OBJECT

public:
  /// @param counting  of the same model; outlives this
  RegionsBox(SceneModel* model, const GradientCounting* counting, QWidget* parent = nullptr);

private:
  QWidget* MakeNumbers();
  NumberSlider* MakeNumber(const char* objectName, const QString& name, double LookRegion::*number);
  void Switch(bool on);
  void Edit(const std::vector<LookRegion>& regions, const QString& name, int gesture);
  void Update(ScenePart part);
  void TakeCounts();
  void ShowNumbers();

  SceneModel* model;
  const GradientCounting* counting;
  QCheckBox* isOn;
  RegionEditor* editor;
  QWidget* content; ///< everything but the switch
  NumberSlider* opacity = nullptr;
  NumberSlider* softness = nullptr;
  std::vector<LookRegion> remembered; ///< for the next time; empty: one that suits the volume
};

}

#endif
