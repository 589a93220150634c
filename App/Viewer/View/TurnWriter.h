#ifndef Varimarch_Viewer_TurnWriter_h
#define Varimarch_Viewer_TurnWriter_h

#include <QImage>
#include <QString>

#include <string>

namespace varimarch
{

constexpr int MoviePicturesPerSecond = 24;

/// Writes the images of a turntable in order. The destructor deletes what was written unless
/// Complete was called. Every function throws std::runtime_error with one sentence.
class TurnWriter
{
public:
  virtual ~TurnWriter() = default;

  /// @param picture  of the same size as those before
  virtual void Add(const QImage& picture) = 0;

  /// Marks the end of the images.
  virtual void End() {}

  /// Waits a moment for pending work and returns true if some is left.
  virtual bool IsBusy() { return false; }

  /// Makes the file final. Call it after End, when IsBusy returns false.
  virtual void Complete() = 0;
};

/// Throws std::runtime_error with "Cannot write turn.mp4" and the reason, if known.
[[noreturn]] void FailToWrite(const QString& path, const QString& reason = {});

}

#endif
