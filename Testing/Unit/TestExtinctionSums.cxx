#include "Core/Look/OpticalTable.h"

#include <gtest/gtest.h>

using namespace varimarch;

TEST(ExtinctionSums, AreTheIntegralOfExtinctionOverTheEntries)
{
  OpticalTable table{ 0.0, 4.0, {} };
  for (const float extinction : { 0.0f, 2.0f, 6.0f, OpaqueExtinction, 1.0f })
  {
    table.entries.emplace_back(0.0f, 0.0f, 0.0f, extinction);
  }
  const std::vector<double> expected = { 0.0, 1.0, 5.0, 5.0 + 0.5 * (6.0 + 100.0),
    5.0 + 0.5 * (6.0 + 100.0) + 0.5 * (100.0 + 1.0) };
  EXPECT_EQ(ExtinctionSums(table, 100.0), expected);
}
