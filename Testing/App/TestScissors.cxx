// Scissors: the part that an outline removes, in masks, in images and in picking.

#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Pipeline/ScenePicking.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> Cube(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double half = 0.5 * (side - 1);
  image->SetDimensions(side, side, side);
  image->SetOrigin(-half, -half, -half);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const values = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(values, image->GetNumberOfPoints(), 200);
  return image;
}

// A camera in front of the patient, 100 mm away: x to the right, z upwards.
ScissorsCut FromTheFront(bool parallel)
{
  ScissorsCut cut;
  cut.camera.parallel = parallel;
  cut.camera.viewAngleDegrees = 90.0;
  cut.camera.pose = CameraPose{ { 0, -100, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 10.0 };
  return cut;
}

bool IsLeft(vtkImageData* mask, int x, int y, int z)
{
  return mask->GetScalarComponentAsDouble(x, y, z, 0) != 0.0;
}

}

TEST(Scissors, CutAPrismInAParallelPicture)
{
  ScissorsCut cut = FromTheFront(true);
  // Half the height of the image is 10 mm: x from 2 to 5 mm, z from -3 to 4 mm.
  cut.outline = { { 0.2, -0.3 }, { 0.5, -0.3 }, { 0.5, 0.4 }, { 0.2, 0.4 } };
  const auto image = Cube(21);
  const auto mask = MaskOf({ cut }, image);
  for (int z = 0; z < 21; ++z)
  {
    for (int x = 0; x < 21; ++x)
    {
      const bool isIn = x - 10 > 2 && x - 10 < 5 && z - 10 > -3 && z - 10 < 4;
      const bool isOut = x - 10 < 2 || x - 10 > 5 || z - 10 < -3 || z - 10 > 4;
      for (const int y : { 0, 10, 20 })
      {
        EXPECT_FALSE(isIn && IsLeft(mask, x, y, z)) << x << ' ' << y << ' ' << z;
        EXPECT_TRUE(!isOut || IsLeft(mask, x, y, z)) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(Scissors, CutAConeInAPerspectivePicture)
{
  ScissorsCut cut = FromTheFront(false);
  // At the centre of the volume, half the height of the image is 100 mm: x from 4.25 to 6 mm. 10 mm
  // nearer to the eye, x is smaller by a tenth.
  cut.outline = { { 0.0425, -1.0 }, { 0.06, -1.0 }, { 0.06, 1.0 }, { 0.0425, 1.0 } };
  const auto mask = MaskOf({ cut }, Cube(21));
  EXPECT_TRUE(IsLeft(mask, 14, 10, 10));
  EXPECT_FALSE(IsLeft(mask, 15, 10, 10));
  EXPECT_FALSE(IsLeft(mask, 14, 0, 10)) << "nearer to the eye, 90 mm away";
  EXPECT_TRUE(IsLeft(mask, 16, 0, 10));
}

TEST(Scissors, KeepTheInsideAndAddUp)
{
  ScissorsCut keep = FromTheFront(true);
  keep.keepsInside = true;
  keep.outline = { { -0.55, -2.0 }, { 0.55, -2.0 }, { 0.55, 2.0 }, { -0.55, 2.0 } };
  ScissorsCut cut = FromTheFront(true);
  cut.outline = { { -2.0, 0.05 }, { 2.0, 0.05 }, { 2.0, 2.0 }, { -2.0, 2.0 } };
  const auto mask = MaskOf({ keep, cut }, Cube(21));
  EXPECT_TRUE(IsLeft(mask, 10, 3, 10));
  EXPECT_FALSE(IsLeft(mask, 17, 3, 10)) << "outside the kept part";
  EXPECT_FALSE(IsLeft(mask, 10, 3, 11)) << "cut out";
  EXPECT_FALSE(MaskOf({}, Cube(3))) << "no mask without cuts";
}

TEST(Scissors, HaveACoarserMaskForALargeVolume)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(601, 300, 300); // no voxels are allocated, since a mask does not need them
  ScissorsCut cut = FromTheFront(true);
  cut.outline = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 } };
  const auto mask = MaskOf({ cut }, image);
  EXPECT_EQ(mask->GetDimensions()[0], 301);
  EXPECT_EQ(mask->GetDimensions()[2], 150);
}

TEST(Scissors, CutInThePicturesOfBothGpuMappers)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 0.0, 1.0 } };
  scene.look.shading.enabled = false;
  scene.camera.parallel = true;
  scene.camera.pose = FromTheFront(true).camera.pose;
  scene.size = { 64, 64 };
  ScissorsCut cut = FromTheFront(true);
  cut.outline = { { 0.02, -2.0 }, { 2.0, -2.0 }, { 2.0, 2.0 }, { 0.02, 2.0 } };
  scene.cuts.scissors = { cut };
  // Include a volume with a reversed third axis, which VTK's mapper gets flipped.
  for (const double third : { 1.0, -1.0 })
  {
    const auto image = Cube(21);
    image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, third);
    image->SetOrigin(-10, -10, -10 * third);
    for (const MapperKind kind : { MapperKind::Varimarch, MapperKind::VtkGpu })
    {
      OffscreenView view(scene, image, kind);
      view.Render();
      const auto picture = view.Bytes();
      EXPECT_GT(picture->GetScalarComponentAsDouble(20, 32, 0, 0), 200.0);
      EXPECT_EQ(picture->GetScalarComponentAsDouble(44, 32, 0, 0), 0.0);
    }
  }
}

TEST(Scissors, RemoveThePartFromPicking)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 0.0, 0.9 } };
  ScissorsCut cut = FromTheFront(true);
  cut.outline = { { 0.0, -2.0 }, { 2.0, -2.0 }, { 2.0, 2.0 }, { 0.0, 2.0 } };
  const auto image = Cube(21);
  const auto mask = MaskOf({ cut }, image);
  EXPECT_TRUE(PointSeen(scene, image, { -4, -50, 0 }, { -4, 50, 0 }, mask));
  EXPECT_FALSE(PointSeen(scene, image, { 4, -50, 0 }, { 4, 50, 0 }, mask));
}
