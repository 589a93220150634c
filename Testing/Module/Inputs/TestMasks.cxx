// Masks decide which voxels are visible, and with which functions. A voxel of a mask fills the cube
// around it, so the length of a ray within a label is known exactly.

#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/ReferenceMaterials.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace varimarch;

namespace
{

// A white block of 9 x 9 x 33 voxels of value 50 in a range of 0 to 100, seen along its z axis,
// with an opacity of 0.05 per unit distance.
class Block
{
public:
  Block()
    : scene(Values(), 9)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, 0.05);
    vtkCamera* camera = this->scene.renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.4);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetFocalPoint(4.0, 4.0, 0.0);
    camera->SetPosition(4.0, 4.0, 300.0);
    camera->SetClippingRange(1.0, 1000.0);
  }

  void SetMask(const Labels& labels, bool binary = false)
  {
    this->scene.mapper->SetMaskInput(MaskOf({ 9, 9, 33 }, labels));
    this->scene.mapper->SetMaskType(binary ? 0 : 1);
  }

  MapperScene scene;

private:
  static vtkSmartPointer<vtkImageData> Values()
  {
    const auto image = MaskOf(
      { 9, 9, 33 }, [](glm::ivec3 voxel) { return voxel.x == 0 ? 100 * (voxel.y % 2) : 50; },
      VTK_SHORT); // a type that packets of rays support
    return image;
  }
};

vtkSmartPointer<vtkPiecewiseFunction> Constant(double value)
{
  const auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AddPoint(0.0, value);
  return function;
}

}

TEST(BinaryMask, EndsHalfWayBetweenVoxels)
{
  Block block;
  // Voxels 10 to 19 and voxel 25: ten unit distances and one.
  block.SetMask([](glm::ivec3 voxel)
    { return (voxel.z >= 10 && voxel.z < 20) || voxel.z == 25 ? 255 : 0; },
    true);
  for (const bool coarse : { false, true })
  {
    block.scene.mapper->SetAutoAdjustSampleDistances(!coarse);
    block.scene.mapper->SetSampleDistance(4.0);
    EXPECT_NEAR(block.scene.MiddlePixel()[3], 1.0 - std::pow(0.95, 11.0), HalfByteStep);
  }
  // Only the half of the first voxel that lies inside the volume.
  block.SetMask([](glm::ivec3 voxel) { return voxel.z == 0 ? 1 : 0; }, true);
  EXPECT_NEAR(block.scene.MiddlePixel()[3], 1.0 - std::pow(0.95, 0.5), HalfByteStep);
  block.SetMask([](glm::ivec3) { return 0; }, true);
  EXPECT_EQ(block.scene.MiddlePixel()[3], 0.0f);
}

TEST(BinaryMask, ConfinesEveryBlendMode)
{
  const auto torso = SmallTorso();
  MapperScene scene(torso, 48);
  scene.opacities->AddPoint(-1100.0, 0.3);
  for (int blend : { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
         vtkVolumeMapper::ADDITIVE_BLEND })
  {
    scene.mapper->SetBlendMode(blend);
    scene.mapper->SetMaskInput(nullptr);
    const std::vector<float> whole = scene.Draw();
    scene.mapper->SetMaskTypeToBinary();
    scene.mapper->SetMaskInput(MaskOf({ 40, 36, 24 }, [](glm::ivec3) { return 1; }));
    EXPECT_LT(CompareImages(whole.data(), scene.Draw().data(), 48 * 48).largest, 2.0) << blend;
    scene.mapper->SetMaskInput(
      MaskOf({ 40, 36, 24 }, [](glm::ivec3 voxel) { return voxel.x < 20 ? 1 : 0; }));
    EXPECT_GT(CompareImages(whole.data(), scene.Draw().data(), 48 * 48).largest, 20.0) << blend;
  }
}

TEST(BinaryMask, MayHaveAnotherResolutionInTheSameBox)
{
  Block block;
  block.scene.mapper->SetMaskTypeToBinary();
  block.scene.mapper->SetMaskInput(MaskOf(
    { 3, 3, 11 }, [](glm::ivec3 voxel) { return voxel.z >= 2 && voxel.z < 5 ? 1 : 0; },
    VTK_UNSIGNED_CHAR));
  EXPECT_NEAR(block.scene.MiddlePixel()[3], 1.0 - std::pow(0.95, 9.0), HalfByteStep);
}

TEST(LabelMap, OpacityIsThatOfAUnitDistanceWhateverTheStep)
{
  Block block;
  vtkVolumeProperty* property = block.scene.volume->GetProperty();
  // Labels may have any value.
  property->SetLabelScalarOpacity(70000, Constant(0.2));
  property->SetLabelScalarOpacity(-3, Constant(0.0));
  block.SetMask(
    [](glm::ivec3 voxel) {
      return voxel.z >= 20 ? 70000 : voxel.z >= 10 ? -3 : voxel.z == 5 ? 12 : 0;
    });
  const double expected = 1.0 - std::pow(0.8, 12.5) * std::pow(0.95, 9.5);
  for (const double sampleDistance : { 4.0, 1.0, 0.25 })
  {
    block.scene.mapper->AutoAdjustSampleDistancesOff();
    block.scene.mapper->SetSampleDistance(sampleDistance);
    EXPECT_NEAR(block.scene.MiddlePixel()[3], expected, HalfByteStep) << sampleDistance;
  }
}

TEST(LabelMap, ColoursApplyOnlyToLabelledVoxels)
{
  Block block;
  vtkVolumeProperty* property = block.scene.volume->GetProperty();
  vtkNew<vtkColorTransferFunction> red;
  red->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  property->SetLabelColor(1, red);
  block.SetMask([](glm::ivec3 voxel) { return voxel.z >= 28 ? 1 : 0; });
  const double inFront = 1.0 - std::pow(0.95, 4.5);
  const double all = 1.0 - std::pow(0.95, 32.0);
  EXPECT_NEAR(block.scene.MiddlePixel()[0], all, HalfByteStep);
  EXPECT_NEAR(block.scene.MiddlePixel()[1], all - inFront, HalfByteStep);
  // Half of the label's colour and half of the colour without labels.
  block.scene.mapper->SetMaskBlendFactor(0.5);
  EXPECT_NEAR(block.scene.MiddlePixel()[1], all - 0.5 * inFront, HalfByteStep);
  block.scene.mapper->SetMaskBlendFactor(0.0);
  EXPECT_NEAR(block.scene.MiddlePixel()[1], all, HalfByteStep);
}

TEST(LabelMap, OpacitiesOfAUnitDistanceAreMixed)
{
  Block block;
  block.scene.volume->GetProperty()->SetLabelScalarOpacity(1, Constant(0.25));
  block.SetMask([](glm::ivec3) { return 1; });
  block.scene.mapper->SetMaskBlendFactor(0.25);
  const double expected = 1.0 - std::pow(1.0 - (0.75 * 0.05 + 0.25 * 0.25), 32.0);
  EXPECT_NEAR(block.scene.MiddlePixel()[3], expected, HalfByteStep);
}

TEST(LabelMap, WithFunctionsOfEachLabelIsThatOfTheReference)
{
  LabelledTorso torso;
  const ImageError error = torso.scene.ErrorOf(
    [&](glm::dvec3 position, const Ray& rayGrid) { return torso.MaterialAt(position, rayGrid); });
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 10.0);
  const std::vector<float> drawn = torso.scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.3) << "the image is empty";
}

TEST(LabelMap, LiesOverAFunctionOfValueAndGradient)
{
  LabelledTorso torso;
  ShowValueAndGradient(torso.scene);
  const MapperScene::Material withoutLabel = MaterialOfTwoValues(torso.scene);
  const ImageError error = torso.scene.ErrorOf([&](glm::dvec3 position, const Ray& rayGrid)
    { return torso.MaterialOver(withoutLabel, position, rayGrid); });
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 10.0);
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Rows/ValueAndGradient.glsl"));
}

namespace
{

// A block with an opaque label in nothing. It has one value, so its own gradient lights nothing.
class LitLabel : public Block
{
public:
  explicit LitLabel(const Labels& labels)
  {
    vtkVolumeProperty* property = this->scene.volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.2);
    property->SetDiffuse(0.5);
    property->SetSpecular(0.1);
    property->SetSpecularPower(20.0);
    property->SetLabelScalarOpacity(1, Constant(1.0));
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, 0.0);
    this->scene.mapper->LabelSurfacesOn();
    this->SetMask(labels);
  }
};

int HalfTheBlock(glm::ivec3 voxel)
{
  return voxel.z < 20 ? 1 : 0;
}

}

TEST(LabelMap, IsLitAsTheSurfaceOfItsLabel)
{
  LitLabel facing(HalfTheBlock);
  EXPECT_NEAR(facing.scene.MiddlePixel()[0], 0.8, HalfByteStep);
  facing.scene.mapper->LabelSurfacesOff();
  EXPECT_NEAR(facing.scene.MiddlePixel()[0], 0.2, HalfByteStep) << "as VTK does";
  // A staircase of one step per voxel is a slope of 45 degrees.
  LitLabel slope([](glm::ivec3 voxel) { return voxel.z + voxel.y < 24 ? 1 : 0; });
  const double cosine = std::sqrt(0.5);
  EXPECT_NEAR(slope.scene.MiddlePixel()[0], 0.2 + 0.5 * cosine + 0.1 * std::pow(cosine, 20.0),
    2.0 * HalfByteStep);
}

TEST(LabelMap, IsDullWhereItHasNoSurface)
{
  LitLabel inside([](glm::ivec3) { return 1; });
  EXPECT_NEAR(inside.scene.MiddlePixel()[0], 0.7, HalfByteStep);
  vtkNew<vtkLight> dim;
  dim->SetLightTypeToHeadlight();
  dim->SetIntensity(0.5);
  inside.scene.renderer->RemoveAllLights();
  inside.scene.renderer->AddLight(dim);
  EXPECT_NEAR(inside.scene.MiddlePixel()[0], 0.45, HalfByteStep);
}

TEST(LabelMap, IsNotDampedWhereTheScanIsHomogeneous)
{
  LitLabel label(HalfTheBlock);
  label.scene.mapper->SetDampingGradient(1e4);
  EXPECT_NEAR(label.scene.MiddlePixel()[0], 0.8, HalfByteStep);
}

// Two corners far apart, with nothing between them.
int TwoCorners(glm::ivec3 voxel)
{
  return voxel.x < 2 && (voxel.z < 4 || voxel.z > 28) ? 1 : 0;
}

TEST(LabelMap, IsSkippedWhereABrickHasNoVisibleLabel)
{
  LitLabel label(TwoCorners);
  label.scene.Draw();
  EXPECT_TRUE(label.scene.UsesShaderPart("Step/OpticalField.glsl"));
  EXPECT_EQ(label.scene.MiddlePixel()[3], 0.0f);
  label.SetMask(HalfTheBlock);
  EXPECT_NEAR(label.scene.MiddlePixel()[3], 1.0f, HalfByteStep) << "the field is that of the mask";
}

TEST(BinaryMask, IsSkippedWhereABrickShowsNoVoxel)
{
  Block block;
  block.SetMask(TwoCorners, true);
  block.scene.Draw();
  EXPECT_TRUE(block.scene.UsesShaderPart("Step/OpticalField.glsl"));
  EXPECT_EQ(block.scene.MiddlePixel()[3], 0.0f);
  block.SetMask([](glm::ivec3) { return 1; }, true);
  EXPECT_NEAR(block.scene.MiddlePixel()[3], 1.0 - std::pow(0.95, 32.0), HalfByteStep);
}

TEST(Masks, TakeTheirShaderAndTextureOnlyWhereTheyAre)
{
  Block block;
  block.scene.Draw();
  const vtkIdType bytes = block.scene.mapper->GetGraphicsMemoryBytes();
  EXPECT_TRUE(block.scene.UsesShaderPart("Mask/None.glsl"));
  block.SetMask([](glm::ivec3 voxel) { return voxel.z % 2; }, true);
  block.scene.Draw();
  EXPECT_TRUE(block.scene.UsesShaderPart("Mask/Voxels.glsl"));
  EXPECT_TRUE(block.scene.UsesShaderPart("March/Midpoint.glsl"))
    << "a binary mask uses the same march";
  EXPECT_EQ(block.scene.mapper->GetGraphicsMemoryBytes(), bytes + 9 * 9 * 33 * 4);
  block.scene.mapper->SetMaskTypeToLabelMap();
  block.scene.Draw();
  EXPECT_TRUE(block.scene.UsesShaderPart("Material/Labelled.glsl"));
  block.scene.mapper->SetMaskInput(nullptr);
  block.scene.Draw();
  EXPECT_EQ(block.scene.mapper->GetGraphicsMemoryBytes(), bytes);
}
