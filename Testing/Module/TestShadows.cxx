// Shadows that a volume casts on itself, compared with closed forms, and with a reference that
// integrates the light's way through the volume in double precision.

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Reference/LightTransmittance.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/VolumeGeometry.h"
#include "Module/ReferenceMaterials.h"
#include "Module/UsualSettings.h"
#include "Stages/CutRays.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double Red = 0.8;
constexpr double SlabMm = 8.0;

// A wide slab between z = 0 and z = 8 whose values fall along z, so that its normals face the eye,
// and whose material is the same everywhere. Only diffuse light counts.
class Slab
{
public:
  explicit Slab(double opacityPerMm)
    : scene(Values(), 9)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, Red, 0.4, 0.2);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, opacityPerMm);
    vtkVolumeProperty* const property = this->scene.volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    this->scene.LookDown({ 0.0, 0.0, 0.0 }, 0.5);
    this->scene.renderer->AutomaticLightCreationOff();
    this->scene.renderer->RemoveAllLights();
    this->scene.mapper->ShadowsOn();
  }

  vtkLight* AddLight(glm::dvec3 position, glm::dvec3 focus = glm::dvec3(0.0))
  {
    return ::AddLight(this->scene.renderer, position, focus);
  }

  double DrawnRed() { return this->scene.MiddlePixel()[0]; }

  MapperScene scene;

private:
  static vtkSmartPointer<vtkImageData> Values()
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, 9);
    image->SetOrigin(-20.0, -20.0, 0.0);
    image->SetSpacing(5.0, 5.0, 1.0);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 9 * 9 * 9; ++i)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[i] =
        static_cast<unsigned char>(80 - 10 * (i / (9 * 9)));
    }
    return image;
  }
};

// The light of a slab seen along its normal, lit at an angle: the eye sees exp(-sigma z) of what
// exp(-sigma z / cosine) of the light excites at depth z.
double RedOfSlab(double opacityPerMm, double cosine)
{
  const double extinction = -std::log1p(-opacityPerMm);
  const double both = extinction * (1.0 + 1.0 / cosine);
  return Red * cosine * extinction / both * (1.0 - std::exp(-both * SlabMm));
}

}

TEST(Shadows, OfAHomogeneousSlabHaveTheirClosedForm)
{
  for (const double opacity : { 0.05, 0.3 })
  {
    for (const double cosine : { 1.0, 0.8, 0.4 })
    {
      Slab slab(opacity);
      slab.AddLight(100.0 * glm::dvec3(std::sqrt(1.0 - cosine * cosine), 0.0, cosine));
      EXPECT_NEAR(slab.DrawnRed(), RedOfSlab(opacity, cosine), HalfByteStep)
        << opacity << ", " << cosine;
    }
  }
}

TEST(Shadows, OfMidpointsHaveTheirClosedFormToo)
{
  Slab slab(0.3);
  slab.scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  slab.AddLight({ 60.0, 0.0, 80.0 });
  EXPECT_NEAR(slab.DrawnRed(), RedOfSlab(0.3, 0.8), HalfByteStep);
}

TEST(Shadows, OfTwoHalfLightsAreThoseOfOneWhole)
{
  Slab whole(0.3);
  whole.AddLight({ 30.0, 20.0, 40.0 });
  Slab halves(0.3);
  halves.AddLight({ 30.0, 20.0, 40.0 })->SetIntensity(0.5);
  halves.AddLight({ 30.0, 20.0, 40.0 })->SetIntensity(0.5);
  EXPECT_NEAR(halves.DrawnRed(), whole.DrawnRed(), 1e-3)
    << "two rays have longer segments on llvmpipe";
}

TEST(Shadows, EndAtALightInsideTheVolume)
{
  // The light is in the middle of the slab, so that only what lies between it and a sample counts.
  Slab slab(0.2);
  vtkLight* const lamp = slab.AddLight({ 0.0, 0.0, 4.0 });
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  const double extinction = -std::log1p(-0.2);
  double red = 0.0;
  constexpr int Parts = 100000;
  for (int i = 0; i < Parts; ++i)
  {
    const double depth = (i + 0.5) * SlabMm / Parts;
    red += Red * extinction * SlabMm / Parts *
      std::exp(-extinction * depth - extinction * std::abs(depth - 4.0));
  }
  EXPECT_NEAR(slab.DrawnRed(), red, HalfByteStep);
}

TEST(Shadows, AreNotCastByClippedOrCroppedParts)
{
  // The eye looks down onto the slab's lower half. What is above it is cut away.
  const double opacity = 0.3;
  const double extinction = -std::log1p(-opacity);
  const double expected = Red * 0.5 * (1.0 - std::exp(-2.0 * extinction * 4.0));
  Slab clipped(opacity);
  clipped.AddLight({ 0.0, 0.0, 100.0 });
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 4.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  clipped.scene.mapper->AddClippingPlane(plane);
  EXPECT_NEAR(clipped.DrawnRed(), expected, HalfByteStep);
  Slab cropped(opacity);
  cropped.AddLight({ 0.0, 0.0, 100.0 });
  cropped.scene.mapper->CroppingOn();
  cropped.scene.mapper->SetCroppingRegionPlanes(-200.0, 200.0, -200.0, 200.0, -1.0, 4.0);
  cropped.scene.mapper->SetCroppingRegionFlagsToSubVolume();
  EXPECT_NEAR(cropped.DrawnRed(), expected, 2.0 * HalfByteStep) << "a segment may cross the plane";
}

TEST(Shadows, AreNotCastByWhatAMaskHides)
{
  Slab slab(0.3);
  slab.AddLight({ 0.0, 0.0, 100.0 });
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(slab.scene.image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    voxels[i] = i / (9 * 9) < 5 ? 255 : 0; // up to z = 4.5
  }
  slab.scene.mapper->SetMaskInput(mask);
  slab.scene.mapper->SetMaskTypeToBinary();
  const double extinction = -std::log1p(-0.3);
  // The shader on llvmpipe has long steps in so wide a slab.
  const std::vector<float> drawn = slab.scene.DrawByProcessor();
  EXPECT_NEAR(drawn[4 * (drawn.size() / 8)], Red * 0.5 * (1.0 - std::exp(-9.0 * extinction)),
    2.0 * HalfByteStep)
    << "a segment may cross the faces of the mask";
}

namespace
{

// A turned torso under a sun and a lamp.
class ShadowedTorso
{
public:
  explicit ShadowedTorso(int size)
    : scene(SmallTorso(), size)
    , geometry(VolumeGeometryOf(this->scene.image, this->scene.volume))
    , voxels(static_cast<const short*>(this->scene.image->GetScalarPointer()),
        static_cast<const short*>(this->scene.image->GetScalarPointer()) +
          this->scene.image->GetNumberOfPoints())
    , grid(this->voxels.data(), this->geometry.dimensions)
  {
    vtkVolumeProperty* const property = this->scene.volume->GetProperty();
    property->ShadeOn();
    property->SetSpecular(0.2);
    property->SetSpecularPower(5.0);
    this->scene.mapper->ShadowsOn();
    UseSunAndLamp(this->scene.renderer);
  }

  /// @param opacity  over a millimetre
  void SetMostOpacity(double opacity)
  {
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(-200.0, 0.0);
    this->scene.opacities->AddPoint(300.0, opacity);
  }

  // The nested integral needs no more than a tenth of the tolerance that is tested.
  std::vector<float> Truth(double tolerance = 1e-3)
  {
    const TransferFunction look = TransferFunctionOf(this->scene.volume->GetProperty(), 0);
    ReferenceScene opacities{ [&](glm::ivec3 cell) { return CornersOfCell(this->grid, cell); },
      this->geometry.boxGrid, look };
    opacities.uncutParts =
      CutRays(this->scene.mapper, this->geometry.worldFromGrid, this->geometry.dataFromGrid);
    const LightTransmittance transmittance(
      opacities, glm::inverse(this->geometry.WorldFromGridDirection()), tolerance);
    const auto reaching = [&](glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm)
    { return transmittance.Towards(positionGrid, towardsWorld, farMm); };
    return this->scene.TruthOf(MaterialInShadows(this->scene, reaching), tolerance);
  }

  MapperScene scene;

private:
  VolumeGeometry geometry;
  std::vector<short> voxels;
  ScalarGrid<short> grid;
};

}

TEST(Shadows, KeepTheErrorTolerance)
{
  ShadowedTorso torso(16);
  const std::vector<float> truth = torso.Truth(4e-4);
  const auto errorOf = [&](const std::vector<float>& drawn)
  { return CompareImages(drawn.data(), truth.data(), truth.size() / 4); };
  for (const double tolerance : { 1.0 / 16.0, 1.0 / 64.0, 1.0 / 255.0 })
  {
    torso.scene.mapper->SetErrorTolerance(tolerance);
    EXPECT_LT(errorOf(torso.scene.DrawByProcessor()).percentile999, 255.0 * tolerance) << tolerance;
  }
  torso.scene.mapper->ShadowsOff();
  EXPECT_GT(errorOf(torso.scene.DrawByProcessor()).percentile999, 20.0) << "shadows are seen";
}

// A soft material and one that is opaque within a voxel have other shadows than the torso's.
TEST(Shadows, OfSoftAndOfDenseMaterialKeepTheErrorTolerance)
{
  constexpr double Tolerance = 1.0 / 64.0;
  for (const double mostOpacity : { 0.01, 0.999 })
  {
    ShadowedTorso torso(12);
    torso.SetMostOpacity(mostOpacity);
    torso.scene.mapper->SetErrorTolerance(Tolerance);
    const std::vector<float> truth = torso.Truth();
    const std::vector<float> drawn = torso.scene.DrawByProcessor();
    EXPECT_LT(
      CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999, 255.0 * Tolerance)
      << mostOpacity;
  }
}

// OpenGL without a graphics card ends shaders that take long. Tests draw in this way.
TEST(Shadows, TellWhereShadersAreTooLongForThem)
{
  ShadowedTorso torso(12);
  torso.SetMostOpacity(0.999);
  torso.scene.mapper->SetErrorTolerance(1.0 / 255.0);
  torso.scene.mapper->ShadowsOff();
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.mapper->GetErrorToleranceIsKept());
  torso.scene.mapper->ShadowsOn();
  const ExpectedVtkErrors messages;
  torso.scene.Draw();
  EXPECT_NE(messages.Text().find("shadows may be wrong"), std::string::npos) << messages.Text();
  EXPECT_FALSE(torso.scene.mapper->GetErrorToleranceIsKept());
  EXPECT_EQ(torso.scene.mapper->GetEstimatedError(), 1.0);
}

namespace
{

// A change of something that the light in a volume depends on.
struct LightChange
{
  const char* name;
  void (*change)(MapperScene& scene);
};

const std::vector<LightChange>& LightChanges()
{
  static const std::vector<LightChange> changes = {
    { "camera", [](MapperScene& scene) { scene.renderer->GetActiveCamera()->Azimuth(25.0); } },
    { "light",
      [](MapperScene& scene)
      {
        auto* const light = vtkLight::SafeDownCast(scene.renderer->GetLights()->GetItemAsObject(0));
        light->SetPosition(-90.0, 40.0, -60.0);
      } },
    { "opacity", [](MapperScene& scene) { scene.opacities->AddPoint(40.0, 0.2); } },
    { "plane",
      [](MapperScene& scene)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(scene.image->GetCenter());
        plane->SetNormal(1.0, 0.3, 0.2);
        scene.mapper->AddClippingPlane(plane);
      } },
    { "cropping",
      [](MapperScene& scene)
      {
        const double* const b = scene.image->GetBounds();
        scene.mapper->CroppingOn();
        scene.mapper->SetCroppingRegionPlanes(b[0], 0.5 * (b[0] + b[1]), b[2], b[3], b[4], b[5]);
        scene.mapper->SetCroppingRegionFlagsToSubVolume();
      } },
    { "place", [](MapperScene& scene) { scene.volume->RotateX(15.0); } },
    { "voxels",
      [](MapperScene& scene)
      {
        auto* const voxels = static_cast<short*>(scene.image->GetScalarPointer());
        std::reverse(voxels, voxels + scene.image->GetNumberOfPoints());
        scene.image->GetPointData()->GetScalars()->Modified();
        scene.image->Modified();
      } },
    { "tolerance", [](MapperScene& scene) { scene.mapper->SetErrorTolerance(1.0 / 200.0); } },
    { "spline", [](MapperScene& scene) { scene.mapper->CubicInterpolationOn(); } },
  };
  return changes;
}

}

// Light that is kept from the picture before would show, and so would a node that depends on which
// ray has filled it.
TEST(Shadows, AfterAnyChangeAreThoseOfANewVolume)
{
  constexpr double SoftEnoughForALattice = 0.1;
  for (const LightChange& change : LightChanges())
  {
    ShadowedTorso kept(48);
    kept.SetMostOpacity(SoftEnoughForALattice);
    kept.scene.mapper->SetErrorTolerance(1.0 / 64.0); // without one there is no lattice
    const std::vector<float> before = kept.scene.DrawByProcessor();
    EXPECT_EQ(kept.scene.DrawByProcessor(), before) << change.name;
    change.change(kept.scene);
    ShadowedTorso fresh(48);
    fresh.SetMostOpacity(SoftEnoughForALattice);
    fresh.scene.mapper->SetErrorTolerance(1.0 / 64.0);
    change.change(fresh.scene);
    const std::vector<float> after = kept.scene.DrawByProcessor();
    EXPECT_EQ(after, fresh.scene.DrawByProcessor()) << change.name;
    EXPECT_NE(after, before) << change.name << ": nothing has changed";
  }
}

// The other rule has other samples in packets than in the shader.
TEST(Shadows, OfPacketsAreThoseOfTheShader)
{
  for (const double sampleDistanceMm : { 4.0, 2.0 })
  {
    // llvmpipe ends the shader of shorter steps.
    ShadowedTorso torso(32);
    torso.scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::PreIntegrated);
    torso.scene.mapper->AutoAdjustSampleDistancesOff();
    torso.scene.mapper->SetSampleDistance(sampleDistanceMm);
    const std::vector<float> drawn = torso.scene.Draw();
    EXPECT_TRUE(torso.scene.UsesShaderPart("Reach/ShadowRays.glsl"));
    const std::vector<float> marched = torso.scene.DrawByProcessor();
    EXPECT_FALSE(torso.scene.UsesShaderPart("Reach/ShadowRays.glsl")) << "packets march";
    EXPECT_LT(CompareImages(marched.data(), drawn.data(), drawn.size() / 4).largest, 4.0);
  }
}

TEST(Shadows, TakeTheirShaderOnlyWhereTheyAre)
{
  ShadowedTorso torso(16);
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Reach/ShadowRays.glsl"));
  const vtkIdType bytes = torso.scene.mapper->GetGraphicsMemoryBytes();
  torso.scene.mapper->ShadowsOff();
  torso.scene.Draw();
  EXPECT_FALSE(torso.scene.UsesShaderPart("Reach/ShadowRays.glsl"));
  EXPECT_EQ(torso.scene.mapper->GetGraphicsMemoryBytes(), bytes) << "rays need no memory";
  torso.scene.mapper->ShadowsOn();
  torso.scene.renderer->RemoveAllLights();
  vtkNew<vtkLight> headLight;
  headLight->SetLightTypeToHeadlight();
  torso.scene.renderer->AddLight(headLight);
  torso.scene.Draw();
  EXPECT_FALSE(torso.scene.UsesShaderPart("Reach/ShadowRays.glsl")) << "the eye sees no shadow";
}

TEST(Shadows, OfAVolumeInBlocksAreLeftOutWithASentence)
{
  ShadowedTorso torso(16);
  torso.scene.mapper->SetMaximumGraphicsMemory(60000);
  ExpectedVtkErrors warnings;
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Resume/Block.glsl")) << "the volume fits into one block";
  EXPECT_NE(warnings.Text().find("has no shadows"), std::string::npos) << warnings.Text();
}
