// Reduced copies of volumes: fewer voxels with the same values at the same places.

#include "Scene/Volumes/VolumeLoading.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

// The value is y in world space [mm]. The volume is rotated and shifted, so that any displacement
// shows.
vtkSmartPointer<vtkImageData> Ramp(int width, int height, int depth)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, depth);
  image->SetSpacing(0.5, 1.5, 2.0);
  image->SetOrigin(10.0, -20.0, 30.0);
  image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    static_cast<float*>(image->GetScalarPointer())[point] = float(image->GetPoint(point)[1]);
  }
  return image;
}

}

TEST(SmallCopy, HasTheMeanValuesAtTheirPlaces)
{
  const auto image = Ramp(64, 20, 9);
  const auto small = SmallCopy(image, 16);
  EXPECT_EQ(small->GetDimensions()[0], 16);
  EXPECT_EQ(small->GetDimensions()[1], 10);
  EXPECT_EQ(small->GetDimensions()[2], 9);
  for (vtkIdType point = 0; point < small->GetNumberOfPoints(); ++point)
  {
    ASSERT_NEAR(
      static_cast<float*>(small->GetScalarPointer())[point], small->GetPoint(point)[1], 1e-4);
  }
}

TEST(SmallCopy, SharesNoVoxelsWithASmallVolume)
{
  const auto image = Ramp(8, 8, 8);
  const auto copy = SmallCopy(image, 16);
  EXPECT_EQ(copy->GetNumberOfPoints(), image->GetNumberOfPoints());
  EXPECT_NE(copy->GetScalarPointer(), image->GetScalarPointer());
}
