// vtkVariationFieldGPUVolumeRayCastMapper: settings that it forwards, and scenes that it leaves to
// VTK's mapper.

#include "Module/Scenes/MapperScene.h"

#include <vtkContourValues.h>
#include <vtkInformation.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShaderProperty.h>
#include <vtkShortArray.h>
#include <vtkUniformGrid.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVersionMacros.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace
{

// A change of the scene, made through the class that both mappers inherit.
struct Change
{
  std::string name;
  std::function<void(vtkGPUVolumeRayCastMapper*, MapperScene&)> make;
};

std::ostream& operator<<(std::ostream& stream, const Change& change)
{
  return stream << change.name;
}

std::vector<float> Drawn(
  MapperScene& scene, vtkGPUVolumeRayCastMapper* mapper, const Change& change)
{
  mapper->SetInputData(scene.image);
  change.make(mapper, scene);
  scene.volume->SetMapper(mapper);
  return scene.Draw();
}

const Change Nothing{ "nothing", [](vtkGPUVolumeRayCastMapper*, MapperScene&) {} };

class ForwardedSetting : public testing::TestWithParam<Change>
{
};

class UnsupportedSetting : public testing::TestWithParam<Change>
{
};

// Selects a second array whose values give another image.
void SelectOtherArray(vtkGPUVolumeRayCastMapper* mapper, MapperScene& scene)
{
  vtkNew<vtkShortArray> other;
  other->SetName("other");
  other->SetNumberOfValues(scene.image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < other->GetNumberOfValues(); ++i)
  {
    other->SetValue(i, short(i % 300));
  }
  scene.image->GetPointData()->AddArray(other);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("other");
}

void UseGivenDistance(vtkGPUVolumeRayCastMapper* mapper)
{
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(9.0F);
}

const std::vector<Change> ForwardedSettings{
  { "SampleDistance",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&) { UseGivenDistance(mapper); } },
  { "ScalarArray", SelectOtherArray },
  { "MaximumIntensity",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    { mapper->SetBlendModeToMaximumIntensity(); } },
  { "AverageScalarRange",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    {
      mapper->SetBlendModeToAverageIntensity();
      mapper->SetAverageIPScalarRange(50.0, 150.0);
    } },
  { "Jitter",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    {
      UseGivenDistance(mapper);
      mapper->UseJitteringOn();
    } },
  { "ImageSampleDistance",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    {
      UseGivenDistance(mapper);
      mapper->SetImageSampleDistance(4.0F);
    } },
  { "WindowLevel",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&) { mapper->SetFinalColorLevel(0.2F); } },
  { "Cropping",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene& scene)
    {
      double half[6];
      scene.image->GetBounds(half);
      half[1] = 0.5 * (half[0] + half[1]);
      mapper->SetCroppingRegionPlanes(half);
      mapper->SetCroppingRegionFlagsToSubVolume();
      mapper->CroppingOn();
    } },
  { "ClippingPlane",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      mapper->AddClippingPlane(plane);
    } },
  { "Nearest",
    [](vtkGPUVolumeRayCastMapper*, MapperScene& scene)
    { scene.volume->GetProperty()->SetInterpolationTypeToNearest(); } },
  { "IsoSurface",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene& scene)
    {
      scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 200.0);
      mapper->SetBlendModeToIsoSurface();
    } },
  { "Mask",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene& scene)
    {
      vtkNew<vtkImageData> mask;
      mask->CopyStructure(scene.image);
      mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      mask->GetPointData()->GetScalars()->Fill(0.0);
      mapper->SetMaskInput(mask);
      mapper->SetMaskTypeToBinary();
    } },
};

const std::vector<Change> UnsupportedSettings{
  { "DepthPass",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    {
      mapper->UseDepthPassOn();
      mapper->GetDepthPassContourValues()->SetValue(0, 200.0);
    } },
  { "RangeType",
    [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
    { mapper->SetColorRangeType(vtkGPUVolumeRayCastMapper::NATIVE); } },
  { "OwnShader",
    [](vtkGPUVolumeRayCastMapper*, MapperScene& scene)
    {
      scene.volume->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::RenderToImage::Exit",
        true, "fragOutput0.r = 0.5; //VTK::RenderToImage::Exit", false);
    } },
};

}

TEST(GPUAdapter, DrawsWhatTheMapperItOwnsDrawsAlone)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(vtkNew<vtkVariationFieldVolumeMapper>()->GetErrorTolerance());
  const std::vector<float> alone = scene.DrawByProcessor();
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  EXPECT_EQ(Drawn(scene, adapter, Nothing), alone);
  EXPECT_STREQ(adapter->GetReasonForVtkMapper(), "");
  EXPECT_GT(adapter->GetVariationFieldMapper()->GetEstimatedError(), 0.0) << "no error tolerance";
}

// Settings that VTK's class has only since 9.2.
TEST(GPUAdapter, KeepsTheScatteringThatVtksClassLacks)
{
  MapperScene scene(SmallTorso(), 16);
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  vtkVariationFieldVolumeMapper* const owned = adapter->GetVariationFieldMapper();
  owned->SetVolumetricScatteringBlending(0.7);
  owned->SetGlobalIlluminationReach(0.4);
  Drawn(scene, adapter, Nothing);
  const bool hasScattering = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);
  EXPECT_FLOAT_EQ(owned->GetVolumetricScatteringBlending(), hasScattering ? 0.0 : 0.7);
  EXPECT_FLOAT_EQ(owned->GetGlobalIlluminationReach(), hasScattering ? 0.0 : 0.4);
}

TEST(GPUAdapter, KeepsTheToleranceWhenTheDistanceIsLockedToTheSpacing)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  Drawn(scene, adapter,
    { "locked",
      [](vtkGPUVolumeRayCastMapper* mapper, MapperScene&)
      {
        UseGivenDistance(mapper);
        mapper->LockSampleDistanceToInputSpacingOn();
        mapper->UseJitteringOn();
      } });
  EXPECT_STREQ(adapter->GetReasonForVtkMapper(), "");
  EXPECT_GT(adapter->GetVariationFieldMapper()->GetEstimatedError(), 0.0);
}

TEST(GPUAdapter, GoesBackToTheVariationFieldWhenTheFeatureIsOff)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  const std::vector<float> before = Drawn(scene, adapter, Nothing);
  adapter->UseDepthPassOn();
  adapter->GetDepthPassContourValues()->SetValue(0, 200.0);
  EXPECT_NE(scene.Draw(), before);
  EXPECT_EQ(adapter->GetVariationFieldMapper()->GetGraphicsMemoryBytes(), 0) << "two copies";
  adapter->UseDepthPassOff();
  EXPECT_EQ(scene.Draw(), before);
}

TEST(GPUAdapter, LeavesOutWhatIsBlanked)
{
  const vtkSmartPointer<vtkImageData> image = SmallTorso();
  vtkNew<vtkUniformGrid> blanked;
  blanked->ShallowCopy(image);
  MapperScene scene(blanked);
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  const std::vector<float> before = Drawn(scene, adapter, Nothing);
  for (vtkIdType point = 0; point < blanked->GetNumberOfPoints() / 2; ++point)
  {
    blanked->BlankPoint(point);
  }
  blanked->Modified();
  EXPECT_NE(Drawn(scene, adapter, Nothing), before);
  EXPECT_STREQ(adapter->GetReasonForVtkMapper(), "");
}

TEST(GPUAdapter, LeavesArraysThatAreNotContiguousToVtk)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkSOADataArrayTemplate<short>> spread;
  spread->DeepCopy(scene.image->GetPointData()->GetScalars());
  scene.image->GetPointData()->SetScalars(spread);
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  adapter->SetInputData(scene.image);
  EXPECT_FALSE(adapter->ChooseMapper(scene.renderer, scene.volume));
  EXPECT_NE(std::string(adapter->GetReasonForVtkMapper()).find("side by side"), std::string::npos);
}

TEST(GPUAdapter, LetsGeometryHideWhatVtksMapperDraws)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> vtk;
  scene.renderer->AddActor(Ball(scene.volume->GetCenter(), 0.5 * scene.volume->GetLength()));
  scene.renderer->ResetCameraClippingRange();
  const std::vector<float> hidden = Drawn(scene, vtk, Nothing);
  scene.volume->VisibilityOff();
  EXPECT_EQ(scene.Draw(), hidden);
  EXPECT_GT(*std::max_element(hidden.begin(), hidden.end()), 0.1F) << "no ball";
}

TEST_P(ForwardedSetting, IsDrawnAsByTheMapperItself)
{
  MapperScene plain(SmallTorso());
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> unchanged;
  const std::vector<float> before = Drawn(plain, unchanged, Nothing);

  MapperScene scene(SmallTorso());
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  const std::vector<float> after = Drawn(scene, adapter, GetParam());
  EXPECT_STREQ(adapter->GetReasonForVtkMapper(), "");
  EXPECT_NE(after, before) << "the setting has no effect";
  scene.volume->SetMapper(adapter->GetVariationFieldMapper());
  EXPECT_EQ(scene.Draw(), after);
}

TEST_P(UnsupportedSetting, IsDrawnByVtksMapperAndSaysWhy)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  const std::vector<float> drawn = Drawn(scene, adapter, GetParam());
  EXPECT_NE(std::string(adapter->GetReasonForVtkMapper()), "");
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1F) << "nothing is drawn";

  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> vtk;
  EXPECT_EQ(Drawn(scene, vtk, GetParam()), drawn);
}

INSTANTIATE_TEST_SUITE_P(GPUAdapter, ForwardedSetting, testing::ValuesIn(ForwardedSettings),
  [](const auto& info) { return info.param.name; });
INSTANTIATE_TEST_SUITE_P(GPUAdapter, UnsupportedSetting, testing::ValuesIn(UnsupportedSettings),
  [](const auto& info) { return info.param.name; });
