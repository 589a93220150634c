#include "Scene/Volumes/ImageOrientation.h"

#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// Each voxel's value encodes its index.
vtkSmartPointer<vtkImageData> MirroredImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 4, 5);
  image->SetSpacing(1.0, 2.0, 3.0);
  image->SetOrigin(10.0, 20.0, 30.0);
  image->SetDirectionMatrix(0, -1, 0, -1, 0, 0, 0, 0, -1);
  image->AllocateScalars(VTK_SHORT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    static_cast<short*>(image->GetScalarPointer())[i] = short(i);
  }
  return image;
}

TEST(RightHanded, MovesNoVoxel)
{
  const auto image = MirroredImage();
  image->SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1);
  ASSERT_LT(image->GetDirectionMatrix()->Determinant(), 0.0);
  const auto turned = RightHanded(image);
  EXPECT_GT(turned->GetDirectionMatrix()->Determinant(), 0.0);
  for (int k = 0; k < 5; ++k)
  {
    double position[3];
    image->TransformIndexToPhysicalPoint(1, 2, k, position);
    double index[3];
    turned->TransformPhysicalPointToContinuousIndex(position, index);
    EXPECT_EQ(turned->GetScalarComponentAsDouble(int(std::lround(index[0])),
                int(std::lround(index[1])), int(std::lround(index[2])), 0),
      image->GetScalarComponentAsDouble(1, 2, k, 0));
  }
}

TEST(RightHanded, LeavesARightHandedImageAlone)
{
  const auto image = MirroredImage();
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  EXPECT_EQ(RightHanded(image), image);
}

TEST(WithoutDirection, TransformBringsEveryVoxelBack)
{
  const auto image = MirroredImage();
  vtkNew<vtkTransform> worldFromImage;
  const auto upright = WithoutDirection(image, worldFromImage);
  double expected[3];
  image->TransformIndexToPhysicalPoint(2, 3, 4, expected);
  double found[3];
  upright->TransformIndexToPhysicalPoint(2, 3, 4, found);
  worldFromImage->TransformPoint(found, found);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], 1e-12);
  }
}

}
