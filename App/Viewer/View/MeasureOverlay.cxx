#include "Viewer/View/MeasureOverlay.h"

#include "Scene/WorldVector.h"

#include <vtkImageData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

void DrawLine(QPainter& painter, const QPointF& from, const QPointF& to, Qt::PenStyle style)
{
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setPen(QPen(MarkColor, 2.0, style, Qt::FlatCap));
  painter.drawLine(from, to);
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
  {
  }

  void Draw(const Distance& distance, const QString& text);
  void Draw(const Angle& angle, const QString& text);
  void Draw(const MeasuredBox& box, const QString& text);

  /// Draws the labels over all lines.
  void DrawLabels();

private:
  struct Label
  {
    QRectF place;
    QString text;
  };

  QRectF PlaceOf(const QPointF& beside, const QSizeF& size) const;
  void AddLabel(const QPointF& beside, const std::string& name, const QString& text);
  void DrawArc(const QLineF& first, const QLineF& second);
  Qt::PenStyle StyleOf(const std::array<double, 3>& from, const std::array<double, 3>& to) const;
  std::array<std::optional<QPointF>, 8> CornersOf(const MeasuredBox& box) const;

  QPainter& painter;
  const MeasuredScene& measured;
  const PictureFrame& frame;
  const MeasuresShown& shown;
  std::vector<Label> labels;
};

// The place of a label: beside a position, below other labels, and within the image.
QRectF MeasurePainter::PlaceOf(const QPointF& beside, const QSizeF& size) const
{
  const QSizeF room = this->frame.size - size - QSizeF(4.0, 4.0);
  const QPointF first = beside + QPointF(8.0, -size.height() - 4.0);
  QRectF place(QPointF(std::max(2.0, std::min(first.x(), room.width())),
                 std::max(2.0, std::min(first.y(), room.height()))),
    size);
  const QRectF wanted = place;
  for (auto label = this->labels.begin(); label != this->labels.end();)
  {
    const bool isInTheWay = label->place.intersects(place);
    if (isInTheWay)
    {
      place.moveTop(label->place.bottom() + 1.0);
    }
    label = isInTheWay ? this->labels.begin() : label + 1;
  }
  return place.top() <= room.height() ? place : wanted;
}

void MeasurePainter::AddLabel(const QPointF& beside, const std::string& name, const QString& text)
{
  const QString label = name.empty() ? text : QString::fromStdString(name) + ": " + text;
  const QSizeF size = this->painter.boundingRect(QRectF(0, 0, 1000, 1000), 0, label).size();
  this->labels.push_back({ this->PlaceOf(beside, size), label });
}

void MeasurePainter::DrawLabels()
{
  for (const Label& label : this->labels)
  {
    DrawLegibly(this->painter, label.place, Qt::AlignLeft | Qt::AlignTop, label.text);
  }
}

// The middle of a line decides for all of it.
Qt::PenStyle MeasurePainter::StyleOf(
  const std::array<double, 3>& from, const std::array<double, 3>& to) const
{
  const glm::dvec3 middle = 0.5 * (VectorOf(from) + VectorOf(to));
  return this->shown.isHidden(NumbersOf(middle)) ? Qt::DashLine : Qt::SolidLine;
}

void MeasurePainter::Draw(const Distance& distance, const QString& text)
{
  const std::optional<QPointF> from = this->frame.pixelOf(distance.fromMm);
  const std::optional<QPointF> to = this->frame.pixelOf(distance.toMm);
  if (from && to)
  {
    DrawMark(this->painter, *from, *to, this->StyleOf(distance.fromMm, distance.toMm));
    this->AddLabel(0.5 * (*from + *to), distance.name, text);
  }
}

void MeasurePainter::Draw(const Angle& angle, const QString& text)
{
  const std::optional<QPointF> from = this->frame.pixelOf(angle.fromMm);
  const std::optional<QPointF> vertex = this->frame.pixelOf(angle.vertexMm);
  const std::optional<QPointF> to = this->frame.pixelOf(angle.toMm);
  if (from && vertex && to)
  {
    DrawMark(this->painter, *vertex, *from, this->StyleOf(angle.vertexMm, angle.fromMm));
    DrawMark(this->painter, *vertex, *to, this->StyleOf(angle.vertexMm, angle.toMm));
    this->DrawArc(QLineF(*vertex, *from), QLineF(*vertex, *to));
    this->AddLabel(*vertex, angle.name, text);
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

std::array<std::optional<QPointF>, 8> MeasurePainter::CornersOf(const MeasuredBox& box) const
{
  vtkImageData* const image = this->measured.image;
  glm::dvec3 first;
  glm::dvec3 last;
  image->TransformPhysicalPointToContinuousIndex(box.fromMm.data(), &first.x);
  image->TransformPhysicalPointToContinuousIndex(box.toMm.data(), &last.x);
  std::array<std::optional<QPointF>, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 index(
      i & 1 ? last.x : first.x, i >> 1 & 1 ? last.y : first.y, i >> 2 ? last.z : first.z);
    std::array<double, 3> world;
    image->TransformContinuousIndexToPhysicalPoint(&index.x, world.data());
    corners[i] = this->frame.pixelOf(world);
  }
  return corners;
}

void MeasurePainter::Draw(const MeasuredBox& box, const QString& text)
{
  const std::array<std::optional<QPointF>, 8> corners = this->CornersOf(box);
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::optional<QPointF>& other = corners[i | 1 << axis];
      if (!(i >> axis & 1) && corners[i] && other)
      {
        DrawLine(this->painter, *corners[i], *other, Qt::SolidLine);
      }
    }
  }
  if (corners[0] && corners[7])
  {
    DrawMark(this->painter, *corners[0], *corners[0]);
    DrawMark(this->painter, *corners[7], *corners[7]);
    this->AddLabel(*corners[7], box.name, text);
  }
}

}

void DrawLegibly(QPainter& painter, const QRectF& box, int alignment, const QString& text)
{
  painter.setPen(QColor(0, 0, 0, 200));
  for (const QPointF& offset :
    { QPointF(-1.0, -1.0), QPointF(1.0, -1.0), QPointF(-1.0, 1.0), QPointF(1.0, 1.0) })
  {
    painter.drawText(box.translated(offset), alignment, text);
  }
  painter.setPen(TextColor);
  painter.drawText(box, alignment, text);
}

void DrawMark(QPainter& painter, const QPointF& from, const QPointF& to, Qt::PenStyle style)
{
  DrawLine(painter, from, to, style);
  painter.setPen(QPen(MarkColor, 2.0));
  painter.setBrush(MarkColor);
  painter.drawEllipse(from, 3.0, 3.0);
  painter.drawEllipse(to, 3.0, 3.0);
}

void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const MeasuresShown& shown)
{
  const auto& [scene, texts, image] = measured;
  MeasurePainter measures(painter, measured, frame, shown);
  for (int i = 0; i < texts.distances.size(); ++i)
  {
    const Distance& distance = scene.distances[i];
    if (shown.between(distance.fromMm, distance.toMm))
    {
      measures.Draw(distance, texts.distances[i]);
    }
  }
  for (int i = 0; i < texts.angles.size(); ++i)
  {
    const Angle& angle = scene.angles[i];
    if (shown.between(angle.fromMm, angle.vertexMm) && shown.between(angle.vertexMm, angle.toMm))
    {
      measures.Draw(angle, texts.angles[i]);
    }
  }
  for (int i = 0; i < texts.boxLabels.size(); ++i)
  {
    const MeasuredBox& box = scene.boxes[i];
    if (shown.between(box.fromMm, box.toMm))
    {
      measures.Draw(box, texts.boxLabels[i]);
    }
  }
  measures.DrawLabels();
}

}
