#include "Viewer/View/Overlay.h"

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Scene/Slices/SliceAxes.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QShortcut>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

namespace
{

struct EditorTexts
{
  Q_DECLARE_TR_FUNCTIONS(WordsEditor)
};

}

void AskForWordsOver(
  QWidget* view, const QPointF& place, const std::function<void(const QString&)>& take)
{
  auto* const line = new QLineEdit(view);
  line->setPlaceholderText(EditorTexts::tr("Words"));
  line->setAccessibleName(EditorTexts::tr("Words"));
  line->resize(std::min(200, view->width()), line->sizeHint().height());
  line->move(std::clamp(int(place.x()), 0, view->width() - line->width()),
    std::clamp(int(place.y()), 0, std::max(view->height() - line->height(), 0)));
  const auto finish = [line, take](const QString& words)
  {
    line->disconnect(); // the line loses the focus when it is hidden
    line->hide();
    line->deleteLater();
    take(words);
  };
  QObject::connect(
    line, &QLineEdit::editingFinished, line, [line, finish] { finish(line->text().trimmed()); });
  auto* const escape = new QShortcut(Qt::Key_Escape, line, nullptr, nullptr, Qt::WidgetShortcut);
  QObject::connect(escape, &QShortcut::activated, line, [finish] { finish({}); });
  line->show();
  line->setFocus();
}

namespace
{

constexpr double MarginOfLabel = 2.0; // logical pixels

}

LabelPlaces::LabelPlaces(const QSizeF& image, const std::vector<QRectF>& newTaken)
  : inside(QRectF(QPointF(), image)
             .adjusted(MarginOfLabel, MarginOfLabel, -MarginOfLabel, -MarginOfLabel))
  , taken(newTaken)
{
}

bool LabelPlaces::IsFree(const QRectF& place) const
{
  return std::none_of(this->taken.begin(), this->taken.end(),
    [&](const QRectF& other) { return other.intersects(place); });
}

// Looks at corners at steps of a line and of a part of the width.
std::optional<QPointF> LabelPlaces::NearestFree(const QRectF& wanted) const
{
  constexpr double PartOfWidth = 0.25;
  const QPointF step(
    std::max(PartOfWidth * wanted.width(), 8.0), std::max(wanted.height() + 1.0, 8.0));
  const QPointF last = this->inside.bottomRight() - QPointF(wanted.width(), wanted.height());
  const auto first = [](double from, double at, double of)
  { return at - std::floor((at - from) / of) * of; };
  std::optional<QPointF> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (double y = first(this->inside.top(), wanted.top(), step.y()); y <= last.y(); y += step.y())
  {
    for (double x = first(this->inside.left(), wanted.left(), step.x()); x <= last.x();
         x += step.x())
    {
      const QPointF corner(x, y);
      const double distance = QLineF(corner, wanted.topLeft()).length();
      if (distance < least && this->IsFree({ corner, wanted.size() }))
      {
        nearest = corner;
        least = distance;
      }
    }
  }
  return nearest;
}

std::optional<QRectF> LabelPlaces::Take(const QRectF& wanted)
{
  const QSizeF size = wanted.size();
  const bool fits = size.width() <= this->inside.width() && size.height() <= this->inside.height();
  if (!fits ||
    (this->tooLarge && size.width() >= this->tooLarge->width() &&
      size.height() >= this->tooLarge->height()))
  {
    return std::nullopt;
  }
  QRectF place = wanted;
  place.moveLeft(
    std::clamp(wanted.left(), this->inside.left(), this->inside.right() - size.width()));
  place.moveTop(
    std::clamp(wanted.top(), this->inside.top(), this->inside.bottom() - size.height()));
  if (!this->IsFree(place))
  {
    const std::optional<QPointF> free = this->NearestFree(place);
    if (!free)
    {
      this->tooLarge = size;
      return std::nullopt;
    }
    place.moveTopLeft(*free);
  }
  this->taken.push_back(place);
  return place;
}

}
