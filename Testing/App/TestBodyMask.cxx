// The body of a scan is told from the table, the air and what lies between them.

#include "Scene/Model/SceneCuts.h"
#include "Scene/Segments/BodyMask.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

constexpr double Air = -1000.0;
constexpr double Tissue = 40.0;

bool IsBetween(const glm::dvec2& place, const glm::dvec2& lower, const glm::dvec2& upper)
{
  return place.x >= lower.x && place.x <= upper.x && place.y >= lower.y && place.y <= upper.y;
}

// A slice of a trunk with a lung, a thin part on top like an ear, and a table below it [mm].
double ValueAt(const glm::dvec2& place)
{
  if (glm::length(place - glm::dvec2(80.0, 110.0)) < 15.0)
  {
    return -800.0;
  }
  const bool isTrunk =
    glm::length((place - glm::dvec2(100.0, 110.0)) / glm::dvec2(60.0, 40.0)) < 1.0;
  const bool isEar = IsBetween(place, { 98.0, 56.0 }, { 102.0, 70.0 });
  const bool isTable = IsBetween(place, { 20.0, 158.0 }, { 180.0, 162.0 });
  return isTrunk || isEar ? Tissue : (isTable ? 100.0 : Air);
}

// 200 x 200 x 60 mm, with indices that do not begin at 0.
vtkSmartPointer<vtkImageData> Scan(bool isEmpty = false)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(5, 104, -3, 96, 2, 21);
  image->SetSpacing(2.0, 2.0, 3.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* voxel = static_cast<short*>(image->GetScalarPointer());
  for (int z = 0; z < 20; ++z)
  {
    for (int y = 0; y < 100; ++y)
    {
      for (int x = 0; x < 100; ++x)
      {
        *voxel++ = short(isEmpty ? Air : ValueAt(glm::dvec2(2.0 * x, 2.0 * y)));
      }
    }
  }
  return image;
}

bool IsKept(vtkImageData* mask, vtkImageData* image, const glm::dvec2& place)
{
  return Keeps(mask, image, { 5.0 + place.x / 2.0, -3.0 + place.y / 2.0, 12.0 });
}

}

TEST(BodyMask, KeepsTheBodyWithItsAirAndThinParts)
{
  const auto image = Scan();
  const auto body = BodyMask(image);
  ASSERT_TRUE(body);
  const auto mask = MaskOf({}, image, body);
  EXPECT_EQ(mask->GetNumberOfPoints(), image->GetNumberOfPoints());
  EXPECT_TRUE(IsKept(mask, image, { 100.0, 110.0 })) << "trunk";
  EXPECT_TRUE(IsKept(mask, image, { 80.0, 110.0 })) << "lung";
  EXPECT_TRUE(IsKept(mask, image, { 100.0, 58.0 })) << "ear";
  EXPECT_TRUE(IsKept(mask, image, { 41.0, 110.0 })) << "skin";
  EXPECT_FALSE(IsKept(mask, image, { 100.0, 160.0 })) << "table";
  EXPECT_FALSE(IsKept(mask, image, { 100.0, 156.0 })) << "air between body and table";
  EXPECT_FALSE(IsKept(mask, image, { 10.0, 10.0 })) << "air";
}

TEST(BodyMask, IsCutByScissorsToo)
{
  const auto image = Scan();
  ScissorsCut cut;
  cut.camera.parallel = true;
  cut.camera.pose =
    CameraPose{ { 100.0, 110.0, 500.0 }, { 100.0, 110.0, 0.0 }, { 0.0, 1.0, 0.0 }, 100.0 };
  cut.outline = { { 0.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  const auto mask = MaskOf({ cut }, image, BodyMask(image));
  const auto scissorsAlone = MaskOf({ cut }, image);
  int kept = 0;
  int keptByScissors = 0;
  for (vtkIdType voxel = 0; voxel < mask->GetNumberOfPoints(); ++voxel)
  {
    const bool isKept = static_cast<unsigned char*>(mask->GetScalarPointer())[voxel] != 0;
    const bool byScissors =
      static_cast<unsigned char*>(scissorsAlone->GetScalarPointer())[voxel] != 0;
    EXPECT_LE(isKept, byScissors);
    kept += isKept;
    keptByScissors += byScissors;
  }
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, keptByScissors / 2);
}

TEST(BodyMask, IsMissingWithoutABody)
{
  EXPECT_FALSE(BodyMask(Scan(true)));
  EXPECT_TRUE(HasBodyMask("CT"));
  EXPECT_FALSE(HasBodyMask("MR"));
}
