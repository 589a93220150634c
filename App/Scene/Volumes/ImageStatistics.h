#ifndef Varimarch_Scene_ImageStatistics_h
#define Varimarch_Scene_ImageStatistics_h

#include "Readers/VolumeFile.h"

#include <array>
#include <cstdint>
#include <optional>
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

  /// The factor of relative lengths, see LengthFactor.
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

class ImageStatistics;

/// Air is lighter than this, also where noise is added to it. Hardly any other volume has such
/// values.
constexpr double HighestAirHu = -900.0;

/// The values that stand for Hounsfield units in a CT whose values are others, such as those of an
/// image of 8 bits. It is an estimate from the histogram, for looks; measurements do not use it.
class HounsfieldScale
{
public:
  /// A value of the volume, and the Hounsfield units that it stands for.
  struct Mark
  {
    double hounsfield;
    double value;
  };

  /// @param ascending  the marks of air, soft tissue and dense bone
  explicit HounsfieldScale(const std::array<Mark, 3>& ascending)
    : marks(ascending)
  {
  }

  /// Straight between the marks, and beyond them.
  double ValueAt(double hounsfield) const;

  /// Mean difference of values for one Hounsfield unit, > 0.
  double Factor() const;

private:
  std::array<Mark, 3> marks;
};

/// True if the values can be Hounsfield units, in which everything that is lighter than water is
/// negative.
bool MayBeHounsfieldUnits(const ImageStatistics& statistics);

/// Finds air, soft tissue and bone in the histogram of a volume without negative values. Otsu's
/// threshold (IEEE Trans. Syst. Man Cybern. 9, 1979, 62-66) parts air from the body, 60 % of whose
/// voxels are at most as dense as muscle, and all but 0.5 % at most as dense as compact bone.
/// @returns nothing if the histogram has no such parts: the looks of CT do not suit the volume
std::optional<HounsfieldScale> EstimatedHounsfieldScale(const ImageStatistics& statistics);

/// Lengths of a look that are relative are right for a patient, and hold for a body of this size.
constexpr double BodySideMm = 200.0;

/// True if an image shows a patient, or a part of one, in its size: its reader says so, or its
/// values are Hounsfield units, and its longest side is from 20 mm to 3 m.
/// @param smallestValue  of the image
bool HasSizeOfPatient(vtkImageData* image, double smallestValue);

/// The factor from lengths for a patient to those for an image: 1 if it has the size of one, else
/// the side of a cube as large as the image, divided by BodySideMm. So a look draws about the same
/// picture of a cell, a mouse and a building.
double LengthFactor(vtkImageData* image, double smallestValue);

}

#endif
