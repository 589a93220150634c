#ifndef Varimarch_Scene_ImageStatistics_h
#define Varimarch_Scene_ImageStatistics_h

#include "Readers/VolumeFile.h"

#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Distribution of the values of a volume, with what else a look has to know about it.
class ImageStatistics
{
public:
  /// Counts the values of the first component, or the alpha of colours, see ColoredVoxels. Integers
  /// within a range of 65536 are counted one by one, other numbers in 65536 equal bins over their
  /// finite range. Infinite values count as the smallest or largest finite one, NaN as the
  /// smallest. Padding below the image, see LowestInside(), is not counted.
  explicit ImageStatistics(vtkImageData* image);

  /// The factor of relative lengths, see LengthScale.h.
  double LengthFactor() const { return this->lengthFactor; }

  /// The independent components; empty for a single one and for colours.
  const std::vector<VolumeChannel>& Channels() const { return this->channels; }

  /// The statistics of a component.
  const ImageStatistics& OfChannel(std::size_t channel) const
  {
    return channel == 0 ? *this : this->further[channel - 1];
  }

  /// Adds the counts of another volume, such as another time of it. Unless both are of integers
  /// within 65536 of each other, counts move to the nearest of 65536 bins.
  void Add(const ImageStatistics& other);

  /// Range of the finite values.
  double Smallest() const { return this->smallest; }
  double Largest() const { return this->largest; }

  /// The value below which the given percentage of the voxels lies.
  /// @param percent  [0, 100]
  double Percentile(double percent) const;

  /// Bin i holds the values nearest to Smallest() + i * BinSpacing(); the last bin holds Largest().
  const std::vector<std::int64_t>& Counts() const { return this->counts; }
  double BinSpacing() const { return this->binSpacing; }

  /// The counts resampled into the given number of equal bins from Smallest() to Largest().
  std::vector<std::int64_t> Histogram(int bins) const;

private:
  ImageStatistics(vtkImageData* image, int component);
  double ValueOfBin(std::size_t bin) const;

  double smallest;
  double largest;
  double binSpacing;
  std::vector<std::int64_t> counts;
  double lengthFactor = 1.0;
  std::vector<VolumeChannel> channels;
  std::vector<ImageStatistics> further; ///< statistics of the components after the first
};

}

#endif
