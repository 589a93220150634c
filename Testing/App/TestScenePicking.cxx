// Picking along a ray, and the part of a volume that a scene's cuts keep.

#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Pipeline/ScenePicking.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// A ramp along x: the value is x in mm, from -10 to 10. A direction matrix can turn it.
vtkSmartPointer<vtkImageData> Ramp(bool turned)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 21, 21);
  if (turned)
  {
    // The image's x axis runs along the world's y, its y axis against the world's x.
    image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    image->SetOrigin(10.0, -10.0, -10.0);
  }
  else
  {
    image->SetOrigin(-10.0, -10.0, -10.0);
  }
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 21 * 21 * 21; ++i)
  {
    values[i] = float(i % 21 - 10);
  }
  return image;
}

// Transparent below 3, and opaque within 0.01 mm above.
Scene WallAtThree()
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 3.0, 0.0 }, { 3.0, 0.9999 } };
  scene.look.opacityUnitDistanceMm = 0.01;
  scene.look.shading.enabled = false;
  scene.size = { 32, 32 };
  return scene;
}

constexpr double StepMm = 0.25;

}

TEST(PointSeen, IsWhereTheVolumeBecomesOpaque)
{
  const auto seen = PointSeen(WallAtThree(), Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 });
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[0], 3.0, StepMm);
  EXPECT_EQ((*seen)[1], 1.0);
  EXPECT_EQ((*seen)[2], 2.0);
}

// The gradient of the ramp is 1 per mm.
TEST(PointSeen, IsNotWhereTheGradientMakesItTransparent)
{
  Scene scene = WallAtThree();
  const auto seen = [&] {
    return PointSeen(scene, Ramp(true), { 1.0, -50.0, 2.0 }, { 1.0, 50.0, 2.0 });
  };
  ASSERT_TRUE(seen());
  scene.look.gradientOpacities = { { 1.1, 0.0 }, { 2.0, 1.0 } };
  EXPECT_FALSE(seen());
  scene.look.gradientOpacities = { { 0.5, 0.0 }, { 0.9, 1.0 } };
  ASSERT_TRUE(seen());
  EXPECT_NEAR((*seen())[1], 3.0, StepMm);
  // An opacity of 0.09999 per 0.01 mm absorbs half of the light in 0.066 mm.
  scene.look.gradientOpacities = { { 0.0, 0.1 } };
  ASSERT_TRUE(seen());
  EXPECT_NEAR((*seen())[1], 3.0, StepMm);
  scene.look.opacityUnitDistanceMm = 1.0;
  EXPECT_NEAR((*seen())[1], 3.0 + std::log(0.5) / std::log1p(-0.1 * 0.9999), StepMm);
}

// Half of the light is absorbed at the second of the two surfaces.
TEST(PointSeen, IsOnASurfaceOfEqualValue)
{
  Scene scene = WallAtThree();
  scene.look.blend = Blend::Isosurface;
  scene.look.isosurfaces = { { 3.0, { 1.0, 1.0, 1.0 }, 0.4 }, { 5.0, { 1.0, 1.0, 1.0 }, 0.4 } };
  const auto seen = PointSeen(scene, Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 });
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[0], 5.0, StepMm);
  scene.look.isosurfaces.pop_back();
  EXPECT_FALSE(PointSeen(scene, Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 }));
}

TEST(PointSeen, FollowsTheDirectionOfTheImage)
{
  const auto seen = PointSeen(WallAtThree(), Ramp(true), { 1.0, -50.0, 2.0 }, { 1.0, 50.0, 2.0 });
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[1], 3.0, StepMm);
}

TEST(PointSeen, IsBehindTheCutAwayPart)
{
  Scene scene = WallAtThree();
  scene.cuts.planes = { { { 6.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } } };
  const auto seen = PointSeen(scene, Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 });
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[0], 6.0, StepMm);
  scene.cuts.box[1] = 0.5;
  EXPECT_FALSE(PointSeen(scene, Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 }));
}

TEST(PointSeen, IsEmptyOutsideTheVolume)
{
  EXPECT_FALSE(PointSeen(WallAtThree(), Ramp(false), { -50.0, 11.0, 2.0 }, { 50.0, 11.0, 2.0 }));
}

TEST(PointSeen, HasTheLargestOpacityOfAMaximum)
{
  Scene scene = WallAtThree();
  scene.look.blend = Blend::MaximumIntensity;
  scene.look.opacities = { { -10.0, 0.0 }, { 5.0, 0.8 }, { 10.0, 0.1 } };
  const auto seen = PointSeen(scene, Ramp(false), { -50.0, 1.0, 2.0 }, { 50.0, 1.0, 2.0 });
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[0], 5.0, StepMm);
}

TEST(IsHidden, HoldsBehindASurfaceAndNotOnIt)
{
  const auto image = Ramp(false);
  const auto isHidden = [&](double eyeX, double x) {
    return IsHidden(WallAtThree(), image, { eyeX, 1.0, 2.0 }, { x, 1.0, 2.0 });
  };
  EXPECT_TRUE(isHidden(-50.0, 9.0));
  EXPECT_FALSE(isHidden(-50.0, 4.0)) << "on the surface, which a pick finds only nearly";
  EXPECT_FALSE(isHidden(-50.0, 0.0));
  EXPECT_TRUE(isHidden(50.0, 0.0));
  Scene projection = WallAtThree();
  projection.look.blend = Blend::MaximumIntensity;
  EXPECT_FALSE(IsHidden(projection, image, { -50.0, 1.0, 2.0 }, { 9.0, 1.0, 2.0 }));
}

TEST(ValueAt, IsInterpolatedInsideAndEmptyOutside)
{
  EXPECT_NEAR(ValueAt(Ramp(false), { 2.25, 0.0, 0.0 }).value(), 2.25, 1e-5);
  EXPECT_NEAR(ValueAt(Ramp(true), { 0.0, 2.25, 0.0 }).value(), 2.25, 1e-5);
  EXPECT_FALSE(ValueAt(Ramp(false), { 10.5, 0.0, 0.0 }));
}

TEST(SceneCuts, KeepTheSamePartOfATurnedVolumeWithEveryMapper)
{
  // A quarter of the volume's x range is kept: a quarter of the image's width or height, seen along
  // z.
  Scene scene = WallAtThree();
  scene.look.opacities = { { -10.0, 0.9999 } };
  scene.camera.view = View::Superior;
  scene.camera.parallel = true;
  scene.cuts.box = { 0.5, 0.75, 0.0, 1.0, 0.0, 1.0 };
  for (const bool turned : { false, true })
  {
    for (const MapperKind kind : { MapperKind::Varimarch, MapperKind::VtkGpu, MapperKind::VtkCpu })
    {
      OffscreenView view(scene, Ramp(turned), kind);
      view.Render();
      const vtkSmartPointer<vtkImageData> bytes = view.Bytes();
      int opaque = 0;
      for (int pixel = 0; pixel < 32 * 32; ++pixel)
      {
        const auto* rgb = static_cast<unsigned char*>(bytes->GetScalarPointer()) + 3 * pixel;
        opaque += rgb[0] > 127 ? 1 : 0;
      }
      // A column of pixels at each cut may fall on either side.
      EXPECT_NEAR(opaque, 32 * 8, 32) << turned << " " << int(kind);
    }
  }
}

TEST(SceneCuts, ReachIsThatOfTheCorners)
{
  const auto [first, last] = ReachAlong({ 0.0, 0.0, 3.0 }, Ramp(false));
  EXPECT_NEAR(first, -10.0, 1e-9);
  EXPECT_NEAR(last, 10.0, 1e-9);
  EXPECT_NEAR(ReachAlong({ 1.0, 1.0, 1.0 }, Ramp(true))[1], std::sqrt(300.0), 1e-9);
}

TEST(CutPlane, AtDepthHasThatDepth)
{
  const CutPlane plane = { { 3.0, 7.0, 0.0 }, { 0.0, -2.0, 0.0 } };
  EXPECT_NEAR(DepthOf(plane, Ramp(false)), 0.15, 1e-9) << "3 of the 20 mm from the side it keeps";
  for (const bool turned : { false, true })
  {
    const CutPlane moved = AtDepth(0.75, plane, Ramp(turned));
    EXPECT_NEAR(moved.pointMm[1], -5.0, 1e-9);
    EXPECT_EQ(moved.normal, plane.normal);
    EXPECT_NEAR(DepthOf(moved, Ramp(turned)), 0.75, 1e-9);
  }
  EXPECT_EQ(DepthOf({ { 0.0, 50.0, 0.0 }, { 0.0, 1.0, 0.0 } }, Ramp(false)), 1.0);
}
