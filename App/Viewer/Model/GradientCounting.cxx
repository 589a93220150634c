#include "Viewer/Model/GradientCounting.h"

#include "Scene/Looks/ValueGradientHistogram.h"

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
}

void GradientCounting::Begin()
{
  this->counts.reset();
  emit this->Begun();
  const auto study = this->model->EditedStudy();
  this->task.Start([study](const TaskProgress&) { return CountsOf(study->volume.image); },
    [this](const std::shared_ptr<const GradientCounts>& found)
    {
      this->counts = found;
      emit this->Counted();
    });
}

}
