// Measurements of a volume against their formulas.

#include "Scene/Measures.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace varimarch;

namespace
{

// Values are offset + x in voxels, from 0 to 9; voxels of 1 x 2 x 3 mm.
vtkSmartPointer<vtkImageData> Ramp(int type, double offset)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(0, 9, 0, 9, 0, 9);
  image->SetSpacing(1.0, 2.0, 3.0);
  image->AllocateScalars(type, 1);
  for (int i = 0; i < 1000; ++i)
  {
    image->SetScalarComponentFromDouble(i % 10, i / 10 % 10, i / 100, 0, offset + i % 10);
  }
  return image;
}

TEST(Angle, IsMeasuredBetweenItsArms)
{
  EXPECT_DOUBLE_EQ(AngleDegrees({ { 2, 0, 0 }, { 0, 0, 0 }, { 0, 3, 0 } }), 90.0);
  EXPECT_DOUBLE_EQ(AngleDegrees({ { 3, 1, 1 }, { 1, 1, 1 }, { 2, 1, 2 } }), 45.0);
  EXPECT_DOUBLE_EQ(AngleDegrees({ { 1, 0, 0 }, { 0, 0, 0 }, { -4, 0, 0 } }), 180.0);
  EXPECT_EQ(AngleDegrees({ { 1, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }), 0.0) << "an arm has no length";
}

TEST(RegionStatistics, CountTheVoxelsInTheBox)
{
  // The box holds voxels 2 to 5 along x, 1 to 3 along y, and 1 to 2 along z, in any order of its
  // corners.
  const RegionStatistics found =
    StatisticsOf({ { 5.4, 1.5, 7.0 }, { 1.6, 6.2, 2.9 } }, Ramp(VTK_SHORT, 0.0));
  EXPECT_EQ(found.voxels, 4 * 3 * 2);
  EXPECT_DOUBLE_EQ(found.volumeMm3, 24 * 6.0);
  EXPECT_DOUBLE_EQ(found.mean, 3.5);
  EXPECT_DOUBLE_EQ(found.standardDeviation, std::sqrt(1.25));
  EXPECT_EQ(found.smallest, 2.0);
  EXPECT_EQ(found.largest, 5.0);
}

TEST(RegionStatistics, KeepTheirDigitsWithLargeValues)
{
  const MeasuredBox all = { { -1, -1, -1 }, { 100, 100, 100 } };
  const RegionStatistics found = StatisticsOf(all, Ramp(VTK_DOUBLE, 1e9));
  EXPECT_EQ(found.voxels, 1000);
  EXPECT_NEAR(found.mean, 1e9 + 4.5, 1e-6);
  EXPECT_NEAR(found.standardDeviation, std::sqrt(8.25), 1e-6);
}

TEST(RegionStatistics, LeaveOutValuesThatAreNotFinite)
{
  const auto image = Ramp(VTK_FLOAT, 0.0);
  image->SetScalarComponentFromDouble(0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN());
  const RegionStatistics found = StatisticsOf({ { 0, 0, 0 }, { 2, 0, 0 } }, image);
  EXPECT_EQ(found.voxels, 2);
  EXPECT_DOUBLE_EQ(found.mean, 1.5);
}

TEST(RegionStatistics, CountTheVoxelsThatAThinBoxPassesThrough)
{
  const RegionStatistics found =
    StatisticsOf({ { 0, 0, 7.2 }, { 9, 18, 7.4 } }, Ramp(VTK_SHORT, 0.0));
  EXPECT_EQ(found.voxels, 100);
  EXPECT_EQ(StatisticsOf({ { 50, 50, 50 }, { 60, 60, 60 } }, Ramp(VTK_SHORT, 0.0)).voxels, 0)
    << "beside the volume";
}

}
