// Scenes that packets of rays do not support are rendered by shaders.

#include "Module/ProcessorMarching.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageAppendComponents.h>
#include <vtkPointData.h>
#include <vtkShaderProperty.h>

#include <limits>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// Adds a second component to each voxel.
vtkSmartPointer<vtkImageData> WithSecondComponent(vtkImageData* image)
{
  vtkNew<vtkImageAppendComponents> pairs;
  pairs->AddInputData(image);
  pairs->AddInputData(image);
  pairs->Update();
  return pairs->GetOutput();
}

// Uses a mask with twice as many voxels along each axis.
void UseFinerMask(MapperScene& scene)
{
  const int* const size = scene.image->GetDimensions();
  vtkNew<vtkImageData> mask;
  mask->SetDimensions(2 * size[0], 2 * size[1], 2 * size[2]);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mask->GetPointData()->GetScalars()->Fill(255.0);
  scene.mapper->SetMaskInput(mask);
  scene.mapper->SetMaskTypeToBinary();
}

}

class ProcessorMarchingIsNotFor
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingIsNotFor, AShaderRendersInstead)
{
  MapperScene scene(SmallTorso());
  ASSERT_TRUE(ByProcessor(scene));
  GetParam().make(scene);
  const std::vector<float> drawn = scene.DrawByProcessor();
  EXPECT_FALSE(scene.ShaderParts().empty());
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.0);
}

INSTANTIATE_TEST_SUITE_P(EveryOther, ProcessorMarchingIsNotFor,
  testing::Values(Change{ "AnAverageOfBoxes",
                    [](MapperScene& s)
                    {
                      s.mapper->SetBlendModeToAverageIntensity();
                      s.volume->GetProperty()->SetInterpolationTypeToNearest();
                    } },
    Change{ "FacesOfBoxes",
      [](MapperScene& s)
      {
        s.mapper->SetBlendModeToIsoSurface();
        s.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
        s.volume->GetProperty()->SetInterpolationTypeToNearest();
      } },
    Change{ "AMaximumAlongASpline",
      [](MapperScene& s)
      {
        s.mapper->CubicInterpolationOn();
        s.mapper->SetBlendModeToMaximumIntensity();
      } },
    Change{ "Simpson", [](MapperScene& s) { s.mapper->SetIntegrationRule(Mapper::Simpson); } },
    Change{ "TheCellField", [](MapperScene& s) { s.mapper->SetAccelerationModeToCellField(); } },
    Change{ "AMaskOfOtherSize", UseFinerMask },
    Change{ "LightOnCuts",
      [](MapperScene& s)
      {
        Clip(s);
        s.volume->GetProperty()->ShadeOn();
        s.volume->GetProperty()->UseClippedVoxelIntensityOn();
      } },
    Change{ "AMaximumOfSeveralComponents",
      [](MapperScene& s)
      {
        s.mapper->SetInputData(WithSecondComponent(s.image));
        s.mapper->SetBlendModeToMaximumIntensity();
      } },
    Change{ "CountsOfReadings", [](MapperScene& s) { s.mapper->SetDrawFetchCounts(true); } },
    Change{ "LittleMemory", [](MapperScene& s) { s.mapper->SetMaximumGraphicsMemory(1 << 26); } },
    Change{ "CodeOfUsers",
      [](MapperScene& s)
      {
        s.volume->GetShaderProperty()->AddFragmentShaderReplacement("//Varimarch::Window", true,
          "vec4 Windowed(vec4 picture) { return picture.bgra; }", false);
      } },
    Change{ "IntegersThatNoFloatIs",
      [](MapperScene& s)
      {
        vtkNew<vtkImageShiftScale> shifted;
        shifted->SetInputData(s.image);
        shifted->SetShift(1 << 25);
        shifted->SetOutputScalarTypeToInt();
        shifted->Update();
        s.mapper->SetInputData(shifted->GetOutput());
        ShowUpperValues(s, shifted->GetOutput());
      } },
    Change{ "IntegersBetweenWhichFloatsAreFew",
      [](MapperScene& s)
      {
        vtkNew<vtkImageShiftScale> shifted;
        shifted->SetInputData(s.image);
        shifted->SetShift(1e9);
        shifted->SetScale(0.01);
        shifted->SetOutputScalarTypeToInt();
        shifted->Update();
        s.mapper->SetInputData(shifted->GetOutput());
        ShowUpperValues(s, shifted->GetOutput());
      } }),
  NameOf);

TEST_F(ProcessorMarching, IsNotForMaximaInImages)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.mapper->RenderToImageOn();
  EXPECT_FALSE(ByProcessor(scene));
  vtkNew<vtkImageData> color;
  scene.mapper->GetColorImage(color);
  EXPECT_GT(color->GetScalarComponentAsDouble(
              color->GetDimensions()[0] / 2, color->GetDimensions()[1] / 2, 0, 3),
    0.0);
}

// Shaders shift and scale the values first, so that products and differences keep their precision.
TEST_F(ProcessorMarching, LeavesFloatsInOddUnitsToShaders)
{
  struct Unit
  {
    double scale;
    double shift;
    bool isPlain;
  };
  for (const Unit& unit : { Unit{ 1e-20, 0.0, false }, Unit{ 1e-9, 0.0, true },
         Unit{ 1e9, 0.0, true }, Unit{ 1e18, 0.0, false }, Unit{ 1.0, 1e7, false } })
  {
    vtkNew<vtkImageShiftScale> scaled;
    scaled->SetInputData(SmallTorso());
    scaled->SetScale(unit.scale);
    scaled->SetShift(unit.shift);
    scaled->SetOutputScalarTypeToFloat();
    scaled->Update();
    MapperScene scene(scaled->GetOutput());
    ShowUpperValues(scene);
    scene.volume->GetProperty()->ShadeOn();
    SCOPED_TRACE(unit.scale);
    EXPECT_EQ(ByProcessor(scene), unit.isPlain);
    if (unit.isPlain)
    {
      ExpectSamePicture(scene);
    }
  }
}

// Shaders know which gradients depend on NaN values.
TEST_F(ProcessorMarching, LeavesGradientsBesideGapsToShaders)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    MapperScene scene(TorsoOfType(type));
    ShowUpperValues(scene);
    scene.volume->GetProperty()->ShadeOn();
    EXPECT_TRUE(ByProcessor(scene));
    scene.image->SetScalarComponentFromDouble(
      20, 18, 12, 0, std::numeric_limits<double>::quiet_NaN());
    scene.image->Modified();
    EXPECT_FALSE(ByProcessor(scene));
    scene.volume->GetProperty()->ShadeOff();
    EXPECT_TRUE(ByProcessor(scene));
    LeaveLowerGradientsOut(scene);
    EXPECT_FALSE(ByProcessor(scene));
  }
}

// A value is interpolated between two voxels along each axis, that of a spline between four.
TEST_F(ProcessorMarching, LeavesThinSlabsToShaders)
{
  struct Slab
  {
    int slices;
    bool cubic;
    bool isThick;
  };
  for (const Slab& slab : { Slab{ 1, false, false }, Slab{ 2, false, true }, Slab{ 3, true, false },
         Slab{ 4, true, true } })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(9, 9, slab.slices);
    image->AllocateScalars(VTK_SHORT, 1);
    short* const voxels = static_cast<short*>(image->GetScalarPointer());
    for (int i = 0; i < 81 * slab.slices; ++i)
    {
      voxels[i] = short(100 * (i % 9) + 50 * (i / 81));
    }
    MapperScene scene(image);
    scene.mapper->SetCubicInterpolation(slab.cubic);
    ShowUpperValues(scene);
    SCOPED_TRACE(slab.slices);
    EXPECT_EQ(ByProcessor(scene), slab.isThick);
    if (slab.isThick)
    {
      ExpectSamePicture(scene);
    }
  }
}
