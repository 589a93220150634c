// Clipping planes and cropping cut exactly at VTK's positions, in every blend mode.

#include "Module/Scenes/MapperScene.h"
#include "Module/Scenes/UsualSettings.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

using namespace varimarch;

namespace
{

constexpr int Size = 64;
constexpr int SubVolume = VTK_CROP_SUBVOLUME;
constexpr int EveryOther = 0x2aaaaaa; // the 13 regions with an odd number

// Adds a plane through a position given as fractions of the volume's bounds.
void AddPlane(MapperScene& scene, glm::dvec3 normal, glm::dvec3 place)
{
  const double* const bounds = scene.volume->GetBounds();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.x, normal.y, normal.z);
  plane->SetOrigin(bounds[0] + place.x * (bounds[1] - bounds[0]),
    bounds[2] + place.y * (bounds[3] - bounds[2]), bounds[4] + place.z * (bounds[5] - bounds[4]));
  scene.mapper->AddClippingPlane(plane);
}

void AddObliquePlanes(MapperScene& scene)
{
  AddPlane(scene, { 1.0, 0.7, -0.3 }, { 0.3, 0.3, 0.4 });
  AddPlane(scene, { -1.0, 0.4, 0.8 }, { 0.75, 0.5, 0.5 });
}

// Uses gentle materials and short steps, so that the cuts dominate the error.
void UseGentleMaterials(MapperScene& scene)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(-1100.0, 0.9, 0.3, 0.2);
  scene.colors->AddRGBPoint(1100.0, 0.3, 0.9, 0.8);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1100.0, 0.004);
  scene.opacities->AddPoint(1100.0, 0.03);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.4);
}

void ExpectTruth(MapperScene& scene, double rootMeanSquare, double largest)
{
  const ImageError error = scene.Error();
  EXPECT_LT(error.rootMeanSquare, rootMeanSquare);
  EXPECT_LT(error.largest, largest);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1f) << "nothing is visible";
}

// A homogeneous volume of 11 voxels and 10 mm per side in which each mm absorbs half of the light.
// It is seen along z in parallel projection, so that a pixel gives the length of its ray.
class HalvingScene : public MapperScene
{
public:
  HalvingScene()
    : MapperScene(HomogeneousImage(), 20)
  {
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.0, 0.5);
    this->mapper->SetEarlyTerminationTransmittance(0.0);
    this->LookDown({ 5.0, 5.0, 5.0 }, 5.0); // a pixel is half a voxel
  }

  /// Length of the ray at x, y [mm]; pixel centres are at 0.25 and 0.75.
  double LengthMm(double x, double y)
  {
    const std::vector<float> drawn = this->Draw();
    const std::size_t pixel = std::size_t(y / 0.5) * 20 + std::size_t(x / 0.5);
    return -std::log2(1.0 - drawn[4 * pixel + 3]);
  }

private:
  static vtkSmartPointer<vtkImageData> HomogeneousImage()
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(11, 11, 11);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 11 * 11 * 11, 50);
    return image;
  }
};

constexpr double LengthError = 1e-5; // [mm]: rounding of floats

}

TEST(Cuts, AClippingPlaneEndsRaysExactlyWhereItIs)
{
  HalvingScene scene;
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 10.0, 1e-2) << "only 1/1024 of the light is left";
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, -1.0); // z <= x
  plane->SetOrigin(0.0, 0.0, 0.0);
  scene.mapper->AddClippingPlane(plane);
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 2.25, LengthError);
  EXPECT_NEAR(scene.LengthMm(4.75, 3.25), 4.75, LengthError);
  EXPECT_TRUE(scene.UsesShaderPart("Clip/Planes.glsl"));

  plane->SetNormal(0.0, 0.0, -2.0); // along the grid: a smaller box, and no plane for the shader
  plane->SetOrigin(7.0, 7.0, 3.3);
  scene.mapper->Modified();
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 3.3, LengthError);
  EXPECT_TRUE(scene.UsesShaderPart("Clip/None.glsl"));
}

TEST(Cuts, AHundredClippingPlanesAreAsExactAsOne)
{
  // A cone around the viewing direction: planes that touch a circle of 4 mm at z = 0 and rise with
  // half the distance to its centre.
  HalvingScene scene;
  constexpr int Count = 100;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Count;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(5.0 + 4.0 * std::cos(angle), 5.0 + 4.0 * std::sin(angle), 0.0);
    plane->SetNormal(-0.5 * std::cos(angle), -0.5 * std::sin(angle), -1.0);
    scene.mapper->AddClippingPlane(plane);
  }
  for (const auto& [x, y] : { std::pair(5.25, 5.25), std::pair(2.25, 6.75), std::pair(7.25, 4.25) })
  {
    double height = 10.0;
    for (int i = 0; i < Count; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / Count;
      const double outwards = (x - 5.0) * std::cos(angle) + (y - 5.0) * std::sin(angle);
      height = std::min(height, 0.5 * (4.0 - outwards));
    }
    EXPECT_NEAR(scene.LengthMm(x, y), height, LengthError);
  }
}

TEST(Cuts, APlaneThatLeavesNothingDrawsNothing)
{
  HalvingScene scene;
  AddPlane(scene, { 1.0, 1.0, 1.0 }, { 1.1, 1.1, 1.1 });
  const std::vector<float> drawn = scene.Draw();
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 0.0f);
}

// VTK's mapper places the planes 10, 12, 16, 20, 22 of 0 ... 32 at 9.75, 11.75, 16, 20, 22.25.
TEST(Cuts, CroppingPlanesAreWhereTheyAreInTheData)
{
  HalvingScene scene;
  scene.mapper->CroppingOn();
  scene.mapper->SetCroppingRegionFlags(SubVolume);
  for (const double upper : { 2.0, 3.5, 5.0, 7.3 })
  {
    scene.mapper->SetCroppingRegionPlanes(1.0, 9.0, 1.0, 9.0, 1.0, upper);
    EXPECT_NEAR(scene.LengthMm(2.25, 3.25), upper - 1.0, LengthError);
    EXPECT_TRUE(scene.UsesShaderPart("Crop/None.glsl")) << "a box costs nothing";
  }
  // All regions but the middle one: along z, the parts in front of it and behind it.
  scene.mapper->SetCroppingRegionFlags(0x7ffffff & ~SubVolume);
  scene.mapper->SetCroppingRegionPlanes(1.0, 9.0, 1.0, 9.0, 1.2, 8.9);
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 1.2 + 1.1, LengthError);
  EXPECT_NEAR(scene.LengthMm(0.75, 3.25), 10.0, 1e-2);
}

TEST(Cuts, PlanesInTheWrongOrderDrawNothing)
{
  HalvingScene scene;
  for (const int flags : { SubVolume, 0x7ffffff })
  {
    CropToMiddle(scene, flags);
    scene.mapper->SetCroppingRegionPlanes(1.0, 9.0, 5.0, 5.0, 1.0, 9.0);
    const std::vector<float> drawn = scene.Draw();
    EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 0.0f);
  }
}

class CutsOfBlend : public testing::TestWithParam<int>
{
protected:
  static bool IsExtreme()
  {
    return GetParam() == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ||
      GetParam() == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  }
};

TEST_P(CutsOfBlend, ClippedAndCroppedPicturesAreTheTruth)
{
  for (const int flags : { 0, SubVolume, VTK_CROP_FENCE, VTK_CROP_INVERTED_CROSS, EveryOther })
  {
    SCOPED_TRACE(flags);
    MapperScene scene(SmallTorso(), Size);
    UseGentleMaterials(scene);
    scene.mapper->SetBlendMode(GetParam());
    AddObliquePlanes(scene);
    if (flags != 0)
    {
      CropToMiddle(scene, flags);
    }
    if (IsExtreme())
    {
      scene.opacities->AddPoint(-1100.0, 0.9);
      scene.opacities->AddPoint(1100.0, 0.2);
    }
    ExpectTruth(scene, 0.3, 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryBlend, CutsOfBlend,
  testing::Values(int(vtkVolumeMapper::COMPOSITE_BLEND),
    int(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND), int(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND),
    int(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND), int(vtkVolumeMapper::ADDITIVE_BLEND)));

TEST(Cuts, PlanesFollowTheMatricesOfImageAndVolume)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const double direction[9] = { 0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, -1.0 };
  torso->SetDirectionMatrix(direction);
  for (const int flags : { SubVolume, VTK_CROP_CROSS })
  {
    MapperScene scene(torso, Size);
    UseGentleMaterials(scene);
    scene.volume->SetScale(1.2, 0.8, 1.0);
    scene.volume->RotateWXYZ(35.0, 0.3, 1.0, 0.2);
    scene.renderer->ResetCamera();
    AddObliquePlanes(scene);
    CropToMiddle(scene, flags);
    ExpectTruth(scene, 0.2, 2.5);
    EXPECT_TRUE(scene.UsesShaderPart("Clip/Planes.glsl"));
  }
}

TEST(Cuts, NormalsAtACutAreThoseOfTheData)
{
  MapperScene scene(SmallTorso(), Size);
  UseGentleMaterials(scene);
  scene.volume->GetProperty()->ShadeOn();
  AddObliquePlanes(scene);
  CropToMiddle(scene, EveryOther);
  ExpectTruth(scene, 0.2, 4.0);
}

TEST(Cuts, ACutIsASurfaceWhereItsIntensityIsGiven)
{
  // Opaque and without a gradient, so there is only ambient light, except at the cut.
  HalvingScene scene;
  scene.opacities->AddPoint(0.0, 1.0);
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.0);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, -1.0);
  plane->SetOrigin(0.0, 0.0, 5.3);
  scene.mapper->AddClippingPlane(plane);
  const auto middle = [&] { return scene.Draw()[4 * (10 * 20 + 10)]; };
  EXPECT_NEAR(middle(), 0.1, 1e-5);
  property->UseClippedVoxelIntensityOn();
  property->SetClippedVoxelIntensity(0.0);
  EXPECT_NEAR(middle(), 0.1 + 0.6, 1e-5);
  EXPECT_TRUE(scene.UsesShaderPart("Gradient/ClippedDifferences.glsl"));
}

TEST(Cuts, AVolumeInBlocksIsCutAsTheWholeIs)
{
  MapperScene scene(ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 7 }), Size);
  UseGentleMaterials(scene);
  AddObliquePlanes(scene);
  for (const int flags : { SubVolume, EveryOther })
  {
    CropToMiddle(scene, flags);
    scene.mapper->SetMaximumGraphicsMemory(0);
    const std::vector<float> whole = scene.Draw();
    scene.mapper->SetMaximumGraphicsMemory(200000);
    const std::vector<float> inBlocks = scene.Draw();
    EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
    EXPECT_LT(CompareImages(inBlocks.data(), whole.data(), whole.size() / 4).largest, 0.2);
  }
}

TEST(Cuts, GapsAreCutLikeTheRest)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  vtkNew<vtkImageData> image;
  image->DeepCopy(torso);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < torso->GetNumberOfPoints(); ++i)
  {
    const bool isGap = i % 1000 == 7;
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, isGap ? std::nan("") : torso->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  MapperScene scene(image, Size);
  UseGentleMaterials(scene);
  scene.mapper->SetNanOpacity(0.05);
  AddObliquePlanes(scene);
  CropToMiddle(scene, EveryOther);
  ExpectTruth(scene, 0.2, 2.5);
}

TEST(Cuts, AnErrorToleranceIsTriedOutAnewForOtherCuts)
{
  MapperScene scene(SmallTorso(), Size);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  const int searches = scene.mapper->GetToleranceSearches();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches);
  AddObliquePlanes(scene);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches + 1);
  CropToMiddle(scene, EveryOther);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches + 2);
}
