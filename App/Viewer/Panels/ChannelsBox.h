#ifndef Varimarch_Viewer_ChannelsBox_h
#define Varimarch_Viewer_ChannelsBox_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <array>
#include <functional>

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

}

#endif
