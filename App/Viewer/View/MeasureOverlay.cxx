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

void DrawLine(QPainter& painter, const QPointF& from, const QPointF& to)
{
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setPen(QPen(MarkColor, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
}

QString Named(const std::string& name, const QString& text)
{
  return name.empty() ? text : QString::fromStdString(name) + ": " + text;
}

// Draws a label beside a position, moved into the image if necessary.
void DrawLabel(
  QPainter& painter, const QPointF& place, const QString& text, const PictureFrame& frame)
{
  const QSizeF size = painter.boundingRect(QRectF(0, 0, 1000, 1000), 0, text).size();
  QPointF corner = place + QPointF(8.0, -size.height() - 4.0);
  corner.setX(std::max(2.0, std::min(corner.x(), frame.size.width() - size.width() - 4.0)));
  corner.setY(std::max(2.0, std::min(corner.y(), frame.size.height() - size.height() - 4.0)));
  DrawLegibly(painter, QRectF(corner, size), Qt::AlignLeft | Qt::AlignTop, text);
}

void DrawDistance(
  QPainter& painter, const Distance& distance, const QString& text, const PictureFrame& frame)
{
  const std::optional<QPointF> from = frame.pixelOf(distance.fromMm);
  const std::optional<QPointF> to = frame.pixelOf(distance.toMm);
  if (from && to)
  {
    DrawMark(painter, *from, *to);
    DrawLabel(painter, 0.5 * (*from + *to), text, frame);
  }
}

void DrawAngle(
  QPainter& painter, const Angle& angle, const QString& text, const PictureFrame& frame)
{
  const std::optional<QPointF> from = frame.pixelOf(angle.fromMm);
  const std::optional<QPointF> vertex = frame.pixelOf(angle.vertexMm);
  const std::optional<QPointF> to = frame.pixelOf(angle.toMm);
  if (!from || !vertex || !to)
  {
    return;
  }
  DrawMark(painter, *vertex, *from);
  DrawMark(painter, *vertex, *to);
  // The arc connects the arms in the image plane.
  const QLineF first(*vertex, *from);
  const QLineF second(*vertex, *to);
  const double radius = std::min({ LargestArcPixels, 0.5 * first.length(), 0.5 * second.length() });
  const double span = std::remainder(second.angle() - first.angle(), 360.0);
  QPainterPath arc;
  const QRectF circle(*vertex - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
  arc.arcMoveTo(circle, first.angle());
  arc.arcTo(circle, first.angle(), span);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(MarkColor, 1.5));
  painter.drawPath(arc);
  DrawLabel(painter, *vertex, text, frame);
}

void DrawBox(QPainter& painter, const MeasuredBox& box, const QString& text, vtkImageData* image,
  const PictureFrame& frame)
{
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
    corners[i] = frame.pixelOf(world);
  }
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::optional<QPointF>& other = corners[i | 1 << axis];
      if (!(i >> axis & 1) && corners[i] && other)
      {
        DrawLine(painter, *corners[i], *other);
      }
    }
  }
  if (corners[0] && corners[7])
  {
    DrawMark(painter, *corners[0], *corners[0]);
    DrawMark(painter, *corners[7], *corners[7]);
    DrawLabel(painter, *corners[7], text, frame);
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

void DrawMark(QPainter& painter, const QPointF& from, const QPointF& to)
{
  DrawLine(painter, from, to);
  painter.setBrush(MarkColor);
  painter.drawEllipse(from, 3.0, 3.0);
  painter.drawEllipse(to, 3.0, 3.0);
}

void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const ShownBetween& isShown)
{
  const auto& [scene, texts, image] = measured;
  for (int i = 0; i < texts.distances.size(); ++i)
  {
    const Distance& distance = scene.distances[i];
    if (isShown(distance.fromMm, distance.toMm))
    {
      DrawDistance(painter, distance, Named(distance.name, texts.distances[i]), frame);
    }
  }
  for (int i = 0; i < texts.angles.size(); ++i)
  {
    const Angle& angle = scene.angles[i];
    if (isShown(angle.fromMm, angle.vertexMm) && isShown(angle.vertexMm, angle.toMm))
    {
      DrawAngle(painter, angle, Named(angle.name, texts.angles[i]), frame);
    }
  }
  for (int i = 0; i < texts.boxLabels.size(); ++i)
  {
    const MeasuredBox& box = scene.boxes[i];
    if (isShown(box.fromMm, box.toMm))
    {
      DrawBox(painter, box, Named(box.name, texts.boxLabels[i]), image, frame);
    }
  }
}

}
