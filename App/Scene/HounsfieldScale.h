#ifndef Varimarch_Scene_HounsfieldScale_h
#define Varimarch_Scene_HounsfieldScale_h

#include <array>
#include <optional>

namespace varimarch
{

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

}

#endif
