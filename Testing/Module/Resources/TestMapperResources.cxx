// Resources that are built and kept, and error messages.

#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"
#include "VtkVersions.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace
{

struct Counts
{
  int volume;
  int ranges;
  int field;
  int table;
  int shader;

  bool operator==(const Counts& other) const
  {
    return volume == other.volume && ranges == other.ranges && field == other.field &&
      table == other.table && shader == other.shader;
  }
};

std::ostream& operator<<(std::ostream& stream, const Counts& counts)
{
  return stream << "volume " << counts.volume << ", ranges " << counts.ranges << ", field "
                << counts.field << ", table " << counts.table << ", shader " << counts.shader;
}

Counts CountsOf(vtkVariationFieldVolumeMapper* mapper)
{
  return { mapper->GetVolumeTextureBuilds(), mapper->GetBrickRangesBuilds(),
    mapper->GetFieldBuilds(), mapper->GetOpticalTableBuilds(), mapper->GetShaderBuilds() };
}

// Numbers of resources that a change makes the next rendering build.
Counts BuiltBy(MapperScene& scene, const std::function<void()>& change)
{
  scene.window->Render();
  const Counts before = CountsOf(scene.mapper);
  change();
  scene.window->Render();
  const Counts after = CountsOf(scene.mapper);
  return { after.volume - before.volume, after.ranges - before.ranges, after.field - before.field,
    after.table - before.table, after.shader - before.shader };
}

const Counts nothing{ 0, 0, 0, 0, 0 };

}

// The rows of the table in Documentation/Architecture.md.

TEST(Rebuilds, TheFirstPictureBuildsEverythingOnce)
{
  MapperScene scene(SmallTorso());
  scene.window->Render();
  EXPECT_EQ(CountsOf(scene.mapper), (Counts{ 1, 1, 1, 1, 1 }));
}

TEST(Rebuilds, ChangedScalarsRebuildAllThatIsMadeOfThem)
{
  MapperScene scene(SmallTorso());
  EXPECT_EQ(BuiltBy(scene, [&] { scene.image->GetPointData()->GetScalars()->Modified(); }),
    (Counts{ 1, 1, 1, 0, 0 }));
  EXPECT_EQ(BuiltBy(scene,
              [&]
              {
                scene.image = SmallTorso();
                scene.mapper->SetInputData(scene.image);
              }),
    (Counts{ 1, 1, 1, 0, 0 }));
  EXPECT_EQ(BuiltBy(scene,
              [&]
              {
                scene.image->SetScalarComponentFromDouble(0, 0, 0, 0, 5000.0);
                scene.image->GetPointData()->GetScalars()->Modified();
              }),
    (Counts{ 1, 1, 1, 1, 0 }))
    << "another range";
}

TEST(Rebuilds, AChangedTransferFunctionRebuildsTheTableAndTheClassesOfBricks)
{
  MapperScene scene(SmallTorso());
  const Counts expected{ 0, 0, 1, 1, 0 };
  EXPECT_EQ(BuiltBy(scene, [&] { scene.opacities->AddPoint(300.0, 0.3); }), expected);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.colors->AddRGBPoint(300.0, 0.3, 0.1, 0.0); }), expected);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.volume->GetProperty()->SetScalarOpacityUnitDistance(2.0); }),
    expected);
}

TEST(Rebuilds, AReplacedFunctionCountsAsAChangeHoweverOldItIs)
{
  vtkNew<vtkPiecewiseFunction> older;
  older->AddPoint(150.0, 0.0);
  older->AddPoint(400.0, 0.5);
  MapperScene scene(SmallTorso());
  scene.colors->Modified(); // newer than both opacity functions
  EXPECT_EQ(BuiltBy(scene, [&] { scene.volume->GetProperty()->SetScalarOpacity(older); }),
    (Counts{ 0, 0, 1, 1, 0 }));
}

TEST(Rebuilds, TheCellFieldIsIndependentOfTheTransferFunction)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetAccelerationModeToCellField();
  EXPECT_EQ(
    BuiltBy(scene, [&] { scene.opacities->AddPoint(300.0, 0.3); }), (Counts{ 0, 0, 0, 1, 0 }));
  EXPECT_EQ(
    BuiltBy(scene, [&] { scene.mapper->SetVariationTolerance(30.0); }), (Counts{ 0, 0, 1, 0, 0 }));
}

TEST(Rebuilds, AnotherChoiceTakesAnotherShader)
{
  MapperScene scene(SmallTorso());
  // Light varies where colours do not, so the field has no homogeneous bricks.
  EXPECT_EQ(
    BuiltBy(scene, [&] { scene.volume->GetProperty()->ShadeOn(); }), (Counts{ 0, 0, 1, 0, 1 }));
  EXPECT_EQ(
    BuiltBy(scene, [&] { scene.mapper->SetAccelerationModeToOff(); }), (Counts{ 0, 0, 0, 0, 1 }));
  EXPECT_EQ(BuiltBy(scene, [&] { scene.mapper->SetBlendModeToMaximumIntensity(); }),
    (Counts{ 0, 0, 0, 0, 1 }));
}

TEST(Rebuilds, CameraLightStepAndWindowSizeRebuildNothing)
{
  MapperScene scene(SmallTorso());
  scene.volume->GetProperty()->ShadeOn();
  EXPECT_EQ(BuiltBy(scene, [&] { scene.renderer->GetActiveCamera()->Azimuth(10.0); }), nothing);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.volume->RotateX(10.0); }), nothing);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.volume->GetProperty()->SetAmbient(0.3); }), nothing);
  EXPECT_EQ(BuiltBy(scene,
              [&]
              {
                scene.mapper->AutoAdjustSampleDistancesOff();
                scene.mapper->SetSampleDistance(3.0);
              }),
    nothing);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.mapper->SetEarlyTerminationTransmittance(0.1); }), nothing);
  EXPECT_EQ(BuiltBy(scene, [&] { scene.window->SetSize(64, 48); }), nothing);
}

TEST(Resources, NothingIsResidentThatTheSceneDoesNotNeed)
{
  MapperScene scene(SmallTorso());
  const vtkIdType volumeBytes = 40 * 36 * 24 * 2;
  const vtkIdType tableBytes = 1024 * 16;
  const vtkIdType brickBytes = 10 * 9 * 6;
  const vtkIdType cellBytes = 39 * 35 * 23;
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), volumeBytes + tableBytes + brickBytes);

  scene.mapper->SetAccelerationModeToCellField();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), volumeBytes + tableBytes + cellBytes);

  scene.mapper->SetAccelerationModeToOff();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), volumeBytes + tableBytes);

  scene.mapper->ReleaseGraphicsResources(scene.window);
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), 0);
}

TEST(Resources, AFieldWithHardlyABrickToSkipIsNotResident)
{
  MapperScene scene(SmallTorso());
  scene.volume->GetProperty()->ShadeOn();
  const auto stepAndBytes = [&]
  {
    scene.window->Render();
    const std::vector<std::string> parts = scene.ShaderParts();
    const auto step = std::find_if(parts.begin(), parts.end(),
      [](const std::string& part) { return part.rfind("Step/", 0) == 0; });
    return std::pair(*step, scene.mapper->GetGraphicsMemoryBytes());
  };
  const auto [skipping, withField] = stepAndBytes();
  EXPECT_EQ(skipping, "Step/OpticalField.glsl");

  scene.opacities->AddPoint(-2000.0, 0.01); // air, too
  const auto [growing, withoutField] = stepAndBytes();
  EXPECT_EQ(growing, "Step/Growing.glsl");
  EXPECT_EQ(withoutField, withField - 10 * 9 * 6);
}

// A table of mean values over pairs needs enough entries for a narrow peak.
TEST(Resources, ATableOfMeansIsAsLargeAsTheFunctionNeeds)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::PreIntegrated);
  scene.colors->RemoveAllPoints();
  const auto bytes = [&](double width)
  {
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(-1024.0, 0.01);
    scene.opacities->AddPoint(300.0 - width, 0.0);
    scene.opacities->AddPoint(300.0, 0.5);
    scene.opacities->AddPoint(300.0 + width, 0.0);
    scene.window->Render();
    return scene.mapper->GetGraphicsMemoryBytes();
  };
  const vtkIdType ofWide = bytes(900.0);
  const vtkIdType ofNarrow = bytes(120.0);
  EXPECT_GE(ofWide, 256 * 256 * 16);
  EXPECT_EQ(ofNarrow - ofWide, (1024 * 1024 - 256 * 256) * 16);
}

TEST(Resources, TheDepthBufferIsCopiedOnlyForOpaqueGeometry)
{
  MapperScene scene(SmallTorso());
  const auto hasDepth = [&]
  {
    scene.window->Render();
    return scene.UsesShaderPart("Depth/SceneGeometry.glsl");
  };
  EXPECT_FALSE(hasDepth());
  const vtkIdType without = scene.mapper->GetGraphicsMemoryBytes();
  const double middle[3] = {};
  const vtkSmartPointer<vtkActor> actor = Ball(middle, 0.5);
  scene.renderer->AddActor(actor);
  EXPECT_TRUE(hasDepth());
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), without + 96 * 96 * 5);
  actor->VisibilityOff();
  EXPECT_FALSE(hasDepth());
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), without);
}

TEST(Resources, EveryScalarTypeDrawsTheSamePicture)
{
  // Values that every type can represent.
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  auto* voxels = static_cast<short*>(torso->GetScalarPointer());
  for (vtkIdType i = 0; i < torso->GetNumberOfPoints(); ++i)
  {
    voxels[i] = short(std::clamp((voxels[i] + 200) / 8, 0, 120));
  }
  // A scene for each type: in a series of new volumes, the steps follow from those before. No
  // field: it counts the ranges of bricks in whole numbers for integers, and in finer steps for
  // floats.
  const auto drawn = [](vtkImageData* image)
  {
    MapperScene scene(image);
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(20.0, 0.0);
    scene.opacities->AddPoint(100.0, 0.2);
    scene.mapper->SetAccelerationMode(vtkVariationFieldVolumeMapper::Off);
    return scene.Draw();
  };
  const std::vector<float> expected = drawn(torso);
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkSmartPointer<vtkDataArray> scalars;
    scalars.TakeReference(vtkDataArray::CreateDataArray(type));
    scalars->DeepCopy(torso->GetPointData()->GetScalars());
    vtkNew<vtkImageData> image;
    image->CopyStructure(torso);
    image->GetPointData()->SetScalars(scalars);
    const std::vector<float> ofType = drawn(image);
    EXPECT_LT(varimarch::CompareImages(ofType.data(), expected.data(), 96 * 96).largest, 0.05)
      << scalars->GetDataTypeAsString();
  }
}

TEST(Errors, AreReportedOnceAndClearedByABetterInput)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkImageData> colors;
  colors->SetDimensions(4, 4, 4);
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 5);
  scene.mapper->SetInputData(colors);
  {
    ExpectedVtkErrors errors;
    scene.window->Render();
    scene.window->Render();
    ASSERT_EQ(errors.Messages().size(), 1u);
    EXPECT_NE(errors.Text().find("has 5 components: expected 1 to 4"), std::string::npos);
  }
  scene.mapper->SetInputData(scene.image);
  scene.window->Render();
  scene.mapper->SetInputData(colors);
  ExpectedVtkErrors errors;
  scene.window->Render();
  EXPECT_EQ(errors.Messages().size(), 1u);
}

TEST(Errors, AnUnsupportedBlendModeIsNamed)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetBlendMode(99);
  ExpectedVtkErrors errors;
  scene.window->Render();
  EXPECT_NE(errors.Text().find("is not supported: expected composite"), std::string::npos);
}

TEST(State, OpenGLIsUnchangedAfterAFrame)
{
  MapperScene scene(SmallTorso());
  scene.volume->VisibilityOff();
  scene.window->Render();
  const auto state = [&]
  {
    scene.window->MakeCurrent();
    std::array<GLint, 6> values{};
    glGetIntegerv(GL_CULL_FACE_MODE, &values[0]);
    glGetIntegerv(GL_BLEND_SRC_RGB, &values[1]);
    glGetIntegerv(GL_BLEND_DST_ALPHA, &values[2]);
    values[3] = glIsEnabled(GL_DEPTH_CLAMP);
    values[4] = glIsEnabled(GL_DEPTH_TEST);
    values[5] = glIsEnabled(GL_CULL_FACE);
    return values;
  };
  const auto before = state();
  scene.volume->VisibilityOn();
  scene.window->Render();
  EXPECT_EQ(state(), before);
}

TEST(State, SurvivesAnotherWindow)
{
  MapperScene scene(SmallTorso());
  const std::vector<float> expected = scene.Draw();
  vtkNew<vtkHeadlessRenderWindow> other;
  other->SetSize(96, 96);
  scene.window->RemoveRenderer(scene.renderer);
  other->AddRenderer(scene.renderer);
  other->Render();
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 2);
  other->RemoveRenderer(scene.renderer);
  scene.window->AddRenderer(scene.renderer);
  EXPECT_LT(varimarch::CompareImages(scene.Draw().data(), expected.data(), 96 * 96).largest, 1e-3);
}
