// Scenes that packets of rays do not support are rendered by shaders.

#include "Module/Scenes/ProcessorMarching.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageAppendComponents.h>
#include <vtkPointData.h>
#include <vtkShaderProperty.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

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

namespace
{

// The torso with values * scale + shift.
vtkSmartPointer<vtkImageData> TorsoInUnits(int type, double scale, double shift)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  const auto scaled = vtkSmartPointer<vtkImageData>::New();
  scaled->CopyStructure(torso);
  scaled->AllocateScalars(type, 1);
  vtkDataArray* const from = torso->GetPointData()->GetScalars();
  vtkDataArray* const to = scaled->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    to->SetComponent(i, 0, from->GetComponent(i, 0) * scale + shift);
  }
  return scaled;
}

struct Units
{
  const char* name;
  int type;
  double scale;
  double shift;
};

const std::vector<Units> OddValues = {
  { "small floats", VTK_FLOAT, 1e-20, 0.0 },
  { "floats", VTK_FLOAT, 1e-9, 0.0 },
  { "large floats", VTK_FLOAT, 1e9, 0.0 },
  { "very large floats", VTK_FLOAT, 1e18, 0.0 },
  { "floats far from zero", VTK_FLOAT, 1.0, 1e7 },
  { "doubles far from zero", VTK_DOUBLE, 1e-4, 1e6 },
  { "integers that no float is", VTK_INT, 1.0, 1 << 25 },
  { "integers between which floats are few", VTK_INT, 0.01, 1e9 },
  { "unsigned integers up to 4e9", VTK_UNSIGNED_INT, 1e6, 2e9 },
  { "unsigned integers near 4e9", VTK_UNSIGNED_INT, 1.0, 4e9 },
  { "integers of 64 bits", VTK_LONG_LONG, 1e12, 0.0 },
  { "integers of 64 bits far from zero", VTK_LONG_LONG, 1.0, 1e15 },
  { "unsigned integers of 64 bits", VTK_UNSIGNED_LONG_LONG, 1e9, 1e13 },
};

}

// Numbers that floats cannot represent are shifted and scaled first, as for shaders, so that
// products and differences keep their precision.
TEST_F(ProcessorMarching, DrawsValuesThatFloatsCannotRepresent)
{
  for (const Units& values : OddValues)
  {
    SCOPED_TRACE(values.name);
    const vtkSmartPointer<vtkImageData> image =
      TorsoInUnits(values.type, values.scale, values.shift);
    MapperScene scene(image);
    ShowUpperValues(scene);
    scene.volume->GetProperty()->ShadeOn();
    ExpectSamePicture(scene);
    scene.volume->GetProperty()->ShadeOff();
    scene.mapper->SetBlendModeToMaximumIntensity();
    ExpectSamePicture(scene);
    scene.mapper->SetBlendModeToIsoSurface();
    double range[2];
    image->GetScalarRange(range);
    scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(
      0, 0.3 * range[0] + 0.7 * range[1]);
    ExpectSamePicture(scene);
  }
}

TEST_F(ProcessorMarching, DrawsSeveralComponentsOfWhichOneIsFarFromZero)
{
  std::vector<std::vector<float>> pictures;
  for (const double shift : { 0.0, double(1 << 25) })
  {
    vtkNew<vtkImageAppendComponents> pairs;
    pairs->AddInputData(TorsoInUnits(VTK_INT, 1.0, shift));
    pairs->AddInputData(TorsoInUnits(VTK_INT, 1.0, 0.0));
    pairs->Update();
    MapperScene scene(pairs->GetOutput());
    ShowUpperValues(scene, TorsoInUnits(VTK_INT, 1.0, shift));
    vtkNew<vtkPiecewiseFunction> second;
    second->AddPoint(100.0, 0.0);
    second->AddPoint(1000.0, 0.3);
    scene.volume->GetProperty()->SetScalarOpacity(1, second);
    // Without colours of its own it has those of the first component, which is shifted.
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    scene.volume->GetProperty()->SetColor(1, white);
    pictures.push_back(scene.DrawByProcessor());
    EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
  }
  const varimarch::ImageError difference =
    varimarch::CompareImages(pictures[0].data(), pictures[1].data(), pictures[0].size() / 4);
  EXPECT_LT(difference.rootMeanSquare, 0.05);
  EXPECT_LT(difference.percentile999, 0.5);
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

namespace
{

// Values that rise along all axes.
vtkSmartPointer<vtkImageData> SlopesOf(const std::array<int, 3>& dimensions, int type)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.data());
  image->AllocateScalars(type, 1);
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x)
      {
        const double wave = 40.0 * std::sin(1.1 * x + 0.7 * y + 0.5 * z);
        image->SetScalarComponentFromDouble(
          x, y, z, 0, 500.0 + 10.0 * x + 7.0 * y + 5.0 * z + wave);
      }
    }
  }
  return image;
}

void ShowAllValues(MapperScene& scene)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(400.0, 0.4);
  scene.opacities->AddPoint(900.0, 0.8);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(400.0, 0.8, 0.3, 0.2);
  scene.colors->AddRGBPoint(900.0, 0.2, 0.9, 1.0);
}

}

TEST_F(ProcessorMarching, DrawsVolumesOfOneVoxelAlongAnAxis)
{
  const std::vector<std::array<int, 3>> sizes = { { 1, 1, 1 }, { 2, 1, 1 }, { 1, 1, 30 },
    { 24, 24, 1 }, { 1, 13, 11 } };
  for (const std::array<int, 3>& size : sizes)
  {
    for (const int type : { VTK_SHORT, VTK_LONG_LONG })
    {
      SCOPED_TRACE(::testing::PrintToString(size) + " of type " + std::to_string(type));
      MapperScene scene(SlopesOf(size, type), 32);
      ShowAllValues(scene);
      ExpectSamePicture(scene);
    }
  }
}

TEST_F(ProcessorMarching, DrawsASliceInEveryWay)
{
  MapperScene scene(SlopesOf({ 24, 24, 1 }, VTK_SHORT), 32);
  ShowAllValues(scene);
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->SetInterpolationTypeToNearest();
  ExpectSamePicture(scene);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  ExpectSamePicture(scene);
  scene.mapper->SetAmbientOcclusion(0.8);
  EXPECT_TRUE(ByProcessor(scene));
  scene.mapper->SetAmbientOcclusion(0.0);
  scene.mapper->SetBlendModeToMaximumIntensity();
  ExpectSamePicture(scene);
}

// A value of a spline lies between four voxels along each axis.
TEST_F(ProcessorMarching, LeavesThinSplinesToShaders)
{
  for (const int slices : { 1, 3, 4 })
  {
    SCOPED_TRACE(slices);
    MapperScene scene(SlopesOf({ 9, 9, slices }, VTK_SHORT));
    ShowAllValues(scene);
    scene.mapper->CubicInterpolationOn();
    EXPECT_EQ(ByProcessor(scene), slices == 4);
  }
}
