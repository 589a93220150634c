#ifndef Varimarch_Core_Quality_InteractiveQuality_h
#define Varimarch_Core_Quality_InteractiveQuality_h

namespace varimarch
{

/// Resolution and accuracy of a frame.
struct PictureQuality
{
  double imageSampleDistance = 1.0; ///< [pixels]
  double toleranceFactor = 1.0;     ///< factor of the error tolerance for its steps
};

/// Chooses the quality of frames during interaction from the time that the last frames took. It
/// becomes coarser at once if frames are late, but finer only after several frames had time to
/// spare, so that the quality does not flicker. Before the first time is known, it limits the
/// number of rays to what any machine casts in a moment.
class InteractiveQuality
{
public:
  /// The quality of the next frame during interaction.
  /// @param pixels  number of pixels of the frame
  PictureQuality Next(double allocatedSeconds, double pixels);

  /// The quality that Next would return if it had not to change it.
  PictureQuality Now(double pixels) const;

  /// Records the time of a frame drawn with the quality from Next. Must not be called for single
  /// frames that had to build resources, whose time says nothing about the next.
  void Took(double seconds);

  /// Index of the current level; 0 is the finest.
  int Level() const { return this->level; }
  static int CoarsestLevel();

private:
  /// The finest level, not finer than `finest`, that is expected to be in time.
  int LevelInTime(int finest, double allocatedSeconds) const;
  double ExpectedSeconds(int other) const;

  int level = 0;
  bool levelIsGuessed = true; ///< true if the level follows only from the number of pixels
  double seconds = 0.0;       ///< time of the last frame at this level; 0 if unknown
  int picturesWithTimeToSpare = 0;
};

}

#endif
