#ifndef Varimarch_Core_Look_TransferBands_h
#define Varimarch_Core_Look_TransferBands_h

#include "Core/Look/TransferFunction.h"

#include <vector>

namespace varimarch
{

/// Optical properties of a material.
struct OpticalProperties
{
  glm::dvec3 rgb;
  double extinction; ///< [1/mm], may be infinite
};

/// A transfer function divided into bands of values in which it is smooth: at its nodes, and at
/// midpoints where a curve has a kink or a step. Quadrature converges fast inside a band, and
/// invisible, constant and opaque bands are known before anything is sampled.
class TransferBands
{
public:
  enum class Kind
  {
    Invisible, ///< zero extinction in the whole band
    Constant,  ///< one colour and one extinction > 0
    Opaque,    ///< infinite extinction in the whole band
    Varying,
  };

  /// The values above `lower`, up to and including `upper`.
  struct Band
  {
    double lower;
    double upper;
    Kind kind;

    /// The value, moved off the ends of the band, so that a rounding error cannot move it across a
    /// step.
    double Kept(double value) const;
  };

  /// @param moreCuts  additional values that end a band
  explicit TransferBands(
    const TransferFunction& transferFunction, const std::vector<double>& moreCuts = {});

  const Band& operator[](int band) const { return this->bands[band]; }

  /// The band of a value and of the values just below it.
  int BandBelow(double value) const;

  /// The band of the values just above a value.
  int BandAbove(double value) const;

  /// True if a value in [lowest, highest] may have extinction; exact up to the ends of bands.
  bool MayBeVisible(double lowest, double highest) const;

  /// A band of one value, for a piece of ray that has this value throughout; it may be a node's
  /// value.
  Band OnlyAt(double value) const;

  /// Optical properties at a value inside a band.
  OpticalProperties Inside(const Band& band, double value) const;

private:
  Kind KindOf(double lower, double upper) const;

  TransferFunction transferFunction;
  std::vector<double> cuts; ///< sorted and unique
  std::vector<Band> bands;  ///< one more than cuts
  std::vector<int> visibleBefore;
};

}

#endif
