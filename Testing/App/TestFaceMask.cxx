// The face of a head: an ellipsoid with a nose, in CT and in values without a unit, in any
// direction.

#include "Scene/Images/OffscreenView.h"
#include "Scene/Segments/BodyMask.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

constexpr int HeadSide = 60; // voxels of 4 mm; the middle of the head is at the origin

// Half axes of 70, 90 and 100 mm, and a nose of 20 mm; the front is at y = -90.
bool IsHead(const std::array<double, 3>& point)
{
  const double x = point[0] / 70.0;
  const double y = point[1] / 90.0;
  const double z = point[2] / 100.0;
  const bool isNose =
    std::abs(point[0]) < 8.0 && std::abs(point[2]) < 10.0 && point[1] < -80.0 && point[1] > -110.0;
  return x * x + y * y + z * z < 1.0 || isNose;
}

struct DrawnHead
{
  vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();

  /// @param toBack  1 if the rows run from the front to the back, -1 if to the front
  DrawnHead(double air, double tissue, int toBack = 1)
  {
    this->image->SetDimensions(HeadSide, HeadSide, HeadSide);
    this->image->SetSpacing(4.0, 4.0, 4.0);
    this->image->SetDirectionMatrix(1, 0, 0, 0, toBack, 0, 0, 0, 1);
    this->image->SetOrigin(-118.0, -118.0 * toBack, -118.0);
    this->image->AllocateScalars(VTK_SHORT, 1);
    this->ForEach(
      [&](int x, int y, int z, const std::array<double, 3>& point)
      {
        *static_cast<short*>(this->image->GetScalarPointer(x, y, z)) =
          short(IsHead(point) ? tissue : air);
      });
  }

  template <class Visit>
  void ForEach(const Visit& visit)
  {
    for (int i = 0; i < HeadSide * HeadSide * HeadSide; ++i)
    {
      const int x = i % HeadSide;
      const int y = i / HeadSide % HeadSide;
      const int z = i / HeadSide / HeadSide;
      std::array<double, 3> point;
      this->image->TransformIndexToPhysicalPoint(x, y, z, point.data());
      visit(x, y, z, point);
    }
  }
};

void ExpectNoFace(DrawnHead head)
{
  const auto mask = FaceMask(head.image, 15.0);
  ASSERT_TRUE(mask);
  int removed = 0;
  head.ForEach(
    [&](int x, int y, int z, const std::array<double, 3>& point)
    {
      const bool isKept = *static_cast<unsigned char*>(mask->GetScalarPointer(x, y, z)) != 0;
      removed += !isKept;
      if (point[1] > 10.0)
      {
        EXPECT_TRUE(isKept) << "the back half";
      }
      // In the middle of the face, the nose is gone with 15 mm behind the face beside it.
      if (std::abs(point[0]) < 20.0 && std::abs(point[2]) < 20.0 && point[1] < -76.0)
      {
        EXPECT_FALSE(isKept) << point[0] << ' ' << point[1] << ' ' << point[2];
      }
    });
  EXPECT_GT(removed, 1000);
}

}

TEST(FaceMask, RemovesTheFrontOfTheHeadWithItsNose)
{
  ExpectNoFace({ -1000.0, 40.0 });
  ExpectNoFace({ 0.0, 600.0 });
}

TEST(FaceMask, KnowsTheFrontWhateverTheOrderOfTheRows)
{
  ExpectNoFace({ -1000.0, 40.0, -1 });
}

TEST(FaceMask, LeavesTheBackWhateverTheDepth)
{
  DrawnHead head(-1000.0, 40.0);
  const auto mask = FaceMask(head.image, 1e300);
  ASSERT_TRUE(mask);
  head.ForEach(
    [&](int x, int y, int z, const std::array<double, 3>& point)
    {
      const bool isKept = *static_cast<unsigned char*>(mask->GetScalarPointer(x, y, z)) != 0;
      const bool isInFront = point[1] < -18.0; // a little more than the middle of -110 and 90 mm
      if (isInFront && std::abs(point[0]) < 20.0 && std::abs(point[2]) < 20.0)
      {
        EXPECT_FALSE(isKept) << point[1];
      }
      else if (point[1] > -2.0)
      {
        EXPECT_TRUE(isKept) << point[1];
      }
    });
}

// Places beside each other are cut alike: no trace of the nose is left.
TEST(FaceMask, TheCutIsSmooth)
{
  const DrawnHead head(-1000.0, 40.0);
  const auto mask = FaceMask(head.image, 15.0);
  const auto depthAt = [&](int x)
  {
    int y = 0;
    while (*static_cast<unsigned char*>(mask->GetScalarPointer(x, y, HeadSide / 2)) == 0)
    {
      ++y;
    }
    return y;
  };
  for (int x = HeadSide / 2 - 5; x < HeadSide / 2 + 5; ++x)
  {
    EXPECT_LE(std::abs(depthAt(x) - depthAt(x + 1)), 1) << x;
  }
}

// A second scan of the same head has a face too.
TEST(FaceMask, HidesFurtherVolumes)
{
  const DrawnHead head(-1000.0, 40.0);
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { -400.0, 0.0 }, { 0.0, 0.5 } };
  scene.size = { 32, 32 };
  scene.camera.view = View::Anterior;
  scene.cuts.faceDepthMm = 15.0;
  OffscreenView view(scene, head.image, MapperKind::Varimarch);
  view.Pipeline().SetOverlays({ { ProceduralSource(), scene.look } }, { { head.image } });
  EXPECT_TRUE(view.Pipeline().Mask());
  EXPECT_EQ(view.Pipeline().Mapper()->GetNumberOfInputConnections(1), 0);
  view.Pipeline().SetCuts({});
  EXPECT_EQ(view.Pipeline().Mapper()->GetNumberOfInputConnections(1), 1);
}
