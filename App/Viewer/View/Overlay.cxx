#include "Viewer/View/Overlay.h"

#include "Scene/AnatomicalDirection.h"
#include "Scene/ScenePicking.h"
#include "Scene/WorldVector.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

const QColor TextColor(235, 235, 235);
const QColor MarkColor(255, 210, 80);
constexpr double Margin = 10.0;     // [logical pixels]
constexpr double CubeHalfSide = 22; // [logical pixels]

std::array<double, 3> Opposite(const std::array<double, 3>& direction)
{
  return { -direction[0], -direction[1], -direction[2] };
}

// Legible on whatever is below it.
void DrawText(QPainter& painter, const QRectF& box, int alignment, const QString& text)
{
  painter.setPen(QColor(0, 0, 0, 200));
  painter.drawText(box.translated(1.0, 1.0), alignment, text);
  painter.setPen(TextColor);
  painter.drawText(box, alignment, text);
}

void DrawLetters(QPainter& painter, const PictureFrame& frame)
{
  const QRectF inside(
    Margin, Margin, frame.size.width() - 2.0 * Margin, frame.size.height() - 2.0 * Margin);
  const auto letters = [](const std::array<double, 3>& direction)
  { return QString::fromStdString(AnatomicalDirection(direction.data())); };
  DrawText(painter, inside, Qt::AlignRight | Qt::AlignVCenter, letters(frame.rightWorld));
  DrawText(painter, inside, Qt::AlignLeft | Qt::AlignVCenter, letters(Opposite(frame.rightWorld)));
  DrawText(painter, inside, Qt::AlignTop | Qt::AlignHCenter, letters(frame.upWorld));
  DrawText(painter, inside, Qt::AlignBottom | Qt::AlignHCenter, letters(Opposite(frame.upWorld)));
}

// A cube turned as the patient is, seen in parallel: of its faces those towards the eye.
void DrawCube(QPainter& painter, const PictureFrame& frame)
{
  const glm::dvec3 right = VectorOf(frame.rightWorld);
  const glm::dvec3 up = VectorOf(frame.upWorld);
  const glm::dvec3 towardsEye = VectorOf(frame.towardsEyeWorld);
  const QPointF center(
    frame.size.width() - 2.2 * CubeHalfSide, frame.size.height() - 2.2 * CubeHalfSide);
  const auto pixelOf = [&](const glm::dvec3& corner)
  { return center + CubeHalfSide * QPointF(glm::dot(right, corner), -glm::dot(up, corner)); };

  for (int face = 0; face < 6; ++face)
  {
    glm::dvec3 normal(0.0);
    normal[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    const double facing = glm::dot(normal, towardsEye);
    if (facing <= 0.0)
    {
      continue;
    }
    glm::dvec3 first(0.0);
    glm::dvec3 second(0.0);
    first[(face / 2 + 1) % 3] = 1.0;
    second[(face / 2 + 2) % 3] = 1.0;
    const QPolygonF outline({ pixelOf(normal + first + second), pixelOf(normal + first - second),
      pixelOf(normal - first - second), pixelOf(normal - first + second) });
    const int gray = int(90.0 + 110.0 * facing);
    painter.setPen(QPen(QColor(20, 20, 20), 1.0));
    painter.setBrush(QColor(gray, gray, gray + 8, 215));
    painter.drawPolygon(outline);
    painter.setOpacity(std::min(1.0, 2.0 * facing));
    painter.setPen(QColor(20, 20, 20));
    painter.drawText(QRectF(pixelOf(normal) - QPointF(12.0, 12.0), QSizeF(24.0, 24.0)),
      Qt::AlignCenter, QString::fromStdString(AnatomicalDirection(&normal.x)));
    painter.setOpacity(1.0);
  }
}

void DrawDistance(QPainter& painter, const Distance& distance, const PictureFrame& frame)
{
  const std::optional<QPointF> from = frame.pixelOf(distance.fromMm);
  const std::optional<QPointF> to = frame.pixelOf(distance.toMm);
  if (!from || !to)
  {
    return;
  }
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(*from, *to);
  painter.setPen(QPen(MarkColor, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(*from, *to);
  painter.setBrush(MarkColor);
  painter.drawEllipse(*from, 3.0, 3.0);
  painter.drawEllipse(*to, 3.0, 3.0);
  const QPointF middle = 0.5 * (*from + *to);
  DrawText(painter, QRectF(middle + QPointF(8.0, -24.0), QSizeF(120.0, 20.0)),
    Qt::AlignLeft | Qt::AlignVCenter, DistanceText(distance));
}

}

PictureFrame FrameOf(vtkCamera* camera, const QSizeF& size)
{
  vtkMatrix4x4* const viewFromWorld = camera->GetViewTransformMatrix();
  const auto row = [&](int i)
  {
    const auto element = [&](int j) { return viewFromWorld->GetElement(i, j); };
    return std::array<double, 3>{ element(0), element(1), element(2) };
  };
  auto clipFromWorld = vtkSmartPointer<vtkMatrix4x4>::New();
  clipFromWorld->DeepCopy(
    camera->GetCompositeProjectionTransformMatrix(size.width() / size.height(), -1.0, 1.0));
  const auto pixelOf = [clipFromWorld, size](const std::array<double, 3>& point)
  {
    double clip[4] = { point[0], point[1], point[2], 1.0 };
    clipFromWorld->MultiplyPoint(clip, clip);
    const QPointF pixel(0.5 * (1.0 + clip[0] / clip[3]) * size.width(),
      0.5 * (1.0 - clip[1] / clip[3]) * size.height());
    return clip[3] > 0.0 ? std::optional<QPointF>(pixel) : std::nullopt;
  };
  return { size, pixelOf, row(0), row(1), row(2) };
}

void DrawOverlay(QPainter& painter, const Scene& scene, const PictureFrame& frame)
{
  painter.setRenderHint(QPainter::Antialiasing);
  DrawLetters(painter, frame);
  DrawCube(painter, frame);
  for (const Distance& distance : scene.distances)
  {
    DrawDistance(painter, distance, frame);
  }
}

QString DistanceText(const Distance& distance)
{
  return QCoreApplication::translate("Overlay", "%1 mm").arg(LengthMm(distance), 0, 'f', 1);
}

}
