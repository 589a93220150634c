// Volumes of several components, which packets of rays march as a mixture. Images match those of
// the shaders to a twentieth of a grey level (RMSE).

#include "Module/Scenes/ComponentVolumes.h"
#include "Module/Scenes/ProcessorMarching.h"

#include <vtkImageCast.h>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// Balls with soft rims beside each other, one for each component, coloured by position.
vtkSmartPointer<vtkImageData> Balls(int components)
{
  constexpr int Size = 33;
  const auto value = [&](glm::ivec3 voxel, int component)
  {
    const glm::dvec3 place = glm::dvec3(voxel) / double(Size - 1);
    if (components == 4 && component < 3)
    {
      return 255.0 * place[component];
    }
    const glm::dvec3 center = 0.5 + 0.15 * glm::dvec3(component - 0.5, 0.5 * component, 0.0);
    return std::max(200.0 - 400.0 * glm::length(place - center), 0.0);
  };
  const auto image = ImageOf(VTK_UNSIGNED_CHAR, components, value, glm::ivec3(Size));
  image->SetSpacing(1.0, 1.2, 0.9);
  image->SetOrigin(-16.0, -19.2, -14.4);
  return image;
}

void UseCast(MapperScene& scene, int type)
{
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(scene.image);
  cast->SetOutputScalarType(type);
  cast->Update();
  scene.mapper->SetInputData(cast->GetOutput());
}

void Shade(MapperScene& scene)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  for (int component = 0; component < 3; ++component)
  {
    property->SetShade(component, 1);
    property->SetSpecular(component, 0.2 + 0.2 * component);
  }
}

void UseGradients(MapperScene& scene)
{
  for (const int component : { 0, 1 })
  {
    vtkNew<vtkPiecewiseFunction> factors;
    factors->AddPoint(0.0, component == 0 ? 0.2 : 1.0);
    factors->AddPoint(15.0, component == 0 ? 1.0 : 0.3);
    scene.volume->GetProperty()->SetGradientOpacity(component, factors);
  }
}

// Crops the middle out.
void CropMiddle(MapperScene& scene)
{
  scene.mapper->CroppingOn();
  scene.mapper->SetCroppingRegionPlanes(-5.0, 4.0, -20.0, 20.0, -6.0, 3.0);
  scene.mapper->SetCroppingRegionFlagsToInvertedCross();
}

struct ComponentsChange
{
  const char* name;
  int components;
  bool independent;
  std::function<void(MapperScene&)> make;
};

void PrintTo(const ComponentsChange& change, std::ostream* os)
{
  *os << change.name;
}

}

class ProcessorMarchingOfComponents
  : public ProcessorMarching
  , public testing::WithParamInterface<ComponentsChange>
{
};

TEST_P(ProcessorMarchingOfComponents, IsThePictureOfTheShader)
{
  const auto image = Balls(GetParam().components);
  MapperScene scene(image);
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->SetIndependentComponents(GetParam().independent);
  for (int component = 0; component < 4; ++component)
  {
    SetLook(property, component, looks[component]);
    property->SetComponentWeight(component, 1.0 - 0.2 * component);
  }
  scene.mapper->SetIntegrationRule(Mapper::Midpoint); // the only rule of packets
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.1f);
  GetParam().make(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, ProcessorMarchingOfComponents,
  testing::Values(ComponentsChange{ "TwoMaterials", 2, true, [](MapperScene&) {} },
    ComponentsChange{ "ThreeMaterials", 3, true, [](MapperScene&) {} },
    ComponentsChange{
      "FourMaterialsOfDoubles", 4, true, [](MapperScene& s) { UseCast(s, VTK_DOUBLE); } },
    ComponentsChange{
      "WithoutField", 2, true, [](MapperScene& s) { s.mapper->SetAccelerationModeToOff(); } },
    ComponentsChange{ "MaterialsInLight", 2, true, Shade },
    ComponentsChange{ "MaterialsWithOpacityOfGradients", 2, true,
      [](MapperScene& s)
      {
        Shade(s);
        UseGradients(s);
      } },
    ComponentsChange{ "MaterialsOfBoxes", 2, true,
      [](MapperScene& s)
      {
        Shade(s);
        ShowBoxes(s);
      } },
    ComponentsChange{ "MaterialsOfSplines", 2, true,
      [](MapperScene& s)
      {
        Shade(s);
        s.mapper->CubicInterpolationOn();
      } },
    ComponentsChange{ "CroppedMaterialsInNoise", 2, true,
      [](MapperScene& s)
      {
        CropMiddle(s);
        s.mapper->UseJitteringOn();
      } },
    ComponentsChange{ "ColorAndOpacity", 2, false, [](MapperScene&) {} },
    ComponentsChange{ "ColorAndOpacityInLight", 2, false,
      [](MapperScene& s)
      {
        Shade(s);
        UseGradients(s);
      } },
    ComponentsChange{ "Colors", 4, false, [](MapperScene&) {} },
    ComponentsChange{
      "ColorsOfShorts", 4, false, [](MapperScene& s) { UseCast(s, VTK_UNSIGNED_SHORT); } },
    ComponentsChange{ "ColorsInLightWithOpacityOfGradients", 4, false,
      [](MapperScene& s)
      {
        Shade(s);
        UseGradients(s);
      } },
    ComponentsChange{ "ColorsOfBoxes", 4, false, ShowBoxes },
    ComponentsChange{ "ColorsInACrop", 4, false, CropMiddle }),
  [](const testing::TestParamInfo<ComponentsChange>& info) { return info.param.name; });

TEST_F(ProcessorMarching, KeepsComponentsOffTheDevice)
{
  const auto image = Balls(4);
  MapperScene scene(image);
  scene.volume->GetProperty()->IndependentComponentsOff();
  scene.DrawByProcessor();
  const vtkIdType bytesOfPixels = 4 * sizeof(float) * scene.size * scene.size;
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), bytesOfPixels);
}

// Packets do not support integration between two samples.
TEST_F(ProcessorMarching, LeavesComponentsByAnotherRuleToShaders)
{
  const auto image = Balls(2);
  MapperScene scene(image);
  EXPECT_TRUE(ByProcessor(scene));
  scene.mapper->SetIntegrationRule(Mapper::PreIntegrated);
  EXPECT_FALSE(ByProcessor(scene));
}
