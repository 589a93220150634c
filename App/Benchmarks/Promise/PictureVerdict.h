#ifndef Varimarch_Promise_PictureVerdict_h
#define Varimarch_Promise_PictureVerdict_h

#include "JudgeScene.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Whether a picture keeps its error tolerance in 99.9 % of its pixels.
struct PictureVerdict
{
  enum class Answer
  {
    Kept,
    Beyond,
    Unsettled ///< the judge's own error is too large to tell
  };
  Answer answer;
  double factor;  ///< error that 99.9 % of the pixels do not exceed [tolerances], as far as known
  double largest; ///< largest error [tolerances]
  int beyond;     ///< pixels that are surely beyond the tolerance
  int doubtful;   ///< pixels of which the judge does not know it
  int pixels;
  int worstX; ///< the pixel with the largest error
  int worstY;
};

/// Judges a picture. All pixels are judged coarsely; those that look wrong, and some others by
/// chance, are judged finer until two finenesses agree. If the others show that the coarse ones
/// cannot be trusted, all are judged finer.
/// @param drawn   premultiplied RGBA, floats, the bottom row first
/// @param behind  the same picture without volumes
/// @param seed    for the choice of pixels
PictureVerdict VerdictOn(const JudgeScene& scene, const std::vector<float>& drawn,
  const std::vector<float>& behind, std::uint64_t seed);

}

#endif
