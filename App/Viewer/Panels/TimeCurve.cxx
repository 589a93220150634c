#include "Viewer/Panels/TimeCurve.h"

#include "Scene/MeasureUnits.h"
#include "Scene/SceneCuts.h"
#include "Scene/ScenePicking.h"
#include "Viewer/Model/NumberText.h"
#include "Viewer/Model/TimeSeries.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <limits>

namespace varimarch
{

namespace
{

/// The chart's place in the widget, and the ranges of its axes.
struct ChartScale
{
  QRectF plot;
  double first;
  double last;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  bool IsEmpty() const { return this->smallest > this->largest; }

  QPointF PointOf(double time, double value) const
  {
    const double height = this->largest > this->smallest ? this->largest - this->smallest : 1.0;
    return { this->plot.left() + this->plot.width() * (time - this->first) / (last - first),
      this->plot.bottom() - this->plot.height() * (value - this->smallest) / height };
  }
};

ChartScale ScaleOf(
  const QRectF& plot, const LoadedTimes& times, const std::vector<std::optional<double>>& values)
{
  ChartScale scale = { plot, times.values.front(), times.values.back() };
  for (const std::optional<double>& value : values)
  {
    scale.smallest = std::min(scale.smallest, value.value_or(scale.smallest));
    scale.largest = std::max(scale.largest, value.value_or(scale.largest));
  }
  return scale;
}

// Lines between neighbours, and a dot at each value, so that one alone is seen too.
void DrawCurve(QPainter& painter, const ChartScale& scale, const LoadedTimes& times,
  const std::vector<std::optional<double>>& values)
{
  QPainterPath lines;
  for (std::size_t time = 0; time < values.size(); ++time)
  {
    if (values[time])
    {
      const QPointF point = scale.PointOf(times.values[time], *values[time]);
      time > 0 && values[time - 1] ? lines.lineTo(point) : lines.moveTo(point);
      painter.drawEllipse(point, 1.5, 1.5);
    }
  }
  painter.drawPath(lines);
}

}

TimeCurve::TimeCurve(SceneModel* model, const TimeSeries* series, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , series(series)
{
  this->setObjectName("timeCurve");
  this->setAccessibleName(tr("Value over time at the crosshair"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* const copy = new QAction(tr("Copy as CSV"), this);
  copy->setObjectName("copyCurve");
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  connect(copy, &QAction::triggered, this,
    [this] { QGuiApplication::clipboard()->setText(this->Csv()); });
  this->addAction(copy);
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  this->setToolTip(tr("Ctrl+C copies the values as CSV"));
  connect(model, &SceneModel::Changed, this, QOverload<>::of(&TimeCurve::update));
  connect(series, &TimeSeries::KeptChanged, this, QOverload<>::of(&TimeCurve::update));
}

std::vector<std::optional<double>> TimeCurve::Values() const
{
  const LoadedVolume& shown = this->model->CurrentStudy()->volume;
  const std::array<double, 3> point =
    this->model->CurrentScene().slices.crosshairMm.value_or(MiddleOf(shown.image));
  std::vector<std::optional<double>> values(shown.times.values.size());
  for (const auto& [time, volume] : this->series->Kept())
  {
    if (const std::optional<double> value = ValueAt(volume.image, point))
    {
      values[std::size_t(time)] = FactorToUnit(volume) * *value;
    }
  }
  return values;
}

QString TimeCurve::Unit() const
{
  const std::string unit = UnitOf(this->model->CurrentStudy()->volume);
  return unit.empty() ? tr("value") : QString::fromStdString(unit);
}

QString TimeCurve::Csv() const
{
  const LoadedTimes& times = this->model->CurrentStudy()->volume.times;
  const std::vector<std::optional<double>> values = this->Values();
  QString text =
    (times.areSeconds ? tr("time [s]") : tr("time")) + ',' + this->Unit() + QChar('\n');
  for (std::size_t time = 0; time < values.size(); ++time)
  {
    if (values[time])
    {
      text += QString::number(times.values[time], 'g', 12) + ',' +
        QString::number(*values[time], 'g', 12) + '\n';
    }
  }
  return text;
}

void TimeCurve::paintEvent(QPaintEvent*)
{
  if (!this->model->CurrentStudy() || !this->model->CurrentStudy()->volume.times.AreSeveral())
  {
    return;
  }
  const LoadedTimes& times = this->model->CurrentStudy()->volume.times;
  const std::vector<std::optional<double>> values = this->Values();
  const double line = this->fontMetrics().height();
  const ChartScale scale =
    ScaleOf(QRectF(this->rect()).adjusted(70.0, 0.5 * line, -10.0, -1.5 * line), times, values);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(this->palette().color(QPalette::Mid));
  painter.drawRect(scale.plot);
  painter.setPen(this->palette().color(QPalette::Text));
  const auto known = std::count_if(
    values.begin(), values.end(), [](const auto& value) { return value.has_value(); });
  painter.drawText(QRectF(scale.plot.left(), scale.plot.bottom(), scale.plot.width(), 1.5 * line),
    Qt::AlignCenter,
    tr("%1 at the crosshair, %2 of %3 times").arg(this->Unit()).arg(known).arg(values.size()));
  if (scale.IsEmpty())
  {
    return;
  }
  const QRectF labels(0.0, scale.plot.top() - 0.5 * line, scale.plot.left() - 6.0, line);
  painter.drawText(labels, Qt::AlignRight | Qt::AlignVCenter, NumberText(scale.largest, 1));
  painter.drawText(labels.translated(0.0, scale.plot.height()), Qt::AlignRight | Qt::AlignVCenter,
    NumberText(scale.smallest, 1));
  const double now = times.values[std::size_t(this->model->ChosenTime())];
  painter.setPen(this->palette().color(QPalette::Highlight));
  painter.drawLine(QPointF(scale.PointOf(now, scale.smallest).x(), scale.plot.top()),
    QPointF(scale.PointOf(now, scale.smallest).x(), scale.plot.bottom()));
  painter.setPen(QPen(this->palette().color(QPalette::Text), 1.5));
  DrawCurve(painter, scale, times, values);
}

}
