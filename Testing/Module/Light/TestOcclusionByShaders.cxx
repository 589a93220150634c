// Ambient occlusion by shaders, compared with closed forms and with that by packets of rays.

#include "Module/Light/OccludedScenes.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkFloatArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double LongStepMm = 0.5;
constexpr double ShortStepMm = 0.25;

double MiddleOfBox(double heightMm)
{
  return std::floor(heightMm + 0.5);
}

double LargestDifference(const std::vector<float>& one, const std::vector<float>& other)
{
  return CompareImages(one.data(), other.data(), one.size() / 4).largest / 255.0;
}

void ShowEdges(MapperScene& scene)
{
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.1);
  factors->AddPoint(150.0, 1.0);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
}

void MaskCorner(MapperScene& scene)
{
  scene.mapper->SetMaskTypeToBinary();
  scene.mapper->SetMaskInput(MaskOf(
    { 40, 36, 24 }, [](glm::ivec3 voxel) { return voxel.x > 12 || voxel.z > 9 ? 1 : 0; },
    VTK_UNSIGNED_CHAR));
}

void CutObliquely(MapperScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(scene.image->GetCenter());
  plane->SetNormal(1.0, 0.3, 0.2);
  scene.mapper->AddClippingPlane(plane);
}

}

TEST(OcclusionByShaders, OfAHomogeneousSlabHasItsClosedForm)
{
  for (const double strength : { 0.3, 1.0 })
  {
    OccludedSlab thin(0.1, strength, 12.0);
    EXPECT_NEAR(thin.RedByShaders(LongStepMm), thin.ExpectedRed(), HalfByteStep) << strength;
    EXPECT_TRUE(thin.scene.UsesShaderPart("Sky/OpenSky.glsl"));
    OccludedSlab thick(0.5, strength, 3.0);
    EXPECT_NEAR(thick.RedByShaders(ShortStepMm), thick.ExpectedRed(), 2.0 * HalfByteStep)
      << strength;
    thick.scene.mapper->SetCompositingOrder(vtkVariationFieldVolumeMapper::BackToFront);
    EXPECT_NEAR(thick.RedByShaders(ShortStepMm), thick.ExpectedRed(), 2.0 * HalfByteStep)
      << strength;
  }
}

TEST(OcclusionByShaders, OfBoxesIsThatOfTheirMiddles)
{
  OccludedSlab slab(0.3, 0.8, 6.0);
  slab.scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  slab.seenFrom = [](double heightMm) { return MiddleOfBox(heightMm) + 2.0; };
  EXPECT_NEAR(slab.RedByShaders(1.0), slab.ExpectedRed(), HalfByteStep);
  EXPECT_TRUE(slab.scene.UsesShaderPart("Through/Voxels.glsl"));
}

TEST(OcclusionByShaders, GoesThroughTheMatterOfAllLabels)
{
  OccludedSlab slab(0.4, 0.8, 6.0);
  LabelFrom(4, 8, 0.15, slab);
  EXPECT_NEAR(slab.RedByShaders(ShortStepMm), slab.ExpectedRed(), 2.0 * HalfByteStep);
}

TEST(OcclusionByShaders, OfALabelIsSeenOutsideItsOwnSurface)
{
  LabelOnNothing slab;
  slab.ExpectRed(slab.RedByShaders(LabelOnNothing::SegmentMm));
  EXPECT_TRUE(slab.scene.UsesShaderPart("Outside/Labels.glsl"));
}

// The voxels to the right of the eye are not numbers from 15 mm on, so that matter ends at 10 mm.
TEST(OcclusionByShaders, EndsAtGaps)
{
  OccludedSlab slab(0.1, 0.8, 19.0);
  vtkImageData* const image = slab.scene.image;
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(i % 9 < 7 ? float(image->GetPointData()->GetScalars()->GetTuple1(i))
                                      : std::numeric_limits<float>::quiet_NaN());
  }
  const double whole = slab.ExpectedRed();
  image->GetPointData()->SetScalars(values);
  slab.widthMm = 10.0;
  EXPECT_NEAR(slab.RedByShaders(LongStepMm), slab.ExpectedRed(), HalfByteStep);
  EXPECT_GT(slab.ExpectedRed(), whole + 2.0 * HalfByteStep);
}

// Both march the same rays, without a lattice.
TEST(OcclusionByShaders, IsThatByPacketsForAllMaterialsOfOneComponent)
{
  const std::vector<std::tuple<const char*, std::function<void(MapperScene&)>>> materials = {
    { "lit", [](MapperScene&) {} },
    { "unlit", [](MapperScene& scene) { scene.volume->GetProperty()->ShadeOff(); } },
    { "gradient opacity", ShowEdges },
    { "value and gradient", ShowValueAndGradient },
    { "cubic",
      [](MapperScene& scene)
      {
        // A spline is less linear in a segment, and packets skip bricks where segments begin.
        scene.mapper->CubicInterpolationOn();
        scene.mapper->SetSampleDistance(3.0);
      } },
    { "mask", MaskCorner },
    { "plane", CutObliquely },
    { "cropping", [](MapperScene& scene) { CropToMiddle(scene, VTK_CROP_FENCE); } },
  };
  constexpr double OneByte = 1.0 / 255.0;
  for (const auto& [name, prepare] : materials)
  {
    OccludedTorso torso(16);
    MapperScene& scene = torso.scene;
    scene.mapper->AutoAdjustSampleDistancesOff();
    scene.mapper->SetSampleDistance(6.0);
    scene.mapper->SetAmbientOcclusionReach(40.0);
    prepare(scene);
    const std::vector<float> byPackets = scene.DrawByProcessor();
    EXPECT_TRUE(scene.ShaderParts().empty()) << name;
    EXPECT_LE(LargestDifference(scene.Draw(), byPackets), OneByte) << name;
    EXPECT_TRUE(scene.UsesShaderPart("Sky/OpenSky.glsl")) << name;
    scene.mapper->SetAmbientOcclusion(0.0);
    EXPECT_GT(LargestDifference(scene.Draw(), byPackets), 8.0 * OneByte) << name << ": is seen";
  }
}

TEST(OcclusionByShaders, TakesNothingWhereItIsOff)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetErrorTolerance(0.0);
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  torso.scene.Draw();
  const std::vector<std::string> parts = torso.scene.ShaderParts();
  const vtkIdType bytes = torso.scene.mapper->GetGraphicsMemoryBytes();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Sky/None.glsl"));
  torso.scene.mapper->SetAmbientOcclusion(0.5);
  torso.scene.mapper->SetAmbientOcclusionReach(10.0);
  torso.scene.Draw();
  EXPECT_NE(torso.scene.ShaderParts(), parts);
  EXPECT_GT(torso.scene.mapper->GetGraphicsMemoryBytes(), bytes);
  EXPECT_EQ(torso.scene.mapper->GetLightMemoryBytes(), 0) << "shaders have no lattice";
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  torso.scene.Draw();
  EXPECT_EQ(torso.scene.ShaderParts(), parts);
  EXPECT_EQ(torso.scene.mapper->GetGraphicsMemoryBytes(), bytes);
}

TEST(OcclusionByShaders, IsLeftOutWhileSomebodyInteracts)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetErrorTolerance(0.0);
  torso.scene.mapper->SetMaximumImageSampleDistance(1.0);
  torso.scene.window->SetDesiredUpdateRate(20.0);
  const std::vector<float> moving = torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Sky/None.glsl"));
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  EXPECT_EQ(torso.scene.Draw(), moving);
}

// A shader sees one block of a volume that does not fit into memory at a time.
TEST(OcclusionByShaders, IsDrawnWithinBoundedMemoryAndLeftOutOfBlocksWithASentence)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetErrorTolerance(0.0);
  torso.scene.mapper->SetAmbientOcclusionReach(10.0);
  torso.scene.mapper->SetMaximumGraphicsMemory(1 << 28);
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Sky/OpenSky.glsl"));
  const ExpectedVtkErrors warnings;
  torso.scene.mapper->SetMaximumGraphicsMemory(60000);
  torso.scene.Draw();
  EXPECT_NE(warnings.Text().find("has no ambient occlusion"), std::string::npos) << warnings.Text();
}

// The rays to all sides from all places of a ray through the volume are too many for OpenGL by the
// processor, which would end them and the ray of the eye with them.
TEST(OcclusionByShaders, OfManyPlacesIsDoubtedWithoutAGraphicsCard)
{
  OccludedSlab slab(0.1, 0.5, 60.0);
  LabelFrom(4, 8, 0.1, slab);
  slab.scene.mapper->SetErrorTolerance(1.0 / 256.0);
  const ExpectedVtkErrors warnings;
  slab.scene.Draw();
  EXPECT_NE(warnings.Text().find("behind translucent matter"), std::string::npos)
    << warnings.Text();
  EXPECT_FALSE(slab.scene.mapper->GetErrorToleranceIsKept());
}
