#ifndef Varimarch_Core_Look_TransferBands_h
#define Varimarch_Core_Look_TransferBands_h

#include "Core/Look/TransferFunction.h"

#include <vector>

namespace varimarch
{

/// What a material does to light.
struct OpticalProperties
{
  glm::dvec3 rgb;
  double extinction; ///< [1/mm], may be infinite
};

/// A transfer function cut into bands of values in which it is smooth: at its nodes, and at the
/// midpoints where a curve has a kink or a step. Inside a band a quadrature rule converges fast,
/// and what is invisible, constant or opaque is known before anything is sampled.
class TransferBands
{
public:
  enum class Kind
  {
    Invisible, ///< no extinction anywhere in the band
    Constant,  ///< one colour and one extinction > 0
    Opaque,    ///< infinite extinction everywhere
    Varying,
  };

  /// The values above `lower`, up to and including `upper`.
  struct Band
  {
    double lower;
    double upper;
    Kind kind;

    /// A value of the band, kept off its ends: round-off that takes it out of the band does not
    /// take it across a step.
    double Kept(double value) const;
  };

  /// @param moreCuts  values that shall end a band too
  explicit TransferBands(
    const TransferFunction& transferFunction, const std::vector<double>& moreCuts = {});

  const Band& operator[](int band) const { return this->bands[band]; }

  /// The band that holds a value and those just below it.
  int BandBelow(double value) const;

  /// The band that holds the values just above.
  int BandAbove(double value) const;

  /// Whether a value in [lowest, highest] may have any extinction; exact up to the ends of bands.
  bool MayBeVisible(double lowest, double highest) const;

  /// A band of one value, which a whole piece of ray has, and which may be that of a node.
  Band OnlyAt(double value) const;

  /// The properties at a value inside a band.
  OpticalProperties Inside(const Band& band, double value) const;

private:
  Kind KindOf(double lower, double upper) const;

  TransferFunction transferFunction;
  std::vector<double> cuts; ///< sorted, each once
  std::vector<Band> bands;  ///< one more than cuts
  std::vector<int> visibleBefore;
};

}

#endif
