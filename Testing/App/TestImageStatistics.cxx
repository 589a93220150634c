#include "Readers/ImageFacts.h"
#include "Scene/Volumes/ImageStatistics.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using varimarch::ImageStatistics;

namespace
{

// The values 0, 1, ... 999, times a factor.
template <class Scalar>
vtkSmartPointer<vtkImageData> Ramp(int type, double factor)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(10, 10, 10);
  image->AllocateScalars(type, 1);
  for (int i = 0; i < 1000; ++i)
  {
    static_cast<Scalar*>(image->GetScalarPointer())[i] = Scalar(factor * i);
  }
  return image;
}

TEST(ImageStatistics, PercentilesOfIntegersAreExact)
{
  const ImageStatistics statistics(Ramp<short>(VTK_SHORT, 1.0));
  EXPECT_EQ(statistics.Smallest(), 0.0);
  EXPECT_EQ(statistics.Largest(), 999.0);
  EXPECT_EQ(statistics.Percentile(0.0), 0.0);
  EXPECT_EQ(statistics.Percentile(50.0), 499.0);
  EXPECT_EQ(statistics.Percentile(100.0), 999.0);
}

TEST(ImageStatistics, PercentilesOfFloatsAreCloseToExact)
{
  const ImageStatistics statistics(Ramp<float>(VTK_FLOAT, 1e-3));
  EXPECT_NEAR(statistics.Percentile(25.05), 0.250, 1e-4);
  EXPECT_NEAR(statistics.Percentile(99.85), 0.998, 1e-4);
}

TEST(ImageStatistics, HistogramCountsEveryVoxelOnce)
{
  const ImageStatistics statistics(Ramp<short>(VTK_SHORT, 1.0));
  const std::vector<std::int64_t> four = statistics.Histogram(4);
  EXPECT_EQ(four[0] + four[1] + four[2] + four[3], 1000);
  EXPECT_NEAR(double(four[1]), 250.0, 1.0);
}

TEST(ImageStatistics, OfTwoVolumesCountIntegersOneByOne)
{
  ImageStatistics statistics(Ramp<short>(VTK_SHORT, 1.0));
  statistics.Add(ImageStatistics(Ramp<short>(VTK_SHORT, -2.0)));
  EXPECT_EQ(statistics.Smallest(), -1998.0);
  EXPECT_EQ(statistics.Largest(), 999.0);
  ASSERT_EQ(statistics.Counts().size(), 2998);
  EXPECT_EQ(statistics.Counts()[1998], 2) << "0 is a value of both";
  EXPECT_EQ(statistics.Counts()[1997], 0);
  EXPECT_EQ(statistics.Counts()[1996], 1);
  EXPECT_EQ(statistics.Counts()[1998 + 500], 1);
}

TEST(ImageStatistics, OfTwoVolumesCountFloatsInBinsOfBothRanges)
{
  ImageStatistics statistics(Ramp<float>(VTK_FLOAT, 1e-3));
  statistics.Add(ImageStatistics(Ramp<float>(VTK_FLOAT, -1e-3)));
  EXPECT_FLOAT_EQ(float(statistics.Smallest()), -0.999f);
  EXPECT_FLOAT_EQ(float(statistics.Largest()), 0.999f);
  EXPECT_NEAR(statistics.Percentile(50.0), 0.0, 1e-3);
  EXPECT_NEAR(statistics.Percentile(75.0), 0.5, 1e-3);
  const std::vector<std::int64_t> halves = statistics.Histogram(2);
  EXPECT_EQ(halves[0] + halves[1], 2000);
}

TEST(ImageStatistics, ValuesThatAreNotFiniteCountAtTheEnds)
{
  const auto image = Ramp<float>(VTK_FLOAT, 1.0);
  auto* voxels = static_cast<float*>(image->GetScalarPointer());
  std::fill(voxels, voxels + 300, -std::numeric_limits<float>::infinity());
  std::fill(voxels + 700, voxels + 900, std::numeric_limits<float>::infinity());
  std::fill(voxels + 900, voxels + 1000, std::numeric_limits<float>::quiet_NaN());
  const ImageStatistics statistics(image);
  EXPECT_EQ(statistics.Smallest(), 300.0);
  EXPECT_EQ(statistics.Largest(), 699.0);
  EXPECT_EQ(statistics.Histogram(4)[0], 300 + 100 + 100);
  EXPECT_EQ(statistics.Histogram(4)[3], 200 + 100);
}

TEST(ImageStatistics, LeavePaddingBelowTheImageOut)
{
  const auto image = Ramp<short>(VTK_SHORT, 1.0);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), 100, short(-2000));
  varimarch::Volume volume;
  volume.lowestInside = 100.0;
  varimarch::KeepFacts(volume, image);
  const ImageStatistics statistics(image);
  EXPECT_EQ(statistics.Smallest(), 100.0);
  EXPECT_EQ(statistics.Largest(), 999.0);
  EXPECT_EQ(statistics.Percentile(0.0), 100.0);
  EXPECT_EQ(statistics.Percentile(50.0), 549.0);
}

TEST(ImageStatistics, AConstantVolumeHasOneValue)
{
  const ImageStatistics statistics(Ramp<unsigned char>(VTK_UNSIGNED_CHAR, 0.0));
  EXPECT_EQ(statistics.Percentile(50.0), 0.0);
  EXPECT_EQ(statistics.Histogram(3)[0], 1000);
}

}
