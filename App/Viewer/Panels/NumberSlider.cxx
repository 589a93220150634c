#include "Viewer/Panels/NumberSlider.h"

#include "Viewer/Model/SceneModel.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr int Positions = 500;

double RoundedToThreeDigits(double number)
{
  return QString::number(number, 'g', 3).toDouble();
}

// Decimals that show the first digit of a small number.
int DigitsBehindPoint(double number)
{
  return int(std::ceil(-std::log10(number)));
}

}

NumberSlider::NumberSlider(double smallest, double largest, Scale scale, QWidget* parent)
  : QWidget(parent)
  , smallest(smallest)
  , largest(largest)
  , scale(scale)
  , slider(new QSlider(Qt::Horizontal))
  , digits(new QDoubleSpinBox)
{
  this->slider->setRange(0, Positions);
  this->digits->setDecimals(2);
  this->digits->setKeyboardTracking(false);
  this->SetRange(smallest, largest);
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->slider, 1);
  row->addWidget(this->digits);
  this->setFocusProxy(this->slider);

  connect(this->slider, &QSlider::sliderPressed, this, [this] { this->gesture = NewGesture(); });
  connect(this->slider, &QSlider::valueChanged, this,
    [this](int position)
    {
      this->gesture = this->slider->isSliderDown() ? this->gesture : NewGesture();
      emit this->Edited(RoundedToThreeDigits(this->NumberOf(position)), this->gesture);
    });
  connect(this->digits, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double number) { emit this->Edited(number, NewGesture()); });
}

void NumberSlider::SetNumber(double number)
{
  const QSignalBlocker blockers[] = { QSignalBlocker(this->slider), QSignalBlocker(this->digits) };
  this->slider->setValue(this->PositionOf(number));
  this->digits->setValue(number);
}

void NumberSlider::SetRange(double newSmallest, double newLargest)
{
  const QSignalBlocker blockers[] = { QSignalBlocker(this->slider), QSignalBlocker(this->digits) };
  const double number = std::clamp(this->digits->value(), newSmallest, newLargest);
  this->smallest = newSmallest;
  this->largest = newLargest;
  const double width = newLargest - newSmallest;
  this->digits->setDecimals(std::max(
    width < 1.0 ? 4 : 2, this->scale == Scale::Linear ? 0 : DigitsBehindPoint(newSmallest)));
  this->digits->setRange(newSmallest, newLargest);
  this->digits->setSingleStep(
    this->scale == Scale::Linear ? 0.01 * width : std::min(0.01 * width, 0.1));
  this->SetNumber(number);
}

void NumberSlider::SetSuffix(const QString& suffix)
{
  this->digits->setSuffix(suffix);
}

double NumberSlider::NumberOf(int position) const
{
  const double part = double(position) / Positions;
  return this->scale == Scale::Linear
    ? this->smallest + part * (this->largest - this->smallest)
    : this->smallest * std::pow(this->largest / this->smallest, part);
}

int NumberSlider::PositionOf(double number) const
{
  const double part = this->scale == Scale::Linear
    ? (number - this->smallest) / (this->largest - this->smallest)
    : std::log(number / this->smallest) / std::log(this->largest / this->smallest);
  return int(std::lround(part * Positions));
}

}
