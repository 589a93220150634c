// Shadows of a torso, compared with a reference that integrates the light's way through the volume
// in double precision.

#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace varimarch;

namespace
{

// A turned torso under a sun and a lamp.
class ShadowedTorso
{
public:
  explicit ShadowedTorso(int size)
    : scene(SmallTorso(), size)
  {
    CastShadowsOfSunAndLamp(this->scene);
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
    return this->scene.TruthOf(MaterialInOwnShadows(this->scene, tolerance), tolerance);
  }

  MapperScene scene;
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
    { "strength", [](MapperScene& scene) { scene.mapper->SetShadowStrength(0.6); } },
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

// Both arrays are of one image, so that no modification time tells them apart.
TEST(Shadows, OfAnotherArrayAreItsOwn)
{
  const auto addMirrored = [](MapperScene& scene)
  {
    vtkDataArray* const scalars = scene.image->GetPointData()->GetScalars();
    const auto mirrored = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    mirrored->DeepCopy(scalars);
    mirrored->SetName("mirrored");
    auto* const voxels = static_cast<short*>(mirrored->GetVoidPointer(0));
    std::reverse(voxels, voxels + mirrored->GetNumberOfTuples());
    scene.image->GetPointData()->AddArray(mirrored);
  };
  const auto drawMirrored = [](MapperScene& scene)
  {
    scene.mapper->SetScalarModeToUsePointFieldData();
    scene.mapper->SelectScalarArray("mirrored");
    return scene.DrawByProcessor();
  };
  ShadowedTorso kept(48);
  ShadowedTorso fresh(48);
  for (ShadowedTorso* torso : { &kept, &fresh })
  {
    torso->SetMostOpacity(0.1);
    torso->scene.mapper->SetErrorTolerance(1.0 / 64.0);
    addMirrored(torso->scene);
  }
  const std::vector<float> before = kept.scene.DrawByProcessor();
  const std::vector<float> after = drawMirrored(kept.scene);
  EXPECT_EQ(after, drawMirrored(fresh.scene));
  EXPECT_NE(after, before);
}

// No time of the mask or of its image tells how its values are meant.
TEST(Shadows, OfAMaskOfAnotherKindAreItsOwn)
{
  const auto inBinary = [](ShadowedTorso& torso)
  {
    torso.scene.mapper->SetMaskTypeToBinary();
    return torso.scene.DrawByProcessor();
  };
  ShadowedTorso kept(48);
  ShadowedTorso fresh(48);
  for (ShadowedTorso* torso : { &kept, &fresh })
  {
    torso->SetMostOpacity(0.1);
    torso->scene.mapper->SetErrorTolerance(1.0 / 64.0);
    torso->scene.mapper->SetMaskInput(
      MaskOf({ 40, 36, 24 }, [](glm::ivec3 voxel) { return voxel.z < 16 ? 1 : 0; }));
    vtkNew<vtkPiecewiseFunction> thin;
    thin->AddPoint(-200.0, 0.0);
    thin->AddPoint(300.0, 0.02);
    torso->scene.volume->GetProperty()->SetLabelScalarOpacity(1, thin);
  }
  const std::vector<float> before = kept.scene.DrawByProcessor();
  const std::vector<float> after = inBinary(kept);
  EXPECT_EQ(after, inBinary(fresh));
  EXPECT_NE(after, before);
}

TEST(Shadows, KeepTheirLatticesUntilTheirLightChanges)
{
  ShadowedTorso torso(16);
  torso.SetMostOpacity(0.1);
  torso.scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const auto buildsAfterDrawing = [&]
  {
    torso.scene.DrawByProcessor();
    return torso.scene.mapper->GetLightLatticeBuilds();
  };
  const int builds = buildsAfterDrawing();
  EXPECT_EQ(builds, 2) << "a sun and a lamp";
  torso.scene.mapper->SetShadowStrength(0.5);
  EXPECT_EQ(buildsAfterDrawing(), builds) << "strength";
  torso.scene.mapper->SetDampingGradient(5.0);
  EXPECT_EQ(buildsAfterDrawing(), builds) << "damping";
  torso.scene.mapper->SetVolumetricScatteringBlending(0.5);
  torso.scene.mapper->SetScatteringAnisotropy(0.3);
  EXPECT_EQ(buildsAfterDrawing(), builds) << "scattering";
  torso.SetMostOpacity(0.05);
  EXPECT_EQ(buildsAfterDrawing(), 2 * builds) << "opacity";
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

TEST(Shadows, KeepNoLatticeWhereTheyAreOff)
{
  ShadowedTorso torso(16);
  torso.SetMostOpacity(0.1);
  torso.scene.mapper->SetErrorTolerance(1.0 / 64.0);
  torso.scene.DrawByProcessor();
  EXPECT_GT(torso.scene.mapper->GetLightMemoryBytes(), 0);
  torso.scene.mapper->ShadowsOff();
  torso.scene.DrawByProcessor();
  EXPECT_EQ(torso.scene.mapper->GetLightMemoryBytes(), 0);
}

namespace
{

// The volume has 69120 bytes of voxels, so that it does not fit.
constexpr vtkIdType TooLittleMemory = 60000;

}

TEST(Shadows, OfAVolumeThatDoesNotFitAreThoseOfOneThatDoes)
{
  ShadowedTorso torso(16);
  MapperScene& scene = torso.scene;
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const std::vector<float> whole = scene.DrawByProcessor();
  scene.mapper->SetMaximumGraphicsMemory(TooLittleMemory);
  EXPECT_EQ(scene.DrawByProcessor(), whole);
  EXPECT_EQ(scene.mapper->GetBlockUploads(), 0) << "packets read the voxels of the caller";
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), TooLittleMemory);
  const int fields = scene.mapper->GetFieldBuilds();
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetFieldBuilds(), fields) << "only the camera has moved";
}

// With a bound of the graphics memory a device draws what it can.
TEST(Shadows, AreDrawnByPacketsOnAnyDevice)
{
  ShadowedTorso torso(16);
  MapperScene& scene = torso.scene;
  scene.mapper->SetProcessorMarching(true);
  for (const vtkIdType memory : { vtkIdType(100000000), TooLittleMemory })
  {
    const bool fits = memory > TooLittleMemory;
    scene.mapper->SetMaximumGraphicsMemory(memory);
    scene.mapper->ShadowsOff();
    scene.Draw();
    EXPECT_TRUE(scene.UsesShaderPart(fits ? "Resume/Whole.glsl" : "Resume/Block.glsl")) << memory;
    scene.mapper->ShadowsOn();
    scene.Draw();
    EXPECT_TRUE(scene.ShaderParts().empty()) << memory;
  }
}

TEST(Shadows, InBlocksOfShadersAreLeftOutWithASentence)
{
  ShadowedTorso torso(16);
  torso.scene.mapper->SetMaximumGraphicsMemory(TooLittleMemory);
  torso.scene.mapper->SetProcessorMarching(false);
  ExpectedVtkErrors warnings;
  torso.scene.Draw();
  EXPECT_TRUE(torso.scene.UsesShaderPart("Resume/Block.glsl")) << "the volume fits into one block";
  EXPECT_NE(warnings.Text().find("has no shadows"), std::string::npos) << warnings.Text();
}
