#include "Core/Geometry/SplineCoefficients.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace varimarch
{

namespace
{

// Pole of the recursive filter that inverts (c[i - 1] + 4 c[i] + c[i + 1]) / 6.
const double Pole = std::sqrt(3.0) - 2.0;

// Lines of numbers that are filtered together in double precision. Number i of line l is at [i *
// count + l].
class Lines
{
public:
  Lines(int length, std::size_t count)
    : length(length)
    , count(count)
    , numbers(length * count)
    , first(count)
  {
  }

  double* operator[](int i) { return this->numbers.data() + i * this->count; }

  void Filter()
  {
    this->Begin();
    for (int i = 1; i < this->length; ++i)
    {
      this->AddTo((*this)[i], Pole, (*this)[i - 1]);
    }
    // The last number includes what the backward filter collects in the mirror image.
    this->Scale((*this)[this->length - 1], Pole / (Pole - 1.0));
    for (int i = this->length - 2; i >= 0; --i)
    {
      double* const numbersHere = (*this)[i];
      const double* const after = (*this)[i + 1];
      for (std::size_t line = 0; line < this->count; ++line)
      {
        numbersHere[line] = Pole * (after[line] - numbersHere[line]);
      }
    }
    for (double& number : this->numbers)
    {
      number *= 6.0;
    }
  }

private:
  void AddTo(double* target, double factor, const double* source) const
  {
    for (std::size_t line = 0; line < this->count; ++line)
    {
      target[line] += factor * source[line];
    }
  }

  void Scale(double* target, double factor) const
  {
    for (std::size_t line = 0; line < this->count; ++line)
    {
      target[line] *= factor;
    }
  }

  // Adds to the first number what the forward filter collects before it: the mirror image of the
  // line, then that of its other end, and so on.
  void Begin()
  {
    const double whole = std::pow(Pole, this->length);
    std::fill(this->first.begin(), this->first.end(), 0.0);
    double power = Pole;
    for (int i = 0; i < this->length && power != 0.0; ++i)
    {
      this->AddTo(this->first.data(), power, (*this)[i]);
      this->AddTo(this->first.data(), power * whole, (*this)[this->length - 1 - i]);
      power *= Pole;
    }
    this->Scale(this->first.data(), 1.0 / (1.0 - whole * whole));
    this->AddTo((*this)[0], 1.0, this->first.data());
  }

  int length;
  std::size_t count;
  std::vector<double> numbers;
  std::vector<double> first;
};

// Distances between neighbours on a line and between neighbouring lines.
struct Strides
{
  std::size_t along;
  std::size_t across;
};

template <class Value>
void FilterLines(Value* values, Lines& lines, int length, std::size_t count, Strides strides)
{
  for (int i = 0; i < length; ++i)
  {
    for (std::size_t line = 0; line < count; ++line)
    {
      lines[i][line] = double(values[i * strides.along + line * strides.across]);
    }
  }
  lines.Filter();
  for (int i = 0; i < length; ++i)
  {
    for (std::size_t line = 0; line < count; ++line)
    {
      values[i * strides.along + line * strides.across] = Value(lines[i][line]);
    }
  }
}

}

template <class Value>
void TurnIntoSplineCoefficients(Value* voxels, glm::ivec3 dimensions)
{
  const std::size_t row = dimensions.x;
  const std::size_t slice = row * dimensions.y;
  tbb::parallel_for(0, dimensions.z,
    [&](int z)
    {
      Value* const values = voxels + z * slice;
      Lines alongX(dimensions.x, dimensions.y);
      FilterLines(values, alongX, dimensions.x, dimensions.y, { 1, row });
      Lines alongY(dimensions.y, dimensions.x);
      FilterLines(values, alongY, dimensions.y, dimensions.x, { row, 1 });
    });
  tbb::parallel_for(0, dimensions.y,
    [&](int y)
    {
      Lines alongZ(dimensions.z, dimensions.x);
      FilterLines(voxels + y * row, alongZ, dimensions.z, dimensions.x, { slice, 1 });
    });
}

template void TurnIntoSplineCoefficients(float*, glm::ivec3);
template void TurnIntoSplineCoefficients(double*, glm::ivec3);

}
