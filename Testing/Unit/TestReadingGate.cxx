// The gate at which rays wait while too many voxels of files are in memory.

#include "Core/Blocks/ReadingGate.h"
#include "Unit/PacketPictures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

namespace varimarch
{
namespace
{

constexpr std::uint64_t LessThanAnyProcessHas = 1;
constexpr std::uint64_t MoreThanAnyProcessHas = std::uint64_t(1) << 60;

bool EndsWithin(const std::future<void>& done, std::chrono::milliseconds time)
{
  return done.wait_for(time) == std::future_status::ready;
}

TEST(ReadingGate, HoldsRaysUntilItIsOpenedAgain)
{
  const PacketPictures pictures;
  const auto march = [&] { pictures.March(InstructionSet::Baseline); };
  ReadingGate& gate = ReadingGate::OfProcess();
  gate.OpenUntil(LessThanAnyProcessHas);
  const std::future<void> marched = std::async(std::launch::async, march);
  EXPECT_FALSE(EndsWithin(marched, std::chrono::milliseconds(300)));
  EXPECT_TRUE(gate.IsInUse());
  gate.OpenUntil(MoreThanAnyProcessHas);
  EXPECT_TRUE(EndsWithin(marched, std::chrono::seconds(60)));
  gate.Open();
  const auto tenthOfASecond = std::chrono::milliseconds(101);
  std::this_thread::sleep_for(tenthOfASecond);
  march();
  EXPECT_FALSE(gate.IsInUse()) << "nobody looks without a bound";
}

}
}
