#include "Scene/Segments/Segments.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace varimarch;

namespace
{

std::vector<Segment> Read(const std::string& text)
{
  const std::filesystem::path path =
    std::filesystem::path(testing::TempDir()) / "varimarch-table.txt";
  std::ofstream(path) << text;
  const auto segments = ReadSegmentTable(path);
  std::filesystem::remove(path);
  return segments;
}

}

TEST(SegmentTables, OfSlicerHaveNamesAndColours)
{
  const auto segments = Read("# Color table file\n# 2 values\n0 Background 0 0 0 0\n"
                             "2 left_kidney 255 51 0 255\n3 vessel 0 0 255 102\n");
  ASSERT_EQ(segments.size(), 3);
  EXPECT_EQ(segments[1].value, 2);
  EXPECT_EQ(segments[1].name, "left_kidney");
  EXPECT_EQ(segments[1].rgb, glm::dvec3(1.0, 0.2, 0.0));
  EXPECT_EQ(segments[1].opacity, 1.0);
  EXPECT_EQ(segments[2].opacity, 0.4);
}

TEST(SegmentTables, OfFreeSurferAreOpaque)
{
  const auto segments = Read("#No. Label Name:   R   G   B   A\n\n0 Unknown 0 0 0 0\n"
                             "10  Left-Thalamus   0 118 14 0\n");
  ASSERT_EQ(segments.size(), 2);
  EXPECT_EQ(segments[1].value, 10);
  EXPECT_EQ(segments[1].name, "Left-Thalamus");
  EXPECT_EQ(segments[1].opacity, 1.0);
}

TEST(SegmentTables, OfItkSnapHaveNamesInQuotes)
{
  const auto segments = Read("# ITK-SnAP Label Description File\n"
                             "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                             "    4   255  128    0      0.5  1  1    \"left kidney\"\n"
                             "    5     0  128    0        1  0  1    \"spleen\"\n");
  ASSERT_EQ(segments.size(), 3);
  EXPECT_EQ(segments[1].value, 4);
  EXPECT_EQ(segments[1].name, "left kidney");
  EXPECT_EQ(segments[1].opacity, 0.5);
  EXPECT_TRUE(segments[1].visible);
  EXPECT_FALSE(segments[2].visible);
  EXPECT_EQ(segments[2].opacity, 1.0);
}

TEST(SegmentTables, ChangeOnlyTheSegmentsThatTheyHave)
{
  std::vector<Segment> segments = { { 1, "one", glm::dvec3(0.5) }, { 2, "two", glm::dvec3(0.5) } };
  TakeTable({ { 2, "liver", glm::dvec3(1.0), false, 0.25 }, { 3, "spleen", {} } }, segments);
  ASSERT_EQ(segments.size(), 2);
  EXPECT_EQ(segments[0].name, "one");
  EXPECT_EQ(segments[1].name, "liver");
  EXPECT_EQ(segments[1].opacity, 0.25);
  EXPECT_FALSE(segments[1].visible);
}

TEST(SegmentTables, WithOtherLinesAreRefused)
{
  try
  {
    Read("1 2 3\n");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("expected lines of index, name, red, green, blue and opacity"),
      std::string::npos)
      << message;
    EXPECT_NE(message.find("\"1 2 3\""), std::string::npos) << message;
  }
  EXPECT_THROW(ReadSegmentTable("/no/such/table.ctbl"), std::runtime_error);
  EXPECT_THROW(Read("1e30 liver 0 0 0 255\n"), std::runtime_error);
}
