#ifndef Varimarch_Core_Quality_PictureStrips_h
#define Varimarch_Core_Quality_PictureStrips_h

namespace varimarch
{

/// Divides images into strips of whole rows, from bottom to top. Each strip should take the
/// requested time; its height follows from the times of earlier strips.
class PictureStrips
{
public:
  struct Rows
  {
    int begin;
    int count;
  };

  /// The next strip of an image, or the rest of it.
  /// @param pictureRows  number of rows of the image
  /// @param longestSeconds  time limit of the strip; 0 means no limit
  Rows Next(int pictureRows, double longestSeconds) const;

  /// Records the time of a strip from Next.
  /// @param longestSeconds  time limit that it had, > 0
  void Took(const Rows& strip, double seconds, double longestSeconds);

  /// True if an image is expected to take longer than one strip may.
  bool IsDivided(int pictureRows) const;

  /// Number of finished rows, from the bottom.
  int Done() const { return this->done; }

  /// Begins the next image, or the same one again.
  void Restart() { this->done = 0; }

private:
  int done = 0;
  int rows = 0; ///< rows of the next strip; 0 if no time is known
};

}

#endif
