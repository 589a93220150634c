#ifndef Varimarch_Viewer_LookBoxes_h
#define Varimarch_Viewer_LookBoxes_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <array>
#include <functional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace varimarch
{

class NumberSlider;

/// The channels of a volume with several: whether each is drawn, in which colour, how opaque, and
/// between which values. It is hidden for volumes of a single component, and only says so for
/// volumes whose components are colours.
class ChannelsBox : public QWidget
{
  Q_OBJECT

public:
  explicit ChannelsBox(SceneModel* model, QWidget* parent = nullptr);

private:
  struct Row
  {
    QWidget* whole;
    QCheckBox* visible; ///< with the name of the channel
    QToolButton* color;
    NumberSlider* opacity;
    std::array<QDoubleSpinBox*, 2> window;
  };

  Row MakeRow(std::size_t channel);
  void MakeWindow(std::size_t channel, Row& row);
  void Update(ScenePart part);
  void Show(std::size_t channel, const LookChannel& settings);
  void ShowWindow(std::size_t channel, const LookChannel& settings);
  void ChooseColor(std::size_t channel);
  void Edit(std::size_t channel, const QString& name,
    const std::function<void(LookChannel&)>& change, int gesture = SceneModel::NoGesture);
  void EditWindow(std::size_t channel);

  SceneModel* model;
  QLabel* ofColors; ///< says that the volume is drawn in its own colours
  std::array<Row, MostChannels> rows;
};

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
