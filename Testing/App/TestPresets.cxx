#include "Scene/Presets.h"
#include "Scene/ProceduralVolume.h"
#include "Scene/SceneFile.h"
#include "Scene/VolumeLoading.h"
#include "Scene/VolumeProperty.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

TEST(Presets, EveryOneIsReadable)
{
  EXPECT_EQ(PresetNames().size(), 11u);
  for (const std::string& name : PresetNames())
  {
    const Look look = Preset(name);
    EXPECT_EQ(look.name, name);
    EXPECT_FALSE(look.description.empty()) << name;
    EXPECT_EQ(look.opacities.front().opacity, 0.0) << name << " must not show the air";
  }
}

TEST(Presets, UnknownNameSuggestsTheNearest)
{
  try
  {
    Preset("ct-bones");
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
  const Look look = Preset("mr-head");
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

TEST(Presets, SuitTheModality)
{
  const auto torso = ProceduralVolume({ ProceduralKind::Torso, { 16, 16, 16 }, 1 });
  EXPECT_EQ(SuggestedPreset({ torso, "CT", {} }).name, "ct-bone");
  EXPECT_EQ(SuggestedPreset({ torso, "", {} }).name, "ct-bone");
  EXPECT_EQ(SuggestedPreset({ torso, "MR", {} }).name, "mr-head");
}

}
