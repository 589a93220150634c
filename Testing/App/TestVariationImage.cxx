// The field of variations of an image: a volume of bytes in the same place.

#include "Scene/Volumes/VariationImage.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

// Zeros and one other value, with spacing, origin and directions of its own.
vtkSmartPointer<vtkImageData> OneOtherVoxel(int type, int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 3, 2);
  image->SetSpacing(0.5, 1.5, 2.0);
  image->SetOrigin(10.0, -20.0, 30.0);
  image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  image->AllocateScalars(type, components);
  for (int i = 0; i < 24; ++i)
  {
    image->SetScalarComponentFromDouble(i % 4, i / 4 % 3, i / 12, 0, i == 0 ? 7.0 : 0.0);
  }
  return image;
}

}

TEST(VariationImage, CountsVoxelsAndLiesWhereTheVolumeDoes)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto image = OneOtherVoxel(type);
    const auto field = VariationImage(image, 7.0, VoxelDistance::Euclidean);
    EXPECT_EQ(field->GetScalarType(), VTK_UNSIGNED_CHAR);
    EXPECT_EQ(field->GetScalarComponentAsDouble(0, 0, 0, 0), 1.0);
    EXPECT_EQ(field->GetScalarComponentAsDouble(3, 0, 0, 0), 3.0);
    EXPECT_EQ(field->GetScalarComponentAsDouble(2, 2, 1, 0), 3.0) << "a distance of 3";
    EXPECT_EQ(field->GetScalarComponentAsDouble(3, 2, 1, 0), 3.0) << "a distance of 3.7";
    for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(field->GetPoint(point)[axis], image->GetPoint(point)[axis]);
      }
    }
  }
}

TEST(VariationImage, RefusesSeveralComponents)
{
  EXPECT_THROW(VariationImage(OneOtherVoxel(VTK_FLOAT, 2), 1.0, VoxelDistance::Euclidean),
    std::invalid_argument);
}
