#include "Viewer/Panels/TimeBar.h"

#include "Viewer/Model/TimeSeries.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <cmath>

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

}
