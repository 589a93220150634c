// The props that cast shadows on volumes.

#include "Module/SlabUnderGeometry.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkAssembly.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkDataSetMapper.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
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

TEST(CasterProps, MayConsistOfBlocksThatAreVisible)
{
  const auto left = Sheet(-90.0, 0.0, 20.0);
  const auto right = Sheet(0.0, 90.0, 20.0);
  left->Update();
  right->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left->GetOutput());
  blocks->SetBlock(1, right->GetOutput());
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
  attributes->SetBlockVisibility(left->GetOutput(), false);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), 0.0, 1e-5);
  attributes->SetBlockVisibility(right->GetOutput(), false);
  EXPECT_NEAR(RedUnder({ UndrawnActor::Of(mapper) }), RedUnder({}), 1e-5);
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
