// Random scenes of all kinds keep the mapper's promise, judged by an integrator of its own.
//
// VARIMARCH_PROMISE_SCENES is the number of scenes, VARIMARCH_PROMISE_SEED the first seed;
// varimarch-bench promise draws more, and a scene that fails alone.

#include "Module/Scenes/Dice.h"
#include "Promise/PromiseRun.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace varimarch;

// Warnings are part of an honest answer.
TEST(Promise, IsKeptOrDeniedInRandomScenes)
{
  PromiseOptions options;
  options.scenes =
    int(NumberFromEnvironment("VARIMARCH_PROMISE_SCENES", 2 * long(PromiseKinds().size())));
  options.seed = std::uint64_t(NumberFromEnvironment("VARIMARCH_PROMISE_SEED", 1));
  options.side = 12;
  const ExpectedVtkErrors messages;
  std::vector<PromisePicture> pictures;
  RunPromise(options, [&](const PromisePicture& picture) { pictures.push_back(picture); });
  const auto count = [&](const auto& isCounted)
  { return std::count_if(pictures.begin(), pictures.end(), isCounted); };
  const auto allResults = [&]
  {
    std::string text;
    for (const PromisePicture& picture : pictures)
    {
      text += ToJson(picture).dump() + "\n";
    }
    return text;
  };
  for (const PromisePicture& picture : pictures)
  {
    EXPECT_FALSE(picture.IsSilentMiss()) << CommandFor(picture) << " --size 12";
  }
  const auto few = std::ptrdiff_t(pictures.size() / 20);
  EXPECT_LE(count([](const PromisePicture& picture) { return picture.IsFalseAlarm(); }), few)
    << allResults();
  EXPECT_LE(count([](const PromisePicture& picture)
              { return picture.verdict.answer == PictureVerdict::Answer::Unsettled; }),
    few)
    << allResults();
}

TEST(Promise, HasAtLeastFortyKindsHalfOfThemLit)
{
  const auto lit = std::count_if(PromiseKinds().begin(), PromiseKinds().end(),
    [](const PromiseKind& kind) { return kind.isLit; });
  EXPECT_GE(PromiseKinds().size(), 40u);
  EXPECT_GE(2 * lit, std::ptrdiff_t(PromiseKinds().size()));
}
