#include "Viewer/View/SliceCorners.h"

#include "Scene/Model/WorldVector.h"
#include "Scene/Slices/SliceAxes.h"
#include "Scene/Slices/SlicePicture.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/Overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QStringList>

#include <glm/geometric.hpp>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr double MarginX = 6.0; // pixels
constexpr double MarginY = 4.0;

struct CornerWords
{
  Q_DECLARE_TR_FUNCTIONS(SliceCorners)
};

QString LettersOf(const glm::dvec3& direction)
{
  return QString::fromStdString(AnatomicalDirection(&direction.x));
}

// Data without units may lie between 0 and 1.
QString WindowText(const SliceRequest& request, double zoom)
{
  const int decimals = request.window < 10.0 ? 3 : 0;
  QStringList lines = { CornerWords::tr("W %1 L %2")
                          .arg(NumberText(request.window, decimals),
                            NumberText(request.level, decimals)) };
  if (zoom != 1.0)
  {
    lines << CornerWords::tr("Zoom %1 %").arg(NumberText(100.0 * zoom, 0));
  }
  return lines.join('\n');
}

// The position is the distance from the origin of the patient's coordinates, such as "S 12.5 mm".
QString PlaceText(vtkImageData* image, const SliceRequest& request, const CornerTexts& texts)
{
  QStringList lines;
  const bool hasNumber = texts.count(CornerText::Number) > 0;
  const bool isTurned = request.turn != SliceTurn();
  const auto slice =
    isTurned ? std::nullopt : SliceNumberAt(image, request.plane, request.middleMm);
  if (slice && hasNumber)
  {
    lines << CornerWords::tr("Slice %1 of %2").arg(slice->number).arg(slice->count);
  }
  if (isTurned && hasNumber)
  {
    lines << CornerWords::tr("Oblique");
  }
  const glm::dvec3 through = VectorOf(AxesOf(request.plane, request.turn).through);
  const double positionMm = glm::dot(VectorOf(request.middleMm), through);
  if (texts.count(CornerText::Position))
  {
    lines << CornerWords::tr("%1 %2 mm")
               .arg(LettersOf(positionMm < 0.0 ? -through : through),
                 NumberText(std::abs(positionMm), 1));
  }
  if (request.slabMm > 0.0 && texts.count(CornerText::Slab))
  {
    lines << CornerWords::tr("Slab %1 mm").arg(NumberText(request.slabMm, 1));
  }
  return lines.join('\n');
}

// Metres and micrometres are written as such.
QString LengthText(double lengthMm)
{
  if (lengthMm < 1.0)
  {
    return CornerWords::tr("%1 µm").arg(NumberText(1000.0 * lengthMm, lengthMm < 0.001 ? 3 : 0));
  }
  return lengthMm < 10.0 ? CornerWords::tr("%1 mm").arg(NumberText(lengthMm, 0))
                         : CornerWords::tr("%1 cm").arg(NumberText(0.1 * lengthMm, 0));
}

QRectF DrawScaleBar(QPainter& painter, const QRectF& inside, double mmPerPixel)
{
  constexpr double LargestPart = 0.3; // part of the view's width
  const double lengthMm = ScaleBarMm(LargestPart * inside.width() * mmPerPixel);
  const QPointF end = inside.bottomRight() - QPointF(0.0, 2.0);
  const QPointF start = end - QPointF(lengthMm / mmPerPixel, 0.0);
  const QPointF tick(0.0, 5.0);
  for (const QPen& pen : { QPen(QColor(0, 0, 0, 160), 3.0), QPen(Qt::white, 1.0) })
  {
    painter.setPen(pen);
    painter.drawLine(start, end);
    painter.drawLine(start, start - tick);
    painter.drawLine(end, end - tick);
  }
  return DrawLegibly(painter, QRectF(inside.topLeft(), end - QPointF(0.0, 6.0)),
    Qt::AlignRight | Qt::AlignBottom, LengthText(lengthMm))
    .united(QRectF(start - tick, end));
}

std::vector<QRectF> DrawDirections(
  QPainter& painter, const QRectF& inside, const SliceRequest& request)
{
  const SliceAxes axes = AxesOf(request.plane, request.turn);
  const glm::dvec3 right = VectorOf(axes.right);
  const glm::dvec3 down = VectorOf(axes.down);
  return {
    DrawLegibly(painter, inside, Qt::AlignRight | Qt::AlignVCenter, LettersOf(right)),
    DrawLegibly(painter, inside, Qt::AlignLeft | Qt::AlignVCenter, LettersOf(-right)),
    DrawLegibly(painter, inside, Qt::AlignBottom | Qt::AlignHCenter, LettersOf(down)),
    DrawLegibly(painter, inside, Qt::AlignTop | Qt::AlignHCenter, LettersOf(-down)),
  };
}

}

std::vector<QRectF> DrawSliceCorners(
  QPainter& painter, const QRectF& view, vtkImageData* image, const SliceCorners& corners)
{
  const auto& [request, zoom, texts] = corners;
  const QRectF inside = view.adjusted(MarginX, MarginY, -MarginX, -MarginY);
  std::vector<QRectF> taken;
  if (texts.count(CornerText::Directions))
  {
    taken = DrawDirections(painter, inside, request);
  }
  if (texts.count(CornerText::Window))
  {
    taken.push_back(
      DrawLegibly(painter, inside, Qt::AlignLeft | Qt::AlignTop, WindowText(request, zoom)));
  }
  taken.push_back(
    DrawLegibly(painter, inside, Qt::AlignRight | Qt::AlignTop, PlaceText(image, request, texts)));
  if (texts.count(CornerText::Scale))
  {
    taken.push_back(DrawScaleBar(painter, inside, request.mmPerPixel));
  }
  return taken;
}

double ScaleBarMm(double mostMm)
{
  const double power = std::pow(10.0, std::floor(std::log10(mostMm)));
  for (const double factor : { 5.0, 2.0 })
  {
    if (factor * power <= mostMm)
    {
      return factor * power;
    }
  }
  return power;
}

}
