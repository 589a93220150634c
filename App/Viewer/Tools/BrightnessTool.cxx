#include "Viewer/Tools/BrightnessTool.h"

#include "Scene/LookRegions.h"
#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double WidestFactor = 10.0;

}

BrightnessTool::BrightnessTool(SceneModel* model, const ToolSurface& surface)
  : model(model)
  , surface(surface)
{
}

bool BrightnessTool::Press(const QPointF& place)
{
  this->pressed = place;
  this->before = this->model->EditedLook();
  this->gesture = NewGesture();
  return true;
}

// A drag across the whole view shifts by half of the data's range, or scales by the factor e.
void BrightnessTool::Drag(const QPointF& place)
{
  const QSizeF size = this->surface.Frame().size;
  const QPointF moved = (place - this->pressed) / std::min(size.width(), size.height());
  const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
  const double range = statistics.Percentile(99.9) - statistics.Percentile(0.1);
  const double factor = std::clamp(std::exp(moved.x()), 1.0 / WidestFactor, WidestFactor);
  const double middle = MiddleOfOpacities(this->before);
  const double shift = -0.5 * range * moved.y();
  const Look scaled = ScaleLook(this->before, factor, middle);
  Look look = MoveNodes(scaled, AllNodes(scaled), shift, 0.0);
  look.regions = TransformedRegions(this->before.regions, factor, (1.0 - factor) * middle + shift);
  this->model->SetLook(look, tr("window and level"), this->gesture);
}

void BrightnessTool::Cancel()
{
  this->model->SetLook(this->before, tr("window and level"), this->gesture);
}

double MiddleOfOpacities(const Look& look)
{
  double first = look.opacities.front().value;
  double last = look.opacities.back().value;
  const auto varies = [](const OpacityNode& a, const OpacityNode& b)
  { return a.opacity != b.opacity; };
  const auto begin = std::adjacent_find(look.opacities.begin(), look.opacities.end(), varies);
  if (begin != look.opacities.end())
  {
    first = begin->value;
    last = std::adjacent_find(look.opacities.rbegin(), look.opacities.rend(), varies)->value;
  }
  return 0.5 * (first + last);
}

}
