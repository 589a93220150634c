#ifndef Varimarch_Benchmarks_PublishedPromise_h
#define Varimarch_Benchmarks_PublishedPromise_h

#include <vtkImageData.h>

namespace varimarch
{

/// Properties of the field of variations of a volume of bytes, and how often it is wrong about
/// interpolated values: a jump of d = S(p) from a position next to p should meet no value that
/// differs by E or more from that at its beginning.
struct PublishedPromise
{
  double buildSeconds;  ///< time to build the field of Euclidean distances
  double meanEuclidean; ///< mean distance [voxels]
  double meanChebyshev; ///< the same, if the surroundings are cubes
  double longJumps;     ///< part of the jumps that go 2 voxels or more, [0, 1]
  double brokenJumps;   ///< part of these that meet such a value, [0, 1]
  double largest;       ///< largest difference that they meet [units of the data]
};

/// Tries jumps from random positions in random directions.
/// @param tolerance  E in units of the data
PublishedPromise TryJumps(vtkImageData* bytes, double tolerance);

}

#endif
