#include "Viewer/Tools/ToolIcons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>
#include <QVector>

#include <map>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

/// Side of the square that icons are drawn in [units]; y points downwards.
constexpr double Side = 24.0;
constexpr double LineWidth = 2.0;

/// The lines and areas of an icon.
struct Drawing
{
  QPainterPath lines;
  QPainterPath areas;
};

QPainterPath Together(const std::vector<QPainterPath>& paths)
{
  QPainterPath all;
  for (const QPainterPath& path : paths)
  {
    all.addPath(path); // the operators of Qt unite areas
  }
  return all;
}

QPainterPath Polyline(const QVector<QPointF>& points)
{
  QPainterPath path;
  path.addPolygon(QPolygonF(points));
  return path;
}

QPainterPath Polygon(const QVector<QPointF>& corners)
{
  QPainterPath path = Polyline(corners);
  path.closeSubpath();
  return path;
}

QPainterPath Circle(const QPointF& middle, double radius)
{
  QPainterPath path;
  path.addEllipse(middle, radius, radius);
  return path;
}

/// @param first  angle [degrees], counted counterclockwise from the right, as by QPainterPath
QPainterPath Arc(const QPointF& middle, double radius, double first, double span)
{
  const QRectF square(middle.x() - radius, middle.y() - radius, 2.0 * radius, 2.0 * radius);
  QPainterPath path;
  path.arcMoveTo(square, first);
  path.arcTo(square, first, span);
  return path;
}

/// An arrow around an axis.
Drawing RotationDrawing()
{
  return { Together({ Arc({ 12, 12 }, 8, 60, 290), Circle({ 12, 12 }, 1) }),
    Polygon({ { 14, 1 }, { 14, 10 }, { 20, 5 } }) };
}

/// A walker.
Drawing WalkDrawing()
{
  return { Together({ Polyline({ { 12, 8 }, { 12, 14 }, { 16, 22 } }),
             Polyline({ { 12, 14 }, { 8, 22 } }), Polyline({ { 6, 13 }, { 12, 9 }, { 18, 12 } }) }),
    Circle({ 12, 3.5 }, 2.5) };
}

/// A disc, half of it bright.
Drawing BrightnessDrawing()
{
  return { Circle({ 12, 12 }, 9), Arc({ 12, 12 }, 9, 90, 180) };
}

/// A line between two ends.
Drawing DistanceDrawing()
{
  return { Together({ Polyline({ { 5, 19 }, { 19, 5 } }), Polyline({ { 2, 16 }, { 8, 22 } }),
             Polyline({ { 16, 2 }, { 22, 8 } }) }),
    {} };
}

/// Two arms with an arc between them.
Drawing AngleDrawing()
{
  return { Together({ Polyline({ { 16, 3 }, { 3, 20 }, { 22, 20 } }), Arc({ 3, 20 }, 11, 0, 52) }),
    {} };
}

/// A cube.
Drawing BoxDrawing()
{
  return {
    Together({ Polygon({ { 12, 2 }, { 21, 7 }, { 21, 17 }, { 12, 22 }, { 3, 17 }, { 3, 7 } }),
      Polyline({ { 3, 7 }, { 12, 12 }, { 21, 7 } }), Polyline({ { 12, 12 }, { 12, 22 } }) }),
    {}
  };
}

/// Open scissors.
Drawing ScissorsDrawing()
{
  return { Together({ Circle({ 6, 18.5 }, 3.2), Circle({ 18, 18.5 }, 3.2),
             Polyline({ { 8, 16 }, { 17, 2 } }), Polyline({ { 16, 16 }, { 7, 2 } }) }),
    {} };
}

/// An outline with a part left in it.
Drawing KeepDrawing()
{
  return { Circle({ 12, 12 }, 9.5), Circle({ 12, 12 }, 5) };
}

/// A pencil over a line.
Drawing PencilDrawing()
{
  return { Together({ Polygon({ { 4, 15 }, { 15, 4 }, { 19, 8 }, { 8, 19 }, { 3, 20 } }),
             Polyline({ { 12, 7 }, { 16, 11 } }), Polyline({ { 14, 21 }, { 21, 21 } }) }),
    {} };
}

class DrawnIcon : public QIconEngine
{
public:
  explicit DrawnIcon(Drawing drawing)
    : drawing(std::move(drawing))
  {
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
  {
    const QColor color = QGuiApplication::palette().color(
      mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / Side, rect.height() / Side);
    painter->fillPath(this->drawing.areas, color);
    painter->strokePath(
      this->drawing.lines, QPen(color, LineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    this->paint(&painter, drawn.rect(), mode, state);
    return drawn;
  }

  QIconEngine* clone() const override { return new DrawnIcon(this->drawing); }

private:
  Drawing drawing;
};

QIcon IconFor(Drawing drawing)
{
  return QIcon(new DrawnIcon(std::move(drawing))); // which owns it
}

}

QIcon IconOf(LeftButton button)
{
  static const std::map<LeftButton, Drawing (*)()> drawings = {
    { LeftButton::Turn, &RotationDrawing }, { LeftButton::Walk, &WalkDrawing },
    { LeftButton::Brightness, &BrightnessDrawing }, { LeftButton::Distance, &DistanceDrawing },
    { LeftButton::Angle, &AngleDrawing }, { LeftButton::Box, &BoxDrawing },
    { LeftButton::CutOut, &ScissorsDrawing }, { LeftButton::KeepOnly, &KeepDrawing }
  };
  const auto drawing = drawings.find(button);
  return drawing == drawings.end() ? AnnotationIcon() : IconFor(drawing->second());
}

QIcon AnnotationIcon()
{
  return IconFor(PencilDrawing());
}

}
