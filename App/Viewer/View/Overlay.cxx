#include "Viewer/View/Overlay.h"

#include "Scene/AnatomicalDirection.h"
#include "Scene/ScenePicking.h"
#include "Scene/WorldVector.h"

#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr double Margin = 10.0;     // [logical pixels]
constexpr double CubeHalfSide = 22; // [logical pixels]

std::array<double, 3> Opposite(const std::array<double, 3>& direction)
{
  return { -direction[0], -direction[1], -direction[2] };
}

std::vector<QRectF> DrawLetters(QPainter& painter, const PictureFrame& frame)
{
  const QRectF inside(
    Margin, Margin, frame.size.width() - 2.0 * Margin, frame.size.height() - 2.0 * Margin);
  const auto letters = [](const std::array<double, 3>& direction)
  { return QString::fromStdString(AnatomicalDirection(direction.data())); };
  return {
    DrawLegibly(painter, inside, Qt::AlignRight | Qt::AlignVCenter, letters(frame.rightWorld)),
    DrawLegibly(
      painter, inside, Qt::AlignLeft | Qt::AlignVCenter, letters(Opposite(frame.rightWorld))),
    DrawLegibly(painter, inside, Qt::AlignTop | Qt::AlignHCenter, letters(frame.upWorld)),
    DrawLegibly(
      painter, inside, Qt::AlignBottom | Qt::AlignHCenter, letters(Opposite(frame.upWorld))),
  };
}

// A cube with the patient's orientation in parallel projection; only faces towards the eye are
// drawn.
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

}

void DrawOverlay(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  vtkImageData* mask, std::vector<QRectF> taken)
{
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<QRectF> letters = DrawLetters(painter, frame);
  taken.insert(taken.end(), letters.begin(), letters.end());
  DrawCube(painter, frame);
  const auto isHidden = [&](const std::array<double, 3>& point)
  {
    const std::optional<QPointF> pixel = frame.pixelOf(point);
    return pixel &&
      IsHidden(
        measured.scene, measured.image, NumbersOf(frame.sightLineAt(*pixel).nearest), point, mask);
  };
  DrawMeasures(painter, measured, frame, { [](const auto&) { return true; }, isHidden, taken });
}

}
