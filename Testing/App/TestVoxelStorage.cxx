// The storages of voxels that the benchmarks compare: each makes the image of the volume that it
// stores.

#include "App/ComparedScene.h"
#include "Scene/Reference/ReferencePicture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace varimarch;

namespace
{

// Slices that fill neither the last texel of four voxels nor the last word.
constexpr std::array<int, 3> Size = { 24, 22, 37 };
constexpr std::size_t Voxels = 24 * 22 * 37;

// The volume with each voxel rounded to the nearest of equally distant levels.
vtkSmartPointer<vtkImageData> Rounded(vtkImageData* volume, int largestLevel)
{
  auto rounded = vtkSmartPointer<vtkImageData>::New();
  rounded->CopyStructure(volume);
  rounded->AllocateScalars(VTK_FLOAT, 1);
  const double* const range = volume->GetScalarRange();
  const double width = range[1] - range[0];
  const auto* const voxels = static_cast<const short*>(volume->GetScalarPointer());
  auto* const values = static_cast<float*>(rounded->GetScalarPointer());
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const double level = std::round((voxels[i] - range[0]) / width * largestLevel);
    values[i] = float(range[0] + level / largestLevel * width);
  }
  return rounded;
}

Pixels DrawnAs(VoxelStorage storage, const Scene& settings, vtkImageData* volume)
{
  ComparedScene scene(settings, volume);
  scene.mapper->SetStorage(storage);
  scene.mapper->SetSampleDistance(0.5);
  scene.mapper->SetStepsPerPass(10000);
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
  return scene.Draw(vtkComparisonMapper::Passes);
}

double BytesOf(VoxelStorage storage)
{
  ComparedScene scene(SoftScene(false), Torso(Size));
  scene.mapper->SetStorage(storage);
  scene.Draw(vtkComparisonMapper::ViewSlices);
  return scene.mapper->GetGraphicsMemoryBytes();
}

class VoxelStorages : public testing::TestWithParam<VoxelStorage>
{
};

}

TEST_P(VoxelStorages, MakeTheReferenceImageOfTheRoundedVoxels)
{
  const Scene settings = SoftScene(false);
  const auto volume = Torso(Size);
  const auto rounded = Rounded(volume, LargestStoredLevel(GetParam()));
  const std::optional<ReferencePicture> truth = DrawReferencePicture(settings, rounded, 1e-5);
  const Pixels expected = PixelsOf(truth.value().image);
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.3f) << "nothing to compare";
  // The error of steps of half a millimetre, through voxels of several.
  EXPECT_LT(Difference(DrawnAs(GetParam(), settings, volume), expected).largest, 0.5);
}

TEST_P(VoxelStorages, DifferFromSixteenBitsOfTheRoundedVoxelsByRoundingOnly)
{
  for (const bool shaded : { false, true })
  {
    const Scene settings = SoftScene(shaded);
    const auto volume = Torso(Size);
    const Pixels expected =
      DrawnAs(VoxelStorage::Bits16, settings, Rounded(volume, LargestStoredLevel(GetParam())));
    // 16 bits round the levels of fewer bits, and normals depend on small differences.
    EXPECT_LT(
      Difference(DrawnAs(GetParam(), settings, volume), expected).largest, shaded ? 0.5 : 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(All, VoxelStorages,
  testing::Values(VoxelStorage::Bits16, VoxelStorage::Bits8, VoxelStorage::FourInTexel,
    VoxelStorage::FourInTexel4, VoxelStorage::Bits6, VoxelStorage::Bit1, VoxelStorage::Slices2D));

TEST(VoxelStorage, TakesTheMemoryOfItsBits)
{
  const double look = BytesOf(VoxelStorage::Bits16) - 2.0 * Voxels;
  EXPECT_EQ(BytesOf(VoxelStorage::Bits8) - look, Voxels);
  EXPECT_EQ(BytesOf(VoxelStorage::FourInTexel) - look, 24 * 22 * 10 * 4);
  EXPECT_EQ(BytesOf(VoxelStorage::Bits6) - look, 24 * 22 * 8 * 4);
  EXPECT_EQ(BytesOf(VoxelStorage::Bit1) - look, 24 * 22 * 2 * 4);
  EXPECT_EQ(BytesOf(VoxelStorage::Slices2D) - look, 6 * 24 * 7 * 22 * 2);
  // A device may keep 4 bits in more.
  EXPECT_LE(BytesOf(VoxelStorage::FourInTexel4) - look, 24 * 22 * 10 * 4);
}
