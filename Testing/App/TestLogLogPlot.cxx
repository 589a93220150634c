#include "Benchmarks/LogLogPlot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace varimarch;

namespace
{

constexpr std::array<unsigned char, 3> Blue = { 0, 114, 178 };
constexpr std::array<unsigned char, 3> Orange = { 213, 94, 0 };

LogLogPlot TwoCurves()
{
  LogLogPlot plot;
  plot.title = "precision of a phantom";
  plot.xTitle = "time [ms]";
  plot.yTitle = "RMSE";
  plot.curves = { { "low and slow", { Blue, Marker::Circle, Stroke::Solid },
                    { { 80.0, 1.0 }, { 160.0, 0.5 } } },
    { "high and quick", { Orange, Marker::Square, Stroke::Solid },
      { { 10.0, 100.0 }, { 20.0, 50.0 } } } };
  return plot;
}

struct Place
{
  double x = 0.0;
  double y = 0.0;
  int pixels = 0;
};

// The mean position of a colour in pixels from the lower left, without the legend at the right.
Place PlaceOf(vtkImageData* picture, const std::array<unsigned char, 3>& color)
{
  const int* size = picture->GetDimensions();
  const auto* rgb = static_cast<const unsigned char*>(picture->GetScalarPointer());
  Place place;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x, rgb += 3)
    {
      if (x < 0.7 * size[0] && std::equal(color.begin(), color.end(), rgb))
      {
        place.x += x;
        place.y += y;
        ++place.pixels;
      }
    }
  }
  place.x /= place.pixels;
  place.y /= place.pixels;
  return place;
}

}

TEST(LogLogPlot, CurvesAreWhereTheirNumbersAre)
{
  const auto picture = DrawPlot(TwoCurves());
  const Place slow = PlaceOf(picture, Blue);
  const Place quick = PlaceOf(picture, Orange);
  ASSERT_GT(slow.pixels, 100);
  ASSERT_GT(quick.pixels, 100);
  EXPECT_GT(slow.x, quick.x + 300.0);
  EXPECT_LT(slow.y, quick.y - 300.0);
}

TEST(LogLogPlot, SvgHoldsCurvesAndWords)
{
  const std::string path = testing::TempDir() + "varimarch-plot.svg";
  WritePlotSvg(TwoCurves(), path);
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(path);
  for (const char* part : { "precision of a phantom", "time [ms]", "low and slow", "high and quick",
         "rgb(0,114,178)", "#d55e00" })
  {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}
