// Gradients in a texture: the image of gradients on the fly, with fewer fetches and more memory.

#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkContourValues.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

constexpr const char* StoredPart = "Gradient/Stored.glsl";

// The difference between the images with and without stored gradients.
varimarch::ImageError DifferenceOf(MapperScene& scene)
{
  scene.mapper->StoredGradientsOff();
  const std::vector<float> onTheFly = scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart(StoredPart));
  scene.mapper->StoredGradientsOn();
  const std::vector<float> stored = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart(StoredPart));
  return varimarch::CompareImages(stored.data(), onTheFly.data(), onTheFly.size() / 4);
}

void ShadeAt(MapperScene& scene, double sampleDistanceMm)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(sampleDistanceMm);
}

// The torso as floats around a large offset, which textures take as floats.
vtkSmartPointer<vtkImageData> TorsoOfFloats()
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  auto floats = vtkSmartPointer<vtkImageData>::New();
  floats->CopyStructure(torso);
  floats->AllocateScalars(VTK_FLOAT, 1);
  const auto* const from = static_cast<const short*>(torso->GetScalarPointer());
  std::copy(
    from, from + torso->GetNumberOfPoints(), static_cast<float*>(floats->GetScalarPointer()));
  return floats;
}

}

// The texture rounds differences of one step of the values, which are the smallest, to a thirtieth.
// Only in the noise of nearly transparent matter is that a visible part of a gradient.
constexpr double RoundingOfGradients = 0.1; // RMSE [1/255]

TEST(StoredGradients, MakeTheImageOfGradientsOnTheFly)
{
  MapperScene scene(SmallTorso());
  ShadeAt(scene, 1.0);
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, RoundingOfGradients);
}

TEST(StoredGradients, MakeTheImageOfFloatsToo)
{
  MapperScene scene(TorsoOfFloats());
  ShadeAt(scene, 1.0);
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, RoundingOfGradients);
}

TEST(StoredGradients, MakeTheImageOfVoxelsAsBoxesAndOfSurfaces)
{
  MapperScene scene(SmallTorso());
  ShadeAt(scene, 1.0);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, RoundingOfGradients);
  scene.volume->GetProperty()->SetInterpolationTypeToLinear();
  scene.mapper->SetBlendModeToIsoSurface();
  scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 200.0);
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, RoundingOfGradients);
}

TEST(StoredGradients, MakeTheImageOfAVolumeInBlocks)
{
  MapperScene scene(
    varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 56, 48 }, 7 }), 32);
  ShadeAt(scene, 1.0);
  scene.mapper->SetMaximumGraphicsMemory(300000);
  // Gradients take memory, so that there are more blocks, and segments begin anew in each.
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, 0.5);
  EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl")) << "the volume fits into one block";
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), scene.mapper->GetMaximumGraphicsMemory());
}

TEST(StoredGradients, FollowTheVoxels)
{
  MapperScene scene(SmallTorso());
  ShadeAt(scene, 1.0);
  scene.mapper->StoredGradientsOn();
  scene.Draw();
  auto* const voxels = static_cast<short*>(scene.image->GetScalarPointer());
  std::reverse(voxels, voxels + scene.image->GetNumberOfPoints());
  scene.image->Modified();
  EXPECT_LT(DifferenceOf(scene).rootMeanSquare, RoundingOfGradients);
}

TEST(StoredGradients, TakeOneFetchInsteadOfSix)
{
  MapperScene scene(SmallTorso(), 16);
  ShadeAt(scene, 1.0);
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
  scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  scene.mapper->DrawFetchCountsOn();
  const auto fetches = [&](bool stored)
  {
    scene.mapper->SetStoredGradients(stored);
    return scene.Draw()[4 * (8 * 16 + 8)];
  };
  const float onTheFly = fetches(false);
  const float stored = fetches(true);
  // Only samples that absorb light have gradients.
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  const float samples = fetches(true);
  EXPECT_GT(stored, samples);
  EXPECT_EQ(onTheFly - samples, 6.0f * (stored - samples));
}

TEST(StoredGradients, LeaveNeitherFileNorTextureWhenTheyAreOff)
{
  MapperScene scene(SmallTorso());
  ShadeAt(scene, 1.0);
  scene.Draw();
  const vtkIdType without = scene.mapper->GetGraphicsMemoryBytes();
  EXPECT_FALSE(scene.UsesShaderPart(StoredPart));

  scene.mapper->StoredGradientsOn();
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart(StoredPart));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), without + 6 * scene.image->GetNumberOfPoints());

  scene.volume->GetProperty()->ShadeOff(); // nothing depends on gradients
  scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart(StoredPart));
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), without);

  scene.volume->GetProperty()->ShadeOn();
  scene.Draw();
  scene.mapper->StoredGradientsOff();
  scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart(StoredPart));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), without);
}
