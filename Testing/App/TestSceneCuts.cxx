#include "Scene/Model/SceneCuts.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

using namespace varimarch;

TEST(SceneCuts, TheBoxStaysInPlaceWhenTheVolumeIsRectified)
{
  // Slices that are sheared along y, and the upright box around them.
  vtkNew<vtkImageData> tilted;
  tilted->SetDimensions(11, 21, 31);
  const double lean[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.6, 0.0, 0.0, 0.8 };
  tilted->SetDirectionMatrix(lean);
  vtkNew<vtkImageData> upright;
  upright->SetDimensions(11, 39, 31);
  upright->SetSpacing(1.0, 1.0, 0.8);

  const std::array<double, 6> box = { 0.25, 0.5, 0.125, 1.0, 0.0, 0.75 };
  const std::array<double, 6> moved = BoxInOther(box, tilted, upright);
  EXPECT_EQ(moved[3], 1.0);
  EXPECT_EQ(moved[4], 0.0);
  for (const int face : { 0, 1, 2, 5 })
  {
    glm::dvec3 before(0.5);
    glm::dvec3 after(0.5);
    before[face / 2] = box[face];
    after[face / 2] = moved[face];
    EXPECT_NEAR(
      PointAtParts(before, tilted)[face / 2], PointAtParts(after, upright)[face / 2], 1e-12)
      << face;
  }
  EXPECT_EQ(BoxInOther(SceneCuts().box, tilted, upright), SceneCuts().box);
}
