#include "Core/Look/PreIntegratedTable.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// A peak of height 1/mm on [40, 60] over a faint ramp, and an opaque material above 90.
OpticalTable PeakTable()
{
  const auto opacity = [](double extinction) { return -std::expm1(-extinction); };
  const TransferFunction function({ { 0.0, { 1.0, 0.0, 0.0 } }, { 100.0, { 0.0, 0.0, 1.0 } } },
    { { 0.0, 0.0 }, { 40.0, 0.0 }, { 50.0, opacity(1.0) }, { 60.0, 0.0 }, { 90.0, 0.0 },
      { 90.0, 1.0 }, { 100.0, 1.0 } },
    1.0);
  return BuildOpticalTable(function, 0.0, 100.0);
}

std::size_t IndexOf(const PreIntegratedTable& table, double value)
{
  const double part = (value - table.firstValue) / (table.lastValue - table.firstValue);
  return std::size_t(std::lround(std::clamp(part, 0.0, 1.0) * (table.size - 1)));
}

glm::vec4 At(const PreIntegratedTable& table, double from, double to)
{
  return table.entries[IndexOf(table, from) * table.size + IndexOf(table, to)];
}

}

TEST(PreIntegratedTable, TheMeanExtinctionIsTheIntegralOverTheValues)
{
  const OpticalTable optical = PeakTable();
  const PreIntegratedTable table = BuildPreIntegratedTable(optical);
  // Midpoint rule over the optical table, between the values of the entries.
  const auto mean = [&](double from, double to)
  {
    const double step = double(optical.entries.size() - 1) / (table.size - 1);
    const double first = double(IndexOf(table, from)) * step;
    const double last = double(IndexOf(table, to)) * step;
    constexpr int Points = 100000;
    double sum = 0.0;
    for (int i = 0; i < Points; ++i)
    {
      const double position = first + (last - first) * (i + 0.5) / Points;
      const auto below = std::size_t(position);
      sum += glm::mix(
        optical.entries[below].a, optical.entries[below + 1].a, float(position - double(below)));
    }
    return sum / Points;
  };
  EXPECT_NEAR(At(table, 30.0, 70.0).a, mean(30.0, 70.0), 1e-6);
  EXPECT_NEAR(At(table, 80.0, 45.0).a, mean(45.0, 80.0), 1e-6);
  EXPECT_GT(At(table, 30.0, 70.0).a, 0.2);
}

TEST(PreIntegratedTable, ItIsSymmetric)
{
  const PreIntegratedTable table = BuildPreIntegratedTable(PeakTable());
  EXPECT_EQ(At(table, 20.0, 80.0), At(table, 80.0, 20.0));
}

TEST(PreIntegratedTable, OneValueHasItsOwnProperties)
{
  const PreIntegratedTable table = BuildPreIntegratedTable(PeakTable());
  EXPECT_NEAR(At(table, 50.0, 50.0).a, 1.0, 0.02);
  EXPECT_EQ(At(table, 20.0, 20.0).a, 0.0f);
}

TEST(PreIntegratedTable, OpaqueEntriesAreOpaqueAndAffectNoOthers)
{
  const PreIntegratedTable table = BuildPreIntegratedTable(PeakTable());
  EXPECT_GT(At(table, 20.0, 95.0).a, 1e20f);
  EXPECT_EQ(At(table, 62.0, 88.0).a, 0.0f);
  EXPECT_NEAR(At(table, 20.0, 95.0).b / At(table, 20.0, 95.0).a, 0.92, 0.03)
    << "expected the colour of the opaque part";
}

TEST(PreIntegratedTable, WhiteIsWhiteBetweenAnyEntriesToo)
{
  const TransferFunction white({ { 0.0, glm::dvec3(1.0) } },
    { { 0.0, 0.0 }, { 40.0, 0.0 }, { 50.0, 1.0 }, { 60.0, 0.0 } }, 1.0);
  for (const glm::vec4& entry :
    BuildPreIntegratedTable(BuildOpticalTable(white, 0.0, 100.0)).entries)
  {
    // A linear relation of the entries also holds for filtered values.
    ASSERT_LE(std::abs(entry.r - entry.a), 1e-6f * entry.a);
  }
}

TEST(PreIntegratedTable, ItsMemoryIsBounded)
{
  const TransferFunction needle({},
    { { 0.0, 0.0 }, { 30000.0, 0.0 }, { 30001.0, 0.5 }, { 30002.0, 0.0 }, { 65535.0, 0.1 } }, 1.0);
  const OpticalTable optical = BuildOpticalTable(needle, 0.0, 65535.0);
  EXPECT_EQ(optical.entries.size(), 65536u);
  EXPECT_EQ(BuildPreIntegratedTable(optical).entries.size(), 1024u * 1024u);
  EXPECT_EQ(BuildPreIntegratedTable(optical, 64 * 64).size, 64);
}
