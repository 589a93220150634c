#ifndef Varimarch_Testing_ProcessorMarching_h
#define Varimarch_Testing_ProcessorMarching_h

// Helpers for tests of rays that the processor marches.

#include "Module/Scenes/MapperScene.h"

#include <vtkContourValues.h>
#include <vtkImageShiftScale.h>
#include <vtkLight.h>
#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

class ProcessorMarching : public testing::Test
{
};

inline bool ByProcessor(MapperScene& scene)
{
  scene.DrawByProcessor();
  return scene.ShaderParts().empty();
}

inline void ExpectSamePicture(MapperScene& scene)
{
  const std::vector<float> marched = scene.DrawByProcessor();
  ASSERT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
  const std::vector<float> drawn = scene.Draw();
  ASSERT_FALSE(scene.ShaderParts().empty());
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1) << "the picture is empty";
  const varimarch::ImageError difference =
    varimarch::CompareImages(marched.data(), drawn.data(), drawn.size() / 4);
  EXPECT_LT(difference.rootMeanSquare, 0.05);
  EXPECT_LT(difference.percentile999, 0.5);
}

inline vtkSmartPointer<vtkImageData> TorsoOfType(int type)
{
  vtkNew<vtkImageShiftScale> bytes;
  bytes->SetInputData(SmallTorso());
  const bool narrow = type == VTK_UNSIGNED_CHAR || type == VTK_SIGNED_CHAR || type == VTK_CHAR;
  bytes->SetShift(type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ? 1024.0 : 0.0);
  bytes->SetScale(narrow ? 1.0 / 16.0 : 1.0);
  bytes->ClampOverflowOn();
  bytes->SetOutputScalarType(type);
  bytes->Update();
  return bytes->GetOutput();
}

// Shows the values above the lowest tenth of the range.
inline void ShowUpperValues(MapperScene& scene, vtkImageData* image)
{
  double range[2];
  image->GetScalarRange(range);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(range[0] + 0.55 * (range[1] - range[0]), 0.0);
  scene.opacities->AddPoint(range[1], 0.4);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(range[0], 0.8, 0.3, 0.2);
  scene.colors->AddRGBPoint(range[1], 1.0, 0.95, 0.85);
}

inline void ShowUpperValues(MapperScene& scene)
{
  ShowUpperValues(scene, scene.image);
}

// Clips half of the volume away at an oblique angle.
inline void Clip(MapperScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.4, 0.2);
  scene.mapper->AddClippingPlane(plane);
}

inline void LeaveLowerGradientsOut(MapperScene& scene)
{
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.0);
  factors->AddPoint(100.0, 1.0);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
}

inline void ShowBoxes(MapperScene& scene)
{
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
}

// Shows skin, with bone visible through it.
inline void ShowIsosurfaces(MapperScene& scene)
{
  scene.mapper->SetBlendModeToIsoSurface();
  scene.volume->GetProperty()->ShadeOn();
  vtkContourValues* const values = scene.volume->GetProperty()->GetIsoSurfaceValues();
  values->SetValue(0, -300.0);
  values->SetValue(1, 100.0);
  values->SetValue(2, 300.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-300.0, 0.2);
  scene.opacities->AddPoint(300.0, 0.8);
}

// Uses a table that is not square, whose opacity rises with both values.
inline void ShowValueAndGradient(MapperScene& scene)
{
  vtkNew<vtkImageData> function;
  function->SetDimensions(7, 4, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 7; ++x)
    {
      const double colorAndOpacity[4] = { x / 6.0, y / 3.0, 0.5, 0.02 * x * y / 3.0 };
      for (int component = 0; component < 4; ++component)
      {
        function->SetScalarComponentFromDouble(x, y, 0, component, colorAndOpacity[component]);
      }
    }
  }
  scene.volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.volume->GetProperty()->SetTransferFunction2D(function);
}

// Adds a light beside the head light, with ambient light and highlights.
inline vtkLight* ShineFromTheSide(MapperScene& scene)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetSpecular(0.4);
  scene.Draw(); // creates the head light
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(300.0, 200.0, 100.0);
  light->SetAmbientColor(0.5, 0.4, 0.3);
  light->SetDiffuseColor(0.9, 0.3, 0.6);
  light->SetSpecularColor(0.2, 0.8, 0.4);
  scene.renderer->AddLight(light);
  return light;
}

struct Change
{
  const char* name;
  std::function<void(MapperScene&)> make;
};

inline void PrintTo(const Change& change, std::ostream* os)
{
  *os << change.name;
}

inline std::string NameOf(const testing::TestParamInfo<Change>& info)
{
  return info.param.name;
}

#endif
