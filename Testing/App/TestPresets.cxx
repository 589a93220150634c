#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using namespace varimarch;

namespace
{

TEST(Presets, EveryOneIsReadable)
{
  EXPECT_EQ(PresetNames().size(), 14u);
  for (const std::string& name : PresetNames())
  {
    const Preset preset = BuiltInPreset(name);
    const Look& look = preset.look;
    EXPECT_EQ(look.name, name);
    EXPECT_TRUE(preset.errorTolerance) << name;
    EXPECT_TRUE(preset.background) << name;
    EXPECT_FALSE(look.description.empty()) << name;
    EXPECT_EQ(look.opacities.front().opacity, 0.0) << name << " must not show air";
  }
}

TEST(Presets, ShadedOnesSayTheLightThatSuitsThem)
{
  for (const std::string& name : PresetNames())
  {
    const Preset preset = BuiltInPreset(name);
    EXPECT_EQ(preset.light.has_value(), preset.look.shading.enabled) << name;
    if (preset.light)
    {
      EXPECT_EQ(preset.light->shadows, 1.0) << name;
      EXPECT_EQ(preset.light->lights.size(), 2u) << name << ": a key and a fill light";
      EXPECT_GT(preset.light->lights[0].intensity, preset.light->lights[1].intensity) << name;
      const Preset again = PresetFromText(PresetText(preset), "test");
      EXPECT_EQ(
        again.light.value().lights[0].softnessDegrees, preset.light->lights[0].softnessDegrees);
      EXPECT_EQ(again.light->scattering, preset.light->scattering);
    }
    Scene scene;
    TakePreset(preset, scene);
    EXPECT_TRUE(scene.lights.empty()) << name << ": a scene takes a light on request only";
  }
}

TEST(Presets, LightThatIsOffIsReadBack)
{
  Preset preset = BuiltInPreset("ct-maximum");
  preset.light = Lighting();
  EXPECT_TRUE(PresetFromText(PresetText(preset), "test").light);
}

TEST(Presets, UnknownNameSuggestsTheNearest)
{
  try
  {
    BuiltInPreset("ct-bones");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "unknown preset \"ct-bones\"; did you mean \"ct-bone\"?");
  }
}

TEST(Presets, RelativeOnesFollowTheData)
{
  const auto volume = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 20, 20, 20 }, 1 });
  const Look look = BuiltInPreset("mr-head").look;
  ASSERT_EQ(look.domain, Domain::Relative);
  const Look before = InUnitsOfData(look, volume);
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    static_cast<float*>(volume->GetScalarPointer())[i] *= 100.0f;
  }
  volume->GetPointData()->GetScalars()->Modified();
  const Look after = InUnitsOfData(look, volume);
  EXPECT_EQ(after.domain, Domain::Data);
  for (std::size_t i = 0; i < look.opacities.size(); ++i)
  {
    EXPECT_NEAR(after.opacities[i].value, 100.0 * before.opacities[i].value, 0.01);
  }
}

// The preset suggested for the torso if its file has these attributes.
PresetSuggestion SuggestionFor(const LoadedVolume& said)
{
  LoadedVolume volume = said;
  volume.image = ProceduralVolume({ ProceduralKind::Torso, { 16, 16, 16 }, 1 });
  return SuggestedPreset(volume, ImageStatistics(volume.image));
}

TEST(Presets, AreSuggestedByTheFilesAttributes)
{
  LoadedVolume said;
  said.modality = "CT";
  EXPECT_EQ(SuggestionFor(said).name, "ct-bone");
  EXPECT_EQ(SuggestionFor(said).reason, SuggestionReason::Modality);
  said.bodyPart = "HEAD";
  EXPECT_EQ(SuggestionFor(said).name, "ct-bone");
  EXPECT_EQ(SuggestionFor(said).reason, SuggestionReason::BodyPart);
  EXPECT_EQ(SuggestionFor(said).said, "HEAD");
  said.bodyPart = "Chest";
  EXPECT_EQ(SuggestionFor(said).name, "ct-lung");
  said.bodyPart = "ABDOMENPELVIS";
  EXPECT_EQ(SuggestionFor(said).name, "ct-soft-tissue");
  said.hasContrastAgent = true;
  EXPECT_EQ(SuggestionFor(said).name, "ct-vessels");
  EXPECT_EQ(SuggestionFor(said).reason, SuggestionReason::ContrastAgent);

  said = {};
  said.modality = "MR";
  EXPECT_EQ(SuggestionFor(said).name, "mr-head");
  said.weighting = "T2";
  EXPECT_EQ(SuggestionFor(said).name, "mr-t2");
  said.weighting = "angiography";
  EXPECT_EQ(SuggestionFor(said).name, "mr-angiography");
  said.modality = "PT";
  EXPECT_EQ(SuggestionFor(said).name, "pet-maximum");
  said.modality = "US";
  EXPECT_EQ(SuggestionFor(said).name, "mr-maximum");
}

// Voxels of air, lung, tissue and bone, in parts of a hundred.
PresetSuggestion SuggestionForChest(
  int lung, int bone, const std::optional<std::array<double, 2>>& windowLevel = {})
{
  LoadedVolume volume;
  volume.windowLevel = windowLevel;
  volume.modality = "CT";
  volume.bodyPart = "CHEST";
  volume.image = vtkSmartPointer<vtkImageData>::New();
  volume.image->SetDimensions(10, 10, 1);
  volume.image->AllocateScalars(VTK_SHORT, 1);
  auto* const values = static_cast<short*>(volume.image->GetScalarPointer());
  std::fill_n(values, 100, short(-1000));
  std::fill_n(values, 60, short(40));
  std::fill_n(values, lung, short(-800));
  std::fill_n(values + lung, bone, short(700));
  return SuggestedPreset(volume, ImageStatistics(volume.image));
}

TEST(Presets, ShowLungsOnlyWhereThereAreLungs)
{
  EXPECT_EQ(SuggestionForChest(20, 5).name, "ct-lung");
  EXPECT_EQ(SuggestionForChest(20, 5).reason, SuggestionReason::BodyPart);
  EXPECT_EQ(SuggestionForChest(2, 5).name, "ct-bone") << "an abdomen with the tips of the lungs";
  EXPECT_EQ(SuggestionForChest(2, 5).reason, SuggestionReason::LittleLung);
  EXPECT_EQ(SuggestionForChest(0, 0).name, "ct-bone");
  EXPECT_EQ(SuggestionForChest(20, 5, { { 1500.0, -600.0 } }).name, "ct-lung");
  EXPECT_EQ(SuggestionForChest(20, 5, { { 400.0, 60.0 } }).name, "ct-bone");
  EXPECT_EQ(SuggestionForChest(20, 5, { { 400.0, 60.0 } }).reason, SuggestionReason::TissueWindow);
}

TEST(Presets, AreSuggestedByTheHistogramWithoutAttributes)
{
  LoadedVolume volume;
  volume.image = ProceduralVolume({ ProceduralKind::Torso, { 16, 16, 16 }, 1 });
  const auto suggested = [&] { return SuggestedPreset(volume, ImageStatistics(volume.image)); };
  EXPECT_EQ(suggested().name, "ct-bone");
  EXPECT_EQ(suggested().reason, SuggestionReason::ValuesOfAir);
  const vtkIdType count = volume.image->GetNumberOfPoints();
  const auto fill = [&](vtkIdType voxels, short value)
  {
    std::fill_n(static_cast<short*>(volume.image->GetScalarPointer()), voxels, value);
    volume.image->GetPointData()->GetScalars()->Modified();
  };
  fill(count / 1000, 3000);
  EXPECT_EQ(suggested().name, "ct-bone") << "a filling";
  fill(count / 200, 3000);
  EXPECT_EQ(suggested().name, "ct-implants");
  fill(count, 40);
  EXPECT_EQ(suggested().name, "mr-head");
  EXPECT_EQ(suggested().reason, SuggestionReason::OtherValues);
}

}
