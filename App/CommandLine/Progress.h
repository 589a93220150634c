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

private:
  void Watch();
  void Show();

  const std::chrono::steady_clock::time_point start;
  const bool onTerminal;
  std::mutex mutex; ///< guards the members below, except the thread
  std::condition_variable finishedChanged;
  std::string activity;
  bool finished = false;
  bool shown = false;
  std::thread watcher;
};

}

#endif
