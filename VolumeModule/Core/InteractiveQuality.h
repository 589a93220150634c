#ifndef Varimarch_Core_InteractiveQuality_h
#define Varimarch_Core_InteractiveQuality_h

namespace varimarch
{

/// How coarsely a picture is drawn.
struct PictureQuality
{
  double imageSampleDistance = 1.0; ///< [pixels]
  double toleranceFactor = 1.0;     ///< of the error that its steps may make
};

/// Chooses how coarsely pictures are drawn while somebody interacts, from how long the last ones
/// took: coarser at once when they are late, finer only when the finer ones have had time to spare
/// for several pictures, so that the quality does not flicker.
class InteractiveQuality
{
public:
  /// Of the next picture while somebody interacts.
  PictureQuality Next(double allocatedSeconds);

  /// How long the picture took that was drawn with the quality of Next. Not to be told of pictures
  /// for which anything had to be built.
  void Took(double seconds);

  /// The range of levels, 0 the finest.
  int Level() const { return this->level; }
  static int CoarsestLevel();

private:
  int level = 0;
  double seconds = 0.0; ///< that the last picture took at this level; 0: not known
  int picturesWithTimeToSpare = 0;
};

}

#endif
