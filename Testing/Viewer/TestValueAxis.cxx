// The value axis of the editor, and the bars of its histogram.

#include "SmallStudy.h"
#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

ValueAxis HeadAxis()
{
  ValueAxis axis;
  axis.SetData(-1024.0, 3071.0);
  axis.SetPixels(40.0, 440.0);
  axis.Fit(-1024.0, 3071.0);
  return axis;
}

}

TEST(ValueAxis, AZoomKeepsTheValueUnderThePointer)
{
  ValueAxis axis = HeadAxis();
  for (const double pixel : { 40.0, 123.0, 440.0 })
  {
    const double value = axis.ToValue(pixel);
    axis.Zoom(pixel, 1.7);
    EXPECT_NEAR(axis.ToValue(pixel), value, 1e-9);
  }
  EXPECT_LT(axis.Last() - axis.First(), 4095.0 / 4.0);
}

TEST(ValueAxis, PixelsAndValuesAreInverse)
{
  const ValueAxis axis = HeadAxis();
  for (const double value : { -1024.0, 0.0, 317.5, 3071.0 })
  {
    EXPECT_NEAR(axis.ToValue(axis.ToPixel(value)), value, 1e-9);
    EXPECT_GT(axis.ToPixel(value), 40.0);
    EXPECT_LT(axis.ToPixel(value), 440.0);
  }
}

TEST(ValueAxis, APanMovesTheValuesWithThePointer)
{
  ValueAxis axis = HeadAxis();
  const double value = axis.ToValue(200.0);
  axis.Pan(30.0);
  EXPECT_NEAR(axis.ToPixel(value), 230.0, 1e-9);
}

TEST(ValueAxis, NeverLosesTheData)
{
  ValueAxis axis = HeadAxis();
  for (int i = 0; i < 200; ++i)
  {
    axis.Zoom(440.0, 0.5);
    axis.Pan(1000.0);
  }
  EXPECT_LE(axis.Last() - axis.First(), 4.0 * 4095.0 * (1.0 + 1e-9));
  EXPECT_LT(axis.First(), 3071.0);
  EXPECT_GT(axis.Last(), -1024.0);
  for (int i = 0; i < 200; ++i)
  {
    axis.Zoom(200.0, 2.0);
  }
  EXPECT_GT(axis.ValuePerPixel(), 0.0);
  EXPECT_TRUE(std::isfinite(axis.ToPixel(0.0)));
}

TEST(ValueAxis, RoundsToLessThanAPixel)
{
  const ValueAxis axis = HeadAxis();
  EXPECT_LE(std::abs(axis.Rounded(317.234, 1.0) - 317.234), 0.5 * axis.ValuePerPixel());
  EXPECT_EQ(axis.Rounded(317.234, 1.0), 320.0);
  EXPECT_EQ(axis.Rounded(317.234, 0.1), 317.0);
}

TEST(ValueAxis, HasRoundTicksFarEnoughApart)
{
  ValueAxis axis = HeadAxis();
  const std::vector<double> wide = axis.Ticks(60.0);
  EXPECT_EQ(wide, (std::vector<double>{ -1000.0, 0.0, 1000.0, 2000.0, 3000.0 }));
  axis.Fit(0.0, 1.0);
  const std::vector<double> narrow = axis.Ticks(60.0);
  ASSERT_GT(narrow.size(), 1u);
  EXPECT_GE(axis.ToPixel(narrow[1]) - axis.ToPixel(narrow[0]), 60.0);
  EXPECT_NEAR(narrow[1] - narrow[0], 0.2, 1e-12);
}

TEST(ValueAxis, HasARangeForAConstantVolume)
{
  ValueAxis axis;
  axis.SetData(7.0, 7.0);
  axis.SetPixels(0.0, 100.0);
  axis.Fit(7.0, 7.0);
  EXPECT_GT(axis.ValuePerPixel(), 0.0);
  EXPECT_NEAR(axis.ToPixel(7.0), 50.0, 1e-6);
}

TEST(HistogramBars, CountEveryVoxelOnceAtAnyWidth)
{
  const auto study = SmallStudy();
  const ImageStatistics& statistics = study->statistics;
  for (const double width : { 0.1, 1.0, 2.5, 40.0, 1e5 })
  {
    const HistogramBars bars(statistics, width);
    std::int64_t voxels = 0;
    double end = -1e9;
    for (const auto& bar : bars.Between(-1e9, 1e9))
    {
      EXPECT_GE(bar.last - bar.first, width);
      EXPECT_TRUE(end == -1e9 || std::abs(bar.first - end) < 1e-6);
      end = bar.last;
      voxels += bar.count;
    }
    EXPECT_EQ(voxels, study->volume.image->GetNumberOfPoints());
  }
}

TEST(HistogramBars, ABarContainsTheRequestedValue)
{
  const auto study = SmallStudy();
  const HistogramBars bars(study->statistics, 30.0);
  for (double value = study->statistics.Smallest(); value < study->statistics.Largest();
       value += 17.3)
  {
    EXPECT_LE(bars.At(value).first, value);
    EXPECT_GE(bars.At(value).last, value);
  }
  EXPECT_EQ(bars.At(1e6).count, 0);
}
