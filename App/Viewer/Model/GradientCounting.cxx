#include "Viewer/Model/GradientCounting.h"

#include "Scene/GradientMagnitudes.h"

#include <QtConcurrentRun>

namespace varimarch
{

namespace
{

std::shared_ptr<const GradientCounts> CountsOf(vtkImageData* volume)
{
  const auto magnitudes = GradientMagnitudes(volume);
  return std::make_shared<const GradientCounts>(
    GradientCounts{ ImageStatistics(magnitudes), HistogramOf(volume, magnitudes) });
}

}

GradientCounting::GradientCounting(SceneModel* model, QObject* parent)
  : QObject(parent)
  , model(model)
{
  connect(model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (IsOtherLookVolume(part))
      {
        this->Begin();
      }
    });
  connect(&this->watcher, &QFutureWatcherBase::finished, this,
    [this]
    {
      this->counts = this->watcher.result();
      emit this->Counted();
    });
}

void GradientCounting::Begin()
{
  this->counts.reset();
  emit this->Begun();
  const auto study = this->model->EditedStudy();
  this->watcher.setFuture(QtConcurrent::run([study] { return CountsOf(study->volume.image); }));
}

}
