#include "Viewer/Tools/ScissorsTool.h"

#include <QLineF>
#include <QPainter>

namespace varimarch
{

namespace
{

constexpr double PointPixels = 3.0;        // spacing of the points of an outline
constexpr double SmallestSidePixels = 6.0; // smaller outlines are taken for clicks

}

ScissorsTool::ScissorsTool(
  SceneModel* model, const ToolSurface& surface, const std::function<Camera()>& camera)
  : model(model)
  , surface(surface)
  , camera(camera)
{
}

bool ScissorsTool::Press(const QPointF& place)
{
  this->drawn = QPolygonF({ place });
  return true;
}

void ScissorsTool::Drag(const QPointF& place)
{
  if (QLineF(this->drawn.last(), place).length() >= PointPixels)
  {
    this->drawn.append(place);
  }
}

void ScissorsTool::Release(const QPointF& place)
{
  this->Drag(place);
  const QSizeF side = this->drawn.boundingRect().size();
  if (this->drawn.size() >= 3 && side.width() >= SmallestSidePixels &&
    side.height() >= SmallestSidePixels)
  {
    ScissorsCut cut;
    cut.camera = this->camera();
    cut.keepsInside = this->keepsInside;
    const QSizeF size = this->surface.Frame().size;
    const double half = 0.5 * size.height();
    for (const QPointF& point : this->drawn)
    {
      cut.outline.push_back({ (point.x() - 0.5 * size.width()) / half, 1.0 - point.y() / half });
    }
    this->model->Edit(ScenePart::Cuts, this->keepsInside ? tr("keep the inside") : tr("cut out"),
      [&](Scene& scene) { scene.cuts.scissors.push_back(cut); });
  }
  this->drawn.clear();
}

void ScissorsTool::Paint(QPainter& painter) const
{
  if (this->drawn.isEmpty())
  {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0));
  painter.drawPolyline(this->drawn);
  painter.setPen(QPen(QColor(255, 110, 90), 2.0));
  painter.setBrush(QColor(255, 110, 90, 40));
  painter.drawPolygon(this->drawn);
}

}
