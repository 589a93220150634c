// The targets of the fuzzer on their seeds, and on every input that ever failed.
#include "Fuzz/FuzzTarget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace varimarch;

namespace
{

std::string BytesOf(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

std::vector<std::filesystem::path> RegressionsOf(const std::string& target)
{
  const std::filesystem::path folder = std::filesystem::path(REGRESSION_FOLDER) / target;
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
  {
    std::copy(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator(),
      std::back_inserter(files));
  }
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzTargetOf : public testing::TestWithParam<FuzzTarget>
{
};

TEST_P(FuzzTargetOf, AcceptsItsSeeds)
{
  const std::vector<std::string> seeds = GetParam().seeds();
  ASSERT_FALSE(seeds.empty());
  for (const std::string& seed : seeds)
  {
    EXPECT_NO_THROW(EXPECT_TRUE(GetParam().run(seed)) << seed.substr(0, 200));
  }
}

TEST_P(FuzzTargetOf, KeepsItsPromisesForWhatOnceFailed)
{
  for (const std::filesystem::path& file : RegressionsOf(GetParam().name))
  {
    SCOPED_TRACE(file.filename());
    EXPECT_NO_THROW(GetParam().run(BytesOf(file)));
  }
}

TEST_P(FuzzTargetOf, KeepsItsPromisesForSeedsCutShort)
{
  for (const std::string& seed : GetParam().seeds())
  {
    for (const std::size_t parts : { 1, 2, 3 })
    {
      EXPECT_NO_THROW(GetParam().run(seed.substr(0, seed.size() * parts / 4)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(On, FuzzTargetOf, testing::ValuesIn(FuzzTargets()),
  [](const testing::TestParamInfo<FuzzTarget>& info)
  {
    std::string name = info.param.name;
    std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return !std::isalnum(letter); }, '_');
    return name;
  });

TEST(FuzzRegressions, AreOfKnownTargets)
{
  for (const auto& folder : std::filesystem::directory_iterator(REGRESSION_FOLDER))
  {
    EXPECT_NO_THROW(FuzzTargetNamed(folder.path().filename())) << folder.path();
  }
}

}
