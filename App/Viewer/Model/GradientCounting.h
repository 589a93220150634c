#ifndef Varimarch_Viewer_GradientCounting_h
#define Varimarch_Viewer_GradientCounting_h

#include "Scene/Looks/ValueGradientHistogram.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"

#include <QObject>

#include <memory>

namespace varimarch
{

/// Gradient magnitudes of a volume, counted alone and together with the values.
struct GradientCounts
{
  ImageStatistics gradients;
  ValueGradientHistogram withValues;
};

/// Counts the gradients of each new volume of a model in a thread, while the volume is already
/// shown.
class GradientCounting : public QObject
{
  Q_OBJECT

public:
  explicit GradientCounting(SceneModel* model, QObject* parent = nullptr);

  /// Null while a volume is counted.
  std::shared_ptr<const GradientCounts> Counts() const { return this->counts; }

signals:
  void Begun();
  void Counted();

private:
  void Begin();

  SceneModel* model;
  std::shared_ptr<const GradientCounts> counts;
  BackgroundTask task;
};

}

#endif
