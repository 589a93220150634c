#ifndef Varimarch_Viewer_MovingImageSize_h
#define Varimarch_Viewer_MovingImageSize_h

#include <QSize>

namespace varimarch
{

/// Chooses the size of images that a thread draws while the view moves, so that a large view keeps
/// its rate. The mapper casts fewer rays by itself, but images must still be filled, read back and
/// copied, which takes time for every pixel. Both sides of an image are divided by a whole number.
class MovingImageSize
{
public:
  /// @param wanted  pixels of the view
  QSize Of(const QSize& wanted) const;

  /// Records the time of an image of that size for everything but its rays [s].
  /// @param allocatedSeconds  for the whole image
  void Took(const QSize& wanted, double seconds, double allocatedSeconds);

  /// The time that is left for the rays of the next image [s]; never less than a half of all.
  double SecondsForRays(double allocatedSeconds) const;

private:
  int DivisorFor(const QSize& wanted) const;

  int divisor = 1;
  double otherSeconds = 0.0; ///< the time of the last image for everything but its rays
};

}

#endif
