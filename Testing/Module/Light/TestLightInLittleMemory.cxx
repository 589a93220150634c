// Shadows and ambient occlusion of a volume for which the graphics memory has no room at all.

#include "Module/Scenes/ComponentVolumes.h"
#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/UsualSettings.h"

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

void DimLight(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  UseSunAndLamp(scene.renderer);
}

// Packets read the voxels of the caller, so that the image is that of a device with enough memory.
void ExpectSameInLittleMemory(MapperScene& scene)
{
  scene.mapper->SetMaximumGraphicsMemory(0);
  const std::vector<float> whole = scene.DrawByProcessor();
  for (const vtkIdType bytes : { vtkIdType(1), vtkIdType(10000) })
  {
    scene.mapper->SetMaximumGraphicsMemory(bytes);
    EXPECT_EQ(scene.DrawByProcessor(), whole) << bytes;
    EXPECT_TRUE(scene.ShaderParts().empty()) << bytes;
  }
}

void ExpectSameOfAllLight(MapperScene& scene)
{
  DimLight(scene);
  scene.mapper->ShadowsOn();
  ExpectSameInLittleMemory(scene);
  scene.mapper->SetAmbientOcclusion(0.5);
  ExpectSameInLittleMemory(scene);
  scene.mapper->ShadowsOff();
  ExpectSameInLittleMemory(scene);
}

}

TEST(LightInLittleMemory, OfAVolumeIsThatOfMuch)
{
  LabelledTorso torso(16);
  torso.scene.mapper->SetMaskInput(nullptr);
  ExpectSameOfAllLight(torso.scene);
}

TEST(LightInLittleMemory, OfLabelsIsThatOfMuch)
{
  LabelledTorso torso(16);
  ExpectSameOfAllLight(torso.scene);
}

TEST(LightInLittleMemory, OfBoxesIsThatOfMuch)
{
  LabelledTorso torso(16);
  torso.scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  ExpectSameOfAllLight(torso.scene);
}

TEST(LightInLittleMemory, OfComponentsIsThatOfMuch)
{
  const auto values = [](glm::ivec3 voxel, int component)
  { return component == 0 ? 100.0 * voxel.x : 120.0 * voxel.y; };
  MapperScene scene(ImageOf(VTK_SHORT, 2, values), 16);
  SetLook(scene.volume->GetProperty(), 0, { { 0.9, 0.4, 0.2 }, 100.0, 800.0, 0.3 });
  SetLook(scene.volume->GetProperty(), 1, { { 0.2, 0.5, 0.9 }, 200.0, 840.0, 0.4 });
  scene.volume->GetProperty()->ShadeOn(1);
  ExpectSameOfAllLight(scene);
}
