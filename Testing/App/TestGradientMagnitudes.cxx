// Gradient magnitudes of volumes, per mm.

#include "Scene/Looks/ValueGradientHistogram.h"

#include <gtest/gtest.h>

#include <limits>

using namespace varimarch;

namespace
{

// Rises by 6 per voxel of 2 mm along x, and by 12 per voxel of 3 mm along z.
vtkSmartPointer<vtkImageData> Slope(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  image->SetSpacing(2.0, 0.5, 3.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < side * side * side; ++i)
  {
    *value++ = float(6 * (i % side) + 12 * (i / (side * side)));
  }
  return image;
}

}

TEST(GradientMagnitudes, ArePerMillimetre)
{
  const auto magnitudes = GradientMagnitudes(Slope(8));
  EXPECT_EQ(magnitudes->GetNumberOfPoints(), 8 * 8 * 8);
  EXPECT_FLOAT_EQ(magnitudes->GetScalarComponentAsFloat(4, 4, 4, 0), 5.0F); // slopes of 3 and 4
}

TEST(GradientMagnitudes, AreFewOfALargeVolume)
{
  const auto magnitudes = GradientMagnitudes(Slope(200));
  EXPECT_LE(magnitudes->GetNumberOfPoints(), 4000000);
  EXPECT_GT(magnitudes->GetNumberOfPoints(), 400000);
  EXPECT_FLOAT_EQ(magnitudes->GetScalarComponentAsFloat(50, 50, 50, 0), 5.0F);
}

TEST(GradientMagnitudes, AreZeroBesideNan)
{
  const auto slope = Slope(8);
  slope->SetScalarComponentFromFloat(3, 4, 4, 0, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(GradientMagnitudes(slope)->GetScalarComponentAsFloat(4, 4, 4, 0), 0.0F);
}
