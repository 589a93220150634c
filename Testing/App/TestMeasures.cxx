// Measurements of a volume against their formulas.

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Measures/RegionStatistics.h"
#include "Scene/Volumes/VolumeLoading.h"

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

RegionStatistics StatisticsIn(
  const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm, vtkImageData* image)
{
  return StatisticsOfBox(fromMm, toMm, image, image);
}

double Degrees(MeasureKind kind, const std::vector<std::array<double, 3>>& points)
{
  return *ValuesOf({ kind, points }, nullptr).degrees;
}

TEST(Angle, IsMeasuredBetweenItsArms)
{
  const auto degrees = [](const std::vector<std::array<double, 3>>& points)
  { return Degrees(MeasureKind::Angle, points); };
  EXPECT_DOUBLE_EQ(degrees({ { 2, 0, 0 }, { 0, 0, 0 }, { 0, 3, 0 } }), 90.0);
  EXPECT_DOUBLE_EQ(degrees({ { 3, 1, 1 }, { 1, 1, 1 }, { 2, 1, 2 } }), 45.0);
  EXPECT_DOUBLE_EQ(degrees({ { 1, 0, 0 }, { 0, 0, 0 }, { -4, 0, 0 } }), 180.0);
  EXPECT_EQ(degrees({ { 1, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }), 0.0) << "an arm has no length";
}

TEST(CobbAngle, IsThatOfLinesWithoutDirection)
{
  const auto degrees = [](const std::vector<std::array<double, 3>>& points)
  { return Degrees(MeasureKind::CobbAngle, points); };
  EXPECT_DOUBLE_EQ(degrees({ { 0, 0, 0 }, { 9, 0, 0 }, { 50, 7, 3 }, { 51, 8, 3 } }), 45.0);
  EXPECT_DOUBLE_EQ(degrees({ { 9, 0, 0 }, { 0, 0, 0 }, { 50, 7, 3 }, { 51, 8, 3 } }), 45.0);
  EXPECT_DOUBLE_EQ(degrees({ { 0, 0, 0 }, { 9, 0, 0 }, { 0, 1, 0 }, { 0, 2, 0 } }), 90.0);
}

// Values are 100 + 10 x - 4 y + z, with x, y and z in mm; voxels of 0.5 x 0.5 x 2 mm. The middle is
// at the world's origin.
vtkSmartPointer<vtkImageData> FineRamp()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(121, 121, 31);
  image->SetOrigin(-30.0, -30.0, -30.0);
  image->SetSpacing(0.5, 0.5, 2.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* value = static_cast<double*>(image->GetScalarPointer());
  for (int k = 0; k < 31; ++k)
  {
    for (int j = 0; j < 121; ++j)
    {
      for (int i = 0; i < 121; ++i)
      {
        *value++ = 100.0 + 10.0 * (0.5 * i - 30.0) - 4.0 * (0.5 * j - 30.0) + 2.0 * k - 30.0;
      }
    }
  }
  return image;
}

constexpr double Pi = 3.14159265358979;

// The pixels that an outline cuts through may be counted or not: its length over the width of a
// pixel, and a few more.
double PixelsOnOutline(double lengthMm, double pixelMm)
{
  return 1.5 * lengthMm / pixelMm;
}

TEST(Ellipse, HasTheStatisticsOfARamp)
{
  const auto image = FineRamp();
  // No pixel lies on the ellipse itself.
  const double a = 12.1;
  const double b = 7.1;
  const MeasureValues found = ValuesOf(
    { MeasureKind::Ellipse, { { 3, -2, 4.3 }, { 3 + a, -2, 4.3 }, { 3, -2 + b, 4.3 } } }, image);
  EXPECT_NEAR(*found.areaMm2, Pi * a * b, 1e-9);
  const RegionStatistics& values = *found.statistics;
  EXPECT_NEAR(double(values.voxels), Pi * a * b / 0.25, PixelsOnOutline(Pi * (a + b), 0.5));
  // The slice at z = 4 is the nearest. A linear function has its value at the middle as the mean,
  // and a standard deviation of half of its increments along the half-diameters.
  const double middle = 100.0 + 30.0 + 8.0 + 4.0;
  EXPECT_NEAR(values.mean, middle, 1e-9) << "pixels lie symmetrically about the middle";
  const double deviation = 0.5 * std::hypot(10.0 * a, 4.0 * b);
  EXPECT_NEAR(values.standardDeviation, deviation, 0.01 * deviation);
  const double reach = std::hypot(10.0 * a, 4.0 * b);
  EXPECT_NEAR(values.smallest, middle - reach, 7.0) << "the sum of increments of half a pixel";
  EXPECT_LE(values.largest, middle + reach);
}

TEST(Ellipse, HasTheStatisticsOfARampInAnObliquePlane)
{
  const auto image = FineRamp();
  // Conjugate half-diameters along (1, 0, 1) and (0, 1, 0), which need not be perpendicular.
  const double h = std::sqrt(0.5);
  const MeasureValues found = ValuesOf(
    { MeasureKind::Ellipse, { { 0, 0, 0 }, { 10.1 * h, 0, 10.1 * h }, { 0, 6.1, 0 } } }, image);
  EXPECT_NEAR(*found.areaMm2, Pi * 10.1 * 6.1, 1e-9);
  EXPECT_NEAR(
    double(found.statistics->voxels), Pi * 10.1 * 6.1 / 0.25, PixelsOnOutline(Pi * 16.2, 0.5));
  EXPECT_NEAR(found.statistics->mean, 100.0, 1e-6);
  const double deviation = 0.5 * std::hypot(11.0 * 10.1 * h, 4.0 * 6.1);
  EXPECT_NEAR(found.statistics->standardDeviation, deviation, 0.01 * deviation);
}

TEST(Freehand, CountsTheVoxelsWhoseCentresItHolds)
{
  const auto image = FineRamp();
  // Half of a square of 10.2 mm, drawn in the plane of a slice: 21 x 21 voxels and the triangle.
  const MeasureValues found = ValuesOf(
    { MeasureKind::Freehand, { { -5.1, -5.1, 0 }, { 5.1, -5.1, 0 }, { 5.1, 5.1, 0 } } }, image);
  EXPECT_NEAR(*found.areaMm2, 0.5 * 10.2 * 10.2, 1e-9);
  EXPECT_NEAR(double(found.statistics->voxels), 21 * 22 / 2, 21) << "centres on the diagonal";
  EXPECT_EQ(found.statistics->largest, 100.0 + 50.0 + 20.0);
}

TEST(Freehand, LeavesOutPixelsBesideTheVolume)
{
  const auto image = FineRamp();
  const auto count = [&](double right)
  {
    return ValuesOf(
      { MeasureKind::Freehand,
        { { 20.1, -5.1, 0 }, { right, -5.1, 0 }, { right, 5.1, 0 }, { 20.1, 5.1, 0 } } },
      image)
      .statistics->voxels;
  };
  EXPECT_EQ(count(30.1), 20 * 21);
  EXPECT_EQ(count(1e9), 20 * 21);
  EXPECT_EQ(ValuesOf({ MeasureKind::Freehand, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } } }, image)
              .statistics->voxels,
    0)
    << "without an area";
}

TEST(Freehand, ReadsTheFirstComponentOfAVolumeOfColours)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(10, 10, 2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 800; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = i % 4 == 0 ? 7 : 200;
  }
  const RegionStatistics found =
    *ValuesOf({ MeasureKind::Freehand,
                { { 0.5, 0.5, 0 }, { 8.5, 0.5, 0 }, { 8.5, 8.5, 0 }, { 0.5, 8.5, 0 } } },
      image)
       .statistics;
  EXPECT_EQ(found.voxels, 64);
  EXPECT_EQ(found.mean, 7.0);
  EXPECT_EQ(found.largest, 7.0);
}

TEST(Ellipse, OfAnySizeIsCounted)
{
  const auto image = FineRamp();
  const double far = 1e17;
  const MeasureValues found = ValuesOf(
    { MeasureKind::Ellipse, { { far, 0, far }, { 3.0 * far, 0, 3.0 * far }, { far, far, far } } },
    image);
  EXPECT_GE(found.statistics->voxels, 0) << "and takes no time without end";
}

TEST(MeasureTable, HasALinePerMeasurementWithItsUnits)
{
  LoadedVolume volume;
  volume.image = Ramp(VTK_SHORT, 0.0);
  volume.uptakeValueFactor = 0.5;
  const std::string table = CsvOf(
    { { MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } }, "a \"b\", c" },
      { MeasureKind::Box, { { 2, 2, 3 }, { 5, 6, 6 } } }, { MeasureKind::Text, { { 1, 2, 3 } } } },
    volume);
  EXPECT_EQ(table,
    "number,kind,name,length_mm,angle_degrees,area_mm2,volume_mm3,voxels,mean,standard_deviation,"
    "smallest,largest,unit,points_mm,volume\n"
    "1,distance,\"a \"\"b\"\", c\",5,,,,,,,,,,\"0 0 0; 3 4 0\",1\n"
    "2,box,\"\",,,,144,24,1.75,0.559016994,1,2.5,SUV,\"2 2 3; 5 6 6\",1\n"
    "3,text,\"\",,,,,,,,,,,\"1 2 3\",1\n");
}

TEST(MeasureTable, HasALineForEachVolumeOverTheFirst)
{
  LoadedVolume volume;
  volume.image = Ramp(VTK_SHORT, 0.0);
  LoadedVolume pet = volume;
  pet.image = Ramp(VTK_SHORT, 100.0);
  pet.image->SetSpacing(1.0, 1.0, 3.0);
  pet.uptakeValueFactor = 0.5;
  const std::string table = CsvOf({ { MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } },
                                    { MeasureKind::Box, { { 2, 2, 3 }, { 5, 6, 6 } } } },
    volume, { { 2, pet, pet.image } });
  EXPECT_EQ(table.substr(table.find('\n') + 1),
    "1,distance,\"\",5,,,,,,,,,,\"0 0 0; 3 4 0\",1\n"
    "2,box,\"\",,,,144,24,3.5,1.11803399,2,5,,\"2 2 3; 5 6 6\",1\n"
    "2,box,\"\",,,,120,40,51.75,0.559016994,51,52.5,SUV,\"2 2 3; 5 6 6\",2\n");
}

TEST(RegionStatistics, CountTheVoxelsInTheBox)
{
  // The box holds voxels 2 to 5 along x, 1 to 3 along y, and 1 to 2 along z, in any order of its
  // corners.
  const RegionStatistics found =
    StatisticsIn({ 5.4, 1.5, 7.0 }, { 1.6, 6.2, 2.9 }, Ramp(VTK_SHORT, 0.0));
  EXPECT_EQ(found.voxels, 4 * 3 * 2);
  EXPECT_DOUBLE_EQ(found.volumeMm3, 24 * 6.0);
  EXPECT_DOUBLE_EQ(found.mean, 3.5);
  EXPECT_DOUBLE_EQ(found.standardDeviation, std::sqrt(1.25));
  EXPECT_EQ(found.smallest, 2.0);
  EXPECT_EQ(found.largest, 5.0);
}

TEST(RegionStatistics, KeepTheirDigitsWithLargeValues)
{
  const RegionStatistics found =
    StatisticsIn({ -1, -1, -1 }, { 100, 100, 100 }, Ramp(VTK_DOUBLE, 1e9));
  EXPECT_EQ(found.voxels, 1000);
  EXPECT_NEAR(found.mean, 1e9 + 4.5, 1e-6);
  EXPECT_NEAR(found.standardDeviation, std::sqrt(8.25), 1e-6);
}

TEST(RegionStatistics, KeepTheirDigitsBesideAFillValue)
{
  const auto image = Ramp(VTK_DOUBLE, 0.0);
  for (int j = 0; j < 10; ++j)
  {
    for (int k = 0; k < 10; ++k)
    {
      image->SetScalarComponentFromDouble(0, j, k, 0, 1e30);
    }
  }
  const RegionStatistics found = StatisticsIn({ 2, 4, 6 }, { 7, 9, 12 }, image);
  EXPECT_DOUBLE_EQ(found.mean, 4.5);
  EXPECT_DOUBLE_EQ(found.standardDeviation, std::sqrt(35.0 / 12.0));
}

TEST(RegionStatistics, LeaveOutValuesThatAreNotFinite)
{
  const auto image = Ramp(VTK_FLOAT, 0.0);
  image->SetScalarComponentFromDouble(0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN());
  const RegionStatistics found = StatisticsIn({ 0, 0, 0 }, { 2, 0, 0 }, image);
  EXPECT_EQ(found.voxels, 2);
  EXPECT_DOUBLE_EQ(found.mean, 1.5);
}

TEST(RegionStatistics, CountTheVoxelsThatAThinBoxPassesThrough)
{
  const RegionStatistics found = StatisticsIn({ 0, 0, 7.2 }, { 9, 18, 7.4 }, Ramp(VTK_SHORT, 0.0));
  EXPECT_EQ(found.voxels, 100);
  EXPECT_EQ(StatisticsIn({ 0, 0, 6 }, { 9, 18, 9 - 1e-12 }, Ramp(VTK_SHORT, 0.0)).voxels, 200)
    << "a box from layer to layer, but for rounding, has both";
  EXPECT_EQ(StatisticsIn({ 50, 50, 50 }, { 60, 60, 60 }, Ramp(VTK_SHORT, 0.0)).voxels, 0)
    << "beside the volume";
}

// The volume over the first is turned by 30 degrees about z, and has voxels of another size.
TEST(RegionStatistics, CountTheVoxelsOfAVolumeOverTheBox)
{
  const auto grid = Ramp(VTK_SHORT, 0.0);
  const auto over = vtkSmartPointer<vtkImageData>::New();
  over->SetDimensions(24, 24, 12);
  over->SetSpacing(0.7, 0.9, 1.7);
  over->SetOrigin(3.0, -4.0, 1.0);
  const double c = std::cos(0.5236);
  const double s = std::sin(0.5236);
  over->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  over->AllocateScalars(VTK_INT, 1);
  for (vtkIdType i = 0; i < over->GetNumberOfPoints(); ++i)
  {
    static_cast<int*>(over->GetScalarPointer())[i] = int(i);
  }
  const auto expectAsByHand =
    [&](const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm)
  {
    std::int64_t count = 0;
    double sum = 0.0;
    for (vtkIdType i = 0; i < over->GetNumberOfPoints(); ++i)
    {
      double point[3];
      over->GetPoint(i, point);
      bool isInside = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        isInside = isInside && point[axis] >= fromMm[axis] && point[axis] <= toMm[axis];
      }
      count += isInside;
      sum += isInside ? double(i) : 0.0;
    }
    const RegionStatistics found = StatisticsOfBox(fromMm, toMm, grid, over);
    EXPECT_EQ(found.voxels, count);
    EXPECT_NEAR(found.mean, sum / double(count), 1e-9);
    EXPECT_GT(count, 10);
  };
  expectAsByHand({ 1.0, 1.0, 3.0 }, { 5.3, 8.2, 12.1 });
  expectAsByHand({ -50.0, 2.0, -50.0 }, { 50.0, 5.0, 50.0 });
  EXPECT_EQ(StatisticsOfBox({ 70, 70, 70 }, { 80, 80, 80 }, grid, over).voxels, 0);
}

}
