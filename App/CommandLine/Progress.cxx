#include "CommandLine/Progress.h"

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

void Progress::SetPart(double newPart)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->part = newPart;
}

double Progress::ElapsedSeconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->start).count();
}

void Progress::Show()
{
  const std::string rest = RestOfWork(this->part, this->ElapsedSeconds());
  if (this->onTerminal)
  {
    std::ostringstream line;
    line << EraseLine << this->activity << " ... " << std::fixed << std::setprecision(0)
         << this->ElapsedSeconds() << " s" << rest;
    std::cerr << line.str() << std::flush;
  }
  else if (!this->shown || (!this->restIsShown && !rest.empty()))
  {
    std::cerr << this->activity + " ..." + rest + "\n" << std::flush;
    this->restIsShown = !rest.empty();
  }
  this->shown = true;
}

std::string RestOfWork(double part, double elapsedSeconds)
{
  constexpr double LeastElapsed = 3.0;
  constexpr double Minute = 60.0;
  constexpr double MostMinutes = 120.0;
  const double minutes = part > 0.0 ? elapsedSeconds * (1.0 - part) / part / Minute : 0.0;
  if (elapsedSeconds < LeastElapsed || minutes < 1.0)
  {
    return "";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << ", about ";
  minutes < MostMinutes ? text << minutes << " minutes left"
                        : text << minutes / 60.0 << " hours left";
  return text.str();
}

}
