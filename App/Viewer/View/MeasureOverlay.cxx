#include "Viewer/View/MeasureOverlay.h"

#include "Scene/MeasureKinds.h"
#include "Scene/WorldVector.h"
#include "Viewer/View/LabelPlaces.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace varimarch
{

namespace
{

const QColor TextColor(235, 235, 235);
const QColor MarkColor(255, 210, 80);
constexpr double LargestArcPixels = 30.0;

void DrawLine(QPainter& painter, const QPolygonF& line, Qt::PenStyle style)
{
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawPolyline(line);
  painter.setPen(QPen(MarkColor, 2.0, style, Qt::FlatCap));
  painter.drawPolyline(line);
}

// Draws measurements one after another; their labels give way to those drawn before.
class MeasurePainter
{
public:
  MeasurePainter(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
    const MeasuresShown& shown)
    : painter(painter)
    , measured(measured)
    , frame(frame)
    , shown(shown)
    , places(frame.size, shown.taken)
  {
  }

  void Draw(const Measure& measure, const QString& text);

  /// Draws the labels over all lines.
  void DrawLabels();

private:
  struct Label
  {
    QRectF place;
    QPointF beside;
    QString text;
  };

  void DrawLines(const MeasureLines& lines);
  void DrawSign(const Measure& measure);
  void DrawArc(const QLineF& first, const QLineF& second);
  void DrawArrowHead(const QLineF& arrow);
  void DrawHandles(const Measure& measure);
  void AddLabel(const Measure& measure, const QString& text);
  double LeftOf(const Measure& measure, double left) const;
  Qt::PenStyle StyleOf(const std::vector<glm::dvec3>& line) const;
  std::optional<QPointF> PixelOf(const glm::dvec3& point) const
  {
    return this->frame.pixelOf(NumbersOf(point));
  }

  QPainter& painter;
  const MeasuredScene& measured;
  const PictureFrame& frame;
  const MeasuresShown& shown;
  LabelPlaces places;
  std::vector<Label> labels;
};

void MeasurePainter::Draw(const Measure& measure, const QString& text)
{
  const MeasureLines lines = LinesOf(measure, this->measured.image);
  std::vector<glm::dvec3> points = PointsOf(measure);
  for (const std::vector<glm::dvec3>& line : lines)
  {
    points.insert(points.end(), line.begin(), line.end());
  }
  if (this->shown.reaching(points))
  {
    this->DrawLines(lines);
    this->DrawSign(measure);
    if (!lines.empty())
    {
      this->DrawHandles(measure);
    }
    this->AddLabel(measure, text);
  }
}

// Parts behind the eye are left out.
void MeasurePainter::DrawLines(const MeasureLines& lines)
{
  for (const std::vector<glm::dvec3>& line : lines)
  {
    const Qt::PenStyle style = this->StyleOf(line);
    QPolygonF part;
    for (const glm::dvec3& point : line)
    {
      const std::optional<QPointF> pixel = this->PixelOf(point);
      if (pixel)
      {
        part << *pixel;
      }
      else
      {
        DrawLine(this->painter, part, style);
        part.clear();
      }
    }
    DrawLine(this->painter, part, style);
  }
}

// The middle of a line decides for all of it.
Qt::PenStyle MeasurePainter::StyleOf(const std::vector<glm::dvec3>& line) const
{
  const std::size_t half = line.size() / 2;
  const glm::dvec3 middle = line.size() == 2 ? 0.5 * (line[0] + line[1]) : line[half];
  return this->shown.isHidden(NumbersOf(middle)) ? Qt::DashLine : Qt::SolidLine;
}

void MeasurePainter::DrawSign(const Measure& measure)
{
  const MeasureSign sign = TraitsOf(measure.kind).sign;
  if (sign == MeasureSign::None)
  {
    return;
  }
  const std::optional<QPointF> first = this->frame.pixelOf(measure.pointsMm[0]);
  const std::optional<QPointF> second = this->frame.pixelOf(measure.pointsMm[1]);
  const std::optional<QPointF> last = this->frame.pixelOf(measure.pointsMm.back());
  if (first && second && last && sign == MeasureSign::Arc)
  {
    this->DrawArc(QLineF(*second, *first), QLineF(*second, *last));
  }
  else if (first && last && sign == MeasureSign::ArrowHead)
  {
    this->DrawArrowHead(QLineF(*first, *last));
  }
}

// The arc connects the arms in the image plane.
void MeasurePainter::DrawArc(const QLineF& first, const QLineF& second)
{
  const double radius = std::min({ LargestArcPixels, 0.5 * first.length(), 0.5 * second.length() });
  const double span = std::remainder(second.angle() - first.angle(), 360.0);
  QPainterPath arc;
  const QRectF circle(first.p1() - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
  arc.arcMoveTo(circle, first.angle());
  arc.arcTo(circle, first.angle(), span);
  this->painter.setBrush(Qt::NoBrush);
  this->painter.setPen(QPen(MarkColor, 1.5));
  this->painter.drawPath(arc);
}

void MeasurePainter::DrawArrowHead(const QLineF& arrow)
{
  constexpr double HeadPixels = 14.0;
  constexpr double HalfAngleDegrees = 22.0;
  QPolygonF head;
  head << arrow.p2();
  for (const double turn : { -HalfAngleDegrees, HalfAngleDegrees })
  {
    QLineF side(arrow.p2(), arrow.p1());
    side.setLength(HeadPixels);
    side.setAngle(side.angle() + turn);
    head << side.p2();
  }
  this->painter.setPen(QPen(QColor(0, 0, 0, 160), 1.0));
  this->painter.setBrush(MarkColor);
  this->painter.drawPolygon(head);
}

void MeasurePainter::DrawHandles(const Measure& measure)
{
  const bool hasHead = TraitsOf(measure.kind).sign == MeasureSign::ArrowHead;
  for (std::size_t i = 0; i < HandleCount(measure) - (hasHead ? 1 : 0); ++i)
  {
    if (const std::optional<QPointF> pixel = this->frame.pixelOf(measure.pointsMm[i]))
    {
      DrawDot(this->painter, *pixel);
    }
  }
}

void MeasurePainter::AddLabel(const Measure& measure, const QString& text)
{
  const int number = TraitsOf(measure.kind).labelPoint;
  const glm::dvec3 point = number < 0 ? MiddleOf(measure) : VectorOf(measure.pointsMm[number]);
  const std::optional<QPointF> beside = this->PixelOf(point);
  if (!beside || text.isEmpty())
  {
    return;
  }
  const QSizeF size = this->painter.boundingRect(QRectF(0, 0, 1000, 1000), 0, text).size();
  constexpr double Gap = 8.0;
  QPointF corner = *beside + QPointF(Gap, -size.height() - 4.0);
  if (corner.x() + size.width() > this->frame.size.width())
  {
    corner.setX(this->LeftOf(measure, beside->x()) - Gap - size.width());
  }
  if (const std::optional<QRectF> place = this->places.Take(QRectF(corner, size)))
  {
    this->labels.push_back({ *place, *beside, text });
  }
}

// The left end of what may be dragged of a measurement.
double MeasurePainter::LeftOf(const Measure& measure, double left) const
{
  for (std::size_t i = 0; i < HandleCount(measure); ++i)
  {
    if (const std::optional<QPointF> pixel = this->frame.pixelOf(measure.pointsMm[i]))
    {
      left = std::min(left, pixel->x());
    }
  }
  return left;
}

// A label far from its measurement is connected to it.
void MeasurePainter::DrawLabels()
{
  constexpr double FarPixels = 40.0;
  for (const Label& label : this->labels)
  {
    const QLineF line(label.place.center(), label.beside);
    if (line.length() > FarPixels + 0.5 * std::hypot(label.place.width(), label.place.height()))
    {
      this->painter.setPen(QPen(QColor(235, 235, 235, 120), 1.0, Qt::DotLine));
      this->painter.drawLine(line);
    }
    DrawLegibly(this->painter, label.place, Qt::AlignLeft | Qt::AlignTop, label.text);
  }
}

}

QRectF DrawLegibly(QPainter& painter, const QRectF& box, int alignment, const QString& text)
{
  painter.setPen(QColor(0, 0, 0, 200));
  for (const QPointF& offset :
    { QPointF(-1.0, -1.0), QPointF(1.0, -1.0), QPointF(-1.0, 1.0), QPointF(1.0, 1.0) })
  {
    painter.drawText(box.translated(offset), alignment, text);
  }
  painter.setPen(TextColor);
  QRectF place;
  painter.drawText(box, alignment, text, &place);
  return text.isEmpty() ? QRectF() : place;
}

void DrawDot(QPainter& painter, const QPointF& place)
{
  painter.setPen(QPen(MarkColor, 2.0));
  painter.setBrush(MarkColor);
  painter.drawEllipse(place, 3.0, 3.0);
}

void DrawMark(QPainter& painter, const QPointF& from, const QPointF& to)
{
  DrawLine(painter, QPolygonF(QVector<QPointF>{ from, to }), Qt::SolidLine);
  DrawDot(painter, from);
  DrawDot(painter, to);
}

void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const MeasuresShown& shown)
{
  MeasurePainter measures(painter, measured, frame, shown);
  for (std::size_t i = 0; i < measured.scene.measures.size(); ++i)
  {
    if (measured.scene.measures[i].visible)
    {
      measures.Draw(measured.scene.measures[i], measured.texts.labels[int(i)]);
    }
  }
  measures.DrawLabels();
}

}
