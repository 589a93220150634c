// Passes other than the plain image: layers between translucent geometry, selections, render to
// image, frames during interaction; and custom shader code.

#include "Module/Scenes/HomogeneousScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkContourValues.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkProperty.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>
#include <vtkVolumePicker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{

using Rgba = std::array<double, 4>;

void ExpectMiddle(const std::vector<float>& picture, int size, const Rgba& truth, double tolerance)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(picture[4 * (size / 2 * size + size / 2) + channel], truth[channel], tolerance)
      << "channel " << channel;
  }
}

// Checks both the shader and packets.
void ExpectMiddle(MapperScene& scene, const Rgba& truth, double tolerance)
{
  ExpectMiddle(scene.Draw(), scene.size, truth, tolerance);
  ExpectMiddle(scene.DrawByProcessor(), scene.size, truth, tolerance);
}

vtkSmartPointer<vtkActor> GlassPlane(double zMm, const std::array<double, 3>& rgb, double opacity)
{
  const vtkSmartPointer<vtkActor> plane = Plane(zMm, -100.0, rgb);
  plane->GetProperty()->SetOpacity(opacity);
  return plane;
}

Rgba Glass(const std::array<double, 3>& rgb, double opacity)
{
  return { opacity * rgb[0], opacity * rgb[1], opacity * rgb[2], opacity };
}

// Opacity of a material that is half opaque after the given length.
double HalfAfter(double lengthMm)
{
  return 1.0 - std::pow(0.5, 1.0 / lengthMm);
}

// The prop and the id that a selector finds at the centre pixel, or null.
std::pair<vtkProp*, vtkIdType> SelectedInMiddle(HomogeneousScene& scene, int association)
{
  scene.window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(16, 16, 16, 16);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  if (selection->GetNumberOfNodes() == 0)
  {
    return { nullptr, -1 };
  }
  vtkSelectionNode* const node = selection->GetNode(0);
  auto* const ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  auto* const prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
  const bool found = ids && ids->GetNumberOfTuples() > 0;
  return { prop, found ? ids->GetValue(0) : vtkIdType(-1) };
}

}

TEST(DepthPeeling, PutsOneTranslucentPlaneIntoTheVolume)
{
  HomogeneousScene scene;
  UseDepthPeeling(scene.renderer);
  const std::array<double, 3> rgb = { 0.1, 0.8, 0.4 };
  scene.renderer->AddActor(GlassPlane(3.0, rgb, 0.4));
  const Rgba truth = Over(scene.Piece(5.0), Over(Glass(rgb, 0.4), scene.Piece(11.0)));
  // VTK's pass keeps its layers in 8 bits.
  ExpectMiddle(scene, truth, 3.0 / 255.0);
}

TEST(DepthPeeling, PutsManyPlanesAndAnOpaqueOneIntoTheVolume)
{
  HomogeneousScene scene(0.04);
  UseDepthPeeling(scene.renderer);
  const std::array<double, 3> red = { 0.9, 0.1, 0.0 };
  const std::array<double, 3> green = { 0.1, 0.8, 0.2 };
  const std::array<double, 3> blue = { 0.0, 0.2, 0.9 };
  scene.renderer->AddActor(GlassPlane(12.0, green, 0.2)); // in front of the volume
  scene.renderer->AddActor(GlassPlane(-2.0, red, 0.3));
  scene.renderer->AddActor(GlassPlane(5.0, green, 0.3));
  scene.renderer->AddActor(GlassPlane(1.0, blue, 0.3));
  const Rgba back = Over(scene.Piece(3.0), Over(Glass(red, 0.3), scene.Piece(6.0)));
  const Rgba open = Over(Glass(green, 0.2),
    Over(scene.Piece(3.0),
      Over(Glass(green, 0.3), Over(scene.Piece(4.0), Over(Glass(blue, 0.3), back)))));
  ExpectMiddle(scene, open, 5.0 / 255.0);

  scene.renderer->AddActor(Plane(-5.0, -100.0, { 1.0, 1.0, 1.0 }));
  const Rgba closed =
    Over(scene.Piece(3.0), Over(Glass(red, 0.3), Over(scene.Piece(3.0), { 1.0, 1.0, 1.0, 1.0 })));
  const Rgba truth = Over(Glass(green, 0.2),
    Over(scene.Piece(3.0),
      Over(Glass(green, 0.3), Over(scene.Piece(4.0), Over(Glass(blue, 0.3), closed)))));
  ExpectMiddle(scene, truth, 5.0 / 255.0);
}

TEST(DepthPeeling, LeavesPixelsWithoutTranslucentGeometryAsTheyAre)
{
  HomogeneousScene scene;
  UseDepthPeeling(scene.renderer);
  const vtkSmartPointer<vtkActor> half = Plane(3.0, 3.0, { 0.1, 0.8, 0.4 });
  half->GetProperty()->SetOpacity(0.4);
  scene.renderer->AddActor(half);
  ExpectMiddle(scene, scene.Piece(HomogeneousScene::SideMm), 2.0 / 255.0);
}

// All passes of a frame have the same view, which must not count as a view at rest.
TEST(DepthPeeling, SearchesForNoStepsWhileTheViewMoves)
{
  MapperScene scene(SmallTorso());
  UseDepthPeeling(scene.renderer);
  scene.renderer->AddActor(GlassPlane(3.0, { 0.1, 0.8, 0.4 }, 0.4));
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  const int searches = scene.mapper->GetToleranceSearches();
  for (int picture = 0; picture < 2; ++picture)
  {
    scene.renderer->GetActiveCamera()->Azimuth(2.0);
    scene.Draw();
  }
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches);
  scene.Draw(); // the view is at rest
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches + 1);
}

// Rendered by shaders and, where possible, by packets of rays.
class PassByMarcher : public testing::TestWithParam<bool>
{
protected:
  void UseMarcher(MapperScene& scene) { scene.mapper->SetProcessorMarching(GetParam()); }
};

class Selection : public PassByMarcher
{
};

class RenderToImage : public PassByMarcher
{
};

const auto NameOfMarcher = [](const testing::TestParamInfo<bool>& info)
{ return info.param ? "ByPackets" : "ByShaders"; };

INSTANTIATE_TEST_SUITE_P(Marchers, Selection, testing::Bool(), NameOfMarcher);
INSTANTIATE_TEST_SUITE_P(Marchers, RenderToImage, testing::Bool(), NameOfMarcher);

TEST_P(Selection, FindsTheCellAndThePointWhereARayBecomesHalfOpaque)
{
  // Half opaque 1.3 mm behind the front face, at z = 14.7 of the grid; x and y are 8.245.
  HomogeneousScene scene(HalfAfter(1.3));
  UseMarcher(scene);
  const auto [cellProp, cell] = SelectedInMiddle(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_EQ(cellProp, scene.volume);
  EXPECT_EQ(cell, (14 * 16 + 8) * 16 + 8);
  const auto [pointProp, point] = SelectedInMiddle(scene, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_EQ(pointProp, scene.volume);
  EXPECT_EQ(point, (15 * 17 + 8) * 17 + 8);
}

TEST_P(Selection, FindsWhatIsInFrontOfTheVolumeAndWhatIsSeenThroughIt)
{
  HomogeneousScene scene(HalfAfter(1.3));
  UseMarcher(scene);
  const vtkSmartPointer<vtkActor> before = Plane(12.0, -100.0, { 1.0, 0.0, 0.0 });
  scene.renderer->AddActor(before);
  EXPECT_EQ(SelectedInMiddle(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS).first, before.Get());

  HomogeneousScene clear(1e-5);
  UseMarcher(clear);
  const vtkSmartPointer<vtkActor> inside = Plane(0.0, -100.0, { 1.0, 0.0, 0.0 });
  clear.renderer->AddActor(inside);
  EXPECT_EQ(SelectedInMiddle(clear, vtkDataObject::FIELD_ASSOCIATION_CELLS).first, inside.Get());
}

TEST_P(Selection, LeavesThePictureAsItWas)
{
  HomogeneousScene scene;
  UseMarcher(scene);
  const std::vector<float> before = scene.Draw();
  SelectedInMiddle(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_EQ(scene.Draw(), before);
}

TEST_P(Selection, ByTheVolumePickerFindsItsFrontFace)
{
  HomogeneousScene scene(0.5);
  UseMarcher(scene);
  scene.window->Render();
  vtkNew<vtkVolumePicker> picker;
  picker->Pick(16.0, 16.0, 0.0, scene.renderer);
  EXPECT_EQ(picker->GetVolume(), scene.volume);
  EXPECT_NEAR(picker->GetPickPosition()[2], 8.0, 0.1);
}

TEST_P(RenderToImage, FillsImagesAndNotTheWindow)
{
  HomogeneousScene scene;
  UseMarcher(scene);
  scene.mapper->RenderToImageOn();
  scene.mapper->SetImageSampleDistance(2.0f);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 0.0f);
  vtkNew<vtkImageData> color;
  vtkNew<vtkImageData> depth;
  scene.mapper->GetColorImage(color);
  scene.mapper->GetDepthImage(depth);
  ASSERT_EQ(color->GetDimensions()[0], 16);
  ASSERT_EQ(depth->GetDimensions()[1], 16);
  const Rgba overWhite = Over(scene.Piece(HomogeneousScene::SideMm), { 1.0, 1.0, 1.0, 0.0 });
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(
      color->GetScalarComponentAsDouble(8, 8, 0, channel), 255.0 * overWhite[channel], 0.51);
  }
  // The front face is 92 mm from the camera, whose clipping planes are at 50 and 150 mm.
  EXPECT_NEAR(depth->GetScalarComponentAsDouble(8, 8, 0, 0), 0.42, 1e-3);
}

class RenderToImageOfBlend
  : public testing::TestWithParam<std::tuple<vtkVolumeMapper::BlendModes, bool>>
{
};

// The part that was marched to find the depth is not marched again: the colour continues there.
TEST_P(RenderToImageOfBlend, HasTheColoursOfTheWindow)
{
  MapperScene scene(SmallTorso(), 32);
  scene.mapper->SetProcessorMarching(std::get<bool>(GetParam()));
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
  scene.mapper->SetBlendMode(std::get<0>(GetParam()));
  const std::vector<float> drawn = scene.Draw();
  scene.mapper->RenderToImageOn();
  scene.Draw();
  vtkNew<vtkImageData> color;
  scene.mapper->GetColorImage(color);
  for (int pixel = 0; pixel < 32 * 32; ++pixel)
  {
    const float* const window = &drawn[4 * pixel];
    for (int channel = 0; channel < 3; ++channel)
    {
      const double overWhite = window[channel] + 1.0 - window[3];
      ASSERT_NEAR(color->GetScalarComponentAsDouble(pixel % 32, pixel / 32, 0, channel),
        255.0 * overWhite, 1.0)
        << pixel;
    }
  }
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.05f) << "the image is empty";
}

// The minimum of the torso is black.
INSTANTIATE_TEST_SUITE_P(Blends, RenderToImageOfBlend,
  testing::Combine(
    testing::Values(vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
      vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND,
      vtkVolumeMapper::ISOSURFACE_BLEND),
    testing::Bool()));

TEST_P(RenderToImage, HasNoDepthWhereOnlyInvisibleValuesAreSummedUp)
{
  HomogeneousScene scene(0.0);
  UseMarcher(scene);
  scene.mapper->SetBlendModeToAdditive();
  scene.mapper->RenderToImageOn();
  scene.Draw();
  vtkNew<vtkImageData> depth;
  scene.mapper->GetDepthImage(depth);
  EXPECT_EQ(depth->GetScalarComponentAsDouble(16, 16, 0, 0), 1.0);
}

TEST_P(RenderToImage, HasTheDepthOfTheFarPlaneOrOfTheBackFaceWhereNothingIsVisible)
{
  HomogeneousScene scene(0.0);
  UseMarcher(scene);
  scene.mapper->RenderToImageOn();
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetDepthImageScalarTypeToUnsignedShort();
  scene.Draw();
  vtkNew<vtkImageData> depth;
  scene.mapper->GetDepthImage(depth);
  EXPECT_EQ(depth->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(depth->GetScalarComponentAsDouble(16, 16, 0, 0), 65535.0);
  scene.mapper->ClampDepthToBackfaceOn();
  scene.Draw();
  scene.mapper->GetDepthImage(depth);
  EXPECT_NEAR(depth->GetScalarComponentAsDouble(16, 16, 0, 0), 0.58 * 65535.0, 2.0);
}

TEST(UserCode, TakesThePlaceOfASlotAndHasUniforms)
{
  HomogeneousScene scene;
  const Rgba plain = scene.Piece(HomogeneousScene::SideMm);
  vtkShaderProperty* const shader = scene.volume->GetShaderProperty();
  shader->GetFragmentCustomUniforms()->SetUniformf("redPart", 0.5f);
  shader->AddFragmentShaderReplacement("//Varimarch::Window", true,
    "vec4 Windowed(vec4 picture) { return vec4(picture.r * redPart, picture.b, picture.ga); }",
    false);
  ExpectMiddle(scene.Draw(), scene.size, { 0.5 * plain[0], plain[2], plain[1], plain[3] }, 1e-5);
  shader->GetFragmentCustomUniforms()->SetUniformf("redPart", 0.25f);
  ExpectMiddle(scene.Draw(), scene.size, { 0.25 * plain[0], plain[2], plain[1], plain[3] }, 1e-5);
  shader->ClearAllShaderReplacements();
  shader->GetFragmentCustomUniforms()->RemoveAllUniforms();
  ExpectMiddle(scene.Draw(), scene.size, plain, 1e-5);
}

TEST(UserCode, ForAMissingSlotIsReported)
{
  HomogeneousScene scene;
  vtkShaderProperty* const shader = scene.volume->GetShaderProperty();
  shader->AddFragmentShaderReplacement("//VTK::Shading::Exit", true, "x", false);
  {
    ExpectedVtkErrors errors;
    scene.window->Render();
    EXPECT_NE(errors.Text().find("has no //VTK::Shading::Exit"), std::string::npos);
  }
  shader->ClearAllShaderReplacements();
  shader->AddFragmentShaderReplacement("//Varimarch::Windows", true, "x", false);
  ExpectedVtkErrors errors;
  scene.window->Render();
  EXPECT_NE(errors.Text().find("has no slot Windows"), std::string::npos);
}

TEST(Interaction, TakesFewerRaysWhileItLastsAndAllAfterwards)
{
  MapperScene scene(SmallTorso(), 64);
  const std::vector<float> still = scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedImageSampleDistance(), 1.0);
  scene.window->SetDesiredUpdateRate(1e7); // faster than any machine
  scene.mapper->SetMaximumImageSampleDistance(4.0f);
  for (int picture = 0; picture < 6; ++picture)
  {
    scene.Draw();
  }
  EXPECT_EQ(scene.mapper->GetUsedImageSampleDistance(), 4.0);
  scene.window->SetDesiredUpdateRate(0.0001);
  EXPECT_EQ(scene.Draw(), still);
  EXPECT_EQ(scene.mapper->GetUsedImageSampleDistance(), 1.0);
}
