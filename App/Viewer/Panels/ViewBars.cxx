#include "Viewer/Panels/ViewBars.h"

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/TimeSeries.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr double UsualTimesPerSecond = 5.0;

}

TimeBar::TimeBar(SceneModel* model, const TimeSeries* series, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , series(series)
  , slider(new QSlider(Qt::Horizontal))
  , speed(new QComboBox)
  , text(new QLabel)
{
  this->setObjectName("timeBar");
  this->MakeActions();
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  this->AddButtons(row);
  this->AddSlider(row);
  this->speed->setObjectName("speed");
  this->speed->setAccessibleName(tr("Speed of the times"));
  row->addWidget(this->speed);
  this->timer.setSingleShot(true);
  this->timer.setTimerType(Qt::PreciseTimer);
  connect(&this->timer, &QTimer::timeout, this, &TimeBar::Advance);
  connect(model, &SceneModel::Changed, this, &TimeBar::Update);
  connect(series, &TimeSeries::Failed, this,
    [this]
    {
      this->play->setChecked(false);
      this->ShowTime();
    });
  this->hide();
}

void TimeBar::MakeActions()
{
  const auto action = [this](const QString& name, const QString& key, const char* objectName)
  {
    auto* const made = new QAction(name, this);
    made->setShortcut(QKeySequence(key));
    made->setObjectName(objectName);
    made->setEnabled(false);
    return made;
  };
  this->play = action(tr("&Play the times"), "P", "playTimes");
  this->previous = action(tr("P&revious time"), ",", "previousTime");
  this->next = action(tr("&Next time"), ".", "nextTime");
  this->loop = action(tr("Repe&at"), "Shift+P", "repeatTimes");
  this->curve = action(tr("&Curve at the crosshair"), "Shift+C", "curveOfTimes");
  this->play->setIcon(this->style()->standardIcon(QStyle::SP_MediaPlay));
  this->previous->setIcon(this->style()->standardIcon(QStyle::SP_MediaSkipBackward));
  this->next->setIcon(this->style()->standardIcon(QStyle::SP_MediaSkipForward));
  this->play->setCheckable(true);
  this->loop->setCheckable(true);
  this->loop->setChecked(true);
  this->curve->setCheckable(true);
  connect(this->curve, &QAction::toggled, this, &TimeBar::CurveWanted);
  connect(this->play, &QAction::toggled, this, &TimeBar::Play);
  connect(this->previous, &QAction::triggered, this, [this] { this->Step(-1); });
  connect(this->next, &QAction::triggered, this, [this] { this->Step(1); });
}

void TimeBar::AddButtons(QHBoxLayout* row)
{
  for (QAction* const action : this->Actions())
  {
    auto* const button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setToolTip(
      tr("%1 (%2)").arg(action->text().remove('&'), action->shortcut().toString()));
    row->addWidget(button);
  }
}

void TimeBar::AddSlider(QHBoxLayout* row)
{
  this->slider->setObjectName("time");
  this->slider->setAccessibleName(tr("Time"));
  connect(this->slider, &QSlider::sliderPressed, this, [this] { this->gesture = NewGesture(); });
  connect(this->slider, &QSlider::valueChanged, this,
    [this](int time)
    {
      this->play->setChecked(false);
      this->gesture = this->slider->isSliderDown() ? this->gesture : NewGesture();
      this->Choose(time, tr("time"), this->gesture);
    });
  row->addWidget(this->slider, 1);
  this->text->setObjectName("timeText");
  row->addWidget(this->text);
}

const LoadedTimes& TimeBar::Times() const
{
  return this->model->CurrentStudy()->volume.times;
}

void TimeBar::Update(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->TakeVolume();
  }
  if (part == ScenePart::Volume || part == ScenePart::Time || part == ScenePart::Voxels ||
    part == ScenePart::Overlays)
  {
    this->ShowTime();
  }
}

void TimeBar::TakeVolume()
{
  const LoadedTimes& times = this->Times();
  this->play->setChecked(false);
  for (QAction* const action : this->Actions())
  {
    action->setEnabled(times.AreSeveral());
  }
  this->setVisible(times.AreSeveral());
  emit this->CurveWanted(times.AreSeveral() && this->curve->isChecked());
  const QSignalBlocker quiet(this->slider);
  this->slider->setRange(0, int(times.values.size()) - 1);
  this->ListSpeeds(times);
}

void TimeBar::ListSpeeds(const LoadedTimes& times)
{
  this->speed->clear();
  if (times.areSeconds)
  {
    this->speed->addItem(tr("As acquired"), 0.0);
  }
  for (const double perSecond : { 1.0, 2.0, 5.0, 10.0, 15.0, 24.0 })
  {
    this->speed->addItem(tr("%1 a second").arg(perSecond), perSecond);
  }
  this->speed->setCurrentIndex(times.areSeconds ? 0 : this->speed->findData(UsualTimesPerSecond));
}

TimeSpeed TimeBar::Speed() const
{
  return { this->speed->currentData().toDouble() };
}

void TimeBar::ShowTime()
{
  const int time = this->model->ChosenTime();
  const QSignalBlocker quiet(this->slider);
  this->slider->setValue(time);
  const QString shown = TimeText(this->Times(), time);
  this->text->setText(this->series->IsShown() ? shown : tr("%1, loading…").arg(shown));
}

void TimeBar::Step(int times)
{
  this->play->setChecked(false);
  const int count = int(this->Times().values.size());
  this->Choose(
    (this->model->ChosenTime() + times + count) % count, tr("time"), SceneModel::NoGesture);
}

void TimeBar::Choose(int time, const QString& name, int ofGesture)
{
  if (time != this->model->ChosenTime())
  {
    this->model->ChooseTime(time, name, ofGesture);
  }
}

// All times that are played are one undo step.
void TimeBar::Play(bool plays)
{
  this->play->setIcon(
    this->style()->standardIcon(plays ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  if (!plays)
  {
    this->timer.stop();
    return;
  }
  this->gesture = NewGesture();
  const bool isAtEnd = this->model->ChosenTime() == this->slider->maximum();
  if (isAtEnd && !this->loop->isChecked())
  {
    this->Choose(0, tr("play"), this->gesture);
  }
  this->Await();
}

void TimeBar::Await()
{
  constexpr double MostMilliseconds = 1e9; // a timer counts them in an integer
  const double seconds = SecondsOfTime(this->Times(), this->model->ChosenTime(), this->Speed());
  this->timer.start(int(std::lround(std::min(1000.0 * seconds, MostMilliseconds))));
}

void TimeBar::Advance()
{
  constexpr int LoadingMilliseconds = 5;
  if (!this->series->IsShown())
  {
    this->timer.start(LoadingMilliseconds);
    return;
  }
  const int last = this->slider->maximum();
  const int time = this->model->ChosenTime();
  if (time == last && !this->loop->isChecked())
  {
    this->play->setChecked(false);
    return;
  }
  this->Choose(time == last ? 0 : time + 1, tr("play"), this->gesture);
  this->Await();
}

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

namespace
{

constexpr double ThickestMm = 100.0;

}

SlabBar::SlabBar(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , thickness(new QDoubleSpinBox)
  , blend(new QComboBox)
  , straighten(new QToolButton)
{
  // Items in the order of SlabBlend.
  this->blend->addItems({ tr("Maximum"), tr("Minimum"), tr("Mean") });
  this->blend->setAccessibleName(tr("Blend mode of the slab"));
  this->thickness->setRange(0.0, ThickestMm);
  this->thickness->setDecimals(1);
  this->thickness->setSuffix(tr(" mm"));
  this->thickness->setAccessibleName(tr("Thickness of the slices"));
  this->thickness->setKeyboardTracking(false);
  this->setToolTip(
    tr("A slab shows the largest, the smallest or the mean value over its thickness"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(new QLabel(tr("Slab")));
  row->addWidget(this->thickness, 1);
  row->addWidget(this->blend);
  this->straighten->setText(tr("Straighten"));
  this->straighten->setToolTip(tr("Show axial, coronal and sagittal slices again"));
  row->addWidget(this->straighten);
  connect(this->thickness, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double millimetres)
    {
      this->model->Edit(ScenePart::Slices, tr("slab"),
        [millimetres](Scene& scene) { scene.slices.slabMm = millimetres; });
    });
  connect(this->blend, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this](int index)
    {
      this->model->Edit(ScenePart::Slices, tr("slab"),
        [index](Scene& scene) { scene.slices.slabBlend = SlabBlend(index); });
    });
  connect(this->straighten, &QToolButton::clicked, this,
    [this]
    {
      this->model->Edit(ScenePart::Slices, tr("straighten the slices"),
        [](Scene& scene) { scene.slices.turn = {}; });
    });
  connect(model, &SceneModel::Changed, this, &SlabBar::Show);
  this->setEnabled(false);
}

void SlabBar::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::Slices)
  {
    return;
  }
  this->setEnabled(true);
  const SliceSettings& slices = this->model->CurrentScene().slices;
  const QSignalBlocker quiet[] = { QSignalBlocker(this->thickness), QSignalBlocker(this->blend) };
  this->thickness->setValue(slices.slabMm);
  this->blend->setCurrentIndex(int(slices.slabBlend));
  this->straighten->setEnabled(slices.turn != SliceTurn());
}

FusionBar::FusionBar(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , blend(new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear))
  , checkerboard(new QCheckBox(tr("Checkerboard")))
{
  this->blend->setAccessibleName(tr("Blend of the volumes"));
  this->blend->setToolTip(tr("0 shows the first volume, 1 those over it"));
  this->checkerboard->setObjectName("checkerboard");
  this->checkerboard->setToolTip(tr("Shows the volumes in alternate squares of 20 mm"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(new QLabel(tr("Blend")));
  row->addWidget(this->blend, 1);
  row->addWidget(this->checkerboard);
  connect(this->blend, &NumberSlider::Edited, this,
    [this](double number, int gesture)
    {
      this->model->Edit(
        ScenePart::Slices, tr("blend of the volumes"),
        [=](Scene& scene) { scene.slices.fusionOpacity = number; }, gesture);
    });
  connect(this->checkerboard, &QCheckBox::clicked, this,
    [this](bool on)
    {
      this->model->Edit(ScenePart::Slices, tr("checkerboard"),
        [on](Scene& scene)
        { scene.slices.fusion = on ? SliceFusion::Checkerboard : SliceFusion::Blend; });
    });
  connect(model, &SceneModel::Changed, this, &FusionBar::Show);
  this->hide();
}

void FusionBar::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::Slices && part != ScenePart::Overlays)
  {
    return;
  }
  const Scene& scene = this->model->CurrentScene();
  this->setVisible(!scene.overlays.empty());
  this->blend->SetNumber(scene.slices.fusionOpacity);
  this->blend->setEnabled(scene.slices.fusion == SliceFusion::Blend);
  this->checkerboard->setChecked(scene.slices.fusion == SliceFusion::Checkerboard);
}

}
