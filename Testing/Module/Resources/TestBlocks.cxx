// A volume rendered in blocks: the image of the whole, within the allowed memory.

#include "Module/Scenes/MapperScene.h"
#include "Resources/VolumeTexture.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"
#include "VtkVersions.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

constexpr int BlocksSize = 64;
// The image and its tables take half of the smaller limit; the volume has 344064 bytes.
constexpr vtkIdType FewBlocks = 340000;
constexpr vtkIdType ManyBlocks = 200000;

vtkSmartPointer<vtkImageData> Torso()
{
  return ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 7 });
}

bool IsDrawnInBlocks(MapperScene& scene)
{
  return scene.UsesShaderPart("Resume/Block.glsl");
}

ImageError Difference(const std::vector<float>& drawn, const std::vector<float>& expected)
{
  return CompareImages(drawn.data(), expected.data(), expected.size() / 4);
}

// Difference between the images in blocks and of the whole.
ImageError DifferenceInBlocks(MapperScene& scene, vtkIdType memory)
{
  scene.mapper->SetMaximumGraphicsMemory(0);
  const std::vector<float> whole = scene.Draw();
  EXPECT_FALSE(IsDrawnInBlocks(scene));
  scene.mapper->SetMaximumGraphicsMemory(memory);
  const std::vector<float> inBlocks = scene.Draw();
  EXPECT_TRUE(IsDrawnInBlocks(scene));
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), memory);
  EXPECT_GT(*std::max_element(whole.begin(), whole.end()), 0.02f) << "nothing is visible";
  return Difference(inBlocks, whole);
}

// Uses short steps and gentle materials, so that the error of the integral is too small to matter.
void UseFineSteps(MapperScene& scene, double mostOpacity)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(-1100.0, 0.9, 0.3, 0.2);
  scene.colors->AddRGBPoint(1100.0, 0.3, 0.9, 0.8);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1100.0, 0.001);
  scene.opacities->AddPoint(1100.0, mostOpacity);
  scene.mapper->AutoAdjustSampleDistancesOff();
  const double* const spacing = scene.image->GetSpacing();
  scene.mapper->SetSampleDistance(std::min({ spacing[0], spacing[1], spacing[2] }) / 24.0);
  scene.mapper->SetEarlyTerminationTransmittance(1e-4);
}

void LookObliquely(MapperScene&) {}

void LookAlongAnAxis(MapperScene& scene)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  scene.renderer->ResetCamera();
}

void LookFromWithin(MapperScene& scene)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  const double* const center = scene.volume->GetCenter();
  camera->SetPosition(center[0] + 10.0, center[1] + 3.0, center[2]);
  camera->SetFocalPoint(center[0] - 20.0, center[1] - 10.0, center[2] + 4.0);
  camera->SetViewAngle(80.0);
  camera->SetClippingRange(0.1, 1000.0);
}

struct CameraView
{
  const char* name;
  void (*look)(MapperScene&);
};

struct VolumeLook
{
  const char* name;
  int blendMode;
  bool shade;
  double mostOpacity; ///< opacity of a voxel
  double limit;       ///< largest difference [1/255]
};

std::ostream& operator<<(std::ostream& stream, const CameraView& view)
{
  return stream << view.name;
}

std::ostream& operator<<(std::ostream& stream, const VolumeLook& look)
{
  return stream << look.name;
}

class BlocksOf : public testing::TestWithParam<std::tuple<CameraView, VolumeLook>>
{
};

}

// Sample positions start anew at the faces of blocks, so images differ by the error of the
// integral. A plane of cells lost or rendered twice would cost more than 1/255.
TEST_P(BlocksOf, MakeThePictureOfTheWhole)
{
  const auto& [view, look] = GetParam();
  MapperScene scene(Torso(), BlocksSize);
  view.look(scene);
  scene.mapper->SetBlendMode(look.blendMode);
  scene.volume->GetProperty()->SetShade(look.shade);
  UseFineSteps(scene, look.mostOpacity);
  for (vtkIdType memory : { FewBlocks, ManyBlocks })
  {
    EXPECT_LT(DifferenceInBlocks(scene, memory).largest, look.limit);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryViewAndLook, BlocksOf,
  testing::Combine(testing::Values(CameraView{ "oblique", LookObliquely },
                     CameraView{ "axis", LookAlongAnAxis }, CameraView{ "within", LookFromWithin }),
    testing::Values(VolumeLook{ "unshaded", vtkVolumeMapper::COMPOSITE_BLEND, false, 0.02, 0.02 },
      // Normals change quickly where the gradient is small.
      VolumeLook{ "shaded", vtkVolumeMapper::COMPOSITE_BLEND, true, 0.02, 0.2 },
      VolumeLook{ "maximum", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, false, 0.9, 0.1 },
      VolumeLook{ "minimum", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, false, 0.9, 0.1 },
      VolumeLook{ "average", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, false, 0.02, 0.02 },
      VolumeLook{ "additive", vtkVolumeMapper::ADDITIVE_BLEND, false, 0.02, 0.02 })));

class BlocksWithFields : public testing::TestWithParam<int>
{
};

TEST_P(BlocksWithFields, MakeThePictureOfTheWhole)
{
  MapperScene scene(Torso(), BlocksSize);
  UseFineSteps(scene, 0.02);
  scene.mapper->SetAccelerationMode(GetParam());
  scene.mapper->SetVariationTolerance(0.0);
  EXPECT_LT(DifferenceInBlocks(scene, FewBlocks).largest, 0.02);
}

INSTANTIATE_TEST_SUITE_P(EveryField, BlocksWithFields,
  testing::Values(vtkVariationFieldVolumeMapper::Off + 0,
    vtkVariationFieldVolumeMapper::CellField + 0, vtkVariationFieldVolumeMapper::OpticalField + 0));

// A homogeneous volume is integrated exactly with any steps, so nothing hides a seam. Rays run
// along the faces of blocks and in them, one pixel per voxel.
TEST(BlockFaces, AreMarchedOnceByRaysThatRunInThem)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(65, 65, 49);
  image->AllocateScalars(VTK_SHORT, 1);
  image->GetPointData()->GetScalars()->Fill(100.0);
  static_cast<short*>(image->GetScalarPointer())[0] = 0; // gives the mean a range of values
  MapperScene scene(image, BlocksSize);
  LookAlongAnAxis(scene);
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetParallelScale(32.0);
  scene.renderer->ResetCameraClippingRange();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(100.0, 0.01);
  for (int blendMode : { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    scene.mapper->SetBlendMode(blendMode);
    // Rays in the faces, and closer to them than a rasterizer can resolve.
    for (double x : { 32.5, 32.499, 32.501 })
    {
      camera->SetPosition(x, -100.0, 24.5);
      camera->SetFocalPoint(x, 32.0, 24.5);
      EXPECT_LT(DifferenceInBlocks(scene, ManyBlocks).largest, 0.01) << x;
    }
  }
}

TEST(BlockFaces, BesideVoxelsThatAreNotFiniteLookAsInTheWhole)
{
  const vtkSmartPointer<vtkImageData> torso = Torso();
  vtkNew<vtkImageData> image;
  image->CopyStructure(torso);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const voxels = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    // Gaps on every twelfth plane along x: on faces of blocks and next to them.
    const bool isFinite = i % 12 > 1 || i / 64 % 7 > 3;
    voxels[i] = isFinite ? float(torso->GetPointData()->GetScalars()->GetComponent(i, 0))
                         : std::numeric_limits<float>::quiet_NaN();
  }
  MapperScene scene(image, BlocksSize);
  UseFineSteps(scene, 0.02);
  scene.mapper->SetSampleDistance(3.0 * scene.mapper->GetSampleDistance());
  scene.mapper->SetNanOpacity(0.02);
  EXPECT_LT(DifferenceInBlocks(scene, 600000).largest, 0.02);
  // Light ends abruptly beside a gap, which every step blurs by its length.
  scene.volume->GetProperty()->ShadeOn();
  EXPECT_LT(DifferenceInBlocks(scene, 600000).largest, 2.5);
}

TEST(Blocks, EndAtGeometryAndKeepToTheirViewport)
{
  MapperScene scene(Torso(), BlocksSize);
  UseFineSteps(scene, 0.02);
  scene.renderer->AddActor(Ball(scene.volume->GetCenter(), 0.3 * scene.volume->GetLength()));
  EXPECT_LT(DifferenceInBlocks(scene, FewBlocks).largest, 0.02);
  scene.renderer->SetViewport(0.25, 0.5, 0.75, 1.0);
  EXPECT_LT(DifferenceInBlocks(scene, FewBlocks).largest, 0.02);
}

TEST(Blocks, KeepAnErrorTolerance)
{
  MapperScene scene(Torso(), BlocksSize);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetMaximumGraphicsMemory(FewBlocks);
  const ImageError error = scene.Error();
  EXPECT_TRUE(IsDrawnInBlocks(scene));
  EXPECT_LT(error.percentile999, 255.0 / 64.0);
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), FewBlocks);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 1);
}

TEST(Blocks, OfCellsMakeThePictureOfTheWhole)
{
  const vtkSmartPointer<vtkImageData> points = Torso();
  vtkNew<vtkImageData> cells;
  cells->SetDimensions(65, 57, 49);
  cells->SetSpacing(points->GetSpacing());
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  MapperScene scene(cells, BlocksSize);
  UseFineSteps(scene, 0.03);
  EXPECT_LT(DifferenceInBlocks(scene, FewBlocks).largest, 0.5);
}

namespace
{

int UploadsBy(MapperScene& scene)
{
  const int before = scene.mapper->GetBlockUploads();
  scene.window->Render();
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), scene.mapper->GetMaximumGraphicsMemory());
  return scene.mapper->GetBlockUploads() - before;
}

}

TEST(BlockMemory, BlocksThatShowNothingAreNotUploadedAndOthersOnce)
{
  MapperScene scene(Torso(), BlocksSize);
  scene.mapper->SetMaximumGraphicsMemory(FewBlocks);
  const int all = UploadsBy(scene);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(500.0, 0.0);
  scene.opacities->AddPoint(600.0, 0.5);
  UploadsBy(scene);
  scene.mapper->ReleaseGraphicsResources(scene.window);
  const int ofBone = UploadsBy(scene);
  EXPECT_LT(ofBone, all);
  EXPECT_GT(ofBone, 0);
  EXPECT_EQ(UploadsBy(scene), 0);

  scene.image->GetPointData()->GetScalars()->Modified();
  EXPECT_EQ(UploadsBy(scene), ofBone);

  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(500.0, 0.0);
  scene.mapper->ReleaseGraphicsResources(scene.window);
  EXPECT_EQ(UploadsBy(scene), 0);
}

TEST(BlockMemory, BlocksOutOfViewAreNotUploaded)
{
  MapperScene scene(Torso(), BlocksSize);
  scene.mapper->SetMaximumGraphicsMemory(FewBlocks);
  const int all = UploadsBy(scene);
  scene.mapper->ReleaseGraphicsResources(scene.window);
  scene.renderer->GetActiveCamera()->Zoom(5.0);
  EXPECT_LT(UploadsBy(scene), all);
}

TEST(BlockMemory, BlocksThatDoNotFitAreUploadedWhenNeeded)
{
  MapperScene scene(Torso(), BlocksSize);
  UseFineSteps(scene, 0.02); // everything is visible
  scene.mapper->SetMaximumGraphicsMemory(FewBlocks);
  const int all = UploadsBy(scene);
  const int again = UploadsBy(scene);
  EXPECT_GT(again, 0);
  EXPECT_LT(again, all);
  EXPECT_GT(scene.mapper->GetGraphicsMemoryBytes(), 3 * FewBlocks / 4);
}

TEST(BlockMemory, AVolumeThatFitsKeepsNoBlocks)
{
  MapperScene scene(Torso(), BlocksSize);
  scene.window->Render();
  const vtkIdType whole = scene.mapper->GetGraphicsMemoryBytes();
  scene.mapper->SetMaximumGraphicsMemory(whole - 1);
  scene.window->Render();
  EXPECT_TRUE(IsDrawnInBlocks(scene));
  scene.mapper->SetMaximumGraphicsMemory(whole);
  scene.window->Render();
  EXPECT_FALSE(IsDrawnInBlocks(scene));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), whole);
}

TEST(BlockMemory, AnEditShows)
{
  MapperScene scene(Torso(), BlocksSize);
  UseFineSteps(scene, 0.02);
  scene.mapper->SetMaximumGraphicsMemory(FewBlocks);
  scene.Draw();
  vtkDataArray* const scalars = scene.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples() / 2; ++i)
  {
    scalars->SetComponent(i, 0, 400.0);
  }
  scalars->Modified();
  const std::vector<float> inBlocks = scene.Draw();
  scene.mapper->SetMaximumGraphicsMemory(0);
  EXPECT_LT(Difference(inBlocks, scene.Draw()).largest, 0.02);
}

TEST(BlockMemory, TooLittleForAnyBlockIsNamed)
{
  MapperScene scene(Torso(), BlocksSize);
  scene.mapper->SetMaximumGraphicsMemory(100000);
  ExpectedVtkErrors errors;
  scene.window->Render();
  EXPECT_NE(errors.Text().find("Cannot draw in a maximum graphics memory of 100000 bytes: this "
                               "image of the volume needs at least 15"),
    std::string::npos)
    << errors.Text();
}

TEST(Blocks, HoldAVolumeLongerThanTheDevicesTextures)
{
  MapperScene scene(SmallTorso(), BlocksSize);
  scene.window->Render();
  GLint longestSide = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longestSide);
  vtkNew<vtkImageData> bar;
  bar->SetDimensions(longestSide + 100, 9, 9);
  bar->SetSpacing(9.0 / longestSide, 1.0, 1.0);
  bar->AllocateScalars(VTK_SHORT, 1);
  auto* const voxels = static_cast<short*>(bar->GetScalarPointer());
  for (vtkIdType i = 0; i < bar->GetNumberOfPoints(); ++i)
  {
    voxels[i] = short(300.0 + 200.0 * std::sin(double(i % (longestSide + 100)) / 100.0));
  }
  scene.image = bar;
  scene.mapper->SetInputData(bar);
  scene.renderer->ResetCamera();
  EXPECT_LT(scene.Error().largest, 1.0);
  EXPECT_TRUE(IsDrawnInBlocks(scene));
}

TEST(Blocks, AreOfSizesThatTheDeviceHasTexturesFor)
{
  MapperScene scene(SmallTorso(), BlocksSize);
  scene.window->Render();
  GLint longestSide = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longestSide);
  const TexelFormat format = TexelFormat::Integers16;
  EXPECT_EQ(VolumeTexture::MostTexels({ 64, 56, 48 }, 1, format), 64u * 56u * 48u);
  const std::size_t most = VolumeTexture::MostTexels(glm::ivec3(longestSide), 1, format);
  EXPECT_GE(most, 64u * 56u * 48u);
  EXPECT_LT(double(most), std::pow(longestSide, 3.0)) << "more than any device's memory";
}
