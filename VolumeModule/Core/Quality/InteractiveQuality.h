#ifndef Varimarch_Core_Quality_InteractiveQuality_h
#define Varimarch_Core_Quality_InteractiveQuality_h

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
/// for several pictures, so that the quality does not flicker. While no time is known, no more rays
/// are cast than any machine casts in a moment.
class InteractiveQuality
{
public:
  /// Of the next picture, of so many pixels, while somebody interacts.
  PictureQuality Next(double allocatedSeconds, double pixels);

  /// How long the picture took that was drawn with the quality of Next. Not to be told of pictures
  /// for which anything had to be built.
  void Took(double seconds);

  /// The range of levels, 0 the finest.
  int Level() const { return this->level; }
  static int CoarsestLevel();

private:
  /// The finest of the levels from this one on that is expected to be in time.
  int LevelInTime(int finest, double allocatedSeconds) const;
  double ExpectedSeconds(int other) const;

  int level = 0;
  bool levelIsGuessed = true; ///< from the number of pixels
  double seconds = 0.0;       ///< that the last picture took at this level; 0: not known
  int picturesWithTimeToSpare = 0;
};

}

#endif
