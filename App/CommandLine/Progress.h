#ifndef Varimarch_CommandLine_Progress_h
#define Varimarch_CommandLine_Progress_h

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace varimarch
{

/// A progress line on stderr with the elapsed seconds, for the lifetime of this object. It appears
/// after a second. On a terminal it is erased at the end; elsewhere, as in a log, it is a single
/// line without control codes.
class Progress
{
public:
  explicit Progress(std::string activity);
  ~Progress();
  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /// Changes the text of the line.
  void SetActivity(const std::string& activity);

  /// Shows how long the rest may take, if that is a minute or more.
  /// @param part  the finished part, [0, 1]
  void SetPart(double part);

private:
  void Watch();
  void Show();
  double ElapsedSeconds() const;

  const std::chrono::steady_clock::time_point start;
  const bool onTerminal;
  std::mutex mutex; ///< guards the members below, except the thread
  std::condition_variable finishedChanged;
  std::string activity;
  bool finished = false;
  bool shown = false;
  double part = 0.0; ///< the finished part, [0, 1]; 0 if it is not known
  bool restIsShown = false;
  std::thread watcher;
};

/// The time that the rest of some work takes if it goes on as it did: ", about 7 minutes left", or
/// hours. Empty in the first seconds, and if it is less than a minute.
/// @param part  the finished part, [0, 1]; 0 if it is not known
std::string RestOfWork(double part, double elapsedSeconds);

}

#endif
