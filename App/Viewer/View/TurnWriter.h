#ifndef Varimarch_Viewer_TurnWriter_h
#define Varimarch_Viewer_TurnWriter_h

#include <QImage>
#include <QString>

#include <string>

namespace varimarch
{

constexpr int MoviePicturesPerSecond = 24;

/// Writes the pictures of a turn, one after the other. What was written goes with it unless it is
/// completed. Every function throws std::runtime_error, one sentence.
class TurnWriter
{
public:
  virtual ~TurnWriter() = default;

  /// @param picture  as large as those before
  virtual void Add(const QImage& picture) = 0;

  /// No more pictures come.
  virtual void End() {}

  /// Whether what was added, or the end, is still being worked at; waits for it for a moment.
  virtual bool IsBusy() { return false; }

  /// Leaves what was written in place. After the end, and not while it is busy.
  virtual void Complete() = 0;
};

/// "Cannot write turn.mp4", and why when that is known.
/// @throws std::runtime_error it
[[noreturn]] void FailToWrite(const QString& path, const QString& reason = {});

}

#endif
