#include "Scene/RegionStatistics.h"

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

ValueSums::ValueSums(double offset)
  : offset(std::isfinite(offset) ? offset : 0.0)
{
}

void ValueSums::Add(double value)
{
  if (std::isfinite(value))
  {
    const double difference = value - this->offset;
    ++this->count;
    this->sum += difference;
    this->sumOfSquares += difference * difference;
    this->smallest = std::min(this->smallest, value);
    this->largest = std::max(this->largest, value);
  }
}

void ValueSums::Join(const ValueSums& other)
{
  this->count += other.count;
  this->sum += other.sum;
  this->sumOfSquares += other.sumOfSquares;
  this->smallest = std::min(this->smallest, other.smallest);
  this->largest = std::max(this->largest, other.largest);
}

RegionStatistics ValueSums::Statistics(vtkImageData* image) const
{
  if (this->count == 0)
  {
    return {};
  }
  const double mean = this->sum / double(this->count);
  const double variance = this->sumOfSquares / double(this->count) - mean * mean;
  const double voxelMm3 = std::abs(image->GetIndexToPhysicalMatrix()->Determinant());
  return { this->count, double(this->count) * voxelMm3, this->offset + mean,
    std::sqrt(std::max(variance, 0.0)), this->smallest, this->largest };
}

}
