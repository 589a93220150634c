#ifndef Varimarch_Core_Quality_PictureStrips_h
#define Varimarch_Core_Quality_PictureStrips_h

namespace varimarch
{

/// Divides pictures into strips of whole rows, from below, each of which takes about as long as is
/// asked for, by how long the last ones took.
class PictureStrips
{
public:
  struct Rows
  {
    int begin;
    int count;
  };

  /// Of a picture of so many rows, or of the rest of it.
  /// @param longestSeconds  0: as long as it takes
  Rows Next(int pictureRows, double longestSeconds) const;

  /// How long the strip took that Next gave.
  /// @param longestSeconds  > 0: it was to take
  void Took(const Rows& strip, double seconds, double longestSeconds);

  /// Whether a picture is expected to take longer than a strip may.
  bool IsDivided(int pictureRows) const;

  /// How many rows of the picture are done, from below.
  int Done() const { return this->done; }

  /// The next picture, or the same from the beginning.
  void Restart() { this->done = 0; }

private:
  int done = 0;
  int rows = 0; ///< of the next strip; 0: nothing is known
};

}

#endif
