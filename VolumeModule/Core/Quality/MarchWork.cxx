#include "Core/Quality/MarchWork.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace varimarch
{

namespace
{

double SecondsOfProcess()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

}

MarchWork::MarchWork(double mostSeconds, Question isWanted)
  : mostSeconds(mostSeconds)
  , isWanted(std::move(isWanted))
  , owner(std::this_thread::get_id())
  , startSeconds(SecondsOfProcess())
{
}

void MarchWork::Begin(int newPackets)
{
  this->packets = std::max(newPackets, 1);
  this->packetsDone = 0;
}

void MarchWork::EndPacket()
{
  constexpr std::chrono::milliseconds BetweenQuestions(50);
  this->packetsDone.fetch_add(1, std::memory_order_relaxed);
  if (std::this_thread::get_id() != this->owner)
  {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - this->askedAt >= BetweenQuestions && !this->IsStopped())
  {
    this->askedAt = now;
    this->isUsedUp = this->Seconds() > this->mostSeconds;
    this->isUnwanted = !this->isWanted(double(this->packetsDone) / double(this->packets));
  }
}

double MarchWork::Seconds() const
{
  return SecondsOfProcess() - this->startSeconds;
}

}
