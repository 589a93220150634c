#include "Frame/Fingerprint.h"

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

enum class Kind
{
  Plain,
  Striped,
};

struct Window
{
  double width = 1.0;
  Kind kind = Kind::Plain;
  std::vector<int> labels;
  const Window* inner = nullptr;
};

auto FieldsOf(const Window& window)
{
  const auto& [width, kind, labels, inner] = window;
  return std::tie(width, kind, labels, inner);
}

}

TEST(Fingerprint, IsAnotherForAnotherMemberOfAStruct)
{
  const Window window;
  EXPECT_EQ(Fingerprint(window), Fingerprint(Window()));
  Window other;
  other.width = 1.0 + std::numeric_limits<double>::epsilon();
  EXPECT_NE(Fingerprint(window), Fingerprint(other));
  other = {};
  other.kind = Kind::Striped;
  EXPECT_NE(Fingerprint(window), Fingerprint(other));
  other = {};
  other.labels = { 3 };
  EXPECT_NE(Fingerprint(window), Fingerprint(other));
  other = {};
  other.inner = &window;
  EXPECT_NE(Fingerprint(window), Fingerprint(other));
}

TEST(Fingerprint, KeepsListsApart)
{
  const std::vector<int> none;
  const std::vector<int> one = { 1 };
  const std::vector<int> two = { 1, 1 };
  EXPECT_NE(Fingerprint(one, two), Fingerprint(two, one));
  EXPECT_NE(Fingerprint(none, one), Fingerprint(one, none));
  EXPECT_NE(Fingerprint(std::string("ab"), std::string("c")),
    Fingerprint(std::string("a"), std::string("bc")));
  EXPECT_NE(Fingerprint(std::optional<int>(), 0), Fingerprint(std::optional<int>(0)));
  EXPECT_NE(Fingerprint(Fingerprint(1, 1), Fingerprint()), Fingerprint(Fingerprint(1), 1));
}

// A search that never ends would be the result of a number that differs from itself.
TEST(Fingerprint, OfANumberThatIsNoneStays)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Fingerprint(none, glm::dvec3(none)), Fingerprint(none, glm::dvec3(none)));
  EXPECT_NE(Fingerprint(none), Fingerprint(0.0));
}

// A double has 53 bits.
TEST(Fingerprint, TellsLargeTimesApart)
{
  const unsigned long time = (1UL << 60) + 1;
  EXPECT_NE(Fingerprint(time), Fingerprint(time + 1));
}
