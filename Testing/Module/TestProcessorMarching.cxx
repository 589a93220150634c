// Rays that the processor marches, in packets, where OpenGL is drawn by it too: the pictures are
// those of the shaders, to a few units in the last place of what they add up.

#include "Core/Packets/PacketMarch.h"
#include "Module/MapperScene.h"

#include <vtkImageCast.h>
#include <vtkImageShiftScale.h>
#include <vtkLight.h>
#include <vtkPlane.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

class ProcessorMarching : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!varimarch::CanMarchPackets())
    {
      GTEST_SKIP() << "this processor has no AVX2 and FMA";
    }
  }
};

bool ByProcessor(MapperScene& scene)
{
  scene.DrawByProcessor();
  return scene.ShaderParts().empty();
}

void ExpectSamePicture(MapperScene& scene)
{
  const std::vector<float> marched = scene.DrawByProcessor();
  ASSERT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
  const std::vector<float> drawn = scene.Draw();
  ASSERT_FALSE(scene.ShaderParts().empty());
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1) << "the picture is empty";
  const varimarch::ImageError difference =
    varimarch::CompareImages(marched.data(), drawn.data(), drawn.size() / 4);
  EXPECT_LT(difference.rootMeanSquare, 0.05);
  EXPECT_LT(difference.percentile999, 0.5);
}

vtkSmartPointer<vtkImageData> TorsoOfType(int type)
{
  vtkNew<vtkImageShiftScale> bytes;
  bytes->SetInputData(SmallTorso());
  const bool narrow = type == VTK_UNSIGNED_CHAR || type == VTK_SIGNED_CHAR || type == VTK_CHAR;
  bytes->SetShift(type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ? 1024.0 : 0.0);
  bytes->SetScale(narrow ? 1.0 / 16.0 : 1.0);
  bytes->ClampOverflowOn();
  bytes->SetOutputScalarType(type);
  bytes->Update();
  return bytes->GetOutput();
}

// From a tenth of the values on.
void ShowUpperValues(MapperScene& scene)
{
  double range[2];
  scene.image->GetScalarRange(range);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(range[0] + 0.55 * (range[1] - range[0]), 0.0);
  scene.opacities->AddPoint(range[1], 0.4);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(range[0], 0.8, 0.3, 0.2);
  scene.colors->AddRGBPoint(range[1], 1.0, 0.95, 0.85);
}

// Half of it is clipped away obliquely.
void Clip(MapperScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.4, 0.2);
  scene.mapper->AddClippingPlane(plane);
}

struct Change
{
  const char* name;
  std::function<void(MapperScene&)> make;
};

void PrintTo(const Change& change, std::ostream* os)
{
  *os << change.name;
}

std::string NameOf(const testing::TestParamInfo<Change>& info)
{
  return info.param.name;
}

}

class ProcessorMarchingOf
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingOf, IsThePictureOfTheShader)
{
  MapperScene scene(SmallTorso());
  GetParam().make(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryPart, ProcessorMarchingOf,
  testing::Values(Change{ "Midpoints", [](MapperScene&) {} },
    Change{ "Light", [](MapperScene& s) { s.volume->GetProperty()->ShadeOn(); } },
    Change{ "Highlights",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.volume->GetProperty()->SetSpecular(0.7);
        s.volume->GetProperty()->SetSpecularPower(23.0);
      } },
    Change{ "Damping",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        s.mapper->SetDampingGradient(200.0);
      } },
    Change{ "PreIntegration",
      [](MapperScene& s)
      {
        // Its segments are half as long as a shader's: at steps as short as these that is the same.
        s.mapper->SetIntegrationRule(Mapper::PreIntegrated);
        s.mapper->AutoAdjustSampleDistancesOff();
        s.mapper->SetSampleDistance(0.5);
      } },
    Change{ "NoField", [](MapperScene& s) { s.mapper->SetAccelerationModeToOff(); } },
    Change{ "NoFieldAndLight",
      [](MapperScene& s)
      {
        s.mapper->SetAccelerationModeToOff();
        s.volume->GetProperty()->ShadeOn();
      } },
    Change{ "Noise", [](MapperScene& s) { s.mapper->UseJitteringOn(); } },
    Change{ "ClippingPlanes", Clip },
    Change{ "Geometry",
      [](MapperScene& s)
      {
        const double middle[3] = { 0.0, 0.0, 0.0 };
        s.renderer->AddActor(Ball(middle, 80.0));
      } },
    Change{ "WindowAndLevel",
      [](MapperScene& s)
      {
        s.mapper->SetFinalColorWindow(0.6f);
        s.mapper->SetFinalColorLevel(0.4f);
      } },
    Change{ "AParallelProjection",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->ParallelProjectionOn();
        s.renderer->GetActiveCamera()->SetParallelScale(180.0);
      } },
    Change{ "AViewAlongAnAxis",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 1.0);
        s.renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
        s.renderer->ResetCamera();
      } },
    Change{ "AnEyeInTheVolume",
      [](MapperScene& s)
      {
        s.renderer->GetActiveCamera()->SetPosition(0.0, 20.0, 0.0);
        s.renderer->ResetCameraClippingRange();
      } },
    Change{ "ATolerance", [](MapperScene& s) { s.mapper->SetErrorTolerance(1.0 / 64.0); } },
    Change{ "FewerRays",
      [](MapperScene& s)
      {
        s.mapper->SetImageSampleDistance(2.0f);
        const double middle[3] = { 0.0, 0.0, 0.0 };
        s.renderer->AddActor(Ball(middle, 80.0));
      } },
    Change{ "MeanOfPictures", [](MapperScene& s) { s.mapper->SetMaximumAccumulatedPictures(2); } }),
  NameOf);

class ProcessorMarchingOfVoxels
  : public ProcessorMarching
  , public testing::WithParamInterface<int>
{
};

TEST_P(ProcessorMarchingOfVoxels, IsThePictureOfTheShader)
{
  MapperScene scene(TorsoOfType(GetParam()));
  ShowUpperValues(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryType, ProcessorMarchingOfVoxels,
  testing::Values(
    VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_FLOAT));

class ProcessorMarchingIsNotFor
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingIsNotFor, SoAShaderDraws)
{
  MapperScene scene(SmallTorso());
  ASSERT_TRUE(ByProcessor(scene));
  GetParam().make(scene);
  const std::vector<float> drawn = scene.DrawByProcessor();
  EXPECT_FALSE(scene.ShaderParts().empty());
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.0);
}

INSTANTIATE_TEST_SUITE_P(EveryOther, ProcessorMarchingIsNotFor,
  testing::Values(
    Change{ "AMaximum", [](MapperScene& s) { s.mapper->SetBlendModeToMaximumIntensity(); } },
    Change{
      "Boxes", [](MapperScene& s) { s.volume->GetProperty()->SetInterpolationTypeToNearest(); } },
    Change{ "ASpline", [](MapperScene& s) { s.mapper->CubicInterpolationOn(); } },
    Change{ "Simpson", [](MapperScene& s) { s.mapper->SetIntegrationRule(Mapper::Simpson); } },
    Change{
      "TheScalarField", [](MapperScene& s) { s.mapper->SetAccelerationModeToScalarField(); } },
    Change{ "CountsOfReadings", [](MapperScene& s) { s.mapper->SetDrawFetchCounts(true); } },
    Change{ "LittleMemory", [](MapperScene& s) { s.mapper->SetMaximumGraphicsMemory(1 << 26); } },
    Change{ "ALightFromTheSide",
      [](MapperScene& s)
      {
        s.volume->GetProperty()->ShadeOn();
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPosition(100.0, 0.0, 0.0);
        s.renderer->AddLight(light);
      } },
    Change{ "CodeOfUsers",
      [](MapperScene& s)
      {
        s.volume->GetShaderProperty()->AddFragmentShaderReplacement("//Varimarch::Window", true,
          "vec4 Windowed(vec4 picture) { return picture.bgra; }", false);
      } },
    Change{ "OtherTypes",
      [](MapperScene& s)
      {
        vtkNew<vtkImageCast> cast;
        cast->SetInputData(s.image);
        cast->SetOutputScalarTypeToInt();
        cast->Update();
        s.mapper->SetInputData(cast->GetOutput());
      } }),
  NameOf);

TEST_F(ProcessorMarching, HasNoVolumeNorFieldNorTableOnTheDevice)
{
  MapperScene scene(SmallTorso());
  scene.mapper->ProcessorMarchingOn();
  scene.Draw();
  const vtkIdType pixels = vtkIdType(scene.size) * scene.size * 4 * vtkIdType(sizeof(float));
  const vtkIdType table = 65536 * 4 * vtkIdType(sizeof(float));
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), pixels + table);
  scene.mapper->ProcessorMarchingOff();
  scene.Draw();
  const vtkIdType byShader = scene.mapper->GetGraphicsMemoryBytes();
  EXPECT_GE(byShader, vtkIdType(2) * 40 * 36 * 24);
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

// What is not a number is no material, and shaders know where it is.
TEST_F(ProcessorMarching, LeavesGapsToShaders)
{
  MapperScene scene(TorsoOfType(VTK_FLOAT));
  ShowUpperValues(scene);
  EXPECT_TRUE(ByProcessor(scene));
  scene.image->SetScalarComponentFromDouble(
    20, 18, 12, 0, std::numeric_limits<double>::quiet_NaN());
  scene.image->Modified();
  EXPECT_FALSE(ByProcessor(scene));
}

// A slab one voxel thick has no pairs of voxels along an axis.
TEST_F(ProcessorMarching, LeavesSingleSlicesToShaders)
{
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(9, 9, 1);
  slice->AllocateScalars(VTK_SHORT, 1);
  short* const voxels = static_cast<short*>(slice->GetScalarPointer());
  std::fill(voxels, voxels + 81, short(400));
  MapperScene scene(slice);
  EXPECT_FALSE(ByProcessor(scene));
}

// The smallest volume that is for packets, which read pairs up to its very end.
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

// A strip is a part of the pixels, whose packets begin elsewhere.
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

// What shaders have on the device goes when they are not needed, and comes again.
TEST_F(ProcessorMarching, ComesAndGoes)
{
  MapperScene scene(SmallTorso());
  scene.mapper->ProcessorMarchingOn();
  const std::vector<float> first = scene.Draw();
  scene.mapper->SetBlendModeToMaximumIntensity();
  EXPECT_NE(scene.Draw(), first);
  scene.mapper->SetBlendModeToComposite();
  EXPECT_EQ(scene.Draw(), first);
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 1);
}
