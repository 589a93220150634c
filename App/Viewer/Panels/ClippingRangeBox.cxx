#include "Viewer/Panels/ClippingRangeBox.h"

#include "Scene/SceneCamera.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QFormLayout>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr double LeastDistanceMm = 0.1;

}

ClippingRangeBox::ClippingRangeBox(SceneModel* model, QWidget* parent)
  : QGroupBox(tr("Distance from the eye"), parent)
  , model(model)
{
  this->setObjectName("clippingRange");
  this->setToolTip(tr("Shows only what lies between two distances from the eye"));
  this->setCheckable(true);
  this->setChecked(false);
  auto* const form = new QFormLayout(this);
  this->distances = { this->MakeDistance("nearest", 0), this->MakeDistance("farthest", 1) };
  form->addRow(tr("Nearest"), this->distances[0]);
  form->addRow(tr("Farthest"), this->distances[1]);
  connect(this, &QGroupBox::clicked, this, &ClippingRangeBox::Switch);
  connect(model, &SceneModel::Changed, this, &ClippingRangeBox::Show);
}

NumberSlider* ClippingRangeBox::MakeDistance(const char* name, int end)
{
  auto* const slider = new NumberSlider(LeastDistanceMm, 1000.0, NumberSlider::Scale::Linear);
  slider->setObjectName(name);
  slider->SetSuffix(tr(" mm"));
  connect(slider, &NumberSlider::Edited, this,
    [this, end](double millimetres, int gesture)
    {
      std::array<double, 2> range = *this->model->CurrentScene().camera.clippingRangeMm;
      range[end] = millimetres;
      // The other end makes way.
      range[1] = std::max(range[1], 2.0 * LeastDistanceMm);
      range[1 - end] = end == 0 ? std::max(range[1], range[0] + LeastDistanceMm)
                                : std::min(range[0], range[1] - LeastDistanceMm);
      this->Edit(range, tr("distance from the eye"), gesture);
    });
  return slider;
}

void ClippingRangeBox::Switch(bool on)
{
  std::optional<std::array<double, 2>> range;
  if (on)
  {
    range = DepthRangeMm(this->model->CurrentScene().camera,
      this->model->CurrentStudy()->volume.image->GetBounds(), LeastDistanceMm);
  }
  this->Edit(range, on ? tr("limit the distance from the eye") : tr("show all distances"),
    SceneModel::NoGesture);
}

void ClippingRangeBox::Edit(
  const std::optional<std::array<double, 2>>& range, const QString& name, int gesture)
{
  this->model->Edit(
    ScenePart::Camera, name, [&](Scene& scene) { scene.camera.clippingRangeMm = range; }, gesture);
}

void ClippingRangeBox::Show(ScenePart part)
{
  if (part != ScenePart::Camera && part != ScenePart::Volume)
  {
    return;
  }
  const Camera& camera = this->model->CurrentScene().camera;
  this->setChecked(camera.clippingRangeMm.has_value());
  const std::array<double, 2> all =
    DepthRangeMm(camera, this->model->CurrentStudy()->volume.image->GetBounds(), LeastDistanceMm);
  const std::array<double, 2> shown = camera.clippingRangeMm.value_or(all);
  for (int end : { 0, 1 })
  {
    this->distances[end]->SetRange(LeastDistanceMm, std::max(all[1], shown[1]));
    this->distances[end]->SetNumber(shown[end]);
  }
}

}
