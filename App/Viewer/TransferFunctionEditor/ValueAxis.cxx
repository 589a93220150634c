#include "Viewer/TransferFunctionEditor/ValueAxis.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double LeastPartOfData = 1e-4;
constexpr double LargestPartOfData = 4.0;
constexpr double RoomAtTheSides = 0.05;

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `width`.
double RoundAtLeast(double width)
{
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= width)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

}

void ValueAxis::SetData(double newSmallest, double newLargest)
{
  this->smallest = newSmallest;
  // A constant volume gets a range of width 1.
  this->largest = newLargest > newSmallest ? newLargest : newSmallest + 1.0;
}

void ValueAxis::SetPixels(double newLeft, double newRight)
{
  this->left = newLeft;
  this->right = std::max(newRight, newLeft + 1.0);
}

void ValueAxis::Fit(double newFirst, double newLast)
{
  const double room = RoomAtTheSides * (newLast - newFirst);
  this->Show(newFirst - room, newLast + room);
}

void ValueAxis::Zoom(double pixel, double factor)
{
  const double data = this->largest - this->smallest;
  const double width = std::clamp(
    (this->last - this->first) / factor, LeastPartOfData * data, LargestPartOfData * data);
  const double scale = width / (this->last - this->first);
  const double fixed = this->ToValue(pixel);
  this->Show(fixed + scale * (this->first - fixed), fixed + scale * (this->last - fixed));
}

void ValueAxis::Pan(double pixels)
{
  const double shift = -pixels * this->ValuePerPixel();
  this->Show(this->first + shift, this->last + shift);
}

void ValueAxis::Show(double newFirst, double newLast)
{
  const double data = this->largest - this->smallest;
  const double width =
    std::clamp(newLast - newFirst, LeastPartOfData * data, LargestPartOfData * data);
  const double middle =
    std::clamp(0.5 * (newFirst + newLast), this->smallest - data, this->largest + data);
  this->first = middle - 0.5 * width;
  this->last = middle + 0.5 * width;
}

double ValueAxis::ToPixel(double value) const
{
  return this->left + (value - this->first) / this->ValuePerPixel();
}

double ValueAxis::ToValue(double pixel) const
{
  return this->first + (pixel - this->left) * this->ValuePerPixel();
}

double ValueAxis::ValuePerPixel() const
{
  return (this->last - this->first) / (this->right - this->left);
}

double ValueAxis::Rounded(double value, double pixels) const
{
  // For decimals, divide by a whole number, so that the result equals the literal 0.3.
  const double exponent = std::floor(std::log10(pixels * this->ValuePerPixel()));
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0.0 ? std::round(value * power) / power : std::round(value / power) * power;
}

int ValueAxis::Decimals() const
{
  return std::max(0, int(-std::floor(std::log10(this->ValuePerPixel()))));
}

std::vector<double> ValueAxis::Ticks(double pixelsApart) const
{
  const double step = RoundAtLeast(pixelsApart * this->ValuePerPixel());
  std::vector<double> ticks;
  for (double i = std::ceil(this->first / step); i * step <= this->last; i += 1.0)
  {
    ticks.push_back(i * step);
  }
  return ticks;
}

}
