// Voxels that fit into 8 bits take 8 bits on the device if it filters them exactly.

#include "Module/Scenes/ComponentVolumes.h"

#include "March/Device/GraphicsDriver.h"
#include "Resources/VolumeTexture.h"

#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr int Side = 12;

// Values of all 8 bits that change much from voxel to voxel, out to the faces of the volume.
double RoughValue(glm::ivec3 voxel, int component)
{
  return (voxel.x * 37 + voxel.y * 91 + voxel.z * 151 + component * 53) % 256;
}

vtkSmartPointer<vtkImageData> RoughVolume(int type, int components, double scale = 1.0)
{
  return ImageOf(
    type, components,
    [&](glm::ivec3 voxel, int component) { return scale * RoughValue(voxel, component); },
    glm::ivec3(Side));
}

// The image of such a volume. Values count in units of `scale`.
std::vector<float> DrawnRough(int type, int components, bool shaded, double scale = 1.0)
{
  MapperScene scene(RoughVolume(type, components, scale), 48);
  scene.mapper->SetAccelerationModeToOff();
  for (int component = 0; component < components; ++component)
  {
    SetLook(scene.volume->GetProperty(), component,
      { { 0.2 + 0.2 * component, 0.9, 0.4 }, 40.0 * scale, 255.0 * scale, 0.3 });
  }
  scene.volume->GetProperty()->SetShade(shaded);
  return scene.Draw();
}

std::vector<ScalarTexels> TexelsOf(vtkDataArray* voxels)
{
  return ScalarTexelsOf({ { voxels, 0 } });
}

}

// The differences along the edges of a volume need the voxels beyond them, as floats have them.
TEST(Texels, OfEightBitsMakeTheImageOfFloats)
{
  for (const bool shaded : { false, true })
  {
    for (int components = 1; components <= 4; ++components)
    {
      SCOPED_TRACE(testing::Message() << components << " components, shaded " << shaded);
      const std::vector<float> bytes = DrawnRough(VTK_UNSIGNED_CHAR, components, shaded);
      const std::vector<float> floats = DrawnRough(VTK_FLOAT, components, shaded);
      EXPECT_GT(*std::max_element(floats.begin(), floats.end()), 0.2f) << "nothing to compare";
      // Filters and tables round to parts of 2^-16 of the values.
      EXPECT_LT(CompareImages(bytes.data(), floats.data(), bytes.size() / 4).largest, 0.1);
    }
  }
}

TEST(Texels, TakeAByteForEachComponentThatFits)
{
  const auto bytesOf = [](int type, double scale)
  {
    MapperScene scene(RoughVolume(type, 1, scale), 16);
    scene.mapper->SetAccelerationModeToOff();
    scene.Draw();
    return scene.mapper->GetGraphicsMemoryBytes();
  };
  MapperScene scene(RoughVolume(VTK_UNSIGNED_CHAR, 1), 16);
  scene.Draw();
  const bool isExact = Filters8BitsExactly(scene.window);
  const vtkIdType voxels = Side * Side * Side;
  EXPECT_EQ(bytesOf(VTK_SHORT, 100.0) - bytesOf(VTK_SHORT, 1.0), isExact ? voxels : 0);
  EXPECT_EQ(bytesOf(VTK_SHORT, 100.0) - bytesOf(VTK_UNSIGNED_CHAR, 1.0), isExact ? voxels : 0);
}

TEST(Texels, AreFilteredExactlyInEightBitsByLlvmpipe)
{
  MapperScene scene(RoughVolume(VTK_UNSIGNED_CHAR, 1), 16);
  scene.Draw();
  const std::string device = scene.window->ReportCapabilities();
  if (device.find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "another device may filter as it likes";
  }
  EXPECT_LT(LargestNarrowDifference(scene.window), 1e-6);
}

TEST(Texels, AreFilteredWithExactWeightsByLlvmpipe)
{
  MapperScene scene(RoughVolume(VTK_UNSIGNED_CHAR, 1), 16);
  scene.Draw();
  const std::string device = scene.window->ReportCapabilities();
  if (device.find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "graphics cards round weights";
  }
  EXPECT_LT(LargestWeightDifference(scene.window), 1e-4);
}

TEST(Texels, AreReadOneByOneWhereTheDeviceRoundsWeights)
{
  MapperScene scene(RoughVolume(VTK_UNSIGNED_CHAR, 1), 16);
  scene.mapper->ProcessorMarchingOff();
  scene.Draw();
  const bool isExact = FiltersBetweenTexelsExactly(scene.window);
  EXPECT_EQ(scene.UsesShaderPart("Filter/OfTexels.glsl"), !isExact);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart("Filter/OfTexels.glsl")) << "boxes have no weights";
}

TEST(Texels, AreNarrowOnlyWhereThatIsExact)
{
  vtkNew<vtkUnsignedShortArray> narrow;
  vtkNew<vtkUnsignedShortArray> wide;
  for (const unsigned short voxel : { 1000, 1100, 1255 })
  {
    narrow->InsertNextValue(voxel);
    wide->InsertNextValue(voxel);
  }
  wide->InsertNextValue(1256);
  EXPECT_EQ(TexelFormatOf(TexelsOf(narrow), true), TexelFormat::Integers8);
  EXPECT_EQ(TexelFormatOf(TexelsOf(narrow), false), TexelFormat::Integers16);
  EXPECT_EQ(TexelFormatOf(TexelsOf(wide), true), TexelFormat::Integers16);
  const TexelMapping mapping = TexelsOf(narrow).front().mapping;
  for (const double voxel : { 1000.0, 1100.0, 1255.0 })
  {
    const double texel = 255.0 * mapping.TexelOf(voxel);
    EXPECT_EQ(texel, std::round(texel)) << "a voxel between two texels";
  }
}
