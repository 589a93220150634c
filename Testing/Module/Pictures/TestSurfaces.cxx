// Isosurfaces and slices are found exactly, whatever the steps.

#include "Core/Geometry/ScalarGrid.h"
#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkBox.h>
#include <vtkContourValues.h>
#include <vtkCylinder.h>
#include <vtkDataArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkSphere.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace varimarch;

namespace
{

constexpr int SurfaceSize = 64;

// Skin as a veil, bone behind it, and a value that does not occur in the volume.
void UseIsosurfaces(MapperScene& scene)
{
  scene.mapper->SetBlendModeToIsoSurface();
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-500.0, 0.3);
  scene.opacities->AddPoint(0.0, 0.5);
  scene.opacities->AddPoint(300.0, 0.9);
  vtkContourValues* const values = scene.volume->GetProperty()->GetIsoSurfaceValues();
  values->SetValue(0, 250.0);
  values->SetValue(1, -400.0);
  values->SetValue(2, 5000.0);
  values->SetValue(3, 10.0);
}

// A few rays graze a surface, and rounding decides whether they hit it.
void ExpectTruth(MapperScene& scene)
{
  const ImageError error = scene.Error();
  EXPECT_LT(error.rootMeanSquare, 2.0);
  const std::vector<float> drawn = scene.Draw();
  const std::vector<float> truth = scene.Truth();
  std::size_t different = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    different += std::abs(drawn[i] - truth[i]) > 1.0 / 255.0;
  }
  EXPECT_LT(different, drawn.size() / 200);
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.3f) << "nothing is visible";
}

// Values x + 2 y + 3 z, which interpolation reproduces exactly.
vtkSmartPointer<vtkImageData> LinearImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 9, 9);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int z = 0; z < 9; ++z)
  {
    for (int y = 0; y < 9; ++y)
    {
      for (int x = 0; x < 9; ++x)
      {
        image->SetScalarComponentFromDouble(x, y, z, 0, x + 2.0 * y + 3.0 * z);
      }
    }
  }
  return image;
}

// Seen along z from above in parallel projection; a pixel's ray is at ((column + 0.5) / 2, ...).
class SliceScene : public MapperScene
{
public:
  SliceScene()
    : MapperScene(LinearImage(), 16)
  {
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 0.0, 0.5, 1.0);
    this->colors->AddRGBPoint(48.0, 1.0, 0.5, 0.0);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.0, 0.5);
    this->mapper->SetBlendModeToSlice();
    this->LookDown({ 4.0, 4.0, 4.0 }, 4.0);
  }

  /// The scalar rendered at a pixel; negative if there is none.
  double ScalarAt(int column, int row)
  {
    const std::vector<float> drawn = this->Draw();
    const float* const pixel = &drawn[4 * (row * 16 + column)];
    return pixel[3] > 0.0f ? 48.0 * pixel[0] / pixel[3] : -1.0;
  }

  double AlphaAt(int column, int row) { return this->Draw()[4 * (row * 16 + column) + 3]; }
};

}

TEST(Isosurfaces, AreTheTruthWhateverTheField)
{
  for (const int mode :
    { vtkVariationFieldVolumeMapper::Off, vtkVariationFieldVolumeMapper::OpticalField })
  {
    MapperScene scene(SmallTorso(), SurfaceSize);
    UseIsosurfaces(scene);
    scene.mapper->SetAccelerationMode(mode);
    ExpectTruth(scene);
    scene.volume->GetProperty()->ShadeOn();
    ExpectTruth(scene);
  }
}

TEST(Isosurfaces, DoNotDependOnTheSampleDistance)
{
  MapperScene scene(SmallTorso(), SurfaceSize);
  UseIsosurfaces(scene);
  const std::vector<float> automatic = scene.Draw();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(1000.0);
  EXPECT_EQ(scene.Draw(), automatic);
}

TEST(Isosurfaces, BricksWithoutThemAreLeftOut)
{
  MapperScene scene(SmallTorso(), SurfaceSize);
  UseIsosurfaces(scene);
  scene.volume->GetProperty()->GetIsoSurfaceValues()->SetNumberOfContours(1); // bone
  scene.mapper->DrawFetchCountsOn();
  const auto fetches = [&](int mode)
  {
    scene.mapper->SetAccelerationMode(mode);
    const std::vector<float> counts = scene.Draw();
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); i += 4)
    {
      sum += counts[i];
    }
    return sum;
  };
  EXPECT_LT(fetches(vtkVariationFieldVolumeMapper::OpticalField),
    0.7 * fetches(vtkVariationFieldVolumeMapper::Off));
}

// VTK's mapper finds a thin shell only if a sample falls into it.
TEST(Isosurfaces, AShellThinnerThanAnyStepIsNotMissed)
{
  MapperScene scene(LinearImage(), 16);
  scene.mapper->SetBlendModeToIsoSurface();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.5);
  vtkContourValues* const values = scene.volume->GetProperty()->GetIsoSurfaceValues();
  values->SetValue(0, 20.0);
  values->SetValue(1, 20.0001);
  scene.LookDown({ 4.0, 4.0, 4.0 }, 4.0);
  const std::vector<float> drawn = scene.Draw();
  // Along the centre ray, at x = y = 4.25, the values range from 12.75 to 36.75.
  EXPECT_NEAR(drawn[4 * (8 * 16 + 8) + 3], 0.75, 1e-5) << "two surfaces of half opacity";
}

TEST(Isosurfaces, AreTheFacesOfVoxelsWithoutInterpolation)
{
  MapperScene scene(SmallTorso(), SurfaceSize);
  UseIsosurfaces(scene);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  ExpectTruth(scene);
  EXPECT_TRUE(scene.UsesShaderPart("March/VoxelSurfaces.glsl"));
}

TEST(Isosurfaces, WithoutAValueNothingIsDrawn)
{
  MapperScene scene(SmallTorso(), SurfaceSize);
  scene.mapper->SetBlendModeToIsoSurface();
  scene.volume->GetProperty()->GetIsoSurfaceValues()->SetNumberOfContours(0);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 0.0f);
}

TEST(Isosurfaces, AreTheSameInBlocks)
{
  MapperScene scene(ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 7 }), SurfaceSize);
  UseIsosurfaces(scene);
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetMaximumGraphicsMemory(200000);
  const std::vector<float> inBlocks = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
  EXPECT_LT(CompareImages(inBlocks.data(), whole.data(), whole.size() / 4).rootMeanSquare, 1.0);
}

TEST(Slices, APlaneShowsTheValuesThatLieOnIt)
{
  SliceScene scene;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 2.5);
  plane->SetNormal(0.3, -0.2, 1.0);
  scene.volume->GetProperty()->SetSliceFunction(plane);
  for (const int column : { 1, 5, 9, 14 })
  {
    for (const int row : { 0, 6, 13 })
    {
      const double x = 0.25 + 0.5 * column;
      const double y = 0.25 + 0.5 * row;
      const double z = 2.5 - 0.3 * x + 0.2 * y;
      const double expected = z >= 0.0 && z <= 8.0 ? x + 2.0 * y + 3.0 * z : -1.0;
      EXPECT_NEAR(scene.ScalarAt(column, row), expected, 1e-3) << column << ", " << row;
    }
  }
  EXPECT_NEAR(scene.AlphaAt(1, 5), 0.5, 1e-6);
}

// VTK's mapper shifts slices by half a voxel.
TEST(Slices, AtTheFacesOfTheVolumeAreTheirVoxels)
{
  SliceScene scene;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 1.0);
  scene.volume->GetProperty()->SetSliceFunction(plane);
  for (const double z : { 0.0, 3.0, 8.0 })
  {
    plane->SetOrigin(0.0, 0.0, z);
    EXPECT_NEAR(scene.ScalarAt(4, 10), 2.25 + 2.0 * 5.25 + 3.0 * z, 2e-3);
  }
  plane->SetOrigin(0.0, 0.0, 8.01);
  EXPECT_EQ(scene.ScalarAt(4, 10), -1.0);
}

TEST(Slices, ByASphereShowItsFrontAndItsBack)
{
  SliceScene scene;
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(4.0, 4.0, 5.0);
  sphere->SetRadius(2.5);
  scene.volume->GetProperty()->SetSliceFunction(sphere);
  EXPECT_EQ(scene.AlphaAt(1, 1), 0.0) << "beside the sphere";
  EXPECT_NEAR(scene.AlphaAt(8, 8), 0.75, 1e-5);
  scene.opacities->AddPoint(0.0, 1.0);
  const double z = 5.0 + std::sqrt(2.5 * 2.5 - 2.0 * 0.25 * 0.25);
  EXPECT_NEAR(scene.ScalarAt(8, 8), 4.25 * 3.0 + 3.0 * z, 2e-3);
}

TEST(Slices, AreOfTheWorldWhateverTheVolumesMatrix)
{
  SliceScene scene;
  scene.volume->SetPosition(0.0, 0.0, 1.5);
  scene.volume->SetScale(1.0, 1.0, 0.5);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.1, 0.0, 1.0);
  plane->SetOrigin(0.0, 0.0, 3.0);
  scene.volume->GetProperty()->SetSliceFunction(plane);
  const double x = 2.25;
  const double zVolume = (3.0 - 0.1 * x - 1.5) / 0.5;
  EXPECT_NEAR(scene.ScalarAt(4, 10), x + 2.0 * 5.25 + 3.0 * zVolume, 2e-3);
}

TEST(Slices, AreCutByClippingPlanesAndShaded)
{
  SliceScene scene;
  vtkNew<vtkPlane> slice;
  slice->SetNormal(0.0, 0.0, 1.0);
  slice->SetOrigin(4.0, 4.0, 4.0);
  scene.volume->GetProperty()->SetSliceFunction(slice);
  vtkNew<vtkPlane> cut;
  cut->SetNormal(1.0, 0.3, 0.0);
  cut->SetOrigin(4.0, 4.0, 4.0);
  scene.mapper->AddClippingPlane(cut);
  EXPECT_EQ(scene.AlphaAt(2, 8), 0.0);
  EXPECT_NEAR(scene.AlphaAt(12, 8), 0.5, 1e-5);
  // Cosine between the gradient (1, 2, 3) and the direction to the eye: 3 / sqrt(14).
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->SetAmbient(0.0);
  scene.volume->GetProperty()->SetDiffuse(1.0);
  scene.volume->GetProperty()->SetSpecular(0.0);
  const double value = 6.25 + 2.0 * 4.25 + 12.0;
  EXPECT_NEAR(scene.ScalarAt(12, 8), value * 3.0 / std::sqrt(14.0), 1e-2);
}

TEST(Slices, ByAFunctionOfHigherDegreeAreRefusedWithASentence)
{
  SliceScene scene;
  vtkNew<vtkBox> box;
  box->SetBounds(1.0, 3.0, 1.0, 3.0, 1.0, 3.0);
  scene.volume->GetProperty()->SetSliceFunction(box);
  ExpectedVtkErrors errors;
  scene.Draw();
  EXPECT_NE(errors.Text().find("Slices by vtkBox are not supported"), std::string::npos)
    << errors.Text();
}

TEST(Isosurfaces, AreThoseOfTheComponentWithTheLargestWeight)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const auto prepare = [](MapperScene& scene, int component)
  {
    scene.mapper->SetBlendModeToIsoSurface();
    vtkVolumeProperty* const property = scene.volume->GetProperty();
    property->GetIsoSurfaceValues()->SetValue(0, 100.0);
    property->SetColor(component, scene.colors);
    property->SetScalarOpacity(component, scene.opacities);
    property->SetAmbient(component, 0.4);
    property->ShadeOn();
  };
  MapperScene alone(torso, 48);
  prepare(alone, 0);

  const auto two = vtkSmartPointer<vtkImageData>::New();
  two->CopyStructure(torso);
  two->AllocateScalars(VTK_SHORT, 2);
  const auto* const values = static_cast<const short*>(torso->GetScalarPointer());
  auto* const both = static_cast<short*>(two->GetScalarPointer());
  for (vtkIdType i = 0; i < torso->GetNumberOfPoints(); ++i)
  {
    both[2 * i] = short(i % 500);
    both[2 * i + 1] = values[i];
  }
  MapperScene second(two, 48);
  prepare(second, 1);
  second.volume->GetProperty()->SetComponentWeight(0, 0.3);
  second.volume->GetProperty()->SetComponentWeight(1, 0.7);
  const std::vector<float> drawn = second.Draw();
  EXPECT_EQ(drawn, alone.Draw());
  second.volume->GetProperty()->SetComponentWeight(0, 0.8);
  EXPECT_NE(second.Draw(), drawn);
}
