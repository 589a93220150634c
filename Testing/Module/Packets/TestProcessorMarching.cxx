// Rays marched by the processor in packets, used when the processor also runs OpenGL: when they are
// used, and what they support.

#include "Module/Scenes/ProcessorMarching.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkAbstractArray.h>
#include <vtkHardwareSelector.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <cmath>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

}

class ProcessorMarchingOfScenes
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingOfScenes, HasNothingButPixelsOnTheDevice)
{
  vtkNew<vtkPlane> plane; // oblique, since other planes only change the box
  plane->SetNormal(1.0, 1.0, 1.0);
  const auto prepare = [&](MapperScene& scene)
  {
    GetParam().make(scene);
    scene.mapper->UseJitteringOn();
    scene.mapper->AddClippingPlane(plane);
    LeaveLowerGradientsOut(scene);
    ShineFromTheSide(scene);
    scene.renderer->GetActiveCamera()->Zoom(8.0); // until every pixel sees something
  };
  MapperScene scene(SmallTorso());
  prepare(scene);
  scene.mapper->ProcessorMarchingOn();
  scene.Draw();
  const vtkIdType pixels = vtkIdType(scene.size) * scene.size * 4 * vtkIdType(sizeof(float));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), pixels);
  scene.mapper->ProcessorMarchingOff();
  scene.Draw();
  MapperScene byShader(SmallTorso());
  prepare(byShader);
  const std::vector<float> drawn = byShader.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), byShader.mapper->GetGraphicsMemoryBytes());
  EXPECT_EQ(scene.Draw(), drawn);
}

INSTANTIATE_TEST_SUITE_P(EveryTable, ProcessorMarchingOfScenes,
  testing::Values(Change{ "AComposite", [](MapperScene&) {} },
    Change{ "AMaximum", [](MapperScene& s) { s.mapper->SetBlendModeToMaximumIntensity(); } },
    Change{ "Isosurfaces", [](MapperScene& s) { s.mapper->SetBlendModeToIsoSurface(); } },
    Change{ "AFunctionOfValueAndGradient", ShowValueAndGradient }),
  NameOf);

// At these tolerances no single ray is decisive, so rounding does not matter.
TEST_F(ProcessorMarching, FindsTheStepsOfTheShaderForATolerance)
{
  for (const double tolerance : { 1.0 / 32.0, 1.0 / 128.0 })
  {
    MapperScene scene(SmallTorso());
    scene.mapper->SetErrorTolerance(tolerance);
    ASSERT_TRUE(ByProcessor(scene));
    const double ofPackets = scene.mapper->GetUsedSampleDistance();
    scene.Draw();
    ASSERT_FALSE(scene.ShaderParts().empty());
    EXPECT_NEAR(scene.mapper->GetUsedSampleDistance(), ofPackets, 0.02 * ofPackets);
  }
}

TEST_F(ProcessorMarching, SeesWhatChanges)
{
  MapperScene scene(SmallTorso());
  ExpectSamePicture(scene);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-400.0, 0.0);
  scene.opacities->AddPoint(-100.0, 0.05);
  ExpectSamePicture(scene);
  short* const voxels = static_cast<short*>(scene.image->GetScalarPointer());
  std::fill(voxels, voxels + 40 * 36 * 12, short(-1000));
  scene.image->Modified();
  ExpectSamePicture(scene);
}

// The smallest volume that packets support; they read pairs up to its very end.
TEST_F(ProcessorMarching, ReadsNothingBeyondTheLastVoxel)
{
  vtkNew<vtkImageData> cell;
  cell->SetDimensions(2, 2, 2);
  cell->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < 8; ++i)
  {
    static_cast<short*>(cell->GetScalarPointer())[i] = short(50 * i);
  }
  MapperScene scene(cell);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.9);
  ExpectSamePicture(scene);
}

// A strip is a part of the pixels, so its packets start at other pixels.
TEST_F(ProcessorMarching, InPartsIsThePictureInTheEnd)
{
  MapperScene scene(SmallTorso(), 150);
  scene.mapper->ProcessorMarchingOn();
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetLongestPartSeconds(1e-9);
  std::vector<float> last;
  do
  {
    last = scene.Draw();
  } while (scene.mapper->GetDrawnPart() < 1.0);
  EXPECT_TRUE(scene.ShaderParts().empty());
  const varimarch::ImageError difference =
    varimarch::CompareImages(last.data(), whole.data(), whole.size() / 4);
  EXPECT_LT(difference.largest, 0.01);
}

// Resources of shaders are freed when unneeded, and return when needed.
TEST_F(ProcessorMarching, ComesAndGoes)
{
  MapperScene scene(SmallTorso());
  scene.mapper->ProcessorMarchingOn();
  const std::vector<float> first = scene.Draw();
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  vtkNew<vtkPlane> plane;
  scene.volume->GetProperty()->SetSliceFunction(plane);
  scene.mapper->SetBlendMode(vtkVolumeMapper::SLICE_BLEND); // packets do not support slices
  EXPECT_NE(scene.Draw(), first);
  EXPECT_FALSE(scene.ShaderParts().empty());
  scene.mapper->SetBlendModeToComposite();
  EXPECT_EQ(scene.Draw(), first);
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 1);
}

// Bone through skin, in a part of the volume, where rays first become visible.
TEST_F(ProcessorMarching, FindsTheDepthsOfTheShader)
{
  for (const bool clamped : { false, true })
  {
    MapperScene scene(SmallTorso());
    Clip(scene);
    scene.mapper->RenderToImageOn();
    scene.mapper->SetClampDepthToBackface(clamped);
    ASSERT_TRUE(ByProcessor(scene));
    vtkNew<vtkImageData> ofPackets;
    scene.mapper->GetDepthImage(ofPackets);
    scene.Draw();
    ASSERT_FALSE(scene.ShaderParts().empty());
    vtkNew<vtkImageData> ofShader;
    scene.mapper->GetDepthImage(ofShader);
    int others = 0;
    int seen = 0;
    for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
    {
      const auto depthOf = [&](vtkImageData* image)
      { return static_cast<const float*>(image->GetScalarPointer())[pixel]; };
      seen += depthOf(ofShader) < 1.0f ? 1 : 0;
      others += std::abs(depthOf(ofPackets) - depthOf(ofShader)) > 2e-3f ? 1 : 0;
    }
    EXPECT_GT(seen, scene.size * scene.size / 10);
    EXPECT_LT(others, seen / 200); // rays that graze the visible part
  }
}

TEST_F(ProcessorMarching, SelectsWithoutVoxelsOnTheDevice)
{
  MapperScene scene(SmallTorso());
  ASSERT_TRUE(ByProcessor(scene));
  scene.mapper->ProcessorMarchingOn();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, 95, 95);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  EXPECT_GT(selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples(), 1000);
  EXPECT_TRUE(scene.ShaderParts().empty());
  const vtkIdType pixels = vtkIdType(scene.size) * scene.size * 4 * vtkIdType(sizeof(float));
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), pixels);
}

TEST_F(ProcessorMarching, TakesMoreSamplesThanShadersMay)
{
  MapperScene scene(SmallTorso(), 16);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(scene.image->GetLength() / 60000.0);
  const std::vector<float> truth = scene.Truth();
  for (const bool byProcessor : { false, true })
  {
    scene.mapper->SetProcessorMarching(byProcessor);
    const ExpectedVtkErrors itIsTooShort;
    const std::vector<float> drawn = scene.Draw();
    EXPECT_EQ(itIsTooShort.Messages().empty(), byProcessor);
    const varimarch::ImageError error =
      varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LT(error.largest, 0.3);
  }
}

TEST_F(ProcessorMarching, LeavesShadersTheirLongerSteps)
{
  const ExpectedVtkErrors itCannotBeKept;
  MapperScene scene(
    varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 64, 64 }, 7 }), 16);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetErrorTolerance(1e-6);
  scene.mapper->ProcessorMarchingOn();
  scene.Draw();
  const double shortestOfLit = scene.image->GetLength() / 10000.0;
  EXPECT_LT(scene.mapper->GetUsedSampleDistance(), 0.95 * shortestOfLit);
  scene.mapper->DrawFetchCountsOn();
  scene.Draw();
  EXPECT_GT(scene.mapper->GetUsedSampleDistance(), 0.95 * shortestOfLit);
}
