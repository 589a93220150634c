// Looks of volumes of any size, of colours and of channels; and the reasons why nothing is seen.

#include "Readers/ImageFacts.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Scene/Volumes/VolumeColors.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> Cube(double sideMm, int type = VTK_FLOAT, int components = 1)
{
  constexpr int Side = 10;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->SetSpacing(sideMm / Side, sideMm / Side, sideMm / Side);
  image->AllocateScalars(type, components);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      scalars->SetComponent(i, c, double(i % 100) * (c + 1));
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> OfPatient(double sideMm)
{
  auto image = Cube(sideMm);
  Volume volume;
  volume.showsPatient = true;
  KeepFacts(volume, image);
  return image;
}

std::string ReasonFor(const Scene& scene, vtkImageData* image)
{
  OffscreenView view(scene, image, MapperKind::Varimarch);
  view.RenderAll();
  return view.ReasonForNothing(scene);
}

Scene VisibleScene(vtkImageData* image)
{
  Scene scene;
  scene.size = { 32, 32 };
  scene.look = InUnitsOfData(BuiltInPreset("mr-head").look, image);
  return scene;
}

}

TEST(LengthFactor, IsOneForPatientsOnly)
{
  EXPECT_EQ(LengthFactor(OfPatient(100.0), 0.0), 1.0);
  EXPECT_EQ(LengthFactor(Cube(100.0), -1000.0), 1.0) << "Hounsfield units";
  EXPECT_NEAR(LengthFactor(Cube(100.0), 0.0), 0.5, 1e-12);
  EXPECT_NEAR(LengthFactor(OfPatient(10.0), 0.0), 0.05, 1e-12) << "no patient is as small";
  EXPECT_NEAR(LengthFactor(OfPatient(4000.0), -1000.0), 20.0, 1e-12) << "nor as large";
}

TEST(LengthFactor, IsThatOfACubeAsLarge)
{
  const auto image = Cube(100.0);
  image->SetSpacing(20.0, 5.0, 10.0);
  EXPECT_NEAR(LengthFactor(image, 0.0), 0.5, 1e-12);
  image->SetDimensions(10, 10, 1);
  EXPECT_NEAR(LengthFactor(image, 0.0), std::cbrt(200.0 * 50.0 * 10.0) / 200.0, 1e-12);
}

TEST(RelativeLengths, AreThoseOfTheVolumeInAllPartsOfALook)
{
  Look look = BuiltInPreset("mr-head").look;
  look.domain = Domain::Data;
  look.gradientOpacities = { { 8.0, 1.0 } };
  look.dampingGradient = 4.0;
  const auto image = Cube(100.0);
  for (const Look& found :
    { InUnitsOfData(look, image), InUnitsOfData(look, ImageStatistics(image)) })
  {
    EXPECT_EQ(found.lengths, Lengths::Millimetres);
    EXPECT_NEAR(found.opacityUnitDistanceMm, 0.5, 1e-12);
    EXPECT_NEAR(found.gradientOpacities[0].value, 16.0, 1e-12);
    EXPECT_NEAR(found.dampingGradient, 8.0, 1e-12);
  }
  look.lengths = Lengths::Millimetres;
  EXPECT_EQ(InUnitsOfData(look, image).opacityUnitDistanceMm, 1.0) << "as given";
}

TEST(RelativeLengths, ArePartOfALooksText)
{
  const Preset preset = BuiltInPreset("mr-head");
  EXPECT_EQ(PresetFromText(PresetText(preset), "test").look.lengths, Lengths::Relative);
}

TEST(ColoredVoxels, HaveAlphaOrElseLuminance)
{
  const auto rgb = Cube(100.0, VTK_UNSIGNED_SHORT, 3);
  EXPECT_FALSE(HoldsColors(rgb)) << "nothing is known of it";
  Volume known;
  known.holdsColors = true;
  KeepFacts(known, rgb);
  ASSERT_TRUE(HoldsColors(rgb));
  const auto image = ColoredVoxels(rgb);
  vtkDataArray* const colored = image->GetPointData()->GetScalars();
  ASSERT_EQ(colored->GetNumberOfComponents(), 4);
  // The largest number, 297, is the blue of voxel 99.
  EXPECT_EQ(colored->GetComponent(99, 2), 255.0);
  EXPECT_EQ(colored->GetComponent(99, 0), 85.0);
  EXPECT_EQ(colored->GetComponent(99, 3), std::round(0.2126 * 85 + 0.7152 * 170 + 0.0722 * 255));

  const auto rgba = Cube(100.0, VTK_UNSIGNED_CHAR, 4);
  vtkDataArray* const scalars = rgba->GetPointData()->GetScalars();
  scalars->SetComponent(5, 3, 77.0);
  EXPECT_EQ(ColoredVoxels(rgba)->GetPointData()->GetScalars()->GetComponent(5, 3), 77.0);
  scalars->FillComponent(3, 255.0);
  scalars->Modified();
  EXPECT_LT(ColoredVoxels(rgba)->GetPointData()->GetScalars()->GetComponent(0, 3), 255.0);
  const auto channels = Cube(100.0, VTK_UNSIGNED_CHAR, 2);
  EXPECT_EQ(ColoredVoxels(channels), channels);
}

TEST(Channels, HaveTheNamesAndColoursOfTheirFile)
{
  const auto image = Cube(100.0, VTK_UNSIGNED_CHAR, 2);
  Volume volume;
  volume.channels = { { "DAPI", glm::dvec3(0.0, 0.0, 1.0) }, { "GFP", glm::dvec3(0.0, 1.0, 0.0) } };
  KeepFacts(volume, image);
  const Look look = InUnitsOfData(BuiltInPreset("mr-head").look, image);
  ASSERT_EQ(look.channels.size(), 2u);
  EXPECT_EQ(look.channels[1].name, "GFP");
  EXPECT_EQ(look.channels[0].rgb, glm::dvec3(0.0, 0.0, 1.0));
  EXPECT_FALSE(look.channels[0].window) << "the curve is that of the first channel";
  ASSERT_TRUE(look.channels[1].window);
  EXPECT_DOUBLE_EQ((*look.channels[1].window)[1], 2.0 * look.opacities.back().value);
}

TEST(Channels, AreWhatTheirSettingsMakeOfTheLook)
{
  Look look;
  look.colors = { { 0.0, glm::dvec3(1.0) } };
  look.opacities = { { 10.0, 0.0 }, { 20.0, 0.5 }, { 30.0, 1.0 } };
  look.channels = { {}, { "", glm::dvec3(1.0, 0.0, 0.0), true, 0.5, { { 100.0, 300.0 } } },
    { "", {}, false } };
  EXPECT_EQ(LookOfChannel(look, 0).opacities[1].value, 20.0);
  const Look second = LookOfChannel(look, 1);
  EXPECT_EQ(second.opacities[1].value, 200.0);
  EXPECT_EQ(second.opacities[2].opacity, 0.5);
  EXPECT_EQ(second.colors[0].rgb, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(LookOfChannel(look, 2).opacities[2].opacity, 0.0);
  EXPECT_EQ(LookOfChannel(look, 3).opacities[2].opacity, 1.0) << "one without settings";
}

TEST(Channels, ArePartOfALooksText)
{
  Preset preset = BuiltInPreset("mr-head");
  preset.look.channels = { { "one", glm::dvec3(0.5, 0.25, 1.0), false, 0.75, { { 1.0, 2.5 } } },
    {} };
  const std::string text = PresetText(preset);
  EXPECT_EQ(PresetText(PresetFromText(text, "test")), text);
  const auto channels = PresetFromText(text, "test").look.channels;
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[0].window, preset.look.channels[0].window);
  EXPECT_FALSE(channels[1].rgb);
  preset.look.channels[0].window = { { 3.0, 2.5 } };
  EXPECT_THROW(PresetFromText(PresetText(preset), "test"), std::runtime_error);
}

TEST(Nothing, IsSeenForAReason)
{
  const auto image = ProceduralVolume({ ProceduralKind::Shells, { 24, 24, 24 }, 1 });
  const Scene visible = VisibleScene(image);
  EXPECT_EQ(ReasonFor(visible, image), "");

  Scene cut = visible;
  cut.cuts.planes = { { { 0.0, 0.0, 1e4 }, { 0.0, 0.0, 1.0 } } };
  EXPECT_EQ(ReasonFor(cut, image), "the cuts remove all of the volume; take one away");
  // Each of two planes leaves half of it.
  const double* const middle = image->GetCenter();
  cut.cuts.planes = { { { middle[0], middle[1], middle[2] + 0.5 }, { 0.0, 0.0, 1.0 } },
    { { middle[0], middle[1], middle[2] - 0.5 }, { 0.0, 0.0, -1.0 } } };
  EXPECT_EQ(ReasonFor(cut, image), "the cuts remove all of the volume; take one away");

  Scene beside = visible;
  beside.camera.pose = CameraPose{ { 0.0, -1e3, 0.0 }, { 0.0, -2e3, 0.0 }, { 0.0, 0.0, 1.0 }, 1.0 };
  EXPECT_NE(ReasonFor(beside, image).find("outside of the view"), std::string::npos);

  Scene clear = visible;
  clear.look.opacities = { { 1e5, 0.0 }, { 2e5, 1.0 } };
  EXPECT_NE(ReasonFor(clear, image).find("above 0 only above 100000"), std::string::npos);
}
