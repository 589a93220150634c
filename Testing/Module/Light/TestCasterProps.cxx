// The props that cast shadows on volumes.

#include "Module/Light/SlabUnderGeometry.h"
#include "Support/ExpectedVtkErrors.h"

#include "VtkVersions.h"

#include <vtkAppendFilter.h>
#include <vtkAssembly.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDataSetMapper.h>
#include <vtkGlyph3DMapper.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOutlineSource.h>
#include <vtkPlane.h>
#include <vtkSkybox.h>
#include <vtkStripper.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace
{

// A change of a sheet over the whole slab, and whether it casts a shadow then.
struct SheetCase
{
  const char* name;
  bool casts;
  std::function<void(vtkActor* sheet)> change;
};

void Clip(vtkActor* actor, double normalX)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(5.0, 0.0, 0.0);
  plane->SetNormal(normalX, 0.0, 0.0);
  actor->GetMapper()->AddClippingPlane(plane);
}

void OptOut(vtkActor* actor)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
  actor->SetPropertyKeys(keys);
}

std::vector<SheetCase> SheetCases()
{
  return {
    { "unchanged", true, [](vtkActor*) {} },
    { "invisible", false, [](vtkActor* sheet) { sheet->VisibilityOff(); } },
    { "translucent", false, [](vtkActor* sheet) { sheet->GetProperty()->SetOpacity(0.5); } },
    { "forced to be translucent", false, [](vtkActor* sheet) { sheet->ForceTranslucentOn(); } },
    { "wireframe", false,
      [](vtkActor* sheet) { sheet->GetProperty()->SetRepresentationToWireframe(); } },
    { "opted out", false, OptOut },
    { "moved away", false, [](vtkActor* sheet) { sheet->SetPosition(300.0, 0.0, 0.0); } },
    { "scaled", false, [](vtkActor* sheet) { sheet->SetScale(0.01, 1.0, 1.0); } },
    { "clipped", false, [](vtkActor* sheet) { Clip(sheet, -1.0); } },
    { "clipped elsewhere", true, [](vtkActor* sheet) { Clip(sheet, 1.0); } },
  };
}

// A skybox that is not drawn, which needs no texture.
class UndrawnSkybox : public vtkSkybox
{
public:
  static UndrawnSkybox* New() { VTK_STANDARD_NEW_BODY(UndrawnSkybox); }
  vtkTypeMacro(UndrawnSkybox, vtkSkybox);

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
};

// Red of a slab in the sun under props.
double RedUnder(const std::vector<vtkProp*>& props)
{
  SlabUnderGeometry slab;
  slab.AddSun();
  for (vtkProp* prop : props)
  {
    slab.scene.renderer->AddViewProp(prop);
  }
  return slab.DrawnRed();
}

}

TEST(CasterProps, AreVisibleOpaqueActorsWithFaces)
{
  const double lit = RedUnder({});
  EXPECT_GT(lit, 0.1);
  for (const SheetCase& one : SheetCases())
  {
    const auto sheet = HiddenActor(Sheet(-90.0, 90.0, 20.0));
    one.change(sheet);
    EXPECT_NEAR(RedUnder({ sheet }), one.casts ? 0.0 : lit, 1e-5) << one.name;
  }
}

TEST(CasterProps, LieBetweenTheLightAndTheVolume)
{
  EXPECT_NEAR(RedUnder({ HiddenActor(Sheet(-90.0, 90.0, -5.0)) }), RedUnder({}), 1e-5);
}

TEST(CasterProps, MayBePartsOfAssemblies)
{
  const auto redAt = [](double x)
  {
    const auto sheet = HiddenActor(Sheet(-10.0, 10.0, 5.0));
    sheet->SetPosition(0.0, 0.0, 5.0);
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(sheet);
    assembly->SetPosition(x, 0.0, 10.0);
    return RedUnder({ assembly });
  };
  EXPECT_NEAR(redAt(7.5), 0.0, 1e-5);
  EXPECT_NEAR(redAt(50.0), RedUnder({}), 1e-5);
}

TEST(CasterProps, MayHaveAMapperOfDataSets)
{
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(Sheet(-90.0, 90.0, 20.0)->GetOutputPort());
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
}

// Two sheets beside the view, of which one lies between the slab and the sun.
TEST(CasterProps, OfOtherDataSetsCastOnceTheyAreDrawn)
{
  vtkNew<vtkAppendFilter> grid;
  grid->AddInputConnection(Sheet(5.0, 40.0, 20.0)->GetOutputPort());
  grid->AddInputConnection(Sheet(-40.0, -5.0, 20.0)->GetOutputPort());
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(grid->GetOutputPort());
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), RedUnder({}), 1e-5);
  vtkNew<vtkActor> drawn;
  drawn->SetMapper(mapper);
  EXPECT_NEAR(RedUnder({ drawn }), 0.0, 1e-5);
}

TEST(CasterProps, AreNoLinesGlyphsAndSkyboxes)
{
  const auto sheet = Sheet(-90.0, 90.0, 20.0);
  vtkNew<vtkOutlineSource> lines;
  lines->SetBounds(-90.0, 90.0, -90.0, 90.0, 20.0, 20.0);
  EXPECT_NEAR(RedUnder({ HiddenActor(lines) }), RedUnder({}), 1e-5);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputConnection(sheet->GetOutputPort());
  glyphs->SetSourceConnection(sheet->GetOutputPort());
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(glyphs) }), RedUnder({}), 1e-5);
  vtkNew<UndrawnSkybox> sky;
  sky->SetMapper(HiddenActor(sheet)->GetMapper());
  EXPECT_NEAR(RedUnder({ sky }), RedUnder({}), 1e-5);
}

TEST(CasterProps, TakeNoScatteredLightWithoutShadows)
{
  const auto redWith = [](bool hasShadows, bool hasSheet)
  {
    SlabUnderGeometry slab;
    slab.AddSun();
    slab.scene.mapper->SetShadows(hasShadows);
    slab.scene.mapper->SetVolumetricScatteringBlending(1.0);
    slab.scene.mapper->SetGlobalIlluminationReach(1.0);
    const auto sheet = HiddenActor(Sheet(-90.0, 90.0, 20.0));
    sheet->SetVisibility(hasSheet);
    slab.scene.renderer->AddActor(sheet);
    return slab.DrawnRed();
  };
  EXPECT_GT(redWith(false, false), 0.01);
  EXPECT_NEAR(redWith(false, true), redWith(false, false), 1e-5);
  EXPECT_NEAR(redWith(true, true), 0.0, 1e-5);
}

TEST(CasterProps, MayConsistOfBlocksThatAreVisible)
{
  const auto left = Sheet(-90.0, 0.0, 20.0);
  const auto right = Sheet(0.0, 90.0, 20.0);
  left->Update();
  right->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left->GetOutput());
  blocks->SetBlock(1, right->GetOutput());
  vtkNew<varimarch::BlockMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
  attributes->SetBlockVisibility(left->GetOutput(), false);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
  attributes->SetBlockVisibility(right->GetOutput(), false);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), RedUnder({}), 1e-5);
}

TEST(CasterProps, InBlocksAreAsVisibleAsTheBlockAround)
{
  const auto sheet = Sheet(-90.0, 90.0, 20.0);
  sheet->Update();
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, sheet->GetOutput());
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  outer->SetBlock(1, nullptr);
  vtkNew<varimarch::BlockMapper> mapper;
  mapper->SetInputDataObject(outer);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
  attributes->SetBlockVisibility(inner, false);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), RedUnder({}), 1e-5);
  attributes->SetBlockVisibility(sheet->GetOutput(), true);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
}

// Each plane may cut a triangle into one more.
TEST(CasterProps, ThatAreCutCountTheTrianglesOfTheirCuts)
{
  const auto sheet = Sheet(-90.0, 90.0, 20.0);
  sheet->SetResolution(800, 700);
  const auto actor = HiddenActor(sheet);
  Clip(actor, 1.0);
  const ExpectedVtkErrors warnings;
  EXPECT_NEAR(RedUnder({ actor }), RedUnder({}), 1e-5);
  EXPECT_NE(warnings.Text().find("more than 2097152 triangles"), std::string::npos)
    << warnings.Text();
}

TEST(CasterProps, OfTooManyTrianglesAreLeftOutWithASentence)
{
  const auto sheet = Sheet(-90.0, 90.0, 20.0);
  sheet->SetResolution(1100, 1000);
  const ExpectedVtkErrors warnings;
  EXPECT_NEAR(RedUnder({ HiddenActor(sheet) }), RedUnder({}), 1e-5);
  EXPECT_NE(warnings.Text().find("more than 2097152 triangles"), std::string::npos)
    << warnings.Text();
}

TEST(CasterProps, MayConsistOfStrips)
{
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(Sheet(-90.0, 90.0, 20.0)->GetOutputPort());
  EXPECT_NEAR(RedUnder({ HiddenActor(strips) }), 0.0, 1e-5);
}
