// Statistics of a scan in segments, against values computed by hand.

#include "Scene/Measures/RegionStatistics.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace varimarch;

namespace
{

template <class Number>
vtkSmartPointer<vtkImageData> Image(int type, const std::vector<Number>& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(int(values.size()), 1, 1);
  image->SetSpacing(2.0, 5.0, 10.0); // 0.1 ml per voxel
  image->AllocateScalars(type, 1);
  std::copy(values.begin(), values.end(), static_cast<Number*>(image->GetScalarPointer()));
  return image;
}

const std::vector<unsigned char> Numbers = { 0, 2, 1, 2, 2, 1, 0 };

TEST(SegmentStatistics, AreThoseOfTheVoxelsOfEachSegment)
{
  const auto statistics = StatisticsOfSegments(Image<unsigned char>(VTK_UNSIGNED_CHAR, Numbers), 3,
    Image<short>(VTK_SHORT, { -1000, 10, 40, 20, 60, 50, 3000 }));
  ASSERT_EQ(statistics.size(), 3u);
  EXPECT_EQ(statistics[0].voxels, 2);
  EXPECT_NEAR(statistics[0].volumeMm3, 200.0, 1e-9);
  EXPECT_NEAR(statistics[0].mean, 45.0, 1e-9);
  EXPECT_NEAR(statistics[0].standardDeviation, 5.0, 1e-9);
  EXPECT_EQ(statistics[1].voxels, 3);
  EXPECT_NEAR(statistics[1].mean, 30.0, 1e-9);
  EXPECT_NEAR(statistics[1].standardDeviation, std::sqrt(1400.0 / 3.0), 1e-9);
  EXPECT_EQ(statistics[1].smallest, 10.0);
  EXPECT_EQ(statistics[1].largest, 60.0);
  EXPECT_EQ(statistics[2].voxels, 0);
  EXPECT_EQ(statistics[2].mean, 0.0);
}

TEST(SegmentStatistics, KeepSmallDifferencesOfLargeValuesAndLeaveOutNaN)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto statistics = StatisticsOfSegments(Image<unsigned char>(VTK_UNSIGNED_CHAR, Numbers), 2,
    Image<double>(VTK_DOUBLE, { 1e9, 1e9, 1e9 + 1.0, nan, 1e9 + 2.0, 1e9 + 3.0, 1e9 }));
  EXPECT_NEAR(statistics[0].mean, 1e9 + 2.0, 1e-6);
  EXPECT_NEAR(statistics[0].standardDeviation, 1.0, 1e-6);
  EXPECT_EQ(statistics[1].voxels, 2);
  EXPECT_NEAR(statistics[1].mean, 1e9 + 1.0, 1e-6);
}

TEST(SegmentStatistics, MeasureShearedVoxels)
{
  const auto scan = Image<short>(VTK_SHORT, { 0, 0, 0, 0, 0, 0, 0 });
  const double sheared[9] = { 1.0, 0.0, 0.6, 0.0, 1.0, 0.0, 0.0, 0.0, 0.8 };
  scan->SetDirectionMatrix(sheared);
  const auto statistics =
    StatisticsOfSegments(Image<unsigned char>(VTK_UNSIGNED_CHAR, Numbers), 2, scan);
  EXPECT_NEAR(statistics[0].volumeMm3, 160.0, 1e-9);
}

TEST(SegmentStatistics, AreATableThatOtherProgramsRead)
{
  const std::vector<Segment> segments = { { 7, "liver, \"left\"", { 1.0, 0.0, 0.0 } },
    { 9, "empty", { 1.0, 0.0, 0.0 } } };
  EXPECT_EQ(CsvOf(segments, { { 4, 2500.0, -12.5, 3.25, -20.0, 1.0 }, {} }),
    "value,name,voxels,volume_ml,mean,standard_deviation,smallest,largest\n"
    "7,\"liver, \"\"left\"\"\",4,2.5,-12.5,3.25,-20,1\n"
    "9,\"empty\",0,0,,,,\n");
}

}
