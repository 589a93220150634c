#include "Progress.h"

#include <unistd.h>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace varimarch
{

namespace
{

// Returns to the start of the line and erases it.
const char* const EraseLine = "\r\x1b[K";

}

Progress::Progress(std::string activity)
  : start(std::chrono::steady_clock::now())
  , onTerminal(isatty(STDERR_FILENO))
  , activity(std::move(activity))
  , watcher([this] { this->Watch(); })
{
}

Progress::~Progress()
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->finished = true;
  }
  this->finishedChanged.notify_one();
  this->watcher.join();
  if (this->shown && this->onTerminal)
  {
    std::cerr << EraseLine << std::flush;
  }
}

void Progress::SetActivity(const std::string& newActivity)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->activity = newActivity;
}

void Progress::Watch()
{
  std::unique_lock<std::mutex> lock(this->mutex);
  auto wait = std::chrono::milliseconds(1000);
  while (!this->finishedChanged.wait_for(lock, wait, [this] { return this->finished; }))
  {
    this->Show();
    wait = std::chrono::milliseconds(500);
  }
}

void Progress::Show()
{
  if (this->onTerminal)
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - this->start;
    std::ostringstream line;
    line << EraseLine << this->activity << " ... " << std::fixed << std::setprecision(0)
         << elapsed.count() << " s";
    std::cerr << line.str() << std::flush;
  }
  else if (!this->shown)
  {
    std::cerr << this->activity + " ...\n" << std::flush;
  }
  this->shown = true;
}

}
