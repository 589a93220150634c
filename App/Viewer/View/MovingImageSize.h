#ifndef Varimarch_Viewer_MovingImageSize_h
#define Varimarch_Viewer_MovingImageSize_h

#include <QSize>

namespace varimarch
{

/// Chooses the size of images that a thread draws while the view moves, so that a large view keeps
/// its rate. The mapper casts fewer rays by itself, but images must still be filled, read back and
/// copied, which takes time for every pixel. Both sides of an image are divided by a whole number.
/// Pixels between rays that are far apart show nothing more, and take time from rays.
class MovingImageSize
{
public:
  /// @param wanted  pixels of the view
  QSize Of(const QSize& wanted) const;

  /// Records an image of that size.
  /// @param seconds           its time for everything but its rays and the pixels between them [s]
  /// @param rayDistance       between rays [pixels of the image], at least 1
  /// @param allocatedSeconds  for the whole image
  void Took(const QSize& wanted, double seconds, double rayDistance, double allocatedSeconds);

  /// The time that is left for the rays of the next image [s]; never less than a half of all.
  double SecondsForRays(double allocatedSeconds) const;

private:
  int DivisorFor(const QSize& wanted) const;

  int divisor = 1;
  double otherSeconds = 0.0; ///< the time of the last image for everything but its rays
};

}

#endif
