// Random scenes of all kinds keep the mapper's promise, judged by an integrator of its own.
//
// VARIMARCH_PROMISE_SCENES is the number of scenes, VARIMARCH_PROMISE_SEED the first seed;
// varimarch-bench promise draws more, and a scene that fails alone.

#include "Module/Dice.h"
#include "Promise/PromiseReport.h"
#include "Promise/PromiseRun.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>

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
  PromiseCounts counts;
  for (const PromisePicture& picture : pictures)
  {
    counts.Add(picture);
    EXPECT_FALSE(picture.IsSilentMiss()) << CommandFor(picture) << " --size 12";
  }
  EXPECT_LE(counts.falseAlarms, counts.pictures / 20) << PromiseMarkdown(pictures);
  EXPECT_LE(counts.unsettled, counts.pictures / 20) << PromiseMarkdown(pictures);
}

TEST(Promise, HasAtLeastFortyKindsHalfOfThemLit)
{
  const auto lit = std::count_if(PromiseKinds().begin(), PromiseKinds().end(),
    [](const PromiseKind& kind) { return kind.isLit; });
  EXPECT_GE(PromiseKinds().size(), 40u);
  EXPECT_GE(2 * lit, std::ptrdiff_t(PromiseKinds().size()));
}
