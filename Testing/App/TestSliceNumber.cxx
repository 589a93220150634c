// The number of a slice, and the windows of a modality.

#include "Scene/Looks/Presets.h"
#include "Scene/Slices/SlicePicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// 10 columns, 20 rows and 30 slices, which run from the head to the feet.
vtkSmartPointer<vtkImageData> FromTheHead()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(10, 20, 30);
  image->SetSpacing(1.0, 2.0, 3.0);
  image->SetOrigin(5.0, 6.0, 700.0);
  const double direction[9] = { 1, 0, 0, 0, 1, 0, 0, 0, -1 };
  image->SetDirectionMatrix(direction);
  return image;
}

}

TEST(SliceNumber, CountsInTheOrderOfTheVoxels)
{
  const auto image = FromTheHead();
  const auto axial = SliceNumberAt(image, SlicePlane::Axial, { 5.0, 6.0, 700.0 - 3.0 * 4 + 1.4 });
  ASSERT_TRUE(axial);
  EXPECT_EQ(axial->number, 5);
  EXPECT_EQ(axial->count, 30);
  const auto coronal = SliceNumberAt(image, SlicePlane::Coronal, { 5.0, 6.0 + 2.0 * 19, 700.0 });
  ASSERT_TRUE(coronal);
  EXPECT_EQ(coronal->number, 20);
  EXPECT_EQ(coronal->count, 20);
  EXPECT_EQ(SliceNumberAt(image, SlicePlane::Sagittal, { -1e6, 0.0, 0.0 })->number, 1);
  EXPECT_EQ(SliceStepMm(image, SlicePlane::Axial), 3.0);
  EXPECT_EQ(SliceStepMm(image, SlicePlane::Sagittal), 1.0);
}

TEST(SliceNumber, IsUnknownInObliquePlanes)
{
  const auto image = FromTheHead();
  const double c = std::cos(0.1);
  const double s = std::sin(0.1);
  const double turned[9] = { 1, 0, 0, 0, c, -s, 0, s, c };
  image->SetDirectionMatrix(turned);
  EXPECT_FALSE(SliceNumberAt(image, SlicePlane::Axial, { 0.0, 0.0, 0.0 }));
  EXPECT_TRUE(SliceNumberAt(image, SlicePlane::Sagittal, { 0.0, 0.0, 0.0 }));
  EXPECT_EQ(SliceStepMm(image, SlicePlane::Axial), 3.0);
}

TEST(WindowPresets, AreOfCtOnly)
{
  EXPECT_LE(WindowPresetsOf("CT").size(), 9u) << "one for each key";
  for (const WindowPreset& preset : WindowPresetsOf("CT"))
  {
    EXPECT_GT(preset.window, 0.0) << preset.name;
  }
  EXPECT_TRUE(WindowPresetsOf("MR").empty());
  EXPECT_TRUE(WindowPresetsOf("").empty());
}
